// SPDX-License-Identifier: MIT
// Reads the visible sets of `occlude bake` (docs/bake.md). Copy this file into your engine: it needs C++17, a little-endian
// machine and nothing else.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <stdexcept>
#include <vector>

namespace visible_sets {
using Number = std::uint32_t;
constexpr Number kNone = 0xFFFFFFFF;
/// A file where it lies in memory, read or mapped. Const calls may run on several threads at once. REQUIRES: cells are below
/// cells(), others throw std::out_of_range. What is no set throws std::runtime_error: no file makes it read or write
/// elsewhere.
class Reader {
 public:
  /// Reads the header alone. `data` must outlive the reader. Throws std::runtime_error for what is no such file, or cut off.
  Reader(const void* data, std::size_t size) : data_(static_cast<const unsigned char*>(data)), size_(size) {
    require(size >= kHeader && std::memcmp(data, "OCCLPVS1", 8) == 0 && at<std::uint64_t>(8) == size);
    cells_ = at<Number>(24), items_ = at<Number>(28);
    require((size - kHeader) / kOfCell >= cells_ && size - kHeader - cells_ * kOfCell >= 8);
  }
  /// Reads all. Throws std::runtime_error if any byte is damaged.
  void check() const {
    std::uint64_t hash = 0xcbf29ce484222325U;
    for (std::size_t i = 0; i < size_; i = i == 39 ? 48 : i + 1) hash = (hash ^ data_[i]) * 0x100000001b3U;
    require(hash == at<std::uint64_t>(40));
  }
  Number cells() const { return cells_; }
  Number items() const { return items_; }
  std::uint64_t model() const { return at<std::uint64_t>(16); }  ///< FNV-1a of the bytes of the model's file
  /// The least corner and the greatest.
  std::array<double, 6> box(Number cell) const { return at<std::array<double, 6>>(kHeader + known(cell) * kOfBox); }
  /// The first cell that holds the eye; kNone if there is none.
  Number cell_at(double x, double y, double z) const {
    Number first = 0;  // that may reach so far
    for (Number end = cells_; first < end;) {
      const Number middle = first + (end - first) / 2;
      box(middle)[0] < x - at<double>(32) ? first = middle + 1 : end = middle;
    }
    for (; first < cells_ && box(first)[0] <= x; ++first) {
      const auto b = box(first);
      if (x <= b[3] && b[1] <= y && y <= b[4] && b[2] <= z && z <= b[5]) return first;
    }
    return kNone;
  }
  /// Whether each item may be seen from somewhere in the cell. What is not is hidden from everywhere in it.
  std::vector<bool> visible(Number cell) const { return set(0, known(cell), items_); }
  /// Whether each cell holds something that may be seen from somewhere in this one.
  std::vector<bool> visible_cells(Number cell) const { return set(cells_, known(cell), cells_); }
  bool visible(Number a, Number b) const { return visible_cells(a)[known(b)]; }

 private:
  static constexpr std::size_t kHeader = 64, kOfBox = 48, kOfCell = kOfBox + 16;
  static void require(bool holds) {
    if (!holds) throw std::runtime_error("no visible sets, or damaged");
  }
  Number known(Number cell) const { return cell < cells_ ? cell : throw std::out_of_range("no such cell"); }
  template <class T>
  T at(std::size_t place) const {
    T value;
    std::memcpy(&value, data_ + place, sizeof value);
    return value;
  }
  std::uint64_t number(std::uint64_t& next, std::uint64_t end) const {
    for (std::uint64_t value = 0, shift = 0;; shift += 7) {
      require(next < end && shift < 35);
      value |= std::uint64_t{data_[next] % 128U} << shift;
      if (data_[next++] < 128) return value;
    }
  }
  /// The set of a cell, by the sets from which it differs; those of its kind begin with the set `first`.
  std::vector<bool> set(std::size_t first, Number cell, Number size) const {
    std::vector<bool> result(size);
    for (int others = 8;; --others) {
      const std::size_t place = kHeader + cells_ * kOfBox + (first + cell) * 8;
      std::uint64_t next = at<std::uint64_t>(place), end = at<std::uint64_t>(place + 8), to = 0;
      require(end <= size_);
      const std::uint64_t back = number(next, end);
      while (next < end) {
        std::uint64_t from = to + number(next, end);
        to = from + number(next, end);
        require(to <= size);
        for (; from < to; ++from) result[from] = !result[from];
      }
      if (back == 0) return result;
      require(back <= cell && others > 0);
      cell -= static_cast<Number>(back);
    }
  }
  const unsigned char* data_;
  std::size_t size_;
  Number cells_, items_;
};
}  // namespace visible_sets
