// SPDX-License-Identifier: MIT
// Visits the tests of a frame by frusta. It traverses the tree again.
#include "camera/sound_camera.h"
#include "descent/frame.h"
#include "frame/culler_access.h"
#include "frusta/node_tests.h"
#include "model/block_tree.h"
#include "model/bounds.h"

namespace occlude::culler {

void visit_shadow_tests(const Culler& culler, const CullResult& frame, const Camera& camera, const CullOptions& options,
                        const std::function<void(const Occluder& occluder, const Box& box)>& visit) {
  const Hierarchy& hierarchy = culler.hierarchy();
  Frame again;
  again.view = FrameView(camera, depth(hierarchy.nodes()[0].box, eye_of(camera)));
  again.margin = ShadowMargin(again.view, options.margin);
  again.result.view = frame.view;
  again.result.occluders = frame.occluders;
  again.result.pairs = frame.pairs;
  FrustaMemory memory;
  const auto on_tests = [&](const TreeBlock& block, const kernel::BlockQuestions& questions, kernel::BoxBytes nodes) {
    for (std::uint32_t i = 0; i < TreeBlock::kNodes; ++i) {
      for (std::size_t k = 0; k < questions.count; ++k) {
        if ((kernel::boxes_of(nodes, k) >> i & 1U) == 0) continue;
        visit(again.result.occluders[questions.frustum[k]], hierarchy.volume(block.node[i]));
      }
    }
  };
  const OccluderSet* const occluders = frame.occluders.empty() ? nullptr : &occluders_of(culler);
  CullOptions in_order = options;
  in_order.executor = nullptr;
  traverse(CullerAccess::tree(culler), hierarchy, occluders, on_tests, in_order, again, memory);
}

}  // namespace occlude::culler
