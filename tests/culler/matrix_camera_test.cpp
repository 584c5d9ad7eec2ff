// SPDX-License-Identifier: MIT
// Cameras that are matrices: what a matrix shows is decided in exact arithmetic on its own numbers, and none of it is
// culled.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>
#include <iostream>
#include <limits>
#include <numbers>
#include <optional>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include "camera/frame_view.h"
#include "camera/shadow_margin.h"
#include "camera/single_precision.h"
#include "frames.h"
#include "model/bounds.h"
#include "occlude/culler/camera.h"
#include "occlude/culler/culler.h"
#include "occlude/kernel/convex_polytope.h"
#include "occlude/kernel/half_space.h"
#include "occlude/kernel/overlap.h"
#include "occlude/kernel/shadow_frustum.h"
#include "occlude/kernel/validity.h"
#include "sanitized.h"
#include "scenes.h"
#include "seed.h"

namespace matrix_camera_test {

using namespace occlude;
using namespace occlude::culler;
using glm::dvec3;
using occlude::seed_of;
using occlude::unless_sanitized;

/// The sign of a sum of products, exactly. REQUIRES: no product overflows or has bits below 2^-1074.
template <std::size_t N>
int sign_of_sum(const std::array<std::array<double, 2>, N>& products) {
  double sum = 0, size = 0;
  for (const auto& [a, b] : products) {
    sum += a * b;
    size += std::fabs(a * b);
  }
  if (std::fabs(sum) > 0x1p-46 * size) return sum > 0 ? 1 : -1;
  std::array<double, 2 * N> terms{};  // do not overlap, in the order of their magnitudes (Shewchuk's grow expansion)
  std::size_t count = 0;
  const auto grow = [&](double b) {
    for (std::size_t i = 0; i < count; ++i) {
      const double s = b + terms[i], of_term = s - b;
      terms[i] = (b - (s - of_term)) + (terms[i] - of_term);
      b = s;
    }
    terms[count++] = b;
  };
  for (const auto& [a, b] : products) {
    const double high = a * b;
    grow(std::fma(a, b, -high));
    grow(high);
  }
  for (std::size_t i = count; i-- > 0;) {
    if (terms[i] != 0) return terms[i] > 0 ? 1 : -1;
  }
  return 0;
}

TEST(SignOfSum, IsExact) {
  using Products = std::array<std::array<double, 2>, 3>;
  EXPECT_EQ(sign_of_sum(Products{{{1 + 0x1p-52, 1 - 0x1p-52}, {-1, 1}, {0x1p-52, 0x1p-52}}}), 0);
  EXPECT_EQ(sign_of_sum(Products{{{1 + 0x1p-52, 1 - 0x1p-52}, {-1, 1}, {0x1p-52, 0x1p-53}}}), -1);
  EXPECT_EQ(sign_of_sum(Products{{{1e30, 1e30}, {-1e30, 1e30}, {1e-30, 1e-30}}}), 1);
}

/// The sign of scale * w + sign * row at a point, exactly.
int side(const MatrixCamera& camera, int row, double sign, double of_w, const dvec3& p) {
  std::array<std::array<double, 2>, 8> products{};
  for (int k = 0; k < 4; ++k) {
    const double coordinate = k < 3 ? p[k] : 1;
    products[static_cast<std::size_t>(2 * k)] = {of_w * camera.matrix[k][3], coordinate};
    products[static_cast<std::size_t>(2 * k + 1)] = {sign * camera.matrix[k][row], coordinate};
  }
  return sign_of_sum(products);
}

/// Whether a point is in the clip volume, exactly.
bool shows(const MatrixCamera& camera, const dvec3& p) {
  for (int row = 0; row < 3; ++row) {
    if (side(camera, row, -1, 1, p) < 0) return false;
    if (side(camera, row, 1, row == 2 && camera.depth == ClipDepth::zero_to_w ? 0 : 1, p) < 0) return false;
  }
  return true;
}

constexpr unsigned kMatrices = unless_sanitized(10'000U, 1000U);

/// Three perpendicular unit vectors. Some are along the axes, but for what sines and cosines leave.
std::array<dvec3, 3> some_turn(std::mt19937& random) {
  if (random() % 4 == 0) {
    std::array<dvec3, 3> axes{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
    for (int turn = 0; turn < 3; ++turn) {
      const double angle = static_cast<double>(random() % 4) * std::numbers::pi / 2;
      const int a = static_cast<int>(random() % 3), b = (a + 1) % 3;
      for (dvec3& v : axes) {
        const double x = v[a], y = v[b];
        v[a] = x * std::cos(angle) - y * std::sin(angle);
        v[b] = x * std::sin(angle) + y * std::cos(angle);
      }
    }
    return axes;
  }
  for (;;) {
    const dvec3 a = random_point(random), b = random_point(random);
    if (glm::length(glm::cross(a, b)) < 0.1) continue;
    const dvec3 forward = glm::normalize(a), right = glm::normalize(glm::cross(a, b));
    return {right, glm::cross(right, forward), forward};
  }
}

enum class Kind { finite, infinite, reversed, reversed_infinite, oblique, parallel, parallel_reversed, sheared };
constexpr std::array kKinds{Kind::finite,  Kind::infinite, Kind::reversed,          Kind::reversed_infinite,
                            Kind::oblique, Kind::parallel, Kind::parallel_reversed, Kind::sheared};

bool is_parallel(Kind kind) { return kind >= Kind::parallel; }

/// A camera, and what it was made of. As it is rounded, they are not quite the same.
struct Made {
  MatrixCamera camera;
  Kind kind;
  double near, far;
  std::function<dvec3(double x, double y, double forward)> place;  ///< at a place in the picture, this far away
  std::string name;
};

Made some_camera(std::mt19937& random, std::optional<Kind> wanted = std::nullopt) {
  const Kind kind = wanted ? *wanted : kKinds[random() % kKinds.size()];
  const auto turn = some_turn(random);
  dvec3 right = turn[0], up = turn[1], forward = turn[2];
  if (random() % 2 == 0) right = -right;  // of either handedness
  const double away = std::array{0.0, 10.0, 10.0, 1e4}[random() % 4];
  const dvec3 eye = random_point(random, away);
  const double near = uniform(random, 0.05, 2), far = near * uniform(random, 20, 2000);
  const double x = uniform(random, 0.2, 3), y = uniform(random, 0.2, 3);  // half of the picture
  const bool is_off_centre = random() % 2 == 0;
  const double off_x = is_off_centre ? uniform(random, -1.5, 1.5) : 0,
               off_y = is_off_centre ? uniform(random, -1.5, 1.5) : 0;
  const bool is_zero_to_w = random() % 2 == 0;

  struct Row {
    dvec3 normal;
    double constant;
  };
  std::array<Row, 4> rows{};
  const bool parallel = is_parallel(kind);
  const double shear = kind == Kind::sheared ? uniform(random, -0.5, 0.5) : 0;
  if (parallel) {
    rows[3] = {dvec3(0), 1};
    rows[0] = {(right + shear * forward) / (10 * x), off_x};
    rows[1] = {up / (10 * y), off_y};
  } else {
    rows[3] = {forward, 0};
    rows[0] = {right / x + off_x * forward, 0};
    rows[1] = {up / y + off_y * forward, 0};
  }
  const double range = far - near;
  if (parallel) {
    const Row zero_to_one{forward / range, -near / range};
    rows[2] = is_zero_to_w ? zero_to_one : Row{2.0 * zero_to_one.normal, 2 * zero_to_one.constant - 1};
    if (kind == Kind::parallel_reversed) {
      rows[2] = is_zero_to_w ? Row{-rows[2].normal, 1 - rows[2].constant} : Row{-rows[2].normal, -rows[2].constant};
    }
  } else if (kind == Kind::oblique) {
    dvec3 normal = glm::normalize(forward + uniform(random, 0, 1.5) * random_point(random));
    if (random() % 2 == 0)
      normal = glm::normalize(up + uniform(random, -0.2, 0.2) * random_point(random));  // a mirror of water
    const double at_corner = glm::dot(normal, far * forward + far * x * right + far * y * up) - near;
    const double scale = (is_zero_to_w ? 1 : 2) * far / std::max(std::fabs(at_corner), 0.1 * far);
    rows[2] = {scale * normal, -scale * near};
    if (!is_zero_to_w) rows[2].normal -= forward;
  } else {
    const bool is_infinite = kind == Kind::infinite || kind == Kind::reversed_infinite;
    double a = is_infinite ? 1 : far / range,
           b = is_infinite ? -near : -far * near / range;  // a + b / distance, from 0 to 1
    if (kind == Kind::reversed || kind == Kind::reversed_infinite) {
      a = 1 - a;
      b = -b;
    }
    rows[2] = is_zero_to_w ? Row{a * forward, b} : Row{(2 * a - 1) * forward, 2 * b};
  }

  const double scale = random() % 4 == 0 ? std::ldexp(uniform(random, 1, 2), static_cast<int>(random() % 40) - 20) : 1;
  std::array<double, 16> numbers{};
  for (std::size_t r = 0; r < 4; ++r) {
    for (int k = 0; k < 3; ++k) numbers[4 * r + static_cast<std::size_t>(k)] = scale * rows[r].normal[k];
    numbers[4 * r + 3] = scale * (rows[r].constant - glm::dot(rows[r].normal, eye));
  }
  const ClipDepth depth = is_zero_to_w ? ClipDepth::zero_to_w : ClipDepth::minus_w_to_w;
  const Nearer nearer = !parallel ? Nearer::unsaid : kind == Kind::parallel_reversed ? Nearer::greater : Nearer::less;
  Made made;
  const bool is_float = random() % 2 == 0;
  if (is_float) {
    std::array<float, 16> floats{};
    std::ranges::transform(numbers, floats.begin(), [](double number) { return static_cast<float>(number); });
    made.camera = MatrixCamera::from_rows(floats.data(), depth, nearer);
  } else {
    made.camera = MatrixCamera::from_rows(numbers.data(), depth, nearer);
  }
  made.kind = kind;
  made.near = near;
  made.far = far;
  made.name = "kind " + std::to_string(static_cast<int>(kind)) + (is_zero_to_w ? ", 0 to w" : ", -w to w") +
              (is_float ? ", floats" : ", doubles") + ", eye within " + std::to_string(away);
  if (parallel) {
    made.place = [=](double px, double py, double t) {
      return eye + t * forward + (10 * x * (px - off_x) - shear * t) * right + 10 * y * (py - off_y) * up;
    };
  } else {
    made.place = [=](double px, double py, double t) {
      return eye + t * (forward + x * (px - off_x) * right + y * (py - off_y) * up);
    };
  }
  return made;
}

/// The last point of a set on the way from one in it to one that is not.
template <class IsIn>
dvec3 last_in(const IsIn& is_in, dvec3 in, dvec3 out) {
  for (;;) {
    const dvec3 middle = 0.5 * (in + out);
    if (middle == in || middle == out) return in;
    (is_in(middle) ? in : out) = middle;
  }
}

/// The last point that shows on the way from one that shows to one that does not.
dvec3 touching(const MatrixCamera& camera, const dvec3& shown, const dvec3& hidden) {
  return last_in([&](const dvec3& p) { return shows(camera, p); }, shown, hidden);
}

double reach(const dvec3& v) { return std::fabs(v.x) + std::fabs(v.y) + std::fabs(v.z); }

/// Points that show, half of them within rounding of a clip plane.
std::vector<dvec3> shown_points(std::mt19937& random, const Made& made, std::size_t count) {
  std::vector<dvec3> points;
  for (int tries = 0; points.size() < count && tries < 60; ++tries) {
    const double distance = made.near * std::exp(uniform(random, 0, std::log(made.far / made.near)));
    const dvec3 point = made.place(uniform(random, -1, 1), uniform(random, -1, 1), distance) + random_point(random, 1e-6);
    if (!shows(made.camera, point)) continue;
    points.push_back(point);
    const dvec3 beside = point + random_point(random, 8 * distance);
    if (!shows(made.camera, beside)) points.push_back(touching(made.camera, point, beside));
  }
  return points;
}

bool keeps(const HalfSpace& h, const dvec3& p) {
  return kernel::relation(to_kernel(h), kernel::Aabb{to_kernel(p), to_kernel(p)}, kernel::Arithmetic::certified) !=
         kernel::Relation::outside;
}

TEST(MatrixCamera, NothingShownIsBeyondAHalfSpace) {
  const std::uint32_t seed = seed_of(1);
  std::cout << "seed " << seed << "\n";
  std::mt19937 random(seed);
  std::array<int, kKinds.size()> tight{}, seen{};
  for (unsigned i = 0; i < kMatrices; ++i) {
    const Made made = some_camera(random);
    ASSERT_EQ(fault(made.camera), "") << made.name << ", camera " << i;
    const std::vector<dvec3> points = shown_points(random, made, 6);
    double depth = 0;
    for (const dvec3& p : points) depth = std::max(depth, reach(p - made.camera.eye()));
    std::vector<HalfSpace> planes;
    append_view_frustum(made.camera, depth, planes);
    ASSERT_LE(planes.size(), 6U);
    const auto kind = static_cast<std::size_t>(made.kind);
    for (const HalfSpace& h : planes) {
      ASSERT_NEAR(glm::length(h.normal), 1, 1e-12);
      double least = std::numeric_limits<double>::infinity();
      for (const dvec3& p : points) {
        ASSERT_TRUE(keeps(h, p)) << made.name << ", camera " << i;
        least = std::min(least, glm::dot(h.normal, p) + h.offset);
      }
      // The error of this sum is far below the margin, except far away.
      EXPECT_GT(least, 0.999 * 0x1p-20 * depth - 0x1p-50 * reach(made.camera.eye())) << made.name << ", camera " << i;
      tight[kind] += least < 0x1p-18 * depth ? 1 : 0;
    }
    seen[kind] += static_cast<int>(points.size());
  }
  for (std::size_t kind = 0; kind < kKinds.size(); ++kind) {
    EXPECT_GT(seen[kind], static_cast<int>(kMatrices / 2)) << "kind " << kind;
    EXPECT_GT(tight[kind], static_cast<int>(kMatrices / 10)) << "kind " << kind;
  }
}

/// The camera with its eye moved by e.
MatrixCamera moved_by(const MatrixCamera& camera, const dvec3& e) {
  MatrixCamera moved = camera;
  for (int row = 0; row < 4; ++row) {
    for (int axis = 0; axis < 3; ++axis) moved.matrix[3][row] -= camera.matrix[axis][row] * e[axis];
  }
  return moved;
}

/// Where the eye is far from the origin, and the model small and next to it, it is the coordinates of the eye that rounding
/// moves planes by, also planes that pass the origin.
TEST(MatrixCamera, SidesHoldNextToAnEyeThatIsFarAway) {
  std::mt19937 random(9);
  constexpr double kDepth = 1e-7;
  int asked = 0;
  for (int i = 0; i < 2000; ++i) {
    const Made made = some_camera(random, i % 2 == 0 ? Kind::finite : Kind::infinite);
    const int row = i / 2 % 2;
    const double sign = i / 4 % 2 == 0 ? 1 : -1;
    // From the origin far along a ray of one side of the picture.
    const double x = row == 0 ? -sign : uniform(random, -1, 1), y = row == 1 ? -sign : uniform(random, -1, 1);
    const dvec3 ray = made.place(x, y, 1e4) - made.place(x, y, 0);
    const MatrixCamera camera = moved_by(made.camera, ray - made.place(x, y, 0));
    const dvec3 eye = camera.eye();
    std::vector<HalfSpace> planes;
    append_view_frustum(camera, kDepth, planes);
    const auto is_in = [&](const dvec3& p) { return side(camera, row, sign, 1, p) >= 0; };
    const dvec3 a = eye + random_point(random, kDepth / 3), b = eye + random_point(random, kDepth / 3);
    if (is_in(a) == is_in(b)) continue;
    ++asked;
    ASSERT_TRUE(keeps(planes.at(static_cast<std::size_t>(2 * row + (sign > 0 ? 0 : 1))),
                      is_in(a) ? last_in(is_in, a, b) : last_in(is_in, b, a)))
        << made.name << ", camera " << i;
  }
  EXPECT_GT(asked, 500);
}

/// The eye, or the direction, of a camera in higher precision where the machine has it.
class Sight {
 public:
  using Real = long double;
  using Vector = glm::vec<3, Real>;

  explicit Sight(const MatrixCamera& camera, bool parallel) : camera_(camera), is_parallel_(parallel) {
    const auto normal = [&](int row) {
      return Vector(Real{camera.matrix[0][row]}, Real{camera.matrix[1][row]}, Real{camera.matrix[2][row]});
    };
    const Vector x = normal(0), y = normal(1), last = parallel ? normal(2) : normal(3);
    const Real determinant = glm::dot(x, glm::cross(y, last));
    const auto meeting = [&](Real a, Real b, Real c) {
      return -(a * glm::cross(y, last) + b * glm::cross(last, x) + c * glm::cross(x, y)) / determinant;
    };
    eye_ = parallel ? glm::cross(x, y) : meeting(camera.matrix[3][0], camera.matrix[3][1], camera.matrix[3][3]);
    const bool is_turned = (glm::dot(eye_, normal(2)) > 0) != (camera.nearer == Nearer::less);
    if (parallel && is_turned) eye_ = -eye_;
  }

  [[nodiscard]] const Vector& eye() const { return eye_; }  ///< or the direction

  /// Whether the point certainly shows: nothing of the triangles that shows, or nearly so, is between, or nearly so.
  [[nodiscard]] bool sees(const dvec3& point, const std::vector<std::array<dvec3, 3>>& triangles) const {
    return shows(camera_, point) &&
           std::ranges::none_of(triangles, [&](const auto& triangle) { return may_hide(triangle, point); });
  }

 private:
  [[nodiscard]] bool may_hide(const std::array<dvec3, 3>& triangle, const dvec3& point) const {
    const Vector p(point), a(triangle[0]), b(triangle[1]), c(triangle[2]);
    const Vector from = is_parallel_ ? p - Real{1e5} * glm::normalize(eye_) : eye_, way = p - from;
    const Vector u = b - a, v = c - a, normal = glm::cross(u, v);
    const Real across = glm::dot(normal, way);
    if (std::fabs(across) < Real{1e-9} * glm::length(normal) * glm::length(way)) return true;
    const Real share = glm::dot(normal, a - from) / across;
    const Vector hit = from + share * way;
    if (share < 0 || share > 1 - Real{1e-12}) return false;
    const Real area = glm::dot(normal, normal);
    const Real of_b = glm::dot(glm::cross(hit - a, v), normal) / area,
               of_c = glm::dot(glm::cross(u, hit - a), normal) / area;
    constexpr Real kNearly = 1e-9;
    if (of_b < -kNearly || of_c < -kNearly || of_b + of_c > 1 + kNearly) return false;
    // Between the eye and the near plane it is not drawn. What is hit a little nearer may be.
    return shows(camera_, dvec3(hit)) || shows(camera_, dvec3(hit + Real{1e-6} * (p - hit)));
  }

  const MatrixCamera& camera_;
  bool is_parallel_;
  Vector eye_{};
};

/// A wall, and small triangles about it. The first corner of each is what is looked for.
struct Stage {
  PolygonSoup soup;
  std::vector<std::array<dvec3, 3>> triangles;  ///< all, fan after fan
  std::vector<dvec3> points;                    ///< of the small ones: those of polygon 1 and following

  void add_wall(const std::array<dvec3, 4>& corners) {
    add(soup, {corners[0], corners[1], corners[2], corners[3]});
    triangles.push_back({corners[0], corners[1], corners[2]});
    triangles.push_back({corners[0], corners[2], corners[3]});
  }
  void add_point(std::mt19937& random, const dvec3& point, double size) {
    if (kernel::check(to_kernel(point)) != kernel::Refusal::none) return;
    const std::array<dvec3, 3> corners{point, point + random_point(random, size), point + random_point(random, size)};
    add(soup, {corners[0], corners[1], corners[2]});
    triangles.push_back(corners);
    points.push_back(point);
  }
};

/// The wall stands in the middle, sometimes at the near plane or through it. The points are behind it, at the border of its
/// shadow within `beside` of it, or anywhere that shows.
Stage some_stage(std::mt19937& random, const Made& made, double beside) {
  Stage stage;
  const double at = made.near * (random() % 3 == 0 ? uniform(random, 0.7, 1.4) : uniform(random, 1.5, 6));
  const bool is_slanted = random() % 2 == 0;
  const double low_x = uniform(random, -0.7, -0.3), low_y = uniform(random, -0.7, -0.3);
  const double high_x = uniform(random, 0.3, 0.7), high_y = uniform(random, 0.3, 0.7);
  std::array<dvec3, 4> corners{};
  for (std::size_t i = 0; i < 4; ++i) {
    const double t = is_slanted && i > 1 ? at * 1.5 : at;  // two corners, so that the wall is flat with parallel rays alone
    corners[i] = made.place(i == 0 || i == 3 ? low_x : high_x, i < 2 ? low_y : high_y, t);
    for (int axis = 0; axis < 3; ++axis) {
      if (std::fabs(corners[i][axis]) < kernel::kMinMagnitude) corners[i][axis] = 0;
    }
  }
  stage.add_wall(corners);
  const auto distance = [&] { return at * uniform(random, 2, 12); };
  for (int i = 0; i < 5; ++i) {
    const double t = distance();
    stage.add_point(random, made.place(uniform(random, low_x, high_x), uniform(random, low_y, high_y), t), 1e-4 * t);
  }
  for (int i = 0; i < 8; ++i) {
    const double t = distance(), off = uniform(random, -1, 1) * beside, across = uniform(random, low_y, high_y);
    const double border = i % 2 == 0 ? low_x : high_x;
    stage.add_point(random, made.place(border + off, across, t), 1e-6 * t);
  }
  for (const dvec3& point : shown_points(random, made, 6)) stage.add_point(random, point, 1e-6 * made.near);
  return stage;
}

Culler culler_of(const PolygonSoup& soup) {
  return Culler(soup, {.hierarchy = {.leaf_size = 1}, .lists = {.threshold = 1e-6, .regions = 1}});
}

/// For each point of the stage, whether its polygon is drawn.
std::vector<bool> drawn_points(const Culler& culler, const CullResult& frame) {
  const std::vector<bool> in_order = drawn_polygons(culler, frame);
  std::vector<bool> drawn(in_order.size() - 1);
  for (std::uint32_t p = 0; p < in_order.size(); ++p) {
    if (const std::uint32_t original = culler.hierarchy().original(p); original > 0) drawn[original - 1] = in_order[p];
  }
  return drawn;
}

CullOptions options_of(Method method) {
  CullOptions options{.method = Method::frusta};
  options.method = method;
  options.cover.width = 256;
  options.cover.height = 192;
  return options;
}

std::size_t hidden_in(const CullResult& frame) { return frame.stats.shadow_culled_polygons; }

TEST(MatrixCamera, NothingVisibleIsCulled) {
  const std::uint32_t seed = seed_of(2);
  std::cout << "seed " << seed << "\n";
  std::mt19937 random(seed);
  std::array<std::size_t, kKinds.size()> visible{}, by_frusta{}, by_cover{};
  for (unsigned i = 0; i < kMatrices; ++i) {
    const Kind kind = kKinds[static_cast<std::size_t>(i) % kKinds.size()];
    const auto k = static_cast<std::size_t>(kind);
    const Made made = some_camera(random, kind);
    const Sight sight(made.camera, is_parallel(kind));
    const Stage stage = some_stage(random, made, i % 3 == 0 ? 0.01 : 1e-5);
    const Culler culler = culler_of(stage.soup);
    for (const Method method : {Method::frusta, Method::cover}) {
      const CullResult frame = culler.cull(made.camera, options_of(method));
      const std::vector<bool> drawn = drawn_points(culler, frame);
      for (std::size_t p = 0; p < stage.points.size(); ++p) {
        if (drawn[p]) continue;
        ASSERT_FALSE(sight.sees(stage.points[p], stage.triangles))
            << made.name << ", camera " << i << ", point " << p << ", method " << static_cast<int>(method);
      }
      (method == Method::frusta ? by_frusta : by_cover)[k] += hidden_in(frame);
    }
    for (const dvec3& point : stage.points) visible[k] += sight.sees(point, stage.triangles) ? 1 : 0;
  }
  for (std::size_t kind = 0; kind < kKinds.size(); ++kind) {
    std::cout << "kind " << kind << ": visible " << visible[kind] << ", culled by frusta " << by_frusta[kind]
              << ", by cover " << by_cover[kind] << "\n";
    EXPECT_GT(visible[kind], kMatrices / 2U) << "kind " << kind;
    EXPECT_GT(by_frusta[kind], kMatrices / 10U) << "kind " << kind;
    EXPECT_GT(by_cover[kind], kMatrices / 10U) << "kind " << kind;
  }
}

/// What a renderer in single precision computes of a row relative to the eye.
float in_floats(const MatrixCamera& camera, int row, const dvec3& point) {
  const dvec3 eye = camera.eye();
  double constant = camera.matrix[3][row];
  for (int k = 0; k < 3; ++k) constant += camera.matrix[k][row] * eye[k];
  float sum = 0;
  for (int k = 0; k < 3; ++k) sum += static_cast<float>(camera.matrix[k][row]) * static_cast<float>(point[k] - eye[k]);
  return sum + static_cast<float>(constant);
}

bool shows_in_floats(const MatrixCamera& camera, const dvec3& p) {
  const float x = in_floats(camera, 0, p), y = in_floats(camera, 1, p), z = in_floats(camera, 2, p),
              w = in_floats(camera, 3, p);
  return -w <= x && x <= w && -w <= y && y <= w && (camera.depth == ClipDepth::zero_to_w ? 0 : -w) <= z && z <= w;
}

TEST(MatrixCamera, NothingShownInSinglePrecisionIsBeyondAHalfSpace) {
  const std::uint32_t seed = seed_of(5);
  std::cout << "seed " << seed << "\n";
  std::mt19937 random(seed);
  unsigned beyond = 0;
  for (unsigned i = 0; i < kMatrices / 5; ++i) {
    const Made made = some_camera(random);
    std::vector<dvec3> points;
    for (int tries = 0; tries < 30; ++tries) {
      const dvec3 at = made.place(uniform(random, -1, 1), uniform(random, -1, 1), made.far * uniform(random, 0.9, 1.1));
      const dvec3 shown = made.place(0, 0, (made.near + made.far) / 2);
      if (!shows(made.camera, shown) || shows(made.camera, at)) continue;
      const dvec3 border = touching(made.camera, shown, at);
      points.push_back(border + uniform(random, 0, 1e-4) * (at - border));
      points.push_back(border + uniform(random, 0, 1e-6) * (at - border));
    }
    double depth = 0;
    for (const dvec3& p : points) depth = std::max(depth, reach(p - made.camera.eye()));
    std::vector<HalfSpace> planes;
    append_view_frustum(made.camera, depth, planes);
    // A view whose model reaches less far is asked about the points.
    PolygonSoup soup;
    const dvec3 middle = made.place(0.1, 0.1, 2 * made.near) + random_point(random, 1e-3);
    add(soup, {middle, middle + random_point(random, 0.1), middle + random_point(random, 0.1)});
    View view;
    Culler(soup, {.lists = {.regions = 1}}).cull(made.camera, {}, view);
    for (const dvec3& p : points) {
      if (!shows_in_floats(made.camera, p)) continue;
      beyond += shows(made.camera, p) ? 0U : 1U;
      ASSERT_NE(view.visibility(kernel::Aabb{to_kernel(p), to_kernel(p)}), Visibility::out_of_view)
          << made.name << ", camera " << i;
      for (const HalfSpace& h : planes) ASSERT_GE(glm::dot(h.normal, p) + h.offset, 0) << made.name << ", camera " << i;
    }
  }
  EXPECT_GT(beyond, kMatrices / 20) << "that do not show in real numbers";
}

/// The depth of parallel rays changes little over a small model. Then single precision rounds it by what it is at the eye.
TEST(MatrixCamera, NothingShownOfASmallModelIsBeyondTheNearPlaneOfParallelRays) {
  std::mt19937 random(10);
  int beyond = 0;
  for (int i = 0; i < 2000; ++i) {
    const Made made = some_camera(
        random, std::array{Kind::parallel, Kind::parallel_reversed, Kind::sheared}[static_cast<std::size_t>(i % 3)]);
    const double range = made.far - made.near;
    const dvec3 eye = made.camera.eye(), inwards = made.place(0, 0, 1) - made.place(0, 0, 0);
    const dvec3 near_eye = eye + random_point(random, 1e-4 * range);
    const auto is_shown = [&](const dvec3& p) { return shows(made.camera, p); };
    const dvec3 border = last_in(is_shown, near_eye + 1e-3 * range * inwards, near_eye - 1e-3 * range * inwards);
    const dvec3 p = border - uniform(random, 0, 1e-7) * range * inwards;
    if (!is_shown(border) || is_shown(p) || !shows_in_floats(made.camera, p)) continue;
    ++beyond;
    std::vector<HalfSpace> planes;
    append_view_frustum(made.camera, reach(p - eye), planes);
    for (const HalfSpace& h : planes) ASSERT_TRUE(keeps(h, p)) << made.name << ", camera " << i;
  }
  EXPECT_GT(beyond, 100);
}

TEST(MatrixCamera, KnowsHowFarItsEyeMayBeOff) {
  std::mt19937 random(6);
  int off = 0;
  for (int i = 0; i < 4000; ++i) {
    const Made made = some_camera(random);
    const double depth = uniform(random, 1, 100);
    const FrameView view(made.camera, depth);
    const Sight sight(made.camera, is_parallel(made.kind));
    Sight::Real distance = 0;
    if (is_parallel(made.kind)) {
      const auto direction = glm::normalize(sight.eye()), forward = Sight::Vector(view.axes.forward);
      distance = Sight::Real{depth} * glm::length(direction - forward);
    } else {
      distance = glm::length(sight.eye() - Sight::Vector(view.eye));
    }
    ASSERT_LE(distance, view.eye_uncertainty) << made.name << ", camera " << i;
    ASSERT_LT(view.eye_uncertainty, 1e-9 * (depth + reach(view.eye))) << made.name << ", camera " << i;
    off += distance > 0x1p-12 * view.eye_uncertainty ? 1 : 0;
  }
  EXPECT_GT(off, 1000);
}

/// Parallel rays may meet after all, very far away: w may change by as much as single numbers may. The farther eyes are from
/// the middle one, the more their rays are turned.
TEST(MatrixCamera, KnowsHowMuchRaysAreTurnedThatAreNearlyParallel) {
  using Vector = Sight::Vector;
  std::mt19937 random(11);
  int turned = 0;
  for (int i = 0; i < 4000; ++i) {
    const auto [right, up, forward] = some_turn(random);
    const double size = std::ldexp(1, 72 + static_cast<int>(random() % 20));
    const dvec3 w = 0.99 * 0x1p-106 * random_point(random);
    std::array<double, 16> numbers{};
    const auto set = [&](std::size_t row, const dvec3& normal, double constant) {
      for (std::size_t k = 0; k < 3; ++k) numbers[4 * row + k] = normal[static_cast<int>(k)];
      numbers[4 * row + 3] = constant;
    };
    set(0, right / size, 0);
    set(1, up / size, 0);
    set(2, forward / size, 0);
    set(3, w, 1);
    MatrixCamera camera = MatrixCamera::from_rows(numbers.data(), ClipDepth::zero_to_w, Nearer::less);
    camera.eyes.radius = i % 4 == 0 ? 0 : std::ldexp(size, static_cast<int>(random() % 8));
    ASSERT_EQ(fault(camera), "");
    const FrameView view(camera, size);
    ASSERT_FALSE(view.is_perspective);
    // From a point of the model to another along a ray of some eye: as far aside as points may be moved.
    const auto value = [&](int row, const Vector& p) {
      const auto at = [&](int column) { return Sight::Real{camera.matrix[column][row]}; };
      return at(0) * p.x + at(1) * p.y + at(2) * p.z + at(3);
    };
    const dvec3 point = random_point(random, size / 3), eye = camera.eyes.radius * glm::normalize(random_point(random));
    const Vector p = Vector(point) - Vector(eye), n(w);
    const Vector ray = glm::normalize(glm::cross(Vector(right / size) * value(3, p) - value(0, p) * n,
                                                 Vector(up / size) * value(3, p) - value(1, p) * n)),
                 sight(view.axes.forward);
    const Sight::Real aside = Sight::Real{size} * glm::length(ray - glm::dot(ray, sight) / glm::dot(sight, sight) * sight);
    ASSERT_LE(aside, 2 * view.eye_uncertainty) << "camera " << i;
    turned += aside > view.eye_uncertainty / 16 ? 1 : 0;
  }
  EXPECT_GT(turned, 100);
}

/// A shadow less what an eye that may be elsewhere takes away holds boxes that are in the shadow from all these eyes.
TEST(MatrixCamera, ShadowsHoldForWhereverTheEyeMayBe) {
  std::mt19937 random(8);
  constexpr double kOff = 0.05;
  FrameView view(Camera{.eye = {0, 0, 0}, .target = {1, 0, 0}}, 100);
  view.eye_uncertainty = kOff;
  const ShadowMargin margin(view, 0);
  int kept = 0, lost = 0, wrong = 0;
  for (int i = 0; i < 4000; ++i) {
    const double slant = uniform(random, 0, 1), size = uniform(random, 0.5, 2);
    const std::vector<kernel::Vec3> wall{
        {2, -size, -size}, {2 + slant, size, -size}, {2 + slant, size, size}, {2, -size, size}};
    const bool is_solid = i % 2 == 0;  // a roof whose edge is nearer than its silhouette
    std::optional<kernel::ConvexPolytope> solid;
    if (is_solid) {
      std::vector<kernel::Vec3> corners = wall;
      corners.push_back({uniform(random, 0.5, 1.9), uniform(random, -0.2, 0.2), uniform(random, -0.2, 0.2)});
      solid = kernel::ConvexPolytope::make({corners, {{0, 1, 2, 3}, {0, 1, 4}, {1, 2, 4}, {2, 3, 4}, {3, 0, 4}}}).polytope;
      if (!solid) continue;
    }
    const auto shadow_from = [&](const dvec3& eye) {
      const auto viewpoint = kernel::Viewpoint::eye(to_kernel(eye));
      return is_solid ? kernel::ShadowFrustum::make(viewpoint, *solid, kernel::Near::surface).frustum
                      : kernel::ShadowFrustum::make(viewpoint, wall, kernel::Near::surface).frustum;
    };
    const double x = uniform(random, 2, 8);
    const kernel::Vec3 low{x, uniform(random, -size, size) * x / 2, uniform(random, -size, size) * x / 2};
    const kernel::Aabb box{low, {low.x + 0.1, low.y + 0.1, low.z + 0.1}};
    const auto is_in = [&](const kernel::ShadowFrustum& shadow) {
      return kernel::overlap_certified(shadow, box, kernel::NearBoundary::open).relation == kernel::Relation::inside;
    };
    const auto shadow = shadow_from({0, 0, 0});
    if (!shadow || !is_in(*shadow)) continue;
    bool is_in_all = true;
    for (int e = 0; e < 24; ++e) {
      const auto other = shadow_from(0.999 * kOff * glm::normalize(random_point(random)));
      ASSERT_TRUE(other);
      is_in_all = is_in_all && is_in(*other);
    }
    const bool keeps = margin.keeps(*shadow, box);
    ASSERT_TRUE(!keeps || is_in_all) << "shadow " << i;
    kept += keeps ? 1 : 0;
    lost += is_in_all ? 0 : 1;
    wrong += is_in_all && !keeps ? 1 : 0;
  }
  EXPECT_GT(kept, 500);
  EXPECT_GT(lost, 30);
  EXPECT_LT(wrong, kept);
}

/// What a picture shows beside its line of sight is culled as what is in the middle.
TEST(MatrixCamera, CullsInAnOffCentrePicture) {
  PolygonSoup soup;
  add(soup, {{2, -6, -1}, {2, -2, -1}, {2, -2, 1}, {2, -6, 1}});  // at slopes of 1 to 3 to the right
  add(soup, {{6, -13, -1}, {6, -11, -1}, {6, -11, 1}, {6, -13, 1}});
  add(soup, {{6, -5, -1}, {6, -4, -1}, {6, -4, 1}, {6, -5, 1}});
  const Culler culler = culler_of(soup);
  const std::array<double, 16> rows{-2, -1, 0, 0, 0, 0, 1, 0, 1, 0, 0, -0.2, 1, 0, 0, 0};
  const MatrixCamera camera = MatrixCamera::from_rows(rows.data(), ClipDepth::minus_w_to_w);
  for (const Method method : {Method::frusta, Method::cover}) {
    const CullResult frame = culler.cull(camera, options_of(method));
    EXPECT_TRUE(is_drawn(culler, frame, 0)) << static_cast<int>(method);
    EXPECT_FALSE(is_drawn(culler, frame, 1)) << static_cast<int>(method);
    EXPECT_EQ(frame.culled.size(), 2U) << "the third is beside the picture";
    EXPECT_EQ(hidden_in(frame), 1U);
  }
}

TEST(MatrixCamera, NothingVisibleFromAnyOfItsEyesIsCulled) {
  const std::uint32_t seed = seed_of(3);
  std::cout << "seed " << seed << "\n";
  std::mt19937 random(seed);
  std::size_t culled = 0, from_others = 0;
  for (int i = 0; i < 800; ++i) {
    Made made = some_camera(random, kKinds[static_cast<std::size_t>(i) % kKinds.size()]);
    const double radius = made.near * uniform(random, 0.02, 0.3);
    const Stage stage = some_stage(random, made, 0.2);
    made.camera.eyes.radius = radius;
    const Culler culler = culler_of(stage.soup);
    const CullResult frame = culler.cull(made.camera, options_of(Method::cover));
    const std::vector<bool> drawn = drawn_points(culler, frame);
    culled += hidden_in(frame);
    const Sight middle(made.camera, is_parallel(made.kind));
    for (int e = 0; e < 16; ++e) {
      // Less than the radius by more than the matrix of the other eye is rounded by.
      const dvec3 off = (1 - 1e-6) * radius * glm::normalize(random_point(random));
      const MatrixCamera other = moved_by(made.camera, off);
      const Sight sight(other, is_parallel(made.kind));
      for (std::size_t p = 0; p < stage.points.size(); ++p) {
        const bool is_seen = sight.sees(stage.points[p], stage.triangles);
        ASSERT_TRUE(drawn[p] || !is_seen) << made.name << ", camera " << i << ", eye " << e << ", point " << p;
        from_others += is_seen && !middle.sees(stage.points[p], stage.triangles) ? 1 : 0;
      }
    }
  }
  std::cout << "culled " << culled << ", seen from other eyes alone " << from_others << "\n";
  EXPECT_GT(culled, 500U);
  EXPECT_GT(from_others, 1000U);
}

/// A Camera that has a matrix.
Camera random_camera_with_matrix(std::mt19937& random) {
  Camera camera = random_camera(random);
  if (camera.projection == Projection::orthographic && std::isinf(camera.far_plane)) camera.far_plane = 1e4;
  return camera;
}

/// Where the matrix shows a point: x, y and z over w.
dvec3 shown_at(const MatrixCamera& camera, const dvec3& point) {
  const glm::dvec4 clip = camera.matrix * glm::dvec4(point, 1);
  return dvec3(clip) / clip.w;
}

/// The point of the camera's picture at x and y in [-1, 1], this far along the line of sight.
dvec3 point_at(const Camera& camera, double x, double y, double distance) {
  const auto [right, up, forward] = camera.axes();
  const bool is_perspective = camera.projection == Projection::perspective;
  const double half = is_perspective ? distance * std::tan(camera.fov_y_deg * std::numbers::pi / 360) : camera.height / 2;
  return camera.eye + half * camera.aspect * x * right + half * y * up + distance * forward;
}

TEST(MatrixCamera, OfACameraShowsWhatItShows) {
  std::mt19937 random(11);
  for (int i = 0; i < 200; ++i) {
    Camera camera = random_camera_with_matrix(random);
    camera.fov_y_deg = uniform(random, 1, 170);
    camera.aspect = uniform(random, 0.3, 3);
    for (const ClipDepth depth : {ClipDepth::minus_w_to_w, ClipDepth::zero_to_w}) {
      for (const Nearer nearer : {Nearer::less, Nearer::greater}) {
        const MatrixCamera made = MatrixCamera::from_camera(camera, depth, nearer);
        ASSERT_EQ(fault(made), "");
        EXPECT_TRUE(made.depth == depth && made.nearer == nearer && made.eyes.radius == 0);
        const double least = depth == ClipDepth::zero_to_w ? 0 : -1;
        const double at_near = nearer == Nearer::less ? least : 1, at_far = nearer == Nearer::less ? 1 : least;
        const double far = std::min(camera.far_plane, 1e13);  // so far that depths are those of infinity
        const double x = uniform(random, -1, 1), y = uniform(random, -1, 1);
        for (const auto& [distance, z] : {std::pair{camera.near_plane, at_near}, {far, at_far}}) {
          const dvec3 shown = shown_at(made, point_at(camera, x, y, distance));
          // Rounding of the eye, some 45 of its distance, at the near plane of 0.1.
          EXPECT_NEAR(shown.x, x, 1e-10);
          EXPECT_NEAR(shown.y, y, 1e-10);
          EXPECT_NEAR(shown.z, z, 1e-10);
        }
      }
    }
  }
}

TEST(MatrixCamera, OfACameraAtTheOriginIsAProjection) {
  Camera lens{.eye = {0, 0, 0}, .target = {0, 0, -1}, .up = {0, 1, 0}, .fov_y_deg = 90, .aspect = 2, .near_plane = 0.25};
  const auto rows = [&](ClipDepth depth, Nearer nearer) {
    return glm::transpose(MatrixCamera::from_camera(lens, depth, nearer).matrix);
  };
  const auto expect_row = [](const glm::dvec4& row, const glm::dvec4& expected) {
    for (int k = 0; k < 4; ++k) EXPECT_NEAR(row[k], expected[k], 1e-15);
  };
  const glm::dmat4 endless = rows(ClipDepth::zero_to_w, Nearer::greater);
  expect_row(endless[0], {0.5, 0, 0, 0});
  expect_row(endless[1], {0, 1, 0, 0});
  expect_row(endless[2], {0, 0, 0, 0.25});
  expect_row(endless[3], {0, 0, -1, 0});
  lens.far_plane = 1;
  expect_row(rows(ClipDepth::minus_w_to_w, Nearer::less)[2], {0, 0, -5.0 / 3, -2.0 / 3});  // glFrustum
}

TEST(MatrixCamera, OfNoCameraIsRefused) {
  const auto made = [](const Camera& camera, Nearer nearer) {
    return refusal([&] { static_cast<void>(MatrixCamera::from_camera(camera, ClipDepth::zero_to_w, nearer)); });
  };
  EXPECT_EQ(made({.aspect = -1}, Nearer::less), fault(Camera{.aspect = -1}));
  EXPECT_EQ(made({.projection = Projection::orthographic}, Nearer::less),
            "parallel rays without a far plane have no matrix");
  EXPECT_EQ(made({}, Nearer::unsaid), "which depths are nearer is not said");
}

TEST(MatrixCamera, CullsAsTheCameraDoes) {
  std::mt19937 random(4);
  const Culler culler(random_town_of_houses(4, 2000), {.hierarchy = {.leaf_size = 4}});
  std::array<std::size_t, 2> by_camera{}, by_matrix{}, viewed_by_camera{}, viewed_by_matrix{};
  for (int i = 0; i < 60; ++i) {
    const Camera camera = random_camera_with_matrix(random);
    const MatrixCamera matrix = MatrixCamera::from_camera(camera, ClipDepth::zero_to_w, Nearer::less);
    for (const Method method : {Method::frusta, Method::cover}) {
      const auto m = static_cast<std::size_t>(method);
      const CullStats a = culler.cull(camera, options_of(method)).stats;
      const CullStats b = culler.cull(matrix, options_of(method)).stats;
      by_camera[m] += a.shadow_culled_polygons;
      by_matrix[m] += b.shadow_culled_polygons;
      viewed_by_camera[m] += a.view_culled_polygons;
      viewed_by_matrix[m] += b.view_culled_polygons;
    }
  }
  for (std::size_t m = 0; m < 2; ++m) {
    EXPECT_GT(by_camera[m], 1000U);
    EXPECT_NEAR(static_cast<double>(by_matrix[m]) / static_cast<double>(by_camera[m]), 1, 0.01) << m;
    EXPECT_NEAR(static_cast<double>(viewed_by_matrix[m]) / static_cast<double>(viewed_by_camera[m]), 1, 0.001) << m;
  }
}

/// A camera at the origin that looks along +x, up is z: w = x. The rows are those of x, y, z, w.
std::array<double, 16> along_x(double depth_slope, double depth_constant) {
  return {0, -1, 0, 0, 0, 0, 1, 0, depth_slope, 0, 0, depth_constant, 1, 0, 0, 0};
}

/// A cover closes pixels of a border too, where boxes may reach beyond the camera's picture: as many again in the smallest
/// coarse picture. What hides is not clipped there either.
TEST(MatrixCamera, NothingHidesBeforeTheNearPlaneInABorder) {
  std::mt19937 random(12);
  std::array<int, 2> across{};
  for (std::size_t i = 0; i < 8000; ++i) {
    const Made made = some_camera(random, i % 2 == 0 ? Kind::oblique : Kind::sheared);
    const FrameView view(made.camera, made.far);
    ASSERT_TRUE(!view.is_perspective || view.near > view.eye_uncertainty + kSinglePrecision * view.depth)
        << "where places have errors";
    if (view.is_oblique) continue;
    ++across[i % 2];
    const glm::dmat3 along = glm::inverse(glm::transpose(glm::dmat3(view.axes.right, view.axes.up, view.axes.forward)));
    for (const auto& [x, y] : {std::pair{-2, -2}, {-2, 2}, {2, -2}, {2, 2}}) {
      const double depth = view.is_perspective ? view.near : 1;
      const dvec3 p = view.eye + along * dvec3(x * view.half_width * depth, y * view.half_height * depth, view.near);
      ASSERT_FALSE(view.may_clip(p)) << made.name << ", camera " << i;
    }
  }
  EXPECT_GT(across[0], 100);
  EXPECT_GT(across[1], 20);
}

/// A wall before the near plane hides nothing, one beyond hides, whichever way depth runs.
TEST(MatrixCamera, KnowsTheNearPlaneOfEveryDepth) {
  struct Depth {
    ClipDepth clip;
    double slope, constant;
    const char* name;
  };
  constexpr double kNear = 1, kFar = 100;
  for (const auto& [clip, slope, constant, name] :
       {Depth{ClipDepth::minus_w_to_w, (kFar + kNear) / (kFar - kNear), -2 * kFar * kNear / (kFar - kNear), "OpenGL"},
        Depth{ClipDepth::zero_to_w, kFar / (kFar - kNear), -kFar * kNear / (kFar - kNear), "Vulkan"},
        Depth{ClipDepth::zero_to_w, -kNear / (kFar - kNear), kFar * kNear / (kFar - kNear), "reversed"},
        Depth{ClipDepth::zero_to_w, 0, kNear, "reversed, infinite"},
        Depth{ClipDepth::minus_w_to_w, 1, -2 * kNear, "infinite"}}) {
    const MatrixCamera camera = MatrixCamera::from_rows(along_x(slope, constant).data(), clip);
    ASSERT_EQ(fault(camera), "") << name;
    for (const Method method : {Method::frusta, Method::cover}) {
      for (const bool is_beyond : {false, true}) {
        PolygonSoup soup;
        const double at = is_beyond ? 1.01 : 0.99;
        add_wall(soup, at, -0.5 * at, 0.5 * at, -0.5 * at, 0.5 * at);
        add_wall(soup, 9, -1, 1, -1, 1);
        add_wall(soup, 9, 5, 6, -1, 1);
        const Culler culler = culler_of(soup);
        const CullResult frame = culler.cull(camera, options_of(method));
        EXPECT_EQ(is_drawn(culler, frame, 1), !is_beyond) << name << ", method " << static_cast<int>(method);
        EXPECT_EQ(is_drawn(culler, frame, 0), is_beyond) << name << ", method " << static_cast<int>(method);
        EXPECT_TRUE(is_drawn(culler, frame, 2)) << name;
      }
    }
    std::vector<HalfSpace> planes;
    append_view_frustum(camera, 100, planes);
    const bool is_infinite = slope == 0 || slope == 1;
    EXPECT_EQ(planes.size(), is_infinite ? 5U : 6U) << name << ": an infinite far plane is none";
  }
}

/// A shadow map of a light that shines along -z on a floor with a roof above it. Depth runs along the light, or reversed.
TEST(MatrixCamera, IsAShadowMap) {
  PolygonSoup soup;
  add(soup, {{-2, -2, 5}, {2, -2, 5}, {2, 2, 5}, {-2, 2, 5}});  // the roof
  add(soup, {{-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}});  // the floor below it
  add(soup, {{5, 5, 0}, {6, 5, 0}, {6, 6, 0}, {5, 6, 0}});      // beside it
  const Culler culler = culler_of(soup);
  const std::array<double, 16> standard{0.1, 0, 0, 0, 0, 0.1, 0, 0, 0, 0, -0.1, 1, 0, 0, 0, 1};  // z: 0 at 10, 1 at 0
  const std::array<double, 16> reversed{0.1, 0, 0, 0, 0, 0.1, 0, 0, 0, 0, 0.1, 0, 0, 0, 0, 1};
  for (const Method method : {Method::frusta, Method::cover}) {
    const auto drawn = [&](const std::array<double, 16>& rows, Nearer nearer) {
      const CullResult frame =
          culler.cull(MatrixCamera::from_rows(rows.data(), ClipDepth::zero_to_w, nearer), options_of(method));
      return std::array{is_drawn(culler, frame, 0), is_drawn(culler, frame, 1), is_drawn(culler, frame, 2)};
    };
    EXPECT_EQ(drawn(standard, Nearer::less), (std::array{true, false, true}));
    EXPECT_EQ(drawn(reversed, Nearer::greater), (std::array{true, false, true}));
    EXPECT_EQ(drawn(reversed, Nearer::less), (std::array{true, true, true})) << "light from below: the floor is the smaller";
  }
}

TEST(MatrixCamera, IsReadFromColumnsAndRows) {
  std::mt19937 random(7);
  const Made made = some_camera(random);
  std::array<float, 16> columns{}, rows{};
  for (int column = 0; column < 4; ++column) {
    for (int row = 0; row < 4; ++row) {
      const auto number = static_cast<float>(made.camera.matrix[column][row]);
      columns[static_cast<std::size_t>(4 * column + row)] = number;
      rows[static_cast<std::size_t>(4 * row + column)] = number;
    }
  }
  const MatrixCamera a = MatrixCamera::from_columns(columns.data(), made.camera.depth, made.camera.nearer);
  const MatrixCamera b = MatrixCamera::from_rows(rows.data(), made.camera.depth, made.camera.nearer);
  EXPECT_EQ(a.matrix, b.matrix);
  EXPECT_EQ(a.matrix[3][1], static_cast<double>(static_cast<float>(made.camera.matrix[3][1])));
}

TEST(MatrixCamera, WhatCannotBeUsedIsRefused) {
  const std::array<double, 16> good = along_x(1, -2);
  const std::array<double, 16> parallel{0, -0.1, 0, 0, 0, 0, 0.1, 0, 0.1, 0, 0, 0, 0, 0, 0, 1};
  const auto fault_of = [](std::array<double, 16> rows, const std::function<void(std::array<double, 16>&)>& change,
                           Nearer nearer = Nearer::unsaid) {
    change(rows);
    return fault(MatrixCamera::from_rows(rows.data(), ClipDepth::minus_w_to_w, nearer));
  };
  using Rows = std::array<double, 16>;
  const auto nothing = [](Rows&) {};
  EXPECT_EQ(fault_of(good, nothing), "");
  EXPECT_EQ(fault_of(good, nothing, Nearer::less), "");
  EXPECT_EQ(fault_of(parallel, nothing, Nearer::less), "");
  EXPECT_EQ(fault_of(parallel, nothing, Nearer::greater), "");
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  for (const double number : {kInfinity, -kInfinity, std::numeric_limits<double>::quiet_NaN(), 0x1.1p100}) {
    for (std::size_t i = 0; i < 16; ++i) {
      EXPECT_EQ(fault_of(good, [&](Rows& rows) { rows[i] = number; }), "a number is not finite or out of range");
    }
  }
  const auto row_of_zeros = [](std::size_t row) {
    return [=](Rows& rows) { std::fill_n(rows.begin() + static_cast<std::ptrdiff_t>(4 * row), 4, 0.0); };
  };
  EXPECT_EQ(fault_of(good, row_of_zeros(0)), "the matrix is singular: it has no eye");
  EXPECT_EQ(fault_of(good, row_of_zeros(1)), "the matrix is singular: it has no eye");
  EXPECT_EQ(fault_of(good, row_of_zeros(2)), "the matrix is singular: it has no depth");
  EXPECT_EQ(fault_of(good, row_of_zeros(3)), "w is nowhere positive");
  EXPECT_EQ(fault_of(good, [](Rows& rows) { std::copy_n(rows.begin(), 3, rows.begin() + 4); }),
            "the matrix is singular: it has no eye");
  EXPECT_EQ(fault_of(good, [](Rows& rows) { rows[11] = 0; }), "the matrix is singular: it has no depth");
  EXPECT_EQ(fault_of(good, [](Rows& rows) { rows[8] = -1; }), "the matrix is singular: it has no near plane");
  EXPECT_EQ(fault_of(good, [](Rows& rows) { rows[1] = -0x1p40; }), "the picture must have an extent, and a bound");
  EXPECT_EQ(fault_of(good, [](Rows& rows) { rows[6] = 0x1p-30; }), "the picture must have an extent, and a bound");
  EXPECT_EQ(fault_of(good,
                     [](Rows& rows) {
                       rows[6] = 0x1p-20;
                       rows[7] = 0x1p90;
                     }),
            "the eye is out of range");
  EXPECT_EQ(fault_of(good, nothing, Nearer::greater), "the matrix says otherwise of what is nearer");
  EXPECT_EQ(fault_of(parallel, nothing), "with parallel rays it must be said whether nearer is less or greater");
  EXPECT_EQ(fault_of(parallel, row_of_zeros(0), Nearer::less), "the matrix is singular: it has no direction");
  EXPECT_EQ(fault_of(parallel, row_of_zeros(2), Nearer::less), "the matrix is singular: it has no direction");
  EXPECT_EQ(fault_of(
                parallel, [](Rows& rows) { rows[15] = -1; }, Nearer::less),
            "w is nowhere positive");
  EXPECT_EQ(fault_of(
                parallel, [](Rows& rows) { rows[1] = 0x1p-99, rows[15] = 0x1p90; }, Nearer::less),
            "the picture must have an extent, and a bound");

  MatrixCamera camera = MatrixCamera::from_rows(good.data(), ClipDepth::minus_w_to_w);
  const Culler culler = culler_of(random_town(1, 10));
  for (const double radius : {-1.0, kInfinity, 0x1p-101, 0x1p101, std::numeric_limits<double>::quiet_NaN()}) {
    camera.eyes.radius = radius;
    EXPECT_EQ(fault(camera), "the radius of the eyes must be 0, or positive and in range");
  }
  camera.eyes.radius = 0.1;
  EXPECT_EQ(fault(camera), "");
  for (const Method method : {Method::frusta, Method::cover}) {
    EXPECT_EQ(refusal([&] { static_cast<void>(culler.cull(camera, options_of(method))); }), "");
  }
  camera.eyes.half_edges[1].x = 0.1;
  EXPECT_EQ(fault(camera), "the eyes are in a ball or in a box, not both");
  camera.eyes = EyeRegion::box({0.1, 0, 0});
  EXPECT_EQ(fault(camera), "");
  camera.eyes.half_edges[2].z = kInfinity;
  EXPECT_EQ(fault(camera), "a half-edge of the eyes is not finite or out of range");
}

/// What a rotation leaves of zeros is far below the kernel's least number.
TEST(MatrixCamera, TakesWhatRotationsLeave) {
  constexpr double kLeft = 3.7e-33;
  std::array<double, 16> rows = along_x(1, -2);
  for (double& number : rows) number = number == 0 ? kLeft : number;
  const MatrixCamera camera = MatrixCamera::from_rows(rows.data(), ClipDepth::minus_w_to_w);
  ASSERT_EQ(fault(camera), "");
  EXPECT_EQ(camera.eye(), dvec3(0));
  rows = {0, -0.1, 0, 0, 0, 0, 0.1, 0, 0.1, 0, 0, 0, 1e-33, 0, 0, 1};
  const MatrixCamera parallel = MatrixCamera::from_rows(rows.data(), ClipDepth::minus_w_to_w, Nearer::less);
  ASSERT_EQ(fault(parallel), "") << "the last row is far from zero";
  EXPECT_FALSE(parallel.viewpoint().is_eye());
  std::vector<HalfSpace> planes;
  append_view_frustum(camera, 10, planes);
  append_view_frustum(parallel, 10, planes);
  for (const HalfSpace& h : planes) {
    EXPECT_EQ(kernel::check(to_kernel(h.normal)), kernel::Refusal::none);
    EXPECT_EQ(kernel::check(h.offset), kernel::Refusal::none);
  }
}

}  // namespace matrix_camera_test
