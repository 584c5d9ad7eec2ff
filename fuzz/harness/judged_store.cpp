// SPDX-License-Identifier: MIT
#include "judged_store.h"

#include <exception>

#include "differential/cull_judge.h"
#include "differential/small_scenes.h"
#include "occlude/render/errors.h"
#include "occlude/render/walk.h"

namespace occlude::harness {
namespace {

using culler::Method;

/// What is wrong with frames by this method: two from each of some places.
std::string fault_of_frames(const culler::Culler& culler, Method method, fuzz::Random& random) {
  culler::CullOptions options{.method = culler::Method::frusta};
  options.method = method;
  for (int place = 0; place < 4; ++place) {
    const culler::Camera camera = fuzz::some_camera(random, culler.hierarchy().soup());
    if (!culler::fault(camera).empty()) continue;
    culler::View view;
    for (int frame = 0; frame < 2; ++frame) {
      const culler::CullResult& result = culler.cull(camera, options, view);
      if (std::string fault = fuzz::fault_of(culler, camera, options, result); !fault.empty()) return fault;
    }
  }
  return "";
}

}  // namespace

JudgedStore judged(const std::filesystem::path& store, bool believes_oriented_boxes, fuzz::Random& random) try {
  for (const Method method : {Method::frusta, Method::cover}) {
    render::WalkOptions options;
    options.cull.method = method;
    const culler::Culler culler = render::make_culler(render::ModelFile(store), options);
    const std::string fault = fault_of_frames(culler, method, random);
    if (fault.empty() || (believes_oriented_boxes && fault == "a polygon reaches out of the box of its node")) continue;
    return {false, fault};
  }
  return {};
} catch (const render::InputError&) {
  return {true, ""};
} catch (const std::exception& error) {
  return {false, std::string("another exception: ") + error.what()};
}

}  // namespace occlude::harness
