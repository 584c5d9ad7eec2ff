// SPDX-License-Identifier: MIT
// Faces of any shape against the same polygons in CGAL: what is drawn of them, and what is culled behind them.
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Polygon_2.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <random>
#include <string>
#include <vector>

#include "culler/random_faces.h"
#include "exact_visibility.h"
#include "occlude/culler/culler.h"

namespace occlude {
namespace faces_test {

using culler::Face;
using culler::OpenFace;
using culler::PolygonSoup;
using culler::RandomFaces;
using Exact = CGAL::Exact_predicates_exact_constructions_kernel;
using Polygon = CGAL::Polygon_2<Exact>;
using Point = Exact::Point_2;

Polygon polygon_of(const Face& face) {
  Polygon polygon;
  for (const glm::dvec3& v : face) polygon.push_back(Point(v.x, v.y));
  return polygon;
}

/// A face as CGAL has it.
class ExactFace {
 public:
  explicit ExactFace(const OpenFace& face) : outline_(polygon_of(face.outline)) {
    for (const Face& hole : face.holes) holes_.push_back(polygon_of(hole));
  }

  [[nodiscard]] Exact::FT area() const {
    Exact::FT sum = outline_.area();
    for (const Polygon& hole : holes_) sum += hole.area();  // clockwise, so less
    return sum;
  }
  [[nodiscard]] bool holds(const Point& p) const {
    return outline_.bounded_side(p) != CGAL::ON_UNBOUNDED_SIDE &&
           std::ranges::none_of(holes_, [&](const Polygon& h) { return h.bounded_side(p) == CGAL::ON_BOUNDED_SIDE; });
  }
  [[nodiscard]] bool is_on_border(const Point& p) const {
    const auto is_on = [&](const Polygon& loop) { return loop.bounded_side(p) == CGAL::ON_BOUNDARY; };
    return is_on(outline_) || std::ranges::any_of(holes_, is_on);
  }

 private:
  Polygon outline_;
  std::vector<Polygon> holes_;
};

/// Adds the face with its vertices moved by place().
template <class Place>
void add_face(PolygonSoup& soup, const Face& face, const Place& place) {
  std::vector<std::uint32_t> loop;
  for (const glm::dvec3& v : face) loop.push_back(soup.add_vertex(place(v)));
  ASSERT_NE(soup.add_face(loop), culler::FaceShape::crossing);
}

/// The triangles of a soup of one face, in the lattice of the face.
std::vector<Polygon> triangles_of(const PolygonSoup& soup, const Face& face) {
  std::vector<Polygon> triangles;
  for (std::size_t p = 0; p < soup.size(); ++p) {
    const auto loop = soup.loop(p);
    for (std::size_t i = 1; i + 1 < loop.size(); ++i) {
      triangles.push_back(polygon_of({face[loop[0]], face[loop[i]], face[loop[i + 1]]}));
    }
  }
  return triangles;
}

/// In planes that are aslant to all axes, of a plane's points all but the third coordinate's being whole numbers.
TEST(Faces, DrawnOnceInsideAndNowhereElse) {
  for (std::uint64_t seed = 1; seed <= 300; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    RandomFaces faces(seed);
    const OpenFace face = faces.with_openings();
    const ExactFace exact(face);
    std::mt19937_64 random(seed);
    PolygonSoup soup;
    add_face(soup, face.loop, [&](const glm::dvec3& v) {
      const glm::dvec3 moved{v.x, v.y, 0.5 * v.x - 0.25 * v.y};
      return glm::dvec3{moved[static_cast<int>(seed % 3)], moved[static_cast<int>((seed + 1) % 3)],
                        moved[static_cast<int>((seed + 2) % 3)]};
    });
    const std::vector<Polygon> triangles = triangles_of(soup, face.loop);
    Exact::FT drawn = 0;
    for (const Polygon& triangle : triangles) drawn += CGAL::abs(triangle.area());
    EXPECT_EQ(drawn, exact.area());
    for (int i = 0; i < 100; ++i) {
      const auto coordinate = [&] { return static_cast<double>(random() % 4096) * faces.size() / 4096; };
      const double x = coordinate();
      const Point p(x, coordinate());
      if (exact.is_on_border(p)) continue;
      const auto covers = [&](const Polygon& t) { return t.is_simple() && t.bounded_side(p) == CGAL::ON_BOUNDED_SIDE; };
      const auto touches = [&](const Polygon& t) { return t.is_simple() && t.bounded_side(p) == CGAL::ON_BOUNDARY; };
      const auto times = std::ranges::count_if(triangles, covers);
      EXPECT_TRUE(times == (exact.holds(p) ? 1 : 0) || (times == 0 && std::ranges::any_of(triangles, touches)));
    }
  }
}

/// A face as a wall at x = 8 and small things at x = 16. Seen from the origin, they are at half their coordinates in the
/// wall.
TEST(Faces, NothingIsCulledThatOneSeesThroughTheirOpenings) {
  std::size_t culled_things = 0;
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    RandomFaces faces(seed);
    const OpenFace face = faces.with_openings();
    const ExactFace exact(face);
    const double scale = 8 / faces.size();
    PolygonSoup soup;
    add_face(soup, face.loop, [&](const glm::dvec3& v) { return glm::dvec3{8, scale * v.x - 4, scale * v.y - 4}; });
    const std::size_t walls = soup.size();
    for (double y = -8; y < 8; ++y) {
      for (double z = -8; z < 8; ++z) {
        const std::uint32_t a = soup.add_vertex({16, y, z}), b = soup.add_vertex({16, y + 0.25, z});
        soup.add_polygon(std::array{a, b, soup.add_vertex({16, y, z + 0.25})});
      }
    }
    const culler::Camera camera{.eye = {0, 0, 0}, .target = {1, 0, 0}, .near_plane = 0.1};
    const culler::Culler culler(soup, {.hierarchy = {.leaf_size = 1}});
    const culler::Hierarchy& hierarchy = culler.hierarchy();
    const std::vector<bool> shows = proof::visible_triangles(hierarchy.soup(), camera);
    const std::vector<bool> viewed = culler::polygons_of(
        culler.cull(camera, {.method = culler::Method::frusta, .occluders = 0}).drawn, hierarchy.soup().size());
    for (const auto method : {culler::Method::frusta, culler::Method::cover}) {
      const std::vector<bool> drawn =
          culler::polygons_of(culler.cull(camera, {.method = method, .occluders = 64}).drawn, hierarchy.soup().size());
      for (std::uint32_t p = 0; p < drawn.size(); ++p) {
        if (drawn[p] || !viewed[p] || hierarchy.original(p) < walls) continue;
        ++culled_things;
        EXPECT_FALSE(shows[hierarchy.first_triangle(p)]);
        for (const std::uint32_t v : hierarchy.soup().loop(p)) {
          const glm::dvec3& corner = hierarchy.soup().vertices[v];
          EXPECT_TRUE(exact.holds(Point((corner.y / 2 + 4) / scale, (corner.z / 2 + 4) / scale)));
        }
      }
    }
  }
  EXPECT_GT(culled_things, 1000U);
}

}  // namespace faces_test
}  // namespace occlude
