// SPDX-License-Identifier: MIT
#include "occlude/kernel/shadow_frustum.h"

#include <memory>
#include <new>
#include <utility>

#include "build_frustum.h"
#include "stored_frustum.h"

namespace occlude::kernel {

ShadowFrustum::ShadowFrustum() {
  static_assert(sizeof(StoredFrustum) <= kBytes && alignof(StoredFrustum) <= alignof(ShadowFrustum));
  std::construct_at(reinterpret_cast<StoredFrustum*>(stored_));
}
ShadowFrustum::ShadowFrustum(const ShadowFrustum& other) : ShadowFrustum() { own() = other.own(); }
ShadowFrustum::ShadowFrustum(ShadowFrustum&& other) noexcept {
  std::construct_at(reinterpret_cast<StoredFrustum*>(stored_), std::move(other.own()));
  clear(other.own());
}
ShadowFrustum& ShadowFrustum::operator=(const ShadowFrustum& other) {
  own() = other.own();
  return *this;
}
ShadowFrustum& ShadowFrustum::operator=(ShadowFrustum&& other) noexcept {
  if (this == &other) return *this;
  own() = std::move(other.own());
  clear(other.own());
  return *this;
}
ShadowFrustum::~ShadowFrustum() { std::destroy_at(&own()); }

StoredFrustum& ShadowFrustum::own() { return *std::launder(reinterpret_cast<StoredFrustum*>(stored_)); }

Refusal ShadowFrustum::assign(const Viewpoint& viewpoint, std::span<const Vec3> loop, Near near) {
  return build(own(), viewpoint, loop, near);
}

Refusal ShadowFrustum::assign(const Viewpoint& viewpoint, const ConvexPolytope& polytope, Near near,
                              PolytopeSilhouette& seen) {
  return build(own(), viewpoint, polytope, near, seen);
}

ShadowFrustumResult ShadowFrustum::make(const Viewpoint& viewpoint, std::span<const Vec3> loop, Near near) {
  ShadowFrustum frustum;
  const Refusal refusal = frustum.assign(viewpoint, loop, near);
  if (refusal != Refusal::none) return {std::nullopt, refusal};
  frustum.prepare_overlap();
  return {std::move(frustum), Refusal::none};
}

ShadowFrustumResult ShadowFrustum::make(const Viewpoint& viewpoint, const ConvexPolytope& polytope, Near near) {
  ShadowFrustum frustum;
  PolytopeSilhouette seen;
  const Refusal refusal = frustum.assign(viewpoint, polytope, near, seen);
  if (refusal != Refusal::none) return {std::nullopt, refusal};
  frustum.prepare_overlap();
  return {std::move(frustum), Refusal::none};
}

void ShadowFrustum::prepare_overlap() { add_profile(own()); }

void ShadowFrustum::reserve(std::size_t count) {
  StoredFrustum& frustum = own();
  frustum.silhouette.reserve(count);
  frustum.recipes.reserve(count);
  frustum.coarse_planes.reserve(count + kCoarseWidth);
  frustum.filter_planes.reserve(count);
  frustum.refined_planes.reserve(count);
  frustum.cap_edges.reserve(count);
  frustum.cap_vertices.reserve(count);
}

bool ShadowFrustum::is_none() const { return !stored(*this); }
Viewpoint ShadowFrustum::viewpoint() const { return own().viewpoint; }
Vec3 ShadowFrustum::origin() const { return own().origin; }
std::span<const Vec3> ShadowFrustum::silhouette() const { return own().silhouette; }
std::size_t ShadowFrustum::near_count() const { return own().near_count; }
std::size_t ShadowFrustum::plane_count() const { return own().plane_count; }
HalfSpace ShadowFrustum::rounded_plane(std::size_t i) const {
  const FilterPlane& plane = own().filter_planes[i];
  return {plane.normal, plane.offset};
}
const std::optional<SupportPlane>& ShadowFrustum::support_plane() const { return own().support_plane; }

}  // namespace occlude::kernel
