// SPDX-License-Identifier: MIT
#include "occlude/kernel/shadow_frustum.h"

#include "build_frustum.h"
#include "stored_frustum.h"

namespace occlude::kernel {

ShadowFrustum::ShadowFrustum() = default;
ShadowFrustum::ShadowFrustum(const ShadowFrustum& other)
    : stored_(other.stored_ ? std::make_unique<StoredFrustum>(*other.stored_) : nullptr) {}
ShadowFrustum::ShadowFrustum(ShadowFrustum&&) noexcept = default;
ShadowFrustum& ShadowFrustum::operator=(const ShadowFrustum& other) {
  if (other.stored_) {
    own() = *other.stored_;
  } else if (stored_) {
    clear(*stored_);
  }
  return *this;
}
ShadowFrustum& ShadowFrustum::operator=(ShadowFrustum&&) noexcept = default;
ShadowFrustum::~ShadowFrustum() = default;

StoredFrustum& ShadowFrustum::own() {
  if (!stored_) stored_ = std::make_unique<StoredFrustum>();
  return *stored_;
}

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
  return {std::move(frustum), Refusal::none};
}

ShadowFrustumResult ShadowFrustum::make(const Viewpoint& viewpoint, const ConvexPolytope& polytope, Near near) {
  ShadowFrustum frustum;
  PolytopeSilhouette seen;
  const Refusal refusal = frustum.assign(viewpoint, polytope, near, seen);
  if (refusal != Refusal::none) return {std::nullopt, refusal};
  return {std::move(frustum), Refusal::none};
}

void ShadowFrustum::reserve(std::size_t count) {
  StoredFrustum& frustum = own();
  frustum.silhouette.reserve(count);
  frustum.recipes.reserve(count);
  frustum.filter_planes.reserve(count);
  frustum.refined_planes.reserve(count);
  frustum.cap_edges.reserve(count);
  frustum.cap_vertices.reserve(count);
}

bool ShadowFrustum::is_none() const { return !stored(*this); }
Viewpoint ShadowFrustum::viewpoint() const { return is_none() ? Viewpoint{} : stored_->viewpoint; }
Vec3 ShadowFrustum::origin() const { return is_none() ? Vec3{} : stored_->origin; }
std::span<const Vec3> ShadowFrustum::silhouette() const {
  return is_none() ? std::span<const Vec3>() : std::span<const Vec3>(stored_->silhouette);
}
std::size_t ShadowFrustum::near_count() const { return is_none() ? 0 : stored_->near_count; }
std::size_t ShadowFrustum::plane_count() const { return is_none() ? 0 : stored_->plane_count; }
HalfSpace ShadowFrustum::rounded_plane(std::size_t i) const {
  const FilterPlane& plane = stored_->filter_planes[i];
  return {plane.normal, plane.offset};
}
const std::optional<SupportPlane>& ShadowFrustum::support_plane() const {
  static constexpr std::optional<SupportPlane> kNoPlane;
  return is_none() ? kNoPlane : stored_->support_plane;
}

}  // namespace occlude::kernel
