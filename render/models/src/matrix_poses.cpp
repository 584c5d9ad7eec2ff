// SPDX-License-Identifier: MIT
#include "matrix_poses.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include "model_check.h"
#include "noise.h"
#include "occlude/render/errors.h"

namespace occlude::render {
namespace {

using glm::dmat4;
using glm::dvec3;

constexpr std::size_t kWhole = 16, kWithoutLastRow = 12;

/// The matrix whose rows, or columns, follow each other.
dmat4 matrix_of(const MatrixNumbers& matrix, MatrixOrder order) {
  const std::size_t count = matrix.numbers.size(), width = order == MatrixOrder::column ? count / 4 : 4;
  dmat4 result(1);
  for (std::size_t i = 0; i < count; ++i) {
    const auto line = static_cast<int>(i / width), place = static_cast<int>(i % width);
    (order == MatrixOrder::column ? result[line][place] : result[place][line]) = matrix.numbers[i];
  }
  return result;
}

bool has_last_row(const MatrixNumbers& matrix, MatrixOrder order) {
  const dmat4 m = matrix_of(matrix, order);
  return m[0].w == 0 && m[1].w == 0 && m[2].w == 0 && m[3].w == 1;
}

/// Whether all have the same numbers in either order.
bool are_symmetric(std::span<const MatrixNumbers> matrices) {
  return std::ranges::all_of(matrices, [](const MatrixNumbers& m) {
    return m.numbers.size() == kWhole && matrix_of(m, MatrixOrder::row) == matrix_of(m, MatrixOrder::column);
  });
}

MatrixOrder order_of(std::span<const MatrixNumbers> matrices, std::string_view remedy) {
  const auto fit = [&](MatrixOrder order) {
    return std::ranges::all_of(matrices, [&](const MatrixNumbers& m) { return has_last_row(m, order); });
  };
  const bool are_rows = fit(MatrixOrder::row), are_columns = fit(MatrixOrder::column);
  if (are_rows == are_columns && !are_symmetric(matrices)) {
    throw InputError(fmt::format("{}: the numbers may be rows or columns: {}", matrices.front().place, remedy));
  }
  return are_columns && !are_rows ? MatrixOrder::column : MatrixOrder::row;
}

/// Throws InputError for numbers that cannot be those of a matrix.
void check(const MatrixNumbers& matrix) {
  const std::size_t count = matrix.numbers.size();
  if (count != kWhole && count != kWithoutLastRow) {
    throw InputError(fmt::format("{}: a matrix has 16 numbers, or 12, not {}", matrix.place, count));
  }
  if (!std::ranges::all_of(matrix.numbers, [](double x) { return std::isfinite(x); })) {
    throw InputError(matrix.place + ": a number is not finite");
  }
}

}  // namespace

void add_keyframes(CameraPath& path, std::span<const MatrixNumbers> matrices, std::optional<MatrixOrder> order,
                   std::string_view remedy) {
  for (const MatrixNumbers& matrix : matrices) check(matrix);
  const MatrixOrder known = order ? *order : order_of(matrices, remedy);
  for (const MatrixNumbers& matrix : matrices) {
    if (!has_last_row(matrix, known)) throw InputError(matrix.place + ": the last row of a camera's matrix is 0 0 0 1");
    add_keyframe(path, matrix_of(matrix, known), matrix.place);
  }
}

void add_keyframe(CameraPath& path, const dmat4& pose, const std::string& place) {
  if (glm::cross(dvec3(pose[1]), dvec3(pose[2])) == dvec3(0)) {
    throw InputError(place + ": the second and third column are no axes of a camera");
  }
  const dvec3 eye(pose[3]), up = glm::normalize(dvec3(pose[1])), back = glm::normalize(dvec3(pose[2]));
  // As far away as the eye is from the origin: nearer, the direction would lose digits to the target's coordinates.
  const double reach = std::max({1.0, std::fabs(eye.x), std::fabs(eye.y), std::fabs(eye.z)});
  CameraPath::Keyframe key{eye, eye - reach * back, up};
  path.noise += drop_noise({&key.eye, &key.target}) + drop_noise({&*key.up});
  for (const dvec3& v : {key.eye, key.target, *key.up}) {
    if (const auto fault = vertex_fault(v)) throw InputError(fmt::format("{}: {}", place, *fault));
  }
  // Half a millionth of a radian moves no corner of a picture by a thousandth of a pixel, and is what single precision
  // leaves. A camera that looks along `up` to a thousandth has no horizon.
  constexpr double kLevel = 0x1p-21, kAlong = 0x1p-10;
  const dvec3 upwards = glm::normalize(path.up);
  const bool is_level = std::fabs(glm::dot(glm::cross(up, back), upwards)) <= kLevel;
  if (is_level && glm::dot(up, upwards) >= kAlong) key.up.reset();
  path.keyframes.push_back(key);
}

}  // namespace occlude::render
