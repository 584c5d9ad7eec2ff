// SPDX-License-Identifier: MIT
// What proves that polygons are hidden from boxes of eyes, or from outside, and what does not, worked out by hand.
#include "hidden_proof.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <random>
#include <string>
#include <vector>

#include "culler/scenes.h"
#include "hidden_claims.h"
#include "seed.h"

namespace occlude::proof {
namespace hidden_proof_test {

using culler::PolygonSoup;
using kernel::Aabb;

TEST(IsCovered, ByBoxesSideBySide) {
  const Aabb box{{0, 0, 0}, {4, 4, 4}};
  EXPECT_TRUE(is_covered(box, {box}));
  EXPECT_FALSE(is_covered(box, {}));
  EXPECT_TRUE(is_covered(box, {{{-1, 0, 0}, {2, 4, 9}}, {{2, 0, -1}, {5, 4, 4}}}));
  EXPECT_FALSE(is_covered(box, {{{-1, 0, 0}, {2, 4, 9}}, {{std::nextafter(2, 3), 0, -1}, {5, 4, 4}}}));
  // Five that turn around the middle, and that without the middle.
  std::vector<Aabb> turning{{{0, 0, 0}, {3, 1, 4}}, {{3, 0, 0}, {4, 3, 4}}, {{1, 3, 0}, {4, 4, 4}}, {{0, 1, 0}, {1, 4, 4}}};
  EXPECT_FALSE(is_covered(box, turning));
  turning.push_back({{1, 1, 0}, {3, 3, 4}});
  EXPECT_TRUE(is_covered(box, turning));
}

TEST(IsCovered, FlatBoxes) {
  const Aabb flat{{0, 0, 2}, {4, 4, 2}}, point{{1, 1, 1}, {1, 1, 1}};
  EXPECT_TRUE(is_covered(flat, {{{0, 0, 2}, {2, 4, 5}}, {{2, 0, 0}, {4, 4, 2}}}));
  EXPECT_FALSE(is_covered(flat, {{{0, 0, 2}, {2, 4, 5}}, {{2, 0, 0}, {4, 4, 1}}}));
  EXPECT_TRUE(is_covered(point, {{{0, 0, 1}, {1, 1, 3}}}));
  EXPECT_FALSE(is_covered(point, {{{0, 0, 2}, {1, 1, 3}}}));
  EXPECT_FALSE(is_covered({{0, 0, 0}, {4, 4, 4}}, {{{0, 0, 2}, {4, 4, 2}}})) << "a flat box covers only flat ones";
}

/// Against points of a grid, between whose lines there are no faces.
TEST(IsCovered, RandomBoxes) {
  std::mt19937 random(seed_of(8301));
  int covered = 0;
  for (int trial = 0; trial < 2000; ++trial) {
    const auto some = [&](int most) {
      Aabb box;
      for (int axis = 0; axis < 3; ++axis) {
        const int a = static_cast<int>(random() % static_cast<unsigned>(most)),
                  b = static_cast<int>(random() % static_cast<unsigned>(most));
        box.min[axis] = std::min(a, b);
        box.max[axis] = std::max(a, b);
      }
      return box;
    };
    const Aabb box = some(4);
    std::vector<Aabb> by;
    for (int i = 0; i < 8; ++i) by.push_back(some(5));
    bool expected = true;
    for (double x = box.min.x; x <= box.max.x; x += 0.5) {
      for (double y = box.min.y; y <= box.max.y; y += 0.5) {
        for (double z = box.min.z; z <= box.max.z; z += 0.5) {
          bool is_in = false;
          for (const Aabb& b : by) {
            is_in = is_in || (b.min.x <= x && x <= b.max.x && b.min.y <= y && y <= b.max.y && b.min.z <= z && z <= b.max.z);
          }
          expected = expected && is_in;
        }
      }
    }
    EXPECT_EQ(is_covered(box, by), expected);
    covered += expected ? 1 : 0;
  }
  EXPECT_GT(covered, 100);
}

/// As seen from |x|, |y|, |z| <= 1/4, a wall of two halves at x = 2 hides polygon 2 at x = 6, and not polygon 3. The last
/// polygon is see-through. Far aside is a cube, with a triangle in it, and one that divides it.
class Hidden : public testing::Test {
 protected:
  Hidden() {
    culler::add(soup_, {{2, -2, -2}, {2, 0, -2}, {2, 0, 2}, {2, -2, 2}});
    culler::add(soup_, {{2, 0, -2}, {2, 2, -2}, {2, 2, 2}, {2, 0, 2}});
    culler::add(soup_, {{6, -1, -1}, {6, 1, -1}, {6, 1, 1}, {6, -1, 1}});
    culler::add(soup_, {{6, 8, -1}, {6, 9, -1}, {6, 9, 1}, {6, 8, 1}});
    culler::add(soup_, {{-3, -9, -9}, {-2, 9, -9}, {-2, 9, 9}, {-3, -9, 9}});
    const auto at = [](unsigned i) { return glm::dvec3(i & 1U ? 48 : 40, i & 2U ? 8 : 0, i & 4U ? 8 : 0); };
    for (const auto& side : std::vector<std::array<unsigned, 4>>{
             {0, 4, 6, 2}, {1, 3, 7, 5}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 2, 3, 1}, {4, 5, 7, 6}}) {
      culler::add(soup_, {at(side[0]), at(side[1]), at(side[2]), at(side[3])});  // 5 to 10
    }
    culler::add(soup_, {{41, 1, 1}, {42, 1, 1}, {41, 2, 1}, {41, 1, 2}});  // 11
    culler::add(soup_, {at(0), at(3), at(7), at(4)});                      // 12
    soup_.see_through = {0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0};
  }

  [[nodiscard]] std::string fault(const std::string& line) const {
    const auto hierarchy = culler::Hierarchy::build(soup_, {.leaf_size = 1});
    return HiddenProver(hierarchy).prove(line).failure;
  }
  /// By the wall.
  [[nodiscard]] static std::string by_wall(const std::string& hidden = "2", const std::string& from = kCell,
                                           const std::string& more = kWindows, const std::string& eyes = kEyes,
                                           const std::string& drawn = "[1,0,0,0]") {
    return fmt::format(R"({{"hidden":[{}],"box":{{"min":[6,-1,-1],"max":[6,1,1]}},"from":{},{},"drawn":{},{}}})", hidden,
                       from, eyes, drawn, more);
  }
  static std::string by_shell(const std::string& hidden, const std::string& shell = "5,6,7,8,9,10") {
    return fmt::format(R"({{"hidden":[{}],"shell":[{}]}})", hidden, shell);
  }
  /// What of claims and lines is proved: "2 of 3", and the first that is not.
  [[nodiscard]] std::string settled(const std::vector<std::string>& lines) const {
    const auto hierarchy = culler::Hierarchy::build(soup_, {.leaf_size = 1});
    const HiddenProver prover(hierarchy);
    HiddenClaims claims(prover.polygons());
    for (const std::string& line : lines) {
      HiddenLine proved = prover.prove(line);
      EXPECT_EQ(proved.failure, "") << line;
      claims.add(std::move(proved));
    }
    const HiddenClaims::Settled result = claims.settle({});
    std::string text = fmt::format("{} of {}", result.proved, result.claimed);
    if (result.first) text += fmt::format("; {} {} {}", result.first->claim, result.first->box, result.first->face);
    return text;
  }

  PolygonSoup soup_;
  static constexpr const char* kCell = R"({"min":[-0.25,-0.25,-0.25],"max":[0.25,0.25,0.25]})";
  static constexpr const char* kEyes = R"("eyes":{"center":[0,0,0],"half_edges":[[0.25,0,0],[0,0.25,0],[0,0,0.25]]})";
  static constexpr const char* kWindows =
      R"("focus":{"point":[2,0,0],"normal":[1,0,0],"right":[0,-1,0]},"windows":[{"rect":[-0.6,-0.6,0.6,0.6],"polygons":[0,1]}])";
};

TEST_F(Hidden, IsProvedFromABoxOfEyes) {
  EXPECT_EQ(fault(by_wall()), "");
  EXPECT_EQ(fault(by_wall("3")), "a polygon is not in the box");
  EXPECT_EQ(fault(by_wall("2,13")), "no such polygon");
  EXPECT_EQ(fault(by_wall("2", R"({"min":[-0.25,-0.25,-0.25],"max":[0.25,0.25,0.26]})")), "an eye is not in the region");
  EXPECT_EQ(fault(by_wall("2", R"({"min":[0,0,0],"max":[0,0,0]})")), "") << "a part of the eyes";
  const std::string windows = kWindows;
  const auto with = [&](const std::string& polygons) {
    return windows.substr(0, windows.find("[0,1]}]")) + polygons + "}]";
  };
  EXPECT_EQ(fault(by_wall("2", kCell, with("[1,0]"))), "");
  EXPECT_EQ(fault(by_wall("2", kCell, with("[0]"))), "window 0: the border of the sheet shows before the focus plane");
  EXPECT_EQ(fault(by_wall("2", kCell, with("[0,1,4]"))), "a see-through polygon hides nothing");
  EXPECT_EQ(fault(by_wall("2", R"({"min":[0,0,0],"max":[0,0,0.5]})", kWindows,
                          R"("eyes":{"center":[0,0,0],"half_edges":[[1,0,0],[0,1,0],[0,0,1]]})")),
            "the windows do not cover what the box is seen through");
  EXPECT_EQ(fault(by_wall("2", kCell, kWindows, kEyes, "[1,0,0,-3]")), "window 0: the sheet is met an even number of times")
      << "nothing of the wall is drawn";
  EXPECT_EQ(fault(by_wall("2", kCell, kWindows, kEyes, "[0,0,0,1]")), "") << "all of it";
  EXPECT_NE(fault(by_wall("2", kCell, kWindows, kEyes, R"(["nan",0,0,0])")), "");
  for (const char* line : {R"({"hidden":[2]})", R"({"hidden":2,"shell":[]})", R"({"frame":0})"}) {
    EXPECT_THROW(fault(line), LineError) << line;
  }
  EXPECT_THROW(fault(by_wall("2", R"({"min":[1,0,0],"max":[0,0,0]})")), LineError);
  EXPECT_THROW(fault(by_wall("2", kCell, kWindows, kEyes, "[1,0,0]")), LineError);
}

TEST_F(Hidden, IsProvedFromAnEye) {
  constexpr const char *kEye = R"("eye":[0,0,0])", *kPoint = R"({"min":[0,0,0],"max":[0,0,0]})";
  EXPECT_EQ(fault(by_wall("2", kPoint, R"("polygons":[0,1])", kEye)), "");
  EXPECT_EQ(fault(by_wall("2", kPoint, R"("polygons":[0])", kEye)), "the polygons do not hide the box");
  EXPECT_EQ(fault(by_wall("2", kCell, R"("polygons":[0,1])", kEye)), "the eye is not all of the box");
}

TEST_F(Hidden, IsProvedByAClosedShell) {
  EXPECT_EQ(fault(by_shell("[11,1],[11,2]")), "");
  EXPECT_EQ(fault(by_shell("[11,1]", "5,6,7,8,9")), "the shell is not closed");
  EXPECT_EQ(fault(by_shell("[3,1]")), "it is outside of the shell");
  EXPECT_EQ(fault(by_shell("[5,1]")), "the shell meets it");
  EXPECT_EQ(fault(by_shell("[11,3]")), "no such triangle");
  EXPECT_EQ(fault(by_shell("[11,1]", "5,6,7,8,9,10,4")), "a see-through polygon hides nothing");
  EXPECT_EQ(fault(by_shell("[12,1],[12,2]")), "") << "it touches, which a claim may forbid";
}

TEST_F(Hidden, ClaimsAreProvedWhereBoxesCoverTheirs) {
  const auto claim = [](const std::string& faces, const std::string& from) {
    return fmt::format(R"({{"claim":[{}],"from":[{}]}})", faces, from);
  };
  const std::string low = R"({"min":[-0.25,-0.25,-0.25],"max":[0.25,0.25,0]})",
                    high = R"({"min":[-0.25,-0.25,0],"max":[0.25,0.25,0.25]})",
                    above = R"({"min":[-0.25,-0.25,0],"max":[0.25,0.25,0.5]})";
  EXPECT_EQ(settled({claim("[2,1]", kCell), by_wall()}), "1 of 1");
  EXPECT_EQ(settled({claim("[2,1]", kCell), by_wall("2", low), by_wall("2", high)}), "1 of 1");
  EXPECT_EQ(settled({claim("[2,1]", kCell), by_wall("2", low)}), "0 of 1; 0 0 2");
  EXPECT_EQ(settled({claim("[2,1]", low + "," + above), by_wall()}), "1 of 2; 0 1 2");
  EXPECT_EQ(settled({claim("[2,2]", low), by_wall()}), "1 of 2; 0 0 3");
  EXPECT_EQ(settled({claim("[2,1]", low), claim("[2,1]", above), by_wall()}), "1 of 2; 1 0 2");
  EXPECT_EQ(settled({claim("[11,1]", kCell), by_shell("[11,1],[11,2]")}), "0 of 1; 0 0 11") << "only from outside";
  EXPECT_THROW(fault(claim("[12,2]", kCell)), LineError);
  EXPECT_THROW(fault(claim("[2,1],[2,1]", kCell)), LineError);
  EXPECT_THROW(fault(R"({"claim":[[2,1]]})"), LineError);
}

TEST_F(Hidden, ClaimsFromOutside) {
  const auto claim = [](const std::string& faces, const char* more = "") {
    return fmt::format(R"({{"claim":[{}],"outside":{{"min":[-99,-99,-99],"max":[99,99,99]}}{}}})", faces, more);
  };
  EXPECT_EQ(settled({claim("[11,1]"), by_shell("[11,1],[11,2]")}), "1 of 1");
  for (const char* one : {"[11,1]", "[11,2]"}) EXPECT_EQ(settled({claim("[11,1]"), by_shell(one)}), "0 of 1; 0 0 11");
  EXPECT_EQ(settled({claim("[11,2]"), by_shell("[11,1],[11,2],[12,1],[12,2]")}), "1 of 2; 0 0 12") << "it touches";
  EXPECT_EQ(settled({claim("[11,2]", R"(,"touching":true)"), by_shell("[11,1],[11,2],[12,1],[12,2]")}), "2 of 2");
  EXPECT_THROW(fault(R"({"claim":[],"outside":{"min":[-9,-9,-9],"max":[47,9,9]}})"), LineError) << "not around the model";
  EXPECT_THROW(fault(R"({"claim":[],"from":[],"touching":true})"), LineError);
}

/// What the wall hides and what it does not are one face.
TEST_F(Hidden, FacesOfSeveralPieces) {
  soup_.faces = {0, 1, 2, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11};
  EXPECT_EQ(fault(by_wall("[2,0]")), "");
  EXPECT_EQ(fault(by_wall("2")), "no such polygon");
  EXPECT_EQ(settled({fmt::format(R"({{"claim":[[2,1]],"from":[{}]}})", kCell), by_wall("[2,0]")}), "0 of 1; 0 0 2");
}

}  // namespace hidden_proof_test
}  // namespace occlude::proof
