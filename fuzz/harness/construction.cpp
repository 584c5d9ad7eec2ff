// SPDX-License-Identifier: MIT
// What may be an occluder: free and often illegal shapes, refused by everyone or by nobody, however they are written down.
#include <algorithm>
#include <optional>
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

/// Both near sides are refused alike, and so is the cone of rays.
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

/// A loop or its faces turned, shifted and stuttering: neither the refusal nor, where the near side does not hang on the
/// order of the input, an answer may change.
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
    // Of several reasons another may come first.
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
  // With the near side as the kernel took it the oracle proves that it is sound, too.
  const oracle::Shadow shadow(fuzz::to_oracle(question.viewpoint), fuzz::to_oracle(question.occluder),
                              fuzz::to_oracle(question.near, made));
  if (shadow.refusal().empty() != made.frustum.has_value()) {
    harness::fail("the frustum " + harness::text(made.refusal) + ", the oracle: \"" + shadow.refusal() + "\"", question);
  }
  harness::check_refusal(question, made.refusal);
  harness::check_rewritten(question, made, {decoder.box(), decoder.box()});
  return 0;
}
