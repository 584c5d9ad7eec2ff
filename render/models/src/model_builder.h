// SPDX-License-Identifier: MIT
// What every reader does with the vertices and faces of a file.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <glm/vec3.hpp>
#include <span>
#include <string>
#include <vector>

#include "model_check.h"
#include "occlude/render/model.h"

namespace occlude::render {

/// How a face looks.
struct Surface {
  bool is_opaque = true;
  Rgb colour = kWhite;
};

/// Puts a model together. What is wrong with a vertex matters only once a face uses it.
class ModelBuilder {
 public:
  /// Of the colours of faces nothing is kept, unless they are asked for.
  explicit ModelBuilder(bool with_colours) : with_colours_(with_colours) {}

  /// Adds a vertex, with numbers nearer to 0 than 2^-100 taken as 0. place() is called if it cannot be used: the file and
  /// the place in it, for the message.
  template <class Place>
  std::uint32_t add_vertex(const glm::dvec3& vertex, const Place& place) {
    return model_.soup.add_vertex(is_legal(vertex) ? vertex : mended(vertex, place));
  }
  [[nodiscard]] std::size_t vertices() const { return model_.soup.vertices.size(); }

  /// Adds a face of any shape over vertices that are there; one of fewer than three corners is left out. Throws InputError
  /// about a vertex that cannot be used.
  void add_face(std::span<const std::uint32_t> loop, const Surface& surface);

  [[nodiscard]] ModelNotes& notes() { return model_.notes; }

  /// Makes room for so many vertices, and faces of three corners.
  void reserve(std::size_t vertices, std::size_t faces);

  /// The model, without vertices that no face uses. Throws InputError if it has no polygon, or too many corners for 32 bits.
  [[nodiscard]] Model finish(const std::filesystem::path& file);

 private:
  struct Fault {
    std::uint32_t vertex = 0;
    std::string message;
  };

  template <class Place>
  glm::dvec3 mended(glm::dvec3 vertex, const Place& place) {
    const std::size_t tiny = drop_tiny(vertex);
    if (const auto fault = vertex_fault(vertex)) {
      faults_.push_back({static_cast<std::uint32_t>(vertices()), place() + ": " + *fault});
      return glm::dvec3(0);
    }
    model_.notes.tiny_numbers += tiny;
    return vertex;
  }
  void require_sound(std::span<const std::uint32_t> loop) const;
  void leave_out_unused();
  /// All polygons from `first` on are of this colour.
  void colour_from(std::size_t first, const Rgb& colour);

  bool with_colours_;
  Model model_;
  std::vector<std::uint8_t> is_used_;  ///< 1 where a face has the vertex
  std::vector<Fault> faults_;          ///< of vertices that no face may use, ascending; in the soup they are 0
};

}  // namespace occlude::render
