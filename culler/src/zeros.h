// SPDX-License-Identifier: MIT
// A large array of which little is used.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdlib>
#include <memory>
#include <new>
#include <type_traits>
#include <utility>

namespace occlude::culler {

/// Zeros that may be changed. The system makes a page of them when it is first touched, so what is never used costs nothing:
/// a view has a number for each occluder of a model of millions, and uses some thousand.
template <class T>
class Zeros {
 public:
  static_assert(std::is_trivially_copyable_v<T>);

  Zeros() = default;
  ~Zeros() = default;
  Zeros(Zeros&& other) noexcept : elements_(std::move(other.elements_)), size_(std::exchange(other.size_, 0)) {}
  Zeros& operator=(Zeros&& other) noexcept {
    elements_ = std::move(other.elements_);
    size_ = std::exchange(other.size_, 0);
    return *this;
  }

  [[nodiscard]] std::size_t size() const { return size_; }
  [[nodiscard]] T& operator[](std::size_t i) { return elements_[i]; }
  [[nodiscard]] const T& operator[](std::size_t i) const { return elements_[i]; }

  /// Has at least so many elements from now on. Those that were there stay.
  void grow(std::size_t size) {
    if (size <= size_) return;
    size = std::max(size, 2 * size_);
    Elements grown(static_cast<T*>(std::calloc(size, sizeof(T))));
    if (!grown) throw std::bad_alloc();
    std::copy_n(elements_.get(), size_, grown.get());
    elements_ = std::move(grown);
    size_ = size;
  }

 private:
  struct Free {
    void operator()(T* elements) const { std::free(elements); }
  };
  using Elements = std::unique_ptr<T[], Free>;

  Elements elements_;
  std::size_t size_ = 0;
};

}  // namespace occlude::culler
