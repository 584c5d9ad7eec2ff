// SPDX-License-Identifier: MIT
// A large array of which little is used.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <memory>
#include <new>
#include <type_traits>
#include <utility>
#include <vector>

namespace occlude::culler {

/// SparseZeroArray that may be changed. The system makes a page of them when it is first touched, so what is never used
/// costs nothing: a view has a number for each occluder of a model of millions, and uses some thousand.
///
/// No page is read before it is written to. Otherwise Linux would map a shared page of zeros, and interrupt the program's
/// threads to replace it at the first write: in a virtual machine with a busy thread that took 1 ms for each page.
template <class T>
class SparseZeroArray {
 public:
  static_assert(std::is_trivially_copyable_v<T> && sizeof(T) <= 4096);

  SparseZeroArray() = default;
  ~SparseZeroArray() = default;
  SparseZeroArray(SparseZeroArray&& other) noexcept { *this = std::move(other); }
  SparseZeroArray& operator=(SparseZeroArray&& other) noexcept {
    elements_ = std::move(other.elements_);
    size_ = std::exchange(other.size_, 0);
    written_ = std::exchange(other.written_, {});
    return *this;
  }

  [[nodiscard]] std::size_t size() const { return size_; }
  /// Reads, and touches no page that was not written to. REQUIRES: i < size(); so below.
  [[nodiscard]] T get(std::size_t i) const { return is_written(i / kOfPage) ? elements_[i] : T{}; }
  /// Counts as a write, even if nothing is assigned.
  [[nodiscard]] T& operator[](std::size_t i) {
    if (!is_written(i / kOfPage)) write(i / kOfPage);
    return elements_[i];
  }

  /// Has at least so many elements from now on. Those that were there stay.
  void grow(std::size_t size) {
    if (size <= size_) return;
    SparseZeroArray grown(std::max(size, 2 * size_));
    for (std::size_t page = 0; page * kOfPage < size_; ++page) {
      if (is_written(page)) std::copy_n(&elements_[page * kOfPage], size_of(page), &grown[page * kOfPage]);
    }
    *this = std::move(grown);
  }

 private:
  struct Free {
    void operator()(T* elements) const { std::free(elements); }
  };
  /// Ours have 4 KiB, and may begin anywhere in those of the system, which have 4 KiB or more.
  static constexpr std::size_t kOfPage = 4096 / sizeof(T);

  explicit SparseZeroArray(std::size_t size)
      : elements_(static_cast<T*>(std::calloc(size, sizeof(T)))), size_(size), written_(size / kOfPage + 1) {
    if (!elements_) throw std::bad_alloc();
  }

  [[nodiscard]] bool is_written(std::size_t page) const { return written_[page] != 0; }
  [[nodiscard]] std::size_t size_of(std::size_t page) const { return std::min(kOfPage, size_ - page * kOfPage); }
  /// Writes to the page's first and last element, so to each page of the system that it lies in.
  void write(std::size_t page) {
    elements_[page * kOfPage] = elements_[page * kOfPage + size_of(page) - 1] = T{};
    written_[page] = 1;
  }

  std::unique_ptr<T[], Free> elements_;
  std::size_t size_ = 0;
  std::vector<std::uint8_t> written_;  ///< whether each page is
};

}  // namespace occlude::culler
