// SPDX-License-Identifier: MIT
// What a prepared model consists of, as bytes that can be kept and used again where they lie. Reading order: 10.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

namespace occlude::culler {

/// An immutable array. Copies share the elements. Const calls may run on several threads at once; indices are not checked.
template <class T>
class Array {
  static_assert(std::is_trivially_copyable_v<T>);

 public:
  using value_type = T;

  Array() = default;
  /// Owns the elements.
  Array(std::vector<T> elements) {  // NOLINT: the same elements
    auto owned = std::make_shared<const std::vector<T>>(std::move(elements));
    elements_ = *owned;
    keep_ = std::move(owned);
  }
  /// Refers to elements that are there as long as `keep` is.
  Array(std::span<const T> elements, std::shared_ptr<const void> keep) : elements_(elements), keep_(std::move(keep)) {}

  [[nodiscard]] std::size_t size() const { return elements_.size(); }
  [[nodiscard]] bool empty() const { return elements_.empty(); }
  [[nodiscard]] const T* data() const { return elements_.data(); }
  [[nodiscard]] const T& operator[](std::size_t i) const { return elements_[i]; }
  [[nodiscard]] const T& front() const { return elements_.front(); }
  [[nodiscard]] const T& back() const { return elements_.back(); }
  [[nodiscard]] const T* begin() const { return elements_.data(); }
  [[nodiscard]] const T* end() const { return elements_.data() + elements_.size(); }

  friend bool operator==(const Array& a, const Array& b) { return std::ranges::equal(a, b); }

 private:
  std::span<const T> elements_;
  std::shared_ptr<const void> keep_;
};

/// An array of the model, in the byte order and the layout of this machine. `name` is a literal.
struct Part {
  std::string_view name;
  std::size_t element = 0;  ///< bytes of one of its elements
  std::span<const std::byte> bytes;
};

/// Every array of a prepared model: Culler::parts(). The layout of elements is the same on all little-endian machines with
/// IEEE doubles, but may change from version to version of this library: kPartsVersion tells.
struct Parts {
  std::vector<Part> parts;
  std::shared_ptr<const void> keep;  ///< what the bytes are in. The bytes stay valid and unchanged while this lives.
  std::uint64_t left_out = 0;        ///< bytes of the parts that the model has beside these
};

inline constexpr unsigned kPartsVersion = 3;
/// The bytes of each part begin at a multiple of this.
inline constexpr std::size_t kPartAlignment = 64;

}  // namespace occlude::culler
