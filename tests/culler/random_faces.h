// SPDX-License-Identifier: MIT
// Faces on a lattice in the plane z = 0: areas and sides are exact.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <glm/vec3.hpp>
#include <random>
#include <utility>
#include <vector>

namespace occlude::culler {

using Face = std::vector<glm::dvec3>;

/// Twice the area as seen along z, positive where the corners turn counter-clockwise.
[[nodiscard]] inline double area(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c) {
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}
[[nodiscard]] inline double area(const Face& face) {
  double sum = 0;
  for (std::size_t i = 1; i + 1 < face.size(); ++i) sum += area(face[0], face[i], face[i + 1]);
  return sum;
}

[[nodiscard]] inline bool is_on(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& p) {
  return area(a, b, p) == 0 && std::min(a.x, b.x) <= p.x && p.x <= std::max(a.x, b.x) && std::min(a.y, b.y) <= p.y &&
         p.y <= std::max(a.y, b.y);
}

[[nodiscard]] inline bool cross(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c, const glm::dvec3& d) {
  return area(a, b, c) * area(a, b, d) < 0 && area(c, d, a) * area(c, d, b) < 0;
}

[[nodiscard]] inline bool meet(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c, const glm::dvec3& d) {
  return cross(a, b, c, d) || is_on(a, b, c) || is_on(a, b, d) || is_on(c, d, a) || is_on(c, d, b);
}

/// Whether no edge touches another one but where they follow each other.
[[nodiscard]] inline bool is_simple(const Face& face) {
  const std::size_t n = face.size();
  for (std::size_t i = 0; i < n; ++i) {
    const glm::dvec3 &a = face[i], &b = face[(i + 1) % n], &c = face[(i + 2) % n];
    if (is_on(a, b, c) || is_on(b, c, a)) return false;
    for (std::size_t j = i + 2; j < n; ++j) {
      if ((j + 1) % n != i && meet(a, b, face[j], face[(j + 1) % n])) return false;
    }
  }
  return true;
}

/// A face with openings.
struct OpenFace {
  Face loop;                ///< with keyholes
  Face outline;             ///< counter-clockwise
  std::vector<Face> holes;  ///< clockwise
};

class RandomFaces {
 public:
  explicit RandomFaces(std::uint64_t seed) : random_(seed), size_(1U << (3 + random_() % 7)) {}

  /// All coordinates are whole numbers from 0 to below this power of two.
  [[nodiscard]] double size() const { return static_cast<double>(size_); }

  /// Random corners, with crossings undone.
  Face outline(std::size_t least, std::size_t most) {
    for (;;) {
      Face face(least + random_() % (most - least));
      for (glm::dvec3& corner : face) corner = point();
      while (undo_crossing(face)) {
      }
      if (is_simple(face)) return face;
    }
  }

  /// A face counter-clockwise, and triangles cut out of it where random ones fit, each joined by a keyhole.
  OpenFace with_openings() {
    OpenFace result;
    Face face = outline(4, 16);
    if (area(face) < 0) std::ranges::reverse(face);
    result.outline = face;
    for (int tries = 0; tries < 60; ++tries) {
      const glm::dvec3 near = point();
      Face hole{near, near + step(), near + step()};
      if (area(hole) > 0) std::ranges::reverse(hole);
      const std::size_t outer = random_() % face.size();
      if (!fits(face, hole) || !sees(face, outer, hole)) continue;
      result.holes.push_back(hole);
      hole.push_back(hole[0]);
      hole.push_back(face[outer]);
      face.insert(face.begin() + static_cast<std::ptrdiff_t>(outer) + 1, hole.begin(), hole.end());
    }
    std::rotate(face.begin(), face.begin() + static_cast<std::ptrdiff_t>(random_() % face.size()), face.end());
    result.loop = std::move(face);
    return result;
  }

 private:
  glm::dvec3 point() {
    const auto coordinate = [&] { return static_cast<double>(random_() % size_); };
    const double x = coordinate();
    return {x, coordinate(), 0};
  }

  glm::dvec3 step() {
    const auto size = static_cast<double>(size_ / 8);
    return {static_cast<double>(random_() % size_ / 4) - size, static_cast<double>(random_() % size_ / 4) - size, 0};
  }

  static bool undo_crossing(Face& face) {
    const std::size_t n = face.size();
    for (std::size_t i = 0; i + 2 < n; ++i) {
      for (std::size_t j = i + 2; j < n; ++j) {
        if (!cross(face[i], face[i + 1], face[j], face[(j + 1) % n])) continue;
        std::reverse(face.begin() + static_cast<std::ptrdiff_t>(i) + 1, face.begin() + static_cast<std::ptrdiff_t>(j) + 1);
        return true;
      }
    }
    return false;
  }

  /// Calls visit(a, b) for each edge of a loop.
  template <class Visit>
  static bool all_edges(const Face& loop, const Visit& visit) {
    for (std::size_t i = 0; i < loop.size(); ++i) {
      if (!visit(loop[i], loop[(i + 1) % loop.size()])) return false;
    }
    return true;
  }

  static bool is_inside(const Face& face, const glm::dvec3& p) {
    bool inside = false;
    all_edges(face, [&](const auto& a, const auto& b) {
      if ((a.y <= p.y) != (b.y <= p.y) && (area(a, b, p) > 0) == (b.y > a.y)) inside = !inside;
      return true;
    });
    return inside;
  }

  /// Whether the hole lies in the face and has none of its openings in it.
  static bool fits(const Face& face, const Face& hole) {
    const auto is_clear = [&](const auto& a, const auto& b) {
      return is_inside(face, a) && all_edges(face, [&](const auto& c, const auto& d) { return !meet(a, b, c, d); });
    };
    const auto is_outside = [&](const glm::dvec3& p) {
      return !all_edges(hole, [&](const auto& a, const auto& b) { return area(a, b, p) <= 0; });
    };
    return area(hole) != 0 && all_edges(hole, is_clear) && std::ranges::all_of(face, is_outside);
  }

  /// Whether nothing is between a corner of the face, inside of it, and the first corner of the hole.
  static bool sees(const Face& face, std::size_t outer, const Face& hole) {
    const glm::dvec3 &from = face[outer], &to = hole[0];
    const glm::dvec3 &before = face[(outer + face.size() - 1) % face.size()], &after = face[(outer + 1) % face.size()];
    const bool left = area(before, from, to) > 0, right = area(from, after, to) > 0;
    if (area(before, from, after) > 0 ? !(left && right) : !(left || right)) return false;
    const auto is_clear = [&](const auto& a, const auto& b) {
      if (a != from && b != from && a != to && b != to) return !meet(from, to, a, b);
      const glm::dvec3& other = a == from || a == to ? b : a;
      return !is_on(from, to, other) && !(a == from || b == from ? is_on(a, b, to) : is_on(a, b, from));
    };
    return all_edges(face, is_clear) && all_edges(hole, is_clear);
  }

  std::mt19937_64 random_;
  std::uint64_t size_;
};

}  // namespace occlude::culler
