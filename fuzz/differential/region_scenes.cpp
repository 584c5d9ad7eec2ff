// SPDX-License-Identifier: MIT
#include "region_scenes.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>
#include <utility>

#include "any_case.h"
#include "cover/cover_buffer.h"
#include "model/bounds.h"
#include "small_scenes.h"

namespace occlude::fuzz {
namespace {

using culler::Camera;
using culler::EyeRegion;
using glm::dvec3;

/// The box of all vertices.
kernel::Aabb box_of(const culler::PolygonSoup& soup) {
  kernel::Aabb box = culler::empty_box();
  for (const dvec3& v : soup.vertices) culler::grow(box, culler::to_kernel(v));
  return box;
}

bool is_in(const kernel::Aabb& box, const dvec3& v) {
  bool is_in = true;
  for (int axis = 0; axis < 3; ++axis) is_in = is_in && box.min[axis] <= v[axis] && v[axis] <= box.max[axis];
  return is_in;
}

/// Walls are no farther, so that they stay within what add_extent() adds.
constexpr double kFarthestWall = 48;

class Maker {
 public:
  explicit Maker(Random& random) : random_(random) {}

  RegionScene make() {
    scene_.aim = kRegionAims[random_.index(kRegionAims.size())];
    make_camera();
    make_eyes();
    add_extent();
    add_walls();
    add_things();
    if (random_.chance(0.125)) scale(std::ldexp(1.0, some_exponent()));
    return std::move(scene_);
  }

 private:
  [[nodiscard]] double sign() { return random_.chance(0.5) ? 1 : -1; }
  /// 2^-low to 2^-high.
  [[nodiscard]] double small(int low, int high) { return std::ldexp(1.0, -random_.integer(low, high)); }
  /// Of the size of a scene, in which planes in focus have to be legal, too. Rounding leaves small numbers where 0 would be
  /// if a camera looked along an axis, which have to be legal.
  [[nodiscard]] int some_exponent() {
    const int least = is_along_axis_ ? -80 : -30, most = 88 - std::ilogb(extent_.max.x - scene_.camera.eye.x);
    return random_.chance(0.5) ? random_.integer(least, most) : random_.chance(0.5) ? least : most;
  }
  /// A number near 1, or 1.
  [[nodiscard]] double about_one() { return random_.chance(0.3) ? 1 : 1 + sign() * small(1, 52); }

  /// The point that far to the right, up and along the line of sight.
  [[nodiscard]] dvec3 at(double x, double y, double z) const {
    return scene_.camera.eye + x * axes_.right + y * axes_.up + z * axes_.forward;
  }
  /// The point on a ray, given by its slopes.
  [[nodiscard]] dvec3 on_ray(double x, double y, double z) const { return at(x * z, y * z, z); }

  void add(const std::vector<dvec3>& loop) {
    std::vector<std::uint32_t> indices;
    for (const dvec3& v : loop) indices.push_back(scene_.soup.add_vertex(v));
    scene_.soup.add_polygon(indices);
  }

  /// Half of the cameras look along an axis from a point of a lattice: then what is computed below is exact.
  void make_camera() {
    Camera& camera = scene_.camera;
    camera.eye = random_.chance(0.5) ? dvec3(0) : lattice_point(random_, 8);
    dvec3 forward{}, up{};
    is_along_axis_ = random_.chance(0.5);
    if (is_along_axis_) {
      const int axis = random_.integer(0, 2);
      forward[axis] = sign();
      up[(axis + 1) % 3] = 1;
    } else {
      forward = {sign() * random_.integer(1, 4), random_.integer(-4, 4), random_.integer(-4, 4)};
      up = {0.1, 0.3, 1};
    }
    camera.target = camera.eye + forward;
    camera.up = up;
    camera.fov_y_deg = std::array{60.0, 90.0, 120.0}[random_.index(3)];
    camera.aspect = 1;
    camera.near_plane = random_.chance(0.5) ? 1.0 / 64 : 1.0 / 8;
    axes_ = camera.axes();
    half_ = std::tan(camera.fov_y_deg * (3.14159265358979323846 / 360));
    scene_.options.method = culler::Method::cover;
    scene_.options.cover.width = random_.chance(0.5) ? 64 : 128;
    scene_.options.cover.height = random_.chance(0.8) ? scene_.options.cover.width : 96;
    if (random_.chance(0.1)) scene_.options.margin = 0x1p-10;
  }

  void make_eyes() {
    EyeRegion& eyes = scene_.camera.eyes;
    const double size = scene_.camera.near_plane * std::array{0x1p-8, 0.5, 2.0, 8.0, 32.0}[random_.index(5)];
    const auto eighths = [&] { return random_.integer(-8, 8) / 8.0; };
    const auto in_axes = [&](double x, double y, double z) { return x * axes_.right + y * axes_.up + z * axes_.forward; };
    if (scene_.aim == RegionAim::epipole) {
      const double ahead = random_.chance(0.9) ? sign() : 0, x = eighths() / 2, y = eighths() / 2;
      eyes = EyeRegion::box(size * in_axes(x, y, ahead));
      if (eyes.is_point()) eyes = EyeRegion::box(size * axes_.right);
    } else if (random_.chance(0.3)) {
      eyes = EyeRegion::ball(size);
    } else if (random_.chance(0.5)) {
      eyes = EyeRegion::box(size * axes_.right, size / 2 * axes_.up, (random_.chance(0.5) ? size : 0) * axes_.forward);
    } else {
      for (dvec3& half_edge : eyes.half_edges) {
        if (random_.chance(0.7)) half_edge = size * in_axes(eighths(), eighths(), eighths());
      }
      if (eyes.is_point()) eyes = EyeRegion::ball(size);
    }
    near_ = scene_.camera.near_plane + eyes.reach(axes_.forward);
  }

  /// Two small things that say how far the scene reaches. So what is added between them moves no plane in focus.
  void add_extent() {
    const double far = random_.chance(0.125) ? std::ldexp(1.0, random_.integer(9, 40)) : 256;
    for (const double end : {-far, far}) {
      const dvec3 corner = scene_.camera.eye + dvec3(end, end, end);
      add({corner, corner - dvec3(end / 64, 0, 0), corner - dvec3(0, end / 64, 0)});
    }
    extent_ = box_of(scene_.soup);
    layers_ = focus_distances(scene_);
  }

  /// A depth beyond the near plane: that of a plane in focus, or any.
  [[nodiscard]] double some_depth() {
    if (random_.chance(0.4)) {
      const double depth = layers_[random_.index(layers_.size())];
      if (depth < kFarthestWall) return depth;
    }
    return near_ * (1 + std::ldexp(random_.real(0.5, 1), random_.integer(-3, 5)));
  }

  void add_walls() {
    switch (scene_.aim) {
      case RegionAim::overtaking:
        return add_ragged();
      case RegionAim::epipole:
        return add_at_epipole();
      case RegionAim::edge_on:
        return add_edge_on();
      case RegionAim::layers:
        for (int i = random_.integer(1, 3); i > 0; --i) add_panels(some_depth());
        return;
      case RegionAim::touching:
        add_touching();
        return add_panels(some_depth());
      case RegionAim::slivers:
        return add_slivers();
    }
  }

  /// A fan of triangles around a point.
  void add_fan(const dvec3& middle, const std::vector<dvec3>& rim) {
    for (std::size_t i = 0; i < rim.size(); ++i) add({middle, rim[i], rim[(i + 1) % rim.size()]});
  }

  /// A wall with spikes around it that are shorter and thinner than what the eyes move their tips by, which are nearer or
  /// farther than the wall: for some eyes a tip is on the other side of its base.
  void add_ragged() {
    const double depth = some_depth();
    const double x0 = random_.real(-0.5, 0.5) * half_, y0 = random_.real(-0.5, 0.5) * half_,
                 size = random_.real(0.3, 1.2) * half_;
    const auto at_depth = [&](double x, double y, double z) { return on_ray(x, y, std::max(z, 1.01 * near_)); };
    std::vector<dvec3> rim;
    const std::array<std::array<double, 2>, 4> corners{{{-1, -1}, {1, -1}, {1, 1}, {-1, 1}}};
    for (std::size_t i = 0; i < 4; ++i) {
      const auto &a = corners[i], &b = corners[(i + 1) % 4];
      const double along_x = (b[0] - a[0]) / 2, along_y = (b[1] - a[1]) / 2, share = random_.real(0, 2);
      rim.push_back(at_depth(x0 + size * a[0], y0 + size * a[1], depth));
      if (random_.chance(0.5)) continue;
      const double x = x0 + size * (a[0] + share * along_x), y = y0 + size * (a[1] + share * along_y);
      const double thin = pixels(small(2, 12)), out = 1 + pixels(small(-1, 5)) / size;
      rim.push_back(at_depth(x, y, depth));
      rim.push_back(at_depth(x0 + out * (x + thin / 2 * along_x - x0), y0 + out * (y + thin / 2 * along_y - y0),
                             depth * (random_.chance(0.3) ? 1.25 : small(0, 4) * random_.real(1, 2))));
      rim.push_back(at_depth(x + thin * along_x, y + thin * along_y, depth));
      const double in = 1 - pixels(8) / size;
      scene_.edges.push_back({rim.back(), on_ray(x0 + in * (x - x0), y0 + in * (y - y0), depth)});
    }
    scene_.edges.push_back({rim.front(), rim.back()});
    add_fan(on_ray(x0, y0, depth), rim);
  }

  /// A slope of so many pixels of the picture, with its border.
  [[nodiscard]] double pixels(double count) const { return count * 2 * half_ / (scene_.options.cover.width * 2.0 / 3); }

  /// A triangle fan with an edge that the line of the eyes meets.
  void add_at_epipole() {
    const EyeRegion& eyes = scene_.camera.eyes;
    const dvec3& way = eyes.half_edges[0];
    const double ahead = glm::dot(way, axes_.forward);
    if (ahead == 0) return add_ragged();
    const double times = some_depth() / std::fabs(ahead);
    const dvec3 meets = scene_.camera.eye + (ahead < 0 ? -1.0 : 1.0) * std::ldexp(1.0, std::ilogb(times) + 1) * way;
    const double depth = glm::dot(meets - scene_.camera.eye, axes_.forward);
    // Powers of two, so that if the camera looks along an axis, the edge passes through that point exactly.
    const double deep = std::ldexp(1.0, std::ilogb(depth)), wide = std::ldexp(1.0, std::ilogb(depth * half_));
    const auto aside = [&](double most) {
      const double x = random_.integer(-8, 8) / 8.0, y = random_.integer(-8, 8) / 8.0;
      return most * wide * (x * axes_.right + y * axes_.up);
    };
    dvec3 along = aside(1) + random_.integer(-3, 3) / 8.0 * deep * axes_.forward;
    if (along == dvec3(0)) along = wide * axes_.right;
    const dvec3 from = meets - along, to = meets + (random_.chance(0.5) ? 1.0 : 0.5) * along;
    const dvec3 beside = glm::cross(along, axes_.forward);
    const dvec3 away = 1.5 * wide * sign() * (beside == dvec3(0) ? axes_.right : glm::normalize(beside));
    add_fan(meets + 0.5 * away,
            {from, to, meets + along + 1.5 * away + aside(0.5), meets - along + 1.5 * away + aside(0.5)});
    scene_.edges.push_back({from, to});
  }

  /// A large plane beside the eyes or below them. Of how far it is from the middle, the eyes reach some share.
  void add_edge_on() {
    for (int i = random_.integer(1, 2); i > 0; --i) {
      const dvec3 across = random_.chance(0.5) ? axes_.right : axes_.up, level = glm::cross(across, axes_.forward);
      const double share = std::array{0.25, 0.5, 0.74, 0.75, 0.76, 0.99, 1.0, 1.5}[random_.index(8)] * about_one();
      const double side = sign(), begin = random_.chance(0.3) ? near_ / 2 : near_ * random_.real(1, 2);
      const double end = some_depth() + begin, wide = random_.integer(1, 4) * end * half_ / 2,
                   tilt = random_.chance(0.5) ? 0 : random_.integer(-2, 2) / 16.0;
      const double from_eye = scene_.camera.eyes.reach(across) / share;
      const auto corner = [&](double along, double aside) {
        return scene_.camera.eye + along * axes_.forward + side * (from_eye + tilt * along) * across + aside * level;
      };
      add({corner(begin, -wide), corner(begin, wide), corner(end, wide), corner(end, -wide)});
      for (const double aside : {-wide, wide}) scene_.edges.push_back({corner(begin, aside), corner(end, aside)});
      scene_.edges.push_back({corner(begin, -wide), corner(end, wide)});
      scene_.edges.push_back({corner(end, -wide), corner(end, wide)});
    }
    if (random_.chance(0.5)) add_panels(some_depth());
  }

  /// A wall across the line of sight, of a few panels.
  void add_panels(double depth) {
    const int count = random_.integer(1, 3);
    const double size = random_.integer(1, 6) / 4.0 * half_ * depth, bend = random_.chance(0.5) ? 0 : depth / 16;
    const double x0 = random_.integer(-4, 4) / 8.0 * half_ * depth, y0 = random_.integer(-4, 4) / 8.0 * half_ * depth;
    const auto corner = [&](int i, int k) {
      return at(x0 + size * (2.0 * i / count - 1), y0 + size * (2.0 * k / count - 1), depth + bend * ((i + k) % 2));
    };
    for (int i = 0; i < count; ++i) {
      for (int k = 0; k < count; ++k) {
        if (count > 1 && random_.chance(0.05)) continue;
        add({corner(i, k), corner(i + 1, k), corner(i + 1, k + 1), corner(i, k + 1)});
      }
    }
    for (const auto& [i, k] : {std::pair{0, 0}, {count, 0}, {count, count}, {0, count}}) {
      scene_.edges.push_back({corner(i, k), corner(count - k, i)});
    }
  }

  /// A wall that touches the region, from outside or to within very little, or passes through it or its middle.
  void add_touching() {
    const dvec3 across = std::array{axes_.right, axes_.up, axes_.forward}[random_.index(3)];
    const double reach = scene_.camera.eyes.reach(across) * std::array{1.0, 1.0, about_one(), 0.5, 0.0}[random_.index(5)];
    const bool is_ahead = across == axes_.forward;
    const dvec3 along = is_ahead ? axes_.right : axes_.forward, level = glm::cross(across, along);
    const double side = is_ahead ? 1 : sign(), begin = random_.chance(0.5) ? -4 : near_ * random_.real(0.5, 2),
                 end = random_.integer(2, 16);
    const auto corner = [&](double a, double b) {
      return scene_.camera.eye + side * reach * across + a * along + b * level;
    };
    const double wide = random_.integer(1, 4);
    add({corner(begin, -wide), corner(begin, wide), corner(end, wide), corner(end, -wide)});
    scene_.edges.push_back({corner(begin, -wide), corner(end, -wide)});
    scene_.edges.push_back({corner(end, -wide), corner(end, wide)});
  }

  /// A wall of strips, each of two slivers, or slivers that reach far out of the picture.
  void add_slivers() {
    std::vector<double> near_layers;
    std::ranges::copy_if(layers_, std::back_inserter(near_layers), [](double depth) { return depth < kFarthestWall; });
    const double depth = near_layers.empty() ? some_depth() : near_layers[random_.index(near_layers.size())];
    const int strips = random_.integer(2, 8);
    const double size = random_.integer(1, 4) / 4.0 * half_ * depth,
                 length = random_.chance(0.5) ? size : std::max(size, 200.0), turn = random_.integer(-2, 2) / 8.0;
    const double thin = random_.chance(0.5) ? 1 : small(1, 30);  // of every other strip
    const auto corner = [&](double y, double x) { return at(x + turn * y, y - turn * x, depth); };
    double low = -size;
    for (int i = 0; i < strips; ++i) {
      const double high = low + 2 * size / strips * (i % 2 == 0 ? 1 : thin);
      add({corner(low, -length), corner(low, length), corner(high, length)});
      add({corner(low, -length), corner(high, length), corner(high, -length)});
      low = high;
    }
    scene_.edges.push_back({corner(-size, -length), corner(-size, length)});
    scene_.edges.push_back({corner(low, -length), corner(low, length)});
    scene_.edges.push_back({corner(-size, -length), corner(low, -length)});
    scene_.edges.push_back({corner(-size, length), corner(low, length)});
  }

  /// A depth beyond another one: in a plane in focus or just before or behind it, where eyes move things by little; near the
  /// other one; or any.
  [[nodiscard]] double some_depth_beyond(double depth) {
    if (random_.chance(0.3)) return depth * (1 + small(1, 14));
    std::vector<double> beyond;
    std::ranges::copy_if(layers_, std::back_inserter(beyond),
                         [&](double layer) { return layer > depth && layer < kFarthestWall; });
    if (beyond.empty() || random_.chance(0.2)) return some_depth();
    return beyond[random_.index(beyond.size())] * about_one();
  }

  /// Small things a pixel or two beside an edge of a wall, as seen from the middle of the eyes, and anywhere.
  void add_things() {
    for (int i = random_.integer(20, 28); i > 0; --i) {
      double x = random_.real(-1, 1) * half_, y = random_.real(-1, 1) * half_, depth = some_depth() * about_one();
      const auto& [a, b] = scene_.edges[random_.index(scene_.edges.size())];
      const double share = random_.chance(0.3) ? random_.integer(0, 1) : random_.real(0, 1);
      const dvec3 p = a + share * (b - a) - scene_.camera.eye;
      const double along = glm::dot(p, axes_.forward);
      if (along > near_ && random_.chance(0.8)) {
        const double beside = pixels(3 * small(0, 2));
        x = glm::dot(p, axes_.right) / along + beside * random_.real(-1, 1);
        y = glm::dot(p, axes_.up) / along + beside * random_.real(-1, 1);
        depth = some_depth_beyond(along);
      }
      const double size = pixels(small(0, 8)) * depth;
      const std::vector<dvec3> thing{on_ray(x, y, depth), on_ray(x, y, depth) + size * axes_.right,
                                     on_ray(x, y, depth) + size * axes_.up};
      if (std::ranges::all_of(thing, [&](const dvec3& v) { return is_in(extent_, v); })) add(thing);
    }
  }

  void scale(double factor) {
    for (dvec3& v : scene_.soup.vertices) v *= factor;
    for (auto& edge : scene_.edges) {
      for (dvec3& v : edge) v *= factor;
    }
    Camera& camera = scene_.camera;
    camera.eye *= factor;
    camera.target *= factor;
    camera.near_plane *= factor;
    camera.eyes.radius *= factor;
    for (dvec3& half_edge : camera.eyes.half_edges) half_edge *= factor;
  }

  Random& random_;
  RegionScene scene_;
  Camera::Axes axes_{};
  bool is_along_axis_ = false;
  double half_ = 0;  ///< of the picture, at a distance of 1
  double near_ = 0;  ///< beyond the near planes of all eyes
  kernel::Aabb extent_{};
  std::vector<double> layers_;
};

bool is_legal(const RegionScene& scene) {
  return culler::fault(scene.camera).empty() && std::ranges::all_of(scene.soup.vertices, [](const dvec3& v) {
           return kernel::check(kernel::Vec3{v.x, v.y, v.z}) == kernel::Refusal::none;
         });
}

}  // namespace

std::vector<double> focus_distances(const RegionScene& scene) {
  const double reach = culler::depth(box_of(scene.soup), scene.camera.eye);
  culler::CoverBuffer buffer;
  buffer.begin(culler::FrameView(scene.camera, reach), scene.options.cover.width, scene.options.cover.height,
               scene.options.margin);
  const culler::FocusLayers& layers = buffer.box_picture().layers;
  std::vector<double> distances;
  for (std::size_t k = 0; k < layers.count; ++k) distances.push_back(1 / static_cast<double>(layers.focus[k]));
  return distances;
}

RegionScene some_region_scene(Random& random) {
  return first_legal([&]() -> std::optional<RegionScene> {
    RegionScene scene = Maker(random).make();
    return is_legal(scene) ? std::optional(std::move(scene)) : std::nullopt;
  });
}

}  // namespace occlude::fuzz
