// SPDX-License-Identifier: MIT
#include "border.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <map>
#include <set>

namespace occlude::proof {
namespace {

using Corner = std::array<double, 3>;

Corner corner(const kernel::Vec3& v) { return {v.x + 0, v.y + 0, v.z + 0}; }  // adding 0 makes -0 equal to 0

/// For each edge, how often it occurs from the lesser end to the greater, minus how often it occurs in the other direction.
class Edges {
 public:
  void add(const Polygon& loop, int times) {
    for (std::size_t i = 0; i < loop.size(); ++i) {
      const Corner a = corner(loop[i]), b = corner(loop[(i + 1) % loop.size()]);
      if (a < b) count_[{a, b}] += times;
      if (b < a) count_[{b, a}] -= times;
    }
  }
  [[nodiscard]] bool cancel() const {
    return std::ranges::all_of(count_, [](const auto& edge) { return edge.second == 0; });
  }

 private:
  std::map<std::array<Corner, 2>, int> count_;
};

}  // namespace

bool have_border(std::span<const Polygon> parts, const Polygon& loop) {
  Edges edges;
  edges.add(loop, -1);
  std::set<Corner> corners;
  for (const kernel::Vec3& v : loop) corners.insert(corner(v));
  for (const Polygon& part : parts) {
    edges.add(part, 1);
    if (!std::ranges::all_of(part, [&](const kernel::Vec3& v) { return corners.contains(corner(v)); })) return false;
  }
  return edges.cancel();
}

}  // namespace occlude::proof
