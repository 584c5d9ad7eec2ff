// SPDX-License-Identifier: MIT
// Arrays of the caller: numbers of either type, with any stride and alignment.
#pragma once

#include <array>
#include <cstddef>

#include "occlude.h"
#include "occlude/culler/box.h"
#include "occlude/kernel/types.h"

namespace occlude::c {

/// Reads elements of `Count` numbers each.
template <std::size_t Count>
class Elements {
 public:
  /// Throws std::invalid_argument for null with elements, and for an unknown type. `name` is for the message.
  Elements(const void* data, std::size_t count, std::size_t stride, occlude_number_type type, const char* name);

  [[nodiscard]] std::array<double, Count> operator[](std::size_t i) const;

 private:
  const std::byte* data_;
  std::size_t stride_;
  bool is_float_;
};

using Points = Elements<3>;

/// Reads boxes of either kind. Throws std::invalid_argument as Elements, and for an unknown kind.
class Boxes {
 public:
  explicit Boxes(const occlude_boxes* boxes);

  [[nodiscard]] std::size_t size() const { return size_; }
  [[nodiscard]] culler::Box operator[](std::size_t i) const;

 private:
  std::size_t size_;
  bool is_oriented_;
  Elements<6> aligned_;
  Elements<12> oriented_;
};

[[nodiscard]] inline kernel::Vec3 vec3(const double* v) { return {v[0], v[1], v[2]}; }
[[nodiscard]] kernel::Aabb to_box(const occlude_box* box);

}  // namespace occlude::c
