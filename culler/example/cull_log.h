// SPDX-License-Identifier: MIT
// Writes what a culler culled, for `occlude audit MODEL --log FILE` (docs/audit.md). Copy this file into your engine: it
// needs C++11 and nothing else.
#pragma once

#include <cstdint>
#include <cstring>
#include <fstream>
#include <string>
#include <vector>

namespace cull_log {

using Number = std::uint32_t;
struct Range {
  Number first, count;  ///< polygons of the model file, from 0; one or more
};
struct Frame {
  Number number, width, height;  ///< each number once; the size of the picture in pixels
};
enum What : Number { culled = 0, drawn = 1 };             ///< what is listed
enum Depth : Number { minus_w_to_w = 0, zero_to_w = 1 };  ///< of the clip volume: OpenGL; Vulkan, Direct3D and Metal

class Writer {
 public:
  explicit Writer(const std::string& file) : file_(file, std::ios::binary) { file_ << "OCCLLOG1"; }
  /// Whether everything was written.
  bool close() {
    file_.close();
    return !file_.fail();
  }

  /// The polygons of an object, before the first frame that lists it.
  void object(Number id, const std::vector<Range>& polygons) { put(kObject), put(id), put(polygons); }

  /// A frame by the matrix that takes a point of the model, a column, to clip space: sixteen numbers, column after column.
  /// The list is of polygons, std::vector<Range>, or of objects, std::vector<Number>.
  template <class Listed>
  void frame(const Frame& f, const double* matrix, Depth depth, What what, const std::vector<Listed>& list) {
    put(kMatrixFrame), put(f.number), put(f.width), put(f.height), put(what | kind_of(list));
    put(matrix, 16), put(static_cast<Number>(depth)), put(list);
  }
  /// A frame by eye, target and up, with the full vertical angle of view in degrees, and near and far planes.
  template <class Listed>
  void frame(const Frame& f, const double* eye, const double* target, const double* up, double fov, double near_plane,
             double far_plane, What what, const std::vector<Listed>& list) {
    put(kEyeFrame), put(f.number), put(f.width), put(f.height), put(what | kind_of(list));
    put(eye, 3), put(target, 3), put(up, 3), put(&fov, 1), put(&near_plane, 1), put(&far_plane, 1), put(list);
  }

 private:
  static constexpr Number kMatrixFrame = 1, kEyeFrame = 2, kObject = 3;

  static Number kind_of(const std::vector<Range>&) { return 0; }
  static Number kind_of(const std::vector<Number>&) { return 2; }
  void bytes(std::uint64_t bits, int count) {  // the lowest first
    for (int i = 0; i < count; ++i) file_.put(static_cast<char>(bits >> (8 * i) & 255U));
  }
  void put(Number number) { bytes(number, 4); }
  void put(const double* numbers, int count) {
    for (int i = 0; i < count; ++i) {
      std::uint64_t bits;
      std::memcpy(&bits, numbers + i, sizeof bits);
      bytes(bits, 8);
    }
  }
  void put(const Range& range) { put(range.first), put(range.count); }
  template <class Listed>
  void put(const std::vector<Listed>& list) {
    put(static_cast<Number>(list.size()));
    for (const Listed& listed : list) put(listed);
  }

  std::ofstream file_;
};

}  // namespace cull_log
