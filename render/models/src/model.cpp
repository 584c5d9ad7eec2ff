// SPDX-License-Identifier: MIT
#include "occlude/render/model.h"

#include <fmt/format.h>

#include <algorithm>

#include "occlude/culler/polygon_soup.h"

namespace occlude::render {
namespace {

/// "1 face that ..." or "2 faces that ...".
std::string counted(std::size_t count, const char* one, const char* many) {
  return fmt::format("{} {}", count, count == 1 ? one : many);
}

}  // namespace

glm::dvec3 up_of(const ModelNotes& notes) {
  const glm::dvec3& up = notes.convention.up;
  return up == glm::dvec3(0) ? glm::dvec3(0, 0, 1) : up;
}

std::string text_of(const ModelNotes& notes) {
  std::string text;
  const auto add = [&](const std::string& note) { text += (text.empty() ? "" : "; ") + note; };
  if (notes.few_corners != 0) {
    add(counted(notes.few_corners, "face with fewer than three corners is left out",
                "faces with fewer than three corners are left out"));
  }
  if (notes.unsound_vertices != 0) {
    add(counted(notes.unsound_vertices, "vertex that no face uses is left out: its numbers are not legal",
                "vertices that no face uses are left out: their numbers are not legal"));
  }
  if (notes.crossing != 0) {
    add(counted(notes.crossing, "face that crosses itself is drawn as a fan and hides nothing",
                "faces that cross themselves are drawn as fans and hide nothing"));
  }
  if (notes.tiny_numbers != 0) {
    add(counted(notes.tiny_numbers, "coordinate nearer to 0 than 2^-100 is taken as 0",
                "coordinates nearer to 0 than 2^-100 are taken as 0"));
  }
  for (const std::string& warning : notes.warnings) add(warning);
  return text;
}

void make_opaque(culler::PolygonSoup& soup) {
  for (std::size_t p = 0; p < soup.see_through.size(); ++p) {
    if (culler::fan_is_face(soup.vertices, soup.loop(p))) soup.see_through[p] = 0;
  }
  if (std::ranges::count(soup.see_through, 1) == 0) soup.see_through.clear();
}

}  // namespace occlude::render
