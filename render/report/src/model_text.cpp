// SPDX-License-Identifier: MIT
#include "occlude/render/model_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <glm/common.hpp>
#include <initializer_list>
#include <span>

#include "occlude/render/formats.h"
#include "occlude/render/model.h"

namespace occlude::render {
namespace {

std::string count(std::size_t number, const char* one, const char* several) {
  return fmt::format("{} {}", grouped(static_cast<double>(number)), number == 1 ? one : several);
}

struct Kind {
  std::size_t count;
  const char* name;
};

/// " (3 see-through, ...)": those of which there are some.
std::string listed(std::initializer_list<Kind> kinds) {
  std::string text;
  for (const Kind& kind : kinds) {
    if (kind.count != 0) {
      text += fmt::format("{}{} {}", text.empty() ? " (" : ", ", grouped(static_cast<double>(kind.count)), kind.name);
    }
  }
  return text.empty() ? text : text + ")";
}

/// Faces that are drawn as several polygons.
std::size_t in_pieces(const culler::Hierarchy& hierarchy) {
  const std::span<const std::uint32_t> faces = hierarchy.faces();
  std::size_t several = 0;
  for (std::size_t p = 1; p < faces.size(); ++p) {
    const bool is_second = faces[p] == faces[p - 1] && (p == 1 || faces[p] != faces[p - 2]);
    several += is_second ? 1 : 0;
  }
  return several;
}

}  // namespace

std::string text_of_model(const std::string& name, const culler::Hierarchy& hierarchy, const Convention& convention) {
  const culler::SoupView soup = hierarchy.soup();
  glm::dvec3 low = soup.vertices[soup.indices[0]], high = low;
  for (const std::uint32_t corner : soup.indices) {
    low = glm::min(low, soup.vertices[corner]);
    high = glm::max(high, soup.vertices[corner]);
  }
  std::size_t without_area = 0;
  for (std::size_t p = 0; p < soup.size(); ++p) without_area += has_no_area(soup, soup.loop(p)) ? 1 : 0;
  const glm::dvec3 size = high - low;
  const std::string unit = unit_in_words(convention.metres), up = up_in_words(convention.up);
  return fmt::format("{}: {}{}; {:.6g} x {:.6g} x {:.6g} {}, {}\n", name,
                     count(hierarchy.face_count(), "polygon", "polygons"),
                     listed({{in_pieces(hierarchy), "drawn in pieces"},
                             {without_area, "without area"},
                             {static_cast<std::size_t>(std::ranges::count(soup.see_through, 1)), "see-through"}}),
                     size.x, size.y, size.z, unit.empty() ? "units" : unit, up.empty() ? "+z taken as up" : up + " up");
}

}  // namespace occlude::render
