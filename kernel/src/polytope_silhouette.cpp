// SPDX-License-Identifier: MIT
#include "occlude/kernel/polytope_silhouette.h"

#include <algorithm>

#include "plane_coefficients.h"
#include "polytope_cap.h"

namespace occlude::kernel {
namespace {

bool is_turned(const Viewpoint& viewpoint, const ExactPlane& inner) {
  if (viewpoint.is_eye()) return sign_at(inner, viewpoint.value) < 0;
  return certified([&]<class A>(A& arithmetic) {
           return arithmetic.sign(dot(normal<A>(inner), constants<A>(viewpoint.value)));
         }) > 0;
}

}  // namespace

void PolytopeSilhouette::ask(const Viewpoint& viewpoint, const ConvexPolytope& polytope, std::uint32_t face) {
  if (is_asked_[face] != 0) return;
  is_asked_[face] = 1;
  ++faces_asked_;
  turned_[face] = is_turned(viewpoint, inner_plane(polytope, face)) ? 1 : 0;
}

/// The turned faces are connected, and so are the others, because a closed curve divides the sphere of faces into these two
/// parts. So every connected set of faces that changed since the last update lies along the previous border, unless one of
/// the two parts is now empty. In that case no border is found, and all faces have to be asked.
void PolytopeSilhouette::ask_along_border(const Viewpoint& viewpoint, const ConvexPolytope& polytope) {
  for (std::size_t asked_before = polytope.faces().size(); faces_asked_ != asked_before;) {
    asked_before = faces_asked_;
    for (const auto& edge : polytope.edges()) {
      if (turned_[edge.left] == turned_[edge.right]) continue;
      ask(viewpoint, polytope, edge.left);
      ask(viewpoint, polytope, edge.right);
    }
  }
}

/// The loop has the turned faces on its right, seen from outside.
void PolytopeSilhouette::link(const ConvexPolytope& polytope) {
  edges_.clear();
  for (const auto& [from, to, left, right] : polytope.edges()) {
    if (turned_[left] == turned_[right]) continue;
    edges_.push_back(turned_[left] != 0 ? LoopEdge{to, from, left} : LoopEdge{from, to, right});
  }
  std::sort(edges_.begin(), edges_.end(), [](const LoopEdge& a, const LoopEdge& b) { return a.from < b.from; });
  const auto edge_from = [&](std::uint32_t vertex) {
    return std::partition_point(edges_.begin(), edges_.end(), [&](const LoopEdge& e) { return e.from < vertex; });
  };
  loop_.clear();
  for (auto edge = edges_.begin(); loop_.size() < edges_.size(); edge = edge_from(edge->to)) {
    loop_.push_back({edge->from, edge->face});
  }
}

void PolytopeSilhouette::clear() {
  turned_.clear();
  turned_faces_.clear();
  loop_.clear();
  faces_asked_ = 0;
}

void PolytopeSilhouette::reserve(std::size_t faces, std::size_t edges) {
  turned_.reserve(faces);
  is_asked_.reserve(faces);
  turned_faces_.reserve(faces);
  edges_.reserve(edges);
  loop_.reserve(edges);
}

void PolytopeSilhouette::update(const Viewpoint& viewpoint, const ConvexPolytope& polytope) {
  const auto count = static_cast<std::uint32_t>(polytope.faces().size());
  turned_.resize(count);
  is_asked_.assign(count, 0);
  faces_asked_ = 0;
  ask_along_border(viewpoint, polytope);
  link(polytope);
  if (loop_.empty()) {
    for (std::uint32_t face = 0; face < count; ++face) ask(viewpoint, polytope, face);
    link(polytope);
  }
  turned_faces_.clear();
  for (std::uint32_t face = 0; face < count; ++face) {
    if (turned_[face] != 0) turned_faces_.push_back(face);
  }
}

}  // namespace occlude::kernel
