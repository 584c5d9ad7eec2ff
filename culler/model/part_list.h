// SPDX-License-Identifier: MIT
// Arrays to and from the parts of a model.
#pragma once

#include <algorithm>
#include <bit>
#include <cstdint>
#include <memory>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>

#include "occlude/culler/hierarchy.h"
#include "occlude/culler/parts.h"

namespace occlude::culler {

/// Throws std::invalid_argument about a part that cannot be used.
[[noreturn]] inline void refuse_part(std::string_view name, const std::string& reason) {
  throw std::invalid_argument("part \"" + std::string(name) + "\": " + reason);
}

/// The same about a tree of more than kMostLevels levels.
[[noreturn]] inline void refuse_depth(std::string_view name) {
  refuse_part(name, "the tree is deeper than " + std::to_string(kMostLevels) + " levels");
}

/// Appends parts.
class PartWriter {
 public:
  explicit PartWriter(Parts& parts) : parts_(parts) {}

  template <class T>
  void put(std::string_view name, std::span<const T> elements) {
    static_assert(std::is_trivially_copyable_v<T>);
    parts_.parts.push_back({name, sizeof(T), std::as_bytes(elements)});
  }
  template <class Elements>
  void put(std::string_view name, const Elements& elements) {
    put(name, std::span(elements));
  }

 private:
  Parts& parts_;
};

/// Finds parts by name. What it says of them is true of their sizes alone: elements may be anything.
class PartReader {
 public:
  explicit PartReader(const Parts& parts) : parts_(parts) {}

  /// Throws std::invalid_argument where there is no such part, or it has no whole number of such elements in their place.
  template <class T>
  [[nodiscard]] Array<T> get(std::string_view name) const {
    static_assert(std::is_trivially_copyable_v<T> && alignof(T) <= kPartAlignment);
    const Part* part = find(name);
    if (!part) refuse_part(name, "it is missing");
    if (part->element != sizeof(T) || part->bytes.size() % sizeof(T) != 0)
      refuse_part(name, "its elements have another size");
    if (std::bit_cast<std::uintptr_t>(part->bytes.data()) % alignof(T) != 0) refuse_part(name, "it is not aligned");
    return {{reinterpret_cast<const T*>(part->bytes.data()), part->bytes.size() / sizeof(T)}, parts_.keep};
  }
  /// What the elements are in.
  [[nodiscard]] const std::shared_ptr<const void>& keep() const { return parts_.keep; }
  /// The bytes of all parts of the model, those that are left out with them.
  [[nodiscard]] std::uint64_t bytes() const {
    std::uint64_t bytes = parts_.left_out;
    for (const Part& part : parts_.parts) bytes += part.bytes.size();
    return bytes;
  }
  /// Whether there is a part of a name such as is_such(name) says.
  template <class IsSuch>
  [[nodiscard]] bool has_any(const IsSuch& is_such) const {
    return std::ranges::any_of(parts_.parts, is_such, &Part::name);
  }

 private:
  [[nodiscard]] const Part* find(std::string_view name) const {
    const auto found = std::ranges::find(parts_.parts, name, &Part::name);
    return found == parts_.parts.end() ? nullptr : &*found;
  }

  const Parts& parts_;
};

}  // namespace occlude::culler
