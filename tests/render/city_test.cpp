// SPDX-License-Identifier: MIT
// The composite model: the same for everyone, well-formed polygon soup, and a path that keeps clear of it.
#include "occlude/render/city.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <map>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace occlude::render {
namespace city_test {

__extension__ using Wide = __int128;  // ISO C++ has no integer of 128 bits

/// A vertex in units of 2^-10 m, the grid of the model.
struct GridPoint {
  std::int64_t x, y, z;
  friend bool operator==(const GridPoint&, const GridPoint&) = default;
};

struct WideVector {
  Wide x, y, z;
};

GridPoint on_grid(const glm::dvec3& v) {
  return {static_cast<std::int64_t>(v.x * 1024), static_cast<std::int64_t>(v.y * 1024),
          static_cast<std::int64_t>(v.z * 1024)};
}

WideVector minus(const GridPoint& a, const GridPoint& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }

WideVector cross(const WideVector& a, const WideVector& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

Wide dot(const WideVector& a, const WideVector& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }

std::vector<GridPoint> corners(culler::SoupView soup, std::size_t polygon) {
  std::vector<GridPoint> result;
  for (const std::uint32_t i : soup.loop(polygon)) result.push_back(on_grid(soup.vertices[i]));
  return result;
}

/// What is wrong with a polygon, in exact arithmetic; empty if nothing is.
std::string fault(std::span<const GridPoint> loop) {
  const std::size_t n = loop.size();
  if (n < 3) return "fewer than three corners";
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t j = i + 1; j < n; ++j) {
      if (loop[i] == loop[j]) return "a corner twice";
    }
  }
  // The normal at the first corner gives the orientation. No three neighbours may be in one line, and none may turn the
  // other way.
  const WideVector normal = cross(minus(loop[1], loop[0]), minus(loop[2], loop[1]));
  if (dot(normal, normal) == 0) return "no area at a corner";
  for (std::size_t i = 0; i < n; ++i) {
    if (dot(normal, minus(loop[i], loop[0])) != 0) return "not plane";
    const WideVector turn = cross(minus(loop[(i + 1) % n], loop[i]), minus(loop[(i + 2) % n], loop[(i + 1) % n]));
    if (dot(normal, turn) <= 0) return "not convex";
    // The loop must be convex, not a star: every corner lies on the inner side of every edge.
    for (std::size_t j = 0; j < n; ++j) {
      const WideVector side = cross(minus(loop[(i + 1) % n], loop[i]), minus(loop[j], loop[i]));
      if (dot(normal, side) < 0) return "not convex";
    }
  }
  return {};
}

class Fnv1a {
 public:
  void add(std::uint64_t value) {
    for (int i = 0; i < 8; ++i) {
      hash_ = (hash_ ^ (value >> (8 * i) & 0xff)) * 0x100000001b3ULL;
    }
  }
  void add(const glm::dvec3& v) {
    for (const double c : {v.x, v.y, v.z}) add(std::bit_cast<std::uint64_t>(c));
  }
  [[nodiscard]] std::uint64_t value() const { return hash_; }

 private:
  std::uint64_t hash_ = 0xcbf29ce484222325ULL;
};

std::uint64_t hash_of(const City& city) {
  Fnv1a hash;
  for (const glm::dvec3& v : city.soup.vertices) hash.add(v);
  for (const std::uint32_t i : city.soup.indices) hash.add(i);
  for (const std::uint32_t i : city.soup.first) hash.add(i);
  for (const CameraPath::Keyframe& k : city.path.keyframes) {
    hash.add(k.eye);
    hash.add(k.target);
  }
  return hash.value();
}

/// Eye of a frame; on purpose not CameraPath::camera, so that this test needs the generator alone.
glm::dvec3 eye_of(const CameraPath& path, std::size_t frame) {
  const double at =
      static_cast<double>(frame) / static_cast<double>(path.frames - 1) * static_cast<double>(path.keyframes.size() - 1);
  const std::size_t i = std::min(static_cast<std::size_t>(at), path.keyframes.size() - 2);
  const double part = at - static_cast<double>(i);
  return path.keyframes[i].eye * (1 - part) + path.keyframes[i + 1].eye * part;
}

double dot(const glm::dvec3& a, const glm::dvec3& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }

double distance_to_segment(const glm::dvec3& p, const glm::dvec3& a, const glm::dvec3& b) {
  const glm::dvec3 d = b - a;
  const double t = std::clamp(dot(p - a, d) / dot(d, d), 0.0, 1.0);
  const glm::dvec3 r = p - (a + d * t);
  return std::sqrt(dot(r, r));
}

glm::dvec3 cross(const glm::dvec3& a, const glm::dvec3& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

double distance_to_polygon(const glm::dvec3& p, culler::SoupView soup, std::size_t polygon) {
  const auto loop = soup.loop(polygon);
  const auto at = [&](std::size_t i) { return soup.vertices[loop[i % loop.size()]]; };
  glm::dvec3 normal = cross(at(1) - at(0), at(2) - at(0));
  normal /= std::sqrt(dot(normal, normal));
  bool inside = true;
  double nearest = 1e30;
  for (std::size_t i = 0; i < loop.size(); ++i) {
    inside = inside && dot(cross(normal, at(i + 1) - at(i)), p - at(i)) >= 0;
    nearest = std::min(nearest, distance_to_segment(p, at(i), at(i + 1)));
  }
  return inside ? std::min(nearest, std::abs(dot(normal, p - at(0)))) : nearest;
}

/// Polygons by the squares of 8 m in plan that their bounds touch.
class PlanGrid {
 public:
  explicit PlanGrid(culler::SoupView soup) {
    for (std::size_t p = 0; p < soup.size(); ++p) {
      glm::dvec3 low = soup.vertices[soup.loop(p)[0]];
      glm::dvec3 high = low;
      for (const std::uint32_t i : soup.loop(p)) {
        const glm::dvec3& v = soup.vertices[i];
        low = {std::min(low.x, v.x), std::min(low.y, v.y), std::min(low.z, v.z)};
        high = {std::max(high.x, v.x), std::max(high.y, v.y), std::max(high.z, v.z)};
      }
      for (int y = square(low.y); y <= square(high.y); ++y) {
        for (int x = square(low.x); x <= square(high.x); ++x) squares_[{x, y}].push_back(p);
      }
    }
  }
  /// Polygons that may be within 8 m of `p` in plan.
  [[nodiscard]] std::vector<std::size_t> around(const glm::dvec3& p) const {
    std::vector<std::size_t> result;
    for (int y = square(p.y) - 1; y <= square(p.y) + 1; ++y) {
      for (int x = square(p.x) - 1; x <= square(p.x) + 1; ++x) {
        if (const auto found = squares_.find({x, y}); found != squares_.end()) {
          result.insert(result.end(), found->second.begin(), found->second.end());
        }
      }
    }
    return result;
  }

 private:
  static int square(double c) { return static_cast<int>(std::floor(c / 8)); }
  std::map<std::pair<int, int>, std::vector<std::size_t>> squares_;
};

TEST(City, IsTheSameForTheSameNumbersAndEverywhere) {
  const City city = generate_city(20'000, 1);
  EXPECT_EQ(hash_of(city), hash_of(generate_city(20'000, 1)));
  EXPECT_NE(hash_of(city), hash_of(generate_city(20'000, 2)));
  // The same from g++ 12 -O2 and clang 14 -O0 on x86-64. Changes whenever the model is changed on purpose.
  EXPECT_EQ(hash_of(city), 0xebb913fe0e3fb623ULL);
  // A model with every kind of detail in the lake and the hills, and with suburbs.
  EXPECT_EQ(hash_of(generate_city(700'000, 7)), 0x552264586fbd3b9cULL);
}

TEST(City, HasAtLeastAsManyPolygonsAsAskedForAndFewMore) {
  for (const std::size_t n : {20'000U, 33'333U, 60'000U, 150'000U, 299'999U, 500'000U, 1'000'000U}) {
    for (const std::uint64_t seed : {1U, 7U}) {
      const std::size_t size = generate_city(n, seed).soup.size();
      EXPECT_GE(size, n) << "seed " << seed;
      EXPECT_LE(size, n + n * 15 / 100) << "seed " << seed;
    }
  }
}

TEST(City, IsMadeOfConvexExactlyPlanePolygonsOnTheGrid) {
  for (const auto& [n, seed] : {std::pair{20'000U, 1U}, std::pair{120'000U, 5U}, std::pair{700'000U, 3U}}) {
    const City city = generate_city(n, seed);
    std::size_t off_grid = 0;
    for (const glm::dvec3& v : city.soup.vertices) {
      for (const double c : {v.x, v.y, v.z}) {
        if (!(std::abs(c) <= 4096) || std::trunc(c * 1024) != c * 1024) ++off_grid;
      }
    }
    EXPECT_EQ(off_grid, 0U) << n;
    std::size_t faults = 0;
    for (std::size_t p = 0; p < city.soup.size(); ++p) {
      const std::vector<GridPoint> loop = corners(city.soup, p);
      const std::string what = fault(loop);
      if (what.empty()) continue;
      if (++faults <= 5)
        ADD_FAILURE() << what << ": polygon " << p << " of " << n << " at " << loop[0].x / 1024 << ' ' << loop[0].y / 1024;
    }
    EXPECT_EQ(faults, 0U) << n;
  }
}

TEST(City, HasTheFlawsOfSoup) {
  const City city = generate_city(1'000'000, 1);
  std::map<std::vector<std::array<double, 3>>, std::size_t> walls;  // large upright polygons by their corners
  std::size_t duplicates = 0;
  std::size_t slivers = 0;
  for (std::size_t p = 0; p < city.soup.size(); ++p) {
    std::vector<std::array<double, 3>> loop;
    for (const std::uint32_t i : city.soup.loop(p)) {
      const glm::dvec3& v = city.soup.vertices[i];
      loop.push_back({v.x, v.y, v.z});
    }
    const glm::dvec3 a = city.soup.vertices[city.soup.loop(p)[1]] - city.soup.vertices[city.soup.loop(p)[0]];
    const glm::dvec3 b = city.soup.vertices[city.soup.loop(p)[2]] - city.soup.vertices[city.soup.loop(p)[1]];
    // Bars of railings are 24 mm wide; a party wall has a side of 9 m or more.
    const double shorter = std::min(dot(a, a), dot(b, b));
    const double longer = std::max(dot(a, a), dot(b, b));
    if (shorter < 0.03 * 0.03 && longer > 40 * 40 * shorter) ++slivers;
    if (longer > 9 * 9 && loop.size() > 4 && walls[loop]++ == 1) ++duplicates;
  }
  EXPECT_GT(duplicates, 100U);
  EXPECT_GT(slivers, 5000U);
}

TEST(City, PathHasThePapersLengthAndEvenSteps) {
  const City city = generate_city(20'000, 1);
  EXPECT_EQ(city.path.frames, 2748U);
  EXPECT_EQ(city.path.interpolation, CameraPath::Interpolation::linear);
  EXPECT_EQ(city.path.fov_y_deg, 60);
  EXPECT_EQ(city.path.near, 0.1);
  ASSERT_GE(city.path.keyframes.size(), 2U);
  std::array<std::size_t, 3> frames{};  // in London, on the lake and island, in the hills
  for (std::size_t f = 0; f < city.path.frames; ++f) {
    const glm::dvec3 eye = eye_of(city.path, f);
    ++frames[eye.x < -18 ? 0 : eye.x < 400 ? 1 : 2];
    if (f == 0) continue;
    const glm::dvec3 step = eye - eye_of(city.path, f - 1);
    EXPECT_LT(std::sqrt(dot(step, step)), 1.5) << f;
    EXPECT_GT(std::sqrt(dot(step, step)), 0.5) << f;
  }
  EXPECT_NEAR(static_cast<double>(frames[0]) / 2748, 0.66, 0.05);
  EXPECT_NEAR(static_cast<double>(frames[1]) / 2748, 0.18, 0.04);
  EXPECT_NEAR(static_cast<double>(frames[2]) / 2748, 0.15, 0.04);
  for (const CameraPath::Keyframe& k : city.path.keyframes) {
    const glm::dvec3 look = k.target - k.eye;
    EXPECT_GT(std::hypot(look.x, look.y), 4);
    EXPECT_LT(std::abs(look.z), 0.5 * std::hypot(look.x, look.y));
  }
}

TEST(City, PathKeepsClearOfEverythingAndFollowsTheGround) {
  for (const auto& [n, seed] :
       {std::pair{20'000U, 1U}, std::pair{90'000U, 9U}, std::pair{500'000U, 1U}, std::pair{800'000U, 4U}}) {
    const City city = generate_city(n, seed);
    const PlanGrid grid(city.soup);
    int failures = 0;
    // Steps are a metre and less, so a clearance of 0.6 m at every frame also means that no wall lies between two frames.
    for (std::size_t f = 0; f < city.path.frames && failures < 5; ++f) {
      const glm::dvec3 eye = eye_of(city.path, f);
      double nearest = 1e30;
      double ground = -1e30;
      for (const std::size_t p : grid.around(eye)) {
        nearest = std::min(nearest, distance_to_polygon(eye, city.soup, p));
        // The height of what lies directly under the eye.
        const auto loop = city.soup.loop(p);
        const auto at = [&](std::size_t i) { return city.soup.vertices[loop[i % loop.size()]]; };
        const glm::dvec3 normal = cross(at(1) - at(0), at(2) - at(0));
        if (normal.z == 0) continue;
        bool under = true;
        for (std::size_t i = 0; i < loop.size(); ++i) {
          const glm::dvec3 d = at(i + 1) - at(i);
          under = under && (d.x * (eye.y - at(i).y) - d.y * (eye.x - at(i).x)) * (normal.z > 0 ? 1 : -1) >= 0;
        }
        const double z = at(0).z - (normal.x * (eye.x - at(0).x) + normal.y * (eye.y - at(0).y)) / normal.z;
        if (under && z < eye.z) ground = std::max(ground, z);
      }
      if (nearest >= 0.6 && std::abs(eye.z - ground - 1.7) <= 0.25) continue;
      ++failures;
      ADD_FAILURE() << "frame " << f << " of " << n << " at " << eye.x << ' ' << eye.y << ' ' << eye.z
                    << ": nearest polygon " << nearest << " m, ground " << ground;
    }
  }
}

}  // namespace city_test
}  // namespace occlude::render
