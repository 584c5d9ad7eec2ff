// SPDX-License-Identifier: MIT
// Embree: what no ray from the camera meets is not drawn. Its numbers are in single precision.
#include <embree3/rtcore.h>
#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <glm/geometric.hpp>
#include <span>
#include <stdexcept>

#include "occlude/render/pixel_rays.h"
#include "rivals.h"

namespace occlude::experiments {
namespace {

using culler::Camera;
using culler::Hierarchy;

/// Rays that go through Embree together: squares of pixels, which meet the same things.
constexpr int kSide = 4, kRays = kSide * kSide;

struct Release {
  void operator()(RTCDevice device) const { rtcReleaseDevice(device); }
  void operator()(RTCScene scene) const { rtcReleaseScene(scene); }
};
using Device = std::unique_ptr<RTCDeviceTy, Release>;
using Scene = std::unique_ptr<RTCSceneTy, Release>;

void check(RTCDevice device) {
  const RTCError error = rtcGetDeviceError(device);
  if (error != RTC_ERROR_NONE) throw std::runtime_error(fmt::format("Embree: error {}", static_cast<int>(error)));
}

class Rays : public VisibilityWay {
 public:
  Rays(const Hierarchy& tree, RTCBuildQuality quality, const RayPicture& picture)
      : tree_(tree), picture_(picture), device_(rtcNewDevice("")), last_met_(tree.nodes().size(), 0) {
    check(device_.get());
    const kernel::Vec3 &low = tree.nodes()[0].box.min, &high = tree.nodes()[0].box.max;
    centre_ = {low.x + (high.x - low.x) / 2, low.y + (high.y - low.y) / 2, low.z + (high.z - low.z) / 2};
    for (std::uint32_t node = 0; node < tree.nodes().size(); ++node) add_triangles_of(node);
    build(quality);
  }

  void cull(const Camera& camera) override {
    met_.clear();
    ++frame_;
    look_from(camera);
    for (int y = 0; y < picture_.height; y += kSide) {
      for (int x = 0; x < picture_.width; x += kSide) cast(x, y);
    }
  }

  [[nodiscard]] std::vector<culler::PolygonRange> drawn() const override {
    std::vector<std::uint32_t> leaves = met_;
    std::ranges::sort(leaves);
    std::vector<culler::PolygonRange> ranges;
    for (const std::uint32_t leaf : leaves) ranges.push_back({tree_.nodes()[leaf].first, tree_.nodes()[leaf].count});
    return ranges;
  }

 private:
  void add_triangles_of(std::uint32_t node) {
    const culler::HierarchyNode& leaf = tree_.nodes()[node];
    if (!leaf.is_leaf()) return;
    for (std::uint32_t p = leaf.first; p < leaf.first + leaf.count; ++p) {
      const auto loop = tree_.soup().loop(p);
      for (std::size_t i = 2; i < loop.size(); ++i) {
        corners_.insert(corners_.end(), {loop[0], loop[i - 1], loop[i]});
        leaf_of_.push_back(node);
      }
    }
  }

  void build(RTCBuildQuality quality) {
    const std::span<const glm::dvec3> vertices = tree_.soup().vertices;
    RTCGeometry geometry = rtcNewGeometry(device_.get(), RTC_GEOMETRY_TYPE_TRIANGLE);
    auto* const floats = static_cast<float*>(
        rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, 3 * sizeof(float), vertices.size()));
    check(device_.get());
    for (std::size_t i = 0; i < vertices.size(); ++i) {
      for (int axis = 0; axis < 3; ++axis) floats[3 * i + static_cast<std::size_t>(axis)] = coordinate(vertices[i], axis);
    }
    auto* const indices = static_cast<std::uint32_t*>(rtcSetNewGeometryBuffer(
        geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, 3 * sizeof(std::uint32_t), leaf_of_.size()));
    check(device_.get());
    std::ranges::copy(corners_, indices);
    corners_ = {};
    rtcSetGeometryBuildQuality(geometry, quality);
    rtcCommitGeometry(geometry);
    scene_.reset(rtcNewScene(device_.get()));
    rtcSetSceneBuildQuality(scene_.get(), quality);
    rtcAttachGeometry(scene_.get(), geometry);
    rtcReleaseGeometry(geometry);
    rtcCommitScene(scene_.get());
    check(device_.get());
  }

  /// Relative to the middle of the model, where single precision is finest.
  [[nodiscard]] float coordinate(const glm::dvec3& point, int axis) const {
    return static_cast<float>(point[axis] - centre_[axis]);
  }

  /// The ray of the pixel at the upper left, and how it changes from pixel to pixel.
  void look_from(const Camera& camera) {
    const render::PixelRays rays(camera, picture_.width, picture_.height);
    const auto first = rays.ray(0.5, 0.5), right = rays.ray(1.5, 0.5), below = rays.ray(0.5, 1.5);
    origin_ = {first.origin - centre_, right.origin - first.origin, below.origin - first.origin};
    direction_ = {first.direction, right.direction - first.direction, below.direction - first.direction};
    near_ = static_cast<float>(camera.near_plane);
    far_ = static_cast<float>(camera.far_plane);
  }

  /// A vector that is linear in the coordinates of a pixel.
  struct Linear {
    glm::vec3 first, right, below;
    [[nodiscard]] glm::vec3 at(int x, int y) const {
      return first + static_cast<float>(x) * right + static_cast<float>(y) * below;
    }
  };

  void cast(int x, int y) {
    alignas(64) RTCRayHit16 rays;
    alignas(64) int is_valid[kRays];
    for (int i = 0; i < kRays; ++i) {
      const int column = x + i % kSide, row = y + i / kSide;
      is_valid[i] = column < picture_.width && row < picture_.height ? -1 : 0;
      const glm::vec3 origin = origin_.at(column, row), direction = direction_.at(column, row);
      rays.ray.org_x[i] = origin.x;
      rays.ray.org_y[i] = origin.y;
      rays.ray.org_z[i] = origin.z;
      rays.ray.dir_x[i] = direction.x;
      rays.ray.dir_y[i] = direction.y;
      rays.ray.dir_z[i] = direction.z;
      // The direction is 1 long along the line of sight, so these are depths.
      rays.ray.tnear[i] = near_;
      rays.ray.tfar[i] = far_;
      rays.ray.time[i] = 0;
      rays.ray.mask[i] = ~0U;
      rays.ray.flags[i] = 0;
      rays.hit.geomID[i] = RTC_INVALID_GEOMETRY_ID;
      rays.hit.instID[0][i] = RTC_INVALID_GEOMETRY_ID;
    }
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    context.flags = RTC_INTERSECT_CONTEXT_FLAG_COHERENT;
    rtcIntersect16(is_valid, scene_.get(), &context, &rays);
    for (int i = 0; i < kRays; ++i) {
      if (is_valid[i] == 0 || rays.hit.geomID[i] == RTC_INVALID_GEOMETRY_ID) continue;
      const std::uint32_t leaf = leaf_of_[rays.hit.primID[i]];
      if (last_met_[leaf] == frame_) continue;
      last_met_[leaf] = frame_;
      met_.push_back(leaf);
    }
  }

  const Hierarchy& tree_;
  RayPicture picture_;
  Device device_;
  Scene scene_;
  glm::dvec3 centre_{0, 0, 0};
  std::vector<std::uint32_t> corners_, leaf_of_;  ///< of each triangle: its vertices, until the scene is built; its leaf
  Linear origin_{}, direction_{};
  float near_ = 0, far_ = 0;
  std::uint32_t frame_ = 0;
  std::vector<std::uint32_t> last_met_, met_;  ///< of each node: the last frame that met it; the leaves of this frame
};

}  // namespace

std::vector<UnpreparedWay> embree_ways(const Hierarchy& tree, const std::vector<RayPicture>& pictures) {
  std::vector<UnpreparedWay> ways;
  const auto add = [&](const char* builder, RTCBuildQuality quality, const RayPicture& picture) {
    ways.push_back({"Embree", fmt::format("Embree, {}, {}x{} rays", builder, picture.width, picture.height),
                    [&tree, quality, picture] { return std::make_unique<Rays>(tree, quality, picture); }});
  };
  for (const RayPicture& picture : pictures) {
    add("Morton", RTC_BUILD_QUALITY_LOW, picture);
    add("SAH", RTC_BUILD_QUALITY_MEDIUM, picture);
  }
  return ways;
}

}  // namespace occlude::experiments
