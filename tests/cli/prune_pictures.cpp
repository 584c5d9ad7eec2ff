// SPDX-License-Identifier: MIT
// Draws pictures of a model from outside, with and without the polygons that a pruned copy lacks, and compares them pixel by
// pixel. Sends rays from outside to what is gone, and decides exactly whether one is clear. Says what share of the polygons
// that no picture shows is gone. Usage: prune_pictures MODEL PRUNED PICTURES RAYS [SIZE [SEED]]. The two models have their
// polygons in the same order.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <exception>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <iostream>
#include <random>
#include <vector>

#include "exact_rays.h"
#include "occlude/culler/hierarchy.h"
#include "occlude/render/model_io.h"
#include "occlude/render/offscreen_context.h"
#include "occlude/render/scene_renderer.h"

namespace {

using glm::dvec3;
using occlude::culler::Hierarchy;
using occlude::culler::PolygonRange;
using occlude::culler::PolygonSoup;

/// Whether each polygon of `all` is in `some`, too. REQUIRES: those of `some` are in the same order.
std::vector<bool> common(const PolygonSoup& all, const PolygonSoup& some) {
  std::vector<bool> is_kept(all.size());
  std::size_t next = 0;
  for (std::size_t p = 0; p < all.size() && next < some.size(); ++p) {
    const auto a = all.loop(p), b = some.loop(next);
    is_kept[p] = std::ranges::equal(a, b, [&](auto i, auto k) { return all.vertices[i] == some.vertices[k]; });
    next += is_kept[p];
  }
  if (next != some.size()) throw std::runtime_error("the pruned model has polygons that the model has not");
  return is_kept;
}

std::vector<PolygonRange> ranges_of(const std::vector<bool>& set) {
  std::vector<PolygonRange> ranges;
  for (std::uint32_t p = 0; p < set.size(); ++p) {
    if (!set[p]) continue;
    if (ranges.empty() || ranges.back().first + ranges.back().count != p) ranges.push_back({p, 0});
    ++ranges.back().count;
  }
  return ranges;
}

occlude::oracle::Point point_of(const dvec3& v) { return {v.x, v.y, v.z}; }

}  // namespace

int main(int argc, char** argv) try {
  if (argc < 5) return std::cerr << "usage: prune_pictures MODEL PRUNED PICTURES RAYS [SIZE [SEED]]\n", 2;
  const PolygonSoup model = occlude::render::read_model(argv[1]).soup;
  const std::vector<bool> is_kept = common(model, occlude::render::read_model(argv[2]).soup);
  const auto pictures = std::strtoull(argv[3], nullptr, 10);
  const auto rays = std::strtoull(argv[4], nullptr, 10);
  const int size = argc > 5 ? std::atoi(argv[5]) : 256;
  const auto seed = argc > 6 ? std::strtoull(argv[6], nullptr, 10) : std::random_device{}();
  std::mt19937_64 random(seed);
  const auto share = [&] { return static_cast<double>(random() >> 11) * 0x1p-53; };
  dvec3 low = model.vertices[0], high = low;
  for (const dvec3& v : model.vertices) low = glm::min(low, v), high = glm::max(high, v);

  const double extent = glm::length(high - low);
  // An eye near the box or far from it.
  const auto eye_outside = [&] {
    const double away = 0x1p-6 * extent + std::pow(share(), 4) * 2 * extent;
    const auto side = static_cast<int>(random() % 6);
    dvec3 eye;
    for (int axis = 0; axis < 3; ++axis) {
      eye[axis] = low[axis] - away + share() * (high[axis] - low[axis] + 2 * away);
      if (axis == side / 2) eye[axis] = side % 2 == 0 ? low[axis] - away : high[axis] + away;
    }
    return eye;
  };

  const auto context = occlude::render::make_offscreen_context();
  occlude::render::SceneRenderer renderer(model, size, size);
  const std::vector<PolygonRange> all{model.all()}, kept = ranges_of(is_kept);
  std::vector<bool> is_seen(model.size());
  std::size_t different = 0;
  for (std::size_t i = 0; i < pictures; ++i) {
    occlude::culler::Camera camera;
    camera.eye = eye_outside();
    for (int axis = 0; axis < 3; ++axis) camera.target[axis] = low[axis] + share() * (high[axis] - low[axis]);
    const dvec3 sight = glm::abs(camera.target - camera.eye);
    camera.up = sight.z > sight.x && sight.z > sight.y ? dvec3(0, 1, 0) : dvec3(0, 0, 1);
    camera.aspect = 1;
    camera.fov_y_deg = std::array{60, 60, 90, 20}[random() % 4];
    camera.near_plane = 0x1p-9 * extent;
    const auto before = renderer.item_buffer(camera, all), after = renderer.item_buffer(camera, kept);
    const auto shown = before.pixels_of(model.size()), still = after.pixels_of(model.size());
    for (std::size_t p = 0; p < model.size(); ++p) {
      if (shown[p] != 0) is_seen[p] = true;
    }
    std::size_t wrong = 0;
    for (std::size_t k = 0; k < before.pixels.size(); ++k) {
      const bool is_other = before.pixels[k] != after.pixels[k] ||
                            (!before.before.pixels.empty() && before.before.pixels[k] != after.before.pixels[k]);
      if (is_other && wrong++ == 0) {
        std::cout << "picture " << i << " at pixel " << k << ": polygon " << before.pixels[k] << ", then " << after.pixels[k]
                  << '\n';
      }
    }
    if (wrong == 0 && shown != still) wrong = 1;  // of glass behind glass
    different += wrong;
  }
  std::vector<std::size_t> gone_ones;
  for (std::size_t p = 0; p < is_kept.size(); ++p) {
    if (!is_kept[p]) gone_ones.push_back(p);
  }
  const auto tree = Hierarchy::build(model, {.leaf_size = 2});
  const occlude::render::TreeRays tree_rays(tree);
  std::size_t clear = 0;
  for (std::size_t i = 0; i < rays && !gone_ones.empty(); ++i) {
    const std::size_t p = gone_ones[random() % gone_ones.size()], k = 1 + random() % model.triangles(p);
    const auto loop = model.loop(p);
    double u = share(), v = share();
    if (u + v > 1) u = 1 - u, v = 1 - v;
    const dvec3 a = model.vertices[loop[0]], b = model.vertices[loop[k]], c = model.vertices[loop[k + 1]];
    const occlude::oracle::Triangle aim{point_of(a), point_of(b), point_of(c)};
    if (is_clear(tree, tree_rays, eye_outside(), a + u * (b - a) + v * (c - a), aim) && clear++ == 0) {
      std::cout << "a ray reaches polygon " << p << ", which is gone\n";
    }
  }
  std::size_t unseen = 0, gone = 0, gone_unseen = 0;
  for (std::size_t p = 0; p < model.size(); ++p) {
    unseen += !is_seen[p];
    gone += !is_kept[p];
    gone_unseen += !is_seen[p] && !is_kept[p];
  }
  std::cout << "seed " << seed << ": " << pictures << " pictures, " << different << " pixels differ; " << clear << " of "
            << rays << " rays are clear; of " << model.size() << " polygons " << unseen << " are in no picture, " << gone
            << " are gone, "
            << 100.0 * static_cast<double>(gone_unseen) / static_cast<double>(std::max<std::size_t>(unseen, 1))
            << " % of what is in no picture\n";
  return different == 0 && clear == 0 ? 0 : 1;
} catch (const std::exception& error) {
  return std::cerr << error.what() << '\n', 2;
}
