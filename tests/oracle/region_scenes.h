// SPDX-License-Identifier: MIT
// Random witnesses of culls for regions of eyes, about half of them nearly right: sheets of a few triangles between the eyes
// and a box, and windows around what is seen of it. All coordinates in space are multiples of 1/64. In a third of them they
// are multiples of 1/4, and so are the sides of the windows, on planes across the x axis: there much touches.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <functional>
#include <optional>
#include <utility>
#include <vector>

#include "occlude/fuzz/random.h"
#include "occlude/oracle/region.h"

namespace occlude::oracle {

/// A layer of a scene. Each rectangle has the number of a sheet.
struct SceneLayer {
  Focus focus;
  std::vector<std::array<double, 4>> rectangles;
  std::vector<std::size_t> sheet_of;
};

struct RegionScene {
  EyeRegion eyes;
  Aabb box;
  std::optional<HalfSpaceCoefficients> drawn;
  std::vector<std::vector<Loop>> sheets;
  std::vector<SceneLayer> layers;  ///< each after the first is behind the first window of the one before

  [[nodiscard]] RegionWitness witness() const {
    std::vector<Sheet> prepared;
    for (const std::vector<Loop>& polygons : sheets) prepared.emplace_back(polygons, drawn);
    Layer layer;
    for (std::size_t k = layers.size(); k-- > 0;) {
      Layer next{layers[k].focus, {}};
      for (std::size_t i = 0; i < layers[k].rectangles.size(); ++i) {
        const auto& [x0, y0, x1, y1] = layers[k].rectangles[i];
        next.windows.push_back({x0, y0, x1, y1, prepared[layers[k].sheet_of[i]]});
      }
      if (k + 1 < layers.size()) next.windows[0].to = layer;
      layer = std::move(next);
    }
    return {eyes, box, layer};
  }
};

inline double dot(const Point& a, const Point& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

inline Point cross(const Point& a, const Point& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

/// a + factor b
inline Point plus(const Point& a, double factor, const Point& b) {
  return {a[0] + factor * b[0], a[1] + factor * b[1], a[2] + factor * b[2]};
}

class RegionScenes {
 public:
  explicit RegionScenes(std::uint64_t seed) : random_(seed), fineness_(random_.chance(0.3) ? 4 : 64) {}

  RegionScene next() {
    RegionScene scene;
    scene.eyes = eyes();
    const double x = at(4, 9), y = at(-1, 1), z = at(-1, 1);
    scene.box = {{x, y, z}, {x + at(0, 1), y + at(0, 0.75), z + at(0, 0.75)}};
    if (random_.chance(0.4)) scene.drawn = HalfSpaceCoefficients{1, 0, 0, random_.chance(0.8) ? -1.5 : -at(1.5, 4)};
    const std::size_t sheets = 1 + random_.index(2);
    for (std::size_t i = 0; i < sheets; ++i) scene.sheets.push_back(sheet(y, z));
    add_layer(scene, [&] { return point(scene.box); });
    if (random_.chance(0.25)) {
      const std::array<double, 4> sides = scene.layers[0].rectangles[0];
      add_layer(scene, [&] {
        const auto& [point, normal, right] = scene.layers[0].focus;
        const Point at_side = plus(point, sides[random_.chance(0.5) ? 0 : 2], right);
        return plus(at_side, sides[random_.chance(0.5) ? 1 : 3], cross(right, normal));
      });
    }
    return scene;
  }

  /// An eye of the region: often a corner, or on the border.
  Point eye(const EyeRegion& eyes) {
    if (const Obb* box = std::get_if<Obb>(&eyes)) {
      Point e = box->center;
      for (const Point& half_edge : box->half_edges) e = plus(e, share(), half_edge);
      return e;
    }
    const auto& [center, radius] = std::get<Ball>(eyes);
    Point direction{random_.real(-1, 1), random_.real(-1, 1), random_.real(-1, 1)};
    const double size = dot(direction, direction);
    if (random_.chance(0.2) || size == 0) {
      const Point axis{random_.chance(0.5) ? 1. : 0., 0, 0};
      return plus(center, random_.chance(0.5) ? radius : -radius, axis);
    }
    return plus(center, (1 - 0x1p-40) * radius / std::sqrt(size), direction);
  }

  Point point(const Aabb& box) {
    Point p = box.min;
    for (std::size_t k = 0; k < 3; ++k) p[k] += (box.max[k] - box.min[k]) * (share() + 1) / 2;
    return p;
  }

 private:
  [[nodiscard]] bool is_coarse() const { return fineness_ == 4; }
  double at(double low, double high) {
    return random_.integer(static_cast<int>(fineness_ * low), static_cast<int>(fineness_ * high)) / fineness_;
  }
  double tilt() { return is_coarse() || random_.chance(0.5) ? 0 : at(-0.25, 0.25); }
  /// From -1 to 1, in eighths.
  double share() { return random_.chance(0.5) ? (random_.chance(0.5) ? 1 : -1) : random_.integer(-8, 8) / 8.; }

  EyeRegion eyes() {
    const Point center{at(-0.25, 0.25), at(-0.25, 0.25), at(-0.25, 0.25)};
    const double size = !is_coarse() && random_.chance(0.7) ? 0.125 : 0.5;
    if (random_.chance(0.3)) return Ball{center, at(0, size)};
    Obb box{center, {}};
    for (std::size_t k = 0; k < 3; ++k) {
      if (random_.chance(0.3)) continue;
      box.half_edges[k][k] = at(0, size);
      if (random_.chance(0.3)) box.half_edges[k][(k + 1) % 3] = at(-size, size);
    }
    return box;
  }

  /// A net of squares across the x axis around (y, z) and a fan of what one sees there, now and then with something wrong.
  std::vector<Loop> sheet(double y, double z) {
    constexpr std::size_t kNet = 3;
    const bool is_near = random_.chance(0.3);
    const double x = is_near ? at(0.75, 1.5) : at(1.5, 4.5), size = at(0.25, is_near ? 1 : 2.5), bend = is_near ? 0.25 : 0.5;
    std::array<std::array<Point, kNet>, kNet> net;
    for (std::size_t i = 0; i < kNet; ++i) {
      for (std::size_t j = 0; j < kNet; ++j) {
        net[i][j] = {x + at(-bend, bend), y + size * (static_cast<double>(i) - 1) + at(-0.25, 0.25),
                     z + size * (static_cast<double>(j) - 1) + at(-0.25, 0.25)};
        for (std::size_t k = 1; k < 3; ++k) net[i][j][k] = std::floor(fineness_ * net[i][j][k]) / fineness_;
      }
    }
    std::vector<Loop> polygons;
    for (std::size_t i = 0; i + 1 < kNet; ++i) {
      for (std::size_t j = 0; j + 1 < kNet; ++j) {
        polygons.push_back({net[i][j], net[i + 1][j], net[i + 1][j + 1], net[i][j + 1]});
      }
    }
    if (random_.chance(0.1)) polygons.pop_back();
    if (random_.chance(0.1)) polygons.push_back({{0, 0, 0}, {0, 0.5, 0}, {0, 0, at(-1, 1)}});
    if (random_.chance(0.1)) polygons.push_back({polygons[0][0], polygons[0][1], {x, y + at(-2, 2), z + at(-2, 2)}});
    if (random_.chance(0.1)) polygons.push_back({{x + 4, 9, 0}, {x + 4, -9, at(-9, 9)}, {x + 4, -9, 9}});
    return polygons;
  }

  /// Adds a layer through whose windows all eyes see what `seen` gives points of, unless something is wrong.
  void add_layer(RegionScene& scene, const std::function<Point()>& seen) {
    SceneLayer layer{{{at(1.5, 10), at(-1, 1), at(-1, 1)}, {1, tilt(), tilt()}, {tilt(), -1, tilt()}}, {}, {}};
    const Point &n = layer.focus.normal, &right = layer.focus.right, up = cross(right, n), forward = cross(up, right);
    std::array<double, 2> low{1e9, 1e9}, high{-1e9, -1e9};
    for (int i = 0; i < 256; ++i) {
      const Point e = eye(scene.eyes), to = plus(seen(), -1, e), from = plus(layer.focus.point, -1, e);
      const Point p = plus(plus(e, dot(forward, from) / dot(forward, to), to), -1, layer.focus.point);
      // p = x right + y up, and up is at right angles to right
      const std::array<double, 2> axes{dot(p, right) / dot(right, right), dot(p, up) / dot(up, up)};
      for (std::size_t k = 0; k < 2; ++k) {
        low[k] = std::min(low[k], axes[k]);
        high[k] = std::max(high[k], axes[k]);
      }
    }
    const double margin = random_.chance(0.1) ? -0x1p-6 : 0x1p-6;
    const int columns = random_.integer(1, 3), rows = random_.integer(1, 3);
    const auto side = [&](std::size_t k, int i, int of) {
      const double x = low[k] - margin + (high[k] - low[k] + 2 * margin) * i / of;
      return is_coarse() ? (std::floor(4 * x) + i) / 4 : x;
    };
    for (int i = 0; i < columns; ++i) {
      for (int j = 0; j < rows; ++j) {
        layer.rectangles.push_back({side(0, i, columns), side(1, j, rows), side(0, i + 1, columns), side(1, j + 1, rows)});
        layer.sheet_of.push_back(random_.index(scene.sheets.size()));
      }
    }
    scene.layers.push_back(std::move(layer));
  }

  fuzz::Random random_;
  double fineness_;
};

}  // namespace occlude::oracle
