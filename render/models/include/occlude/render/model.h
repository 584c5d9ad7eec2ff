// SPDX-License-Identifier: MIT
// A model as it is read from a file: its polygons, and what was made of what the file has.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "occlude/culler/polygon_soup.h"
#include "occlude/render/convention.h"
#include "occlude/render/rgb.h"

namespace occlude::render {

/// How a model is read.
struct ReadOptions {
  /// What lets light through according to the file is opaque as well. Faces that cross themselves are see-through all the
  /// same, because no one knows what of them is drawn elsewhere.
  bool is_opaque_all = false;
  /// The default is that coordinates are those of the file, whatever it says of unit and axes.
  Conversion conversion = {};
  /// Colours are read, too: three bytes a polygon.
  bool with_colours = false;
};

/// What a reader found, beside faces that are drawn as they are.
struct ModelNotes {
  Convention file;        ///< what the numbers of the file mean, as it, its format or the user says
  Convention convention;  ///< what the coordinates of the model mean: the same, unless they are converted

  std::size_t triangulated = 0;      ///< faces that are concave or have openings, and are drawn as triangles
  std::size_t crossing = 0;          ///< faces that cross themselves: drawn as a fan, hide nothing
  std::size_t without_area = 0;      ///< faces whose corners lie on a line
  std::size_t few_corners = 0;       ///< faces with fewer than three corners, left out
  std::size_t points_and_lines = 0;  ///< left out
  std::size_t unused_vertices = 0;   ///< left out, whatever their numbers are
  std::size_t unsound_vertices = 0;  ///< how many of these have numbers that are not finite or above 2^100, if known
  std::size_t tiny_numbers = 0;      ///< coordinates of vertices that are nearer to 0 than 2^-100, taken as 0
  /// About how far at most a library has moved vertices that gives numbers in single precision; 0: there is none.
  double rounding = 0;
  std::vector<std::string> warnings;  ///< what else the user must know, a line each, without the name of the file
};

/// Polygons are numbered as faces of the file, in its order, those with fewer than three corners left out. A face that is
/// not the fan of its loop has several polygons (PolygonSoup::face).
struct Model {
  culler::PolygonSoup soup;
  ModelNotes notes;
  std::vector<Rgb> colours = {};  ///< of each polygon; empty: all are white, or they were not asked for
};

/// Whether the corners of a face lie on a line. Exact. REQUIRES: at least three corners, and legal coordinates.
[[nodiscard]] bool has_no_area(culler::SoupView soup, std::span<const std::uint32_t> loop);

/// The direction that is up in the model: z where nobody says.
[[nodiscard]] glm::dvec3 up_of(const ModelNotes& notes);

/// What the user must know of how a file was read, in a line; empty if that is nothing.
[[nodiscard]] std::string text_of(const ModelNotes& notes);

/// As ReadOptions::is_opaque_all says.
void make_opaque(culler::PolygonSoup& soup);

}  // namespace occlude::render
