// SPDX-License-Identifier: MIT
#include "occlude/render/missed_report.h"

#include <array>
#include <nlohmann/json.hpp>
#include <string>

namespace occlude::render {

const char* text_of(culler::Missed reason) {
  constexpr std::array<const char*, culler::kMissedReasons> kTexts{
      "it is out of view, but its leaf is not",
      "its leaf is too coarse: its own box is hidden",
      "its box is too coarse: the polygon itself is in a shadow",
      "several occluders hide it together, none alone",
      "an occluder that hides it was listed, but not chosen",
      "no listed occluder hides it alone, or it is visible between pixels",
      "its box extends beyond the coarse picture, or in front of the near plane",
      "it would be hidden, but the frame saved work: its budget was spent, or lately nothing was hidden there",
      "a pixel of its box is open: a border crosses it, or no polygon covers it",
      "the polygons that cover the pixels of its box are not nearer than the box"};
  return kTexts[static_cast<std::size_t>(reason)];
}

nlohmann::ordered_json json_of(const MissedCounts& missed) {
  nlohmann::ordered_json json = {
      {"frames", missed.frames}, {"polygons", missed.counts.missed}, {"asked", missed.counts.asked()}};
  for (std::size_t r = 0; r < culler::kMissedReasons; ++r) {
    const auto reason = static_cast<culler::Missed>(r);
    if (is_of(reason, missed.method)) json[std::string(to_string(reason))] = missed.counts.reasons[r];
  }
  return json;
}

}  // namespace occlude::render
