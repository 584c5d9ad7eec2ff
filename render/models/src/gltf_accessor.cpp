// SPDX-License-Identifier: MIT
#include "gltf_accessor.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <limits>
#include <string>
#include <string_view>
#include <utility>

namespace occlude::render::gltf {
namespace {

unsigned width_of(std::string_view type) {
  constexpr std::array<std::pair<std::string_view, unsigned>, 7> kTypes = {
      {{"SCALAR", 1}, {"VEC2", 2}, {"VEC3", 3}, {"VEC4", 4}, {"MAT2", 4}, {"MAT3", 9}, {"MAT4", 16}}};
  const auto* const found = std::ranges::find(kTypes, type, &std::pair<std::string_view, unsigned>::first);
  if (found == kTypes.end()) refuse(fmt::format("type: \"{}\" is not one of glTF", type));
  return found->second;
}

Component component_of(const json& object) {
  const std::uint64_t number = whole_in(object, "componentType");
  for (const Component known :
       {Component::int8, Component::uint8, Component::int16, Component::uint16, Component::uint32, Component::float32}) {
    if (number == static_cast<std::uint64_t>(known)) return known;
  }
  refuse(fmt::format("componentType: {} is not one of glTF", number));
}

/// What `view` has from `offset` on. Refuses it unless that is enough for so many elements, each `stride` after the one
/// before.
const std::byte* elements_in(std::span<const std::byte> view, std::uint64_t offset, std::uint64_t count,
                             std::uint64_t stride, std::size_t size) {
  const bool is_there = count == 0 || (offset <= view.size() && size <= view.size() - offset &&
                                       count - 1 <= (view.size() - offset - size) / stride);
  if (!is_there)
    refuse(fmt::format("{} elements, {} bytes apart from byte {} on, do not fit in {} bytes", count, stride, offset,
                       view.size()));
  return view.data() + (count == 0 ? 0 : offset);
}

/// The value of a normalized integer: 1 is its largest.
template <class T>
double normalized(T value) {
  return std::max(static_cast<double>(value) / static_cast<double>(std::numeric_limits<T>::max()), -1.0);
}

template <class T>
double integer_at(const std::byte* element, unsigned component, bool is_normalized) {
  const T value = component_at<T>(element, component);
  return is_normalized ? normalized(value) : static_cast<double>(value);
}

}  // namespace

std::size_t size_of(Component component) {
  switch (component) {
    case Component::int8:
    case Component::uint8:
      return 1;
    case Component::int16:
    case Component::uint16:
      return 2;
    case Component::uint32:
    case Component::float32:
      return 4;
  }
  return 0;
}

Accessor::Accessor(const Document& document, Buffers& buffers, std::uint64_t index, unsigned width) {
  const json& accessor = document.item(kAccessors, index);
  at([&] { return document.label(kAccessors, index); },
     [&] {
       const std::string type = text_in(accessor, "type", "");
       layout_ = {component_of(accessor), flag_in(accessor, "normalized", false), width_of(type)};
       if (layout_.width != width) refuse(fmt::format("type: {} instead of {} components", layout_.width, width));
       size_ = whole_in(accessor, "count");
       read_bytes(accessor, buffers);
       if (find(accessor, "sparse") == nullptr) return;
       at([] { return "sparse"; }, [&] { read_sparse(object_in(accessor, "sparse"), buffers); });
     });
}

Accessor::Accessor(const Layout& layout, std::span<const std::byte> bytes)
    : layout_(layout), size_(bytes.size() / element_size()), stride_(element_size()), bytes_(bytes.data()) {}

void Accessor::read_bytes(const json& accessor, Buffers& buffers) {
  const auto index = find_whole(accessor, "bufferView");
  if (!index) return;
  const Buffers::View view = buffers.view(*index);
  stride_ = view.stride == 0 ? element_size() : view.stride;
  if (stride_ < element_size()) refuse(fmt::format("elements of {} bytes are {} bytes apart", element_size(), stride_));
  bytes_ = elements_in(view.bytes, find_whole(accessor, "byteOffset").value_or(0), size_, stride_, element_size());
}

void Accessor::read_sparse(const json& sparse, Buffers& buffers) {
  const std::uint64_t count = whole_in(sparse, "count");
  // The elements of a part lie closely, from its offset on.
  const auto part = [&](const json& place, std::size_t size) {
    return elements_in(buffers.view(whole_in(place, "bufferView")).bytes, find_whole(place, "byteOffset").value_or(0), count,
                       size, size);
  };
  const json& indices = object_in(sparse, "indices");
  const Layout layout{component_of(indices), false, 1};
  const Accessor replaced(layout, {part(indices, size_of(layout.component)), count * size_of(layout.component)});
  if (!replaced.is_unsigned()) refuse("indices: expected unsigned integers");
  for (std::uint64_t i = 0; i < count; ++i) {
    replaced_.push_back(replaced.index(i));
    if (replaced_[i] >= size_) refuse(fmt::format("indices: element {} of {}", replaced_[i], size_));
    if (i > 0 && replaced_[i] <= replaced_[i - 1]) refuse("indices: they do not ascend");
  }
  replacements_ = part(object_in(sparse, "values"), element_size());
}

bool Accessor::is_unsigned() const {
  using enum Component;
  return layout_.component == uint8 || layout_.component == uint16 || layout_.component == uint32;
}

glm::dvec3 Accessor::vec3(std::uint64_t i) const {
  const std::byte* const from = element(i);
  return {number_at(from, 0), number_at(from, 1), number_at(from, 2)};
}

glm::dvec4 Accessor::vec4(std::uint64_t i) const {
  const std::byte* const from = element(i);
  return {number_at(from, 0), number_at(from, 1), number_at(from, 2), number_at(from, 3)};
}

glm::dmat4 Accessor::mat4(std::uint64_t i) const {
  const std::byte* const from = element(i);
  glm::dmat4 matrix;
  for (unsigned k = 0; k < 16; ++k) matrix[static_cast<int>(k / 4)][static_cast<int>(k % 4)] = number_at(from, k);
  return matrix;
}

const std::byte* Accessor::replacement(std::uint64_t i) const {
  const auto found = std::ranges::lower_bound(replaced_, i);
  if (found == replaced_.end() || *found != i) return nullptr;
  return replacements_ + static_cast<std::size_t>(found - replaced_.begin()) * element_size();
}

double Accessor::number_at(const std::byte* element, unsigned component) const {
  switch (layout_.component) {
    case Component::int8:
      return integer_at<std::int8_t>(element, component, layout_.is_normalized);
    case Component::uint8:
      return integer_at<std::uint8_t>(element, component, layout_.is_normalized);
    case Component::int16:
      return integer_at<std::int16_t>(element, component, layout_.is_normalized);
    case Component::uint16:
      return integer_at<std::uint16_t>(element, component, layout_.is_normalized);
    case Component::uint32:
      return integer_at<std::uint32_t>(element, component, layout_.is_normalized);
    case Component::float32:
      return component_at<float>(element, component);
  }
  return 0;
}

}  // namespace occlude::render::gltf
