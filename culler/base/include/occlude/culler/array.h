// SPDX-License-Identifier: MIT
// Arrays that are made once: in memory of their own, or where they lie already. Reading order: 10.
#pragma once

#include <algorithm>
#include <cstddef>
#include <memory>
#include <span>
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

}  // namespace occlude::culler
