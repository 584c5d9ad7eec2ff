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

/// A file where it lies in memory, read or mapped. Const calls may run on several threads at once.
class Reader {
 public:
  /// `data` must outlive the reader. Throws std::runtime_error for what is no such file, or is cut off or damaged.
  Reader(const void* data, std::size_t size) : data_(static_cast<const unsigned char*>(data)) {
    require(size >= kHeader && std::memcmp(data, "OCCLPVS1", 8) == 0 && at<std::uint64_t>(8) == size);
    cells_ = at<Number>(24), items_ = at<Number>(28), widest_ = at<double>(32);
    require((size - kHeader) / kOfCell >= cells_ && (size - kHeader - cells_ * kOfCell) >= 8);
    std::uint64_t hash = 0xcbf29ce484222325U;
    for (std::size_t i = kHeader; i < size; ++i) hash = (hash ^ data_[i]) * 0x100000001b3U;
    require(hash == at<std::uint64_t>(40));
  }

  Number cells() const { return cells_; }
  Number items() const { return items_; }
  std::uint64_t model() const { return at<std::uint64_t>(16); }  ///< FNV-1a of the bytes of the model's file

  /// The least corner and the greatest.
  std::array<double, 6> box(Number cell) const { return at<std::array<double, 6>>(kHeader + cell * kOfBox); }

  /// The first cell that holds the eye; kNone if there is none.
  Number cell_at(double x, double y, double z) const {
    Number first = 0;  // that may reach so far
    for (Number end = cells_; first < end;) {
      const Number middle = first + (end - first) / 2;
      box(middle)[0] < x - widest_ ? first = middle + 1 : end = middle;
    }
    for (; first < cells_ && box(first)[0] <= x; ++first) {
      const auto b = box(first);
      if (x <= b[3] && b[1] <= y && y <= b[4] && b[2] <= z && z <= b[5]) return first;
    }
    return kNone;
  }

  /// Whether each item may be seen from somewhere in the cell. What is not is hidden from everywhere in it.
  std::vector<bool> visible(Number cell) const { return set(cell, items_); }
  /// Whether each cell holds something that may be seen from somewhere in this one.
  std::vector<bool> visible_cells(Number cell) const { return set(cells_ + cell, cells_); }
  bool visible(Number a, Number b) const { return visible_cells(a)[b]; }

 private:
  static constexpr std::size_t kHeader = 64, kOfBox = 48, kOfCell = kOfBox + 16;

  static void require(bool holds) {
    if (!holds) throw std::runtime_error("no visible sets, or damaged");
  }
  template <class T>
  T at(std::size_t place) const {
    T value;
    std::memcpy(&value, data_ + place, sizeof value);
    return value;
  }
  std::uint64_t place(Number set) const { return at<std::uint64_t>(kHeader + cells_ * kOfBox + set * std::size_t{8}); }
  std::vector<bool> set(Number number, Number size) const {
    std::vector<bool> result(size);
    for (Number back = 1; back != 0; number -= back) toggle(number, result, back);
    return result;
  }
  /// Changes what the set has differently from another one, so far `back`; 0: from the empty set.
  void toggle(Number set, std::vector<bool>& result, Number& back) const {
    std::uint64_t next = place(set), end = place(set + 1);
    const auto number = [&] {
      Number value = 0;
      for (int shift = 0;; shift += 7) {
        const unsigned char byte = data_[next++];
        value |= Number{byte % 128U} << shift;
        if (byte < 128) return value;
      }
    };
    back = number();
    for (Number from = 0, to = 0; next < end; from = to) {
      from += number();
      to = from + number();
      for (Number i = from; i < to; ++i) result[i] = !result[i];
    }
  }

  const unsigned char* data_;
  Number cells_, items_;
  double widest_;
};

}  // namespace visible_sets
