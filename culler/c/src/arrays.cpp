// SPDX-License-Identifier: MIT
#include "arrays.h"

#include <algorithm>
#include <cstring>

#include "status.h"

namespace occlude::c {
namespace {

template <class Number, std::size_t Count>
std::array<double, Count> numbers_at(const std::byte* place) {
  std::array<Number, Count> numbers;
  std::memcpy(numbers.data(), place, sizeof numbers);
  std::array<double, Count> result;
  std::ranges::copy(numbers, result.begin());
  return result;
}

const occlude_boxes& required(const occlude_boxes* boxes) {
  require(boxes, "boxes");
  if (boxes->kind != OCCLUDE_ALIGNED && boxes->kind != OCCLUDE_ORIENTED) refuse_enumerator("kind of boxes", boxes->kind);
  return *boxes;
}

}  // namespace

template <std::size_t Count>
Elements<Count>::Elements(const void* data, std::size_t count, std::size_t stride, occlude_number_type type,
                          const char* name)
    : data_(static_cast<const std::byte*>(data)), stride_(stride), is_float_(type == OCCLUDE_FLOAT) {
  if (type != OCCLUDE_DOUBLE && type != OCCLUDE_FLOAT) refuse_enumerator("number type", type);
  if (count != 0) require(data, name);
  if (stride_ == 0) stride_ = Count * (is_float_ ? sizeof(float) : sizeof(double));
}

template <std::size_t Count>
std::array<double, Count> Elements<Count>::operator[](std::size_t i) const {
  const std::byte* place = data_ + i * stride_;
  return is_float_ ? numbers_at<float, Count>(place) : numbers_at<double, Count>(place);
}

template class Elements<3>;
template class Elements<6>;
template class Elements<12>;

Boxes::Boxes(const occlude_boxes* boxes)
    : size_(required(boxes).count),
      is_oriented_(boxes->kind == OCCLUDE_ORIENTED),
      aligned_(boxes->data, boxes->count, boxes->stride, boxes->type, "data of boxes"),
      oriented_(boxes->data, boxes->count, boxes->stride, boxes->type, "data of boxes") {}

culler::Box Boxes::operator[](std::size_t i) const {
  if (!is_oriented_) {
    const std::array<double, 6> v = aligned_[i];
    return kernel::Aabb{vec3(&v[0]), vec3(&v[3])};
  }
  const std::array<double, 12> v = oriented_[i];
  return kernel::Obb{vec3(&v[0]), {vec3(&v[3]), vec3(&v[6]), vec3(&v[9])}};
}

kernel::Aabb to_box(const occlude_box* box) {
  require(box, "box");
  return {vec3(box->min), vec3(box->max)};
}

}  // namespace occlude::c
