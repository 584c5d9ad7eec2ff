// SPDX-License-Identifier: MIT
// Makes occluders of any shape, often illegal. Each is refused by everyone or by no one, however it is written.
#include <algorithm>
#include <string>
#include <vector>

#include "cases/ask.h"
#include "cases/case_line.h"
#include "cases/to_oracle.h"
#include "decode.h"
#include "finding.h"
#include "occlude/kernel/view_cone.h"

namespace occlude::harness {
namespace {

using fuzz::Case;
using fuzz::Polygon;
using kernel::Refusal;

std::string text(Refusal refusal) {
  return refusal == Refusal::none ? "answers" : "refuses: " + std::string(kernel::to_string(refusal));
}

[[noreturn]] void fail(const std::string& what, const Case& question) {
  finding(what + ": " + cases::write_case("construction", question, ""));
}

/// Both near sides must be refused for the same reason, and so must the cone of rays.
void check_refusal(const Case& question, Refusal refusal) {
  Case other = question;
  other.near = question.near == fuzz::Near::surface ? fuzz::Near::farthest : fuzz::Near::surface;
  if (const Refusal theirs = make_frustum(other).refusal; theirs != refusal) {
    fail("the frustum " + text(refusal) + ", with the other near side " + text(theirs), question);
  }
  const auto cone_refusal = [&] {
    if (const auto* const loop = std::get_if<Polygon>(&question.occluder)) {
      return kernel::ViewCone::make(question.viewpoint, *loop).refusal;
    }
    const auto made = kernel::ConvexPolytope::make(std::get<kernel::Polytope>(question.occluder));
    return made.polytope ? kernel::ViewCone::make(question.viewpoint, *made.polytope).refusal : made.refusal;
  }();
  if (cone_refusal != refusal) fail("the frustum " + text(refusal) + ", the cone " + text(cone_refusal), question);
}

/// The same question with the loop or its faces reversed, rotated or with a vertex repeated. This must not change the
/// refusal. It must not change an answer either, unless the near side depends on the order of the input.
std::vector<Case> rewritten(const Case& question) {
  std::vector<Case> result;
  if (const auto* const loop = std::get_if<Polygon>(&question.occluder); loop != nullptr && !loop->empty()) {
    result.assign(3, question);
    std::ranges::reverse(std::get<Polygon>(result[0].occluder));
    auto& shifted = std::get<Polygon>(result[1].occluder);
    std::rotate(shifted.begin(), shifted.begin() + 1, shifted.end());
    auto& stuttering = std::get<Polygon>(result[2].occluder);
    stuttering.insert(stuttering.begin(), kernel::Vec3(stuttering.front()));
  } else if (const auto* const polytope = std::get_if<kernel::Polytope>(&question.occluder);
             polytope != nullptr && !polytope->faces.empty()) {
    result.assign(2, question);
    std::ranges::reverse(std::get<kernel::Polytope>(result[0].occluder).faces.front());
    std::ranges::reverse(std::get<kernel::Polytope>(result[1].occluder).faces);
  }
  return result;
}

void check_rewritten(const Case& question, const kernel::ShadowFrustumResult& made, const std::vector<fuzz::Box>& boxes) {
  const bool same_shadow = question.near == fuzz::Near::surface && made.frustum && !made.frustum->support_plane();
  for (const Case& other : rewritten(question)) {
    const auto theirs = make_frustum(other);
    // When there are several reasons to refuse, another may come first.
    if (theirs.frustum.has_value() != made.frustum.has_value()) {
      fail("written otherwise the occluder " + text(theirs.refusal) + ", as here it " + text(made.refusal), question);
    }
    for (const fuzz::Box& box : boxes) {
      if (!same_shadow || fuzz::check(box) != Refusal::none) continue;
      if (fuzz::overlap(*theirs.frustum, box).relation != fuzz::overlap(*made.frustum, box).relation) {
        Case asked = question;
        asked.box = box;
        fail("written otherwise the occluder has another shadow", asked);
      }
    }
  }
}

}  // namespace
}  // namespace occlude::harness

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace occlude;
  harness::Decoder decoder({data, size});
  const fuzz::Case question = decoder.question();
  const auto made = make_frustum(question);
  // The oracle gets the near side that the kernel used, so it also proves that this is sound.
  const oracle::Shadow shadow(fuzz::to_oracle(question.viewpoint), fuzz::to_oracle(question.occluder),
                              fuzz::to_oracle(question.near, made));
  if (shadow.refusal().empty() != made.frustum.has_value()) {
    harness::fail("the frustum " + harness::text(made.refusal) + ", the oracle: \"" + shadow.refusal() + "\"", question);
  }
  harness::check_refusal(question, made.refusal);
  harness::check_rewritten(question, made, {decoder.box(), decoder.box()});
  return 0;
}
