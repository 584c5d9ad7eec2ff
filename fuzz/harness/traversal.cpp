// SPDX-License-Identifier: MIT
// Checks every promise of a culled frame on a small soup, with a camera and options.
#include <algorithm>
#include <array>
#include <stdexcept>
#include <string>
#include <vector>

#include "decode.h"
#include "differential/cull_judge.h"
#include "finding.h"
#include "occlude/culler/culler.h"
#include "sight.h"

namespace occlude::harness {
namespace {

using culler::Camera;
using culler::Culler;
using culler::PolygonSoup;

glm::dvec3 vector(const kernel::Vec3& v) { return {v.x, v.y, v.z}; }

PolygonSoup soup_of(Decoder& decoder, const Camera& camera) {
  PolygonSoup soup;
  const auto eye = kernel::Viewpoint::eye({camera.eye.x, camera.eye.y, camera.eye.z});
  for (std::size_t i = 0, count = decoder.below(61); i < count; ++i) {
    const std::uint32_t first = static_cast<std::uint32_t>(soup.vertices.size());
    std::vector<std::uint32_t> loop;
    for (const kernel::Vec3& v : decoder.polygon(eye)) loop.push_back(soup.add_vertex(vector(v)));
    if (loop.size() < 3) loop.assign(3, first == 0 ? soup.add_vertex({}) : first - 1);  // a soup has no polygon with fewer
    soup.add_polygon(loop);
  }
  return soup;
}

/// Adds the faces of a solid that name existing vertices.
void add_solid(Decoder& decoder, const Camera& camera, PolygonSoup& soup) {
  const auto eye = kernel::Viewpoint::eye({camera.eye.x, camera.eye.y, camera.eye.z});
  const kernel::Polytope solid = decoder.polytope(eye);
  const auto first = static_cast<std::uint32_t>(soup.vertices.size());
  for (const kernel::Vec3& v : solid.vertices) soup.add_vertex(vector(v));
  for (std::vector<std::uint32_t> loop : solid.faces) {
    if (loop.size() < 3 || std::ranges::any_of(loop, [&](std::uint32_t i) { return i >= solid.vertices.size(); })) continue;
    for (std::uint32_t& i : loop) i += first;
    soup.add_polygon(loop);
  }
}

Camera camera_of(Decoder& decoder) {
  constexpr std::array<double, 8> kOpenings = {60, 90, 30, 120, 179, 1, 0.001, 53.13010235415598};
  constexpr std::array<double, 4> kAspects = {1, 16.0 / 9, 0.5, 1000};
  Camera camera;
  camera.eye = vector(decoder.point());
  camera.target = vector(decoder.point());
  if (decoder.below(4) == 3) camera.up = vector(decoder.point());
  if (decoder.below(3) == 2) camera.projection = culler::Projection::orthographic;
  camera.fov_y_deg = kOpenings[decoder.below(kOpenings.size())];
  camera.aspect = kAspects[decoder.below(kAspects.size())];
  camera.height = decoder.number();
  if (decoder.flag()) camera.near_plane = decoder.number();
  if (decoder.flag()) camera.far_plane = decoder.number();
  return camera;
}

culler::BuildConfig config_of(Decoder& decoder) {
  constexpr std::array<double, 4> kRegions = {1, 8, 64, 1000};
  culler::BuildConfig config;
  config.hierarchy.leaf_size = static_cast<std::uint32_t>(decoder.below(4));
  config.lists.threshold = decoder.flag() ? 0.03 : 1e-6;
  const std::size_t regions = decoder.below(2 * kRegions.size());
  config.lists.regions = kRegions[regions % kRegions.size()];
  if (regions >= kRegions.size()) config.lists.kind = culler::RegionKind::tree;
  return config;
}

culler::CullOptions options_of(Decoder& decoder) {
  culler::CullOptions options{.method = culler::Method::frusta};
  options.occluders = decoder.below(12);
  if (decoder.flag()) options.shadow_near = kernel::Near::farthest;
  if (decoder.flag()) options.test = kernel::Test::overlap;
  if (decoder.below(8) == 7) options.arithmetic = kernel::Arithmetic::plain;
  return options;
}

std::string fault_of_frame(const Culler& culler, const Camera& camera, const culler::CullOptions& options) {
  const culler::CullResult result = culler.cull(camera, options);
  if (std::string fault = fuzz::fault_of(culler, camera, options, result); !fault.empty()) return fault;
  if (options.arithmetic != kernel::Arithmetic::certified) return "";
  for (const culler::Culled& culled : result.culled) {
    const auto& node = culler.hierarchy().nodes()[culled.node];
    for (std::size_t p = node.first; p < std::size_t{node.first} + node.count; ++p) {
      if (is_surely_visible(culler.hierarchy().soup(), p, camera)) {
        return "polygon " + std::to_string(culler.hierarchy().original(p)) + " is culled and visible";
      }
    }
  }
  return "";
}

}  // namespace
}  // namespace occlude::harness

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace occlude;
  harness::Decoder decoder({data, size});
  const culler::Camera camera = harness::camera_of(decoder);
  culler::BuildConfig config = harness::config_of(decoder);
  culler::CullOptions options = harness::options_of(decoder);
  culler::PolygonSoup soup = harness::soup_of(decoder, camera);
  // These come last, each after the older ones, so that stored inputs still mean the same scenes.
  if (decoder.flag()) config.hierarchy.bounds = culler::Bounds::obb;
  if (decoder.flag()) options.unions = true;
  if (decoder.flag()) config.occluders.shells = false;
  if (decoder.flag()) harness::add_solid(decoder, camera, soup);
  try {
    const culler::Culler culler(soup, config);
    if (const std::string fault = harness::fault_of_frame(culler, camera, options); !fault.empty()) harness::finding(fault);
  } catch (const std::invalid_argument&) {
    // The culler refuses: the soup is empty, a coordinate is illegal, or the camera has a fault.
  }
  return 0;
}
