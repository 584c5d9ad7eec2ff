// SPDX-License-Identifier: MIT
#include "validation.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "item_buffers.h"

namespace occlude::cli {
namespace {

/// Sums over all frames.
struct Totals {
  explicit Totals(const Visibility& visibility) : frames(visibility.frames.size()) {
    for (const FrameVisibility& f : visibility.frames) {
      in_view += f.in_view;
      drawn += f.drawn;
      visible += f.visible;
      false_culls += f.false_culls;
      wrong_pixels += f.wrong_pixels;
      hidden += f.hidden;
      hidden_culled += f.hidden_culled;
    }
  }

  /// Bittner's measures of what is drawn: hidden polygons drawn, and visible ones not drawn, for each visible polygon.
  [[nodiscard]] double overestimate() const { return share(drawn + false_culls - visible, visible); }
  [[nodiscard]] double underestimate() const { return share(false_culls, visible); }
  [[nodiscard]] double culled_share_of_hidden() const { return share(hidden_culled, hidden); }

  [[nodiscard]] double mean(std::size_t sum) const { return share(sum, frames); }

  static double share(std::size_t part, std::size_t whole) {
    return whole == 0 ? 0 : static_cast<double>(part) / static_cast<double>(whole);
  }

  std::size_t frames, in_view = 0, drawn = 0, visible = 0, false_culls = 0, wrong_pixels = 0, hidden = 0, hidden_culled = 0;
};

}  // namespace

bool passed(const Validation& validation) { return validation.failed == 0 && validation.visibility.false_culls.empty(); }

std::string to_text(const Validation& v) {
  const Totals t(v.visibility);
  std::string text = fmt::format("{} of {} witnesses proved\n", v.proved, v.proved + v.failed);
  if (t.frames == 0) return text;
  if (v.is_exact) {
    text += fmt::format("false culls {} in {} frames, by exact visibility\n", t.false_culls, t.frames);
  } else {
    text +=
        fmt::format("false culls {}, wrong pixels {} in {} frames, by item buffers in {} sizes at {} sub-pixel offsets\n",
                    t.false_culls, t.wrong_pixels, t.frames, v.sizes, ItemBuffers::kOffsets);
  }
  text += fmt::format("a frame: {:.0f} polygons in view, {:.0f} drawn, {:.0f} visible; of the hidden {:.1f} % culled\n",
                      t.mean(t.in_view), t.mean(t.drawn), t.mean(t.visible), 100 * t.culled_share_of_hidden());
  text += fmt::format(
      "for each visible polygon {:.3g} hidden ones drawn (overestimate), {:.3g} visible ones not (underestimate)\n",
      t.overestimate(), t.underestimate());
  if (!v.missed) return text;
  const auto& [method, frames, counts] = *v.missed;
  const std::string of_some =
      counts.asked() == counts.missed ? "" : fmt::format(" (of {} of {} that were asked)", counts.asked(), counts.missed);
  text += fmt::format("without a pixel and drawn in {} of the frames, {:.0f} a frame, because{}\n", frames,
                      t.share(counts.missed, frames), of_some);
  for (std::size_t r = 0; r < culler::kMissedReasons; ++r) {
    const auto reason = static_cast<culler::Missed>(r);
    if (!is_of(reason, method)) continue;
    text += fmt::format("{:>7.1f} %  {}\n", 100 * t.share(counts.reasons[r], counts.asked()), render::text_of(reason));
  }
  return text;
}

std::string to_json(const Validation& v) {
  using Json = nlohmann::ordered_json;
  const Totals t(v.visibility);
  Json visibility = {{"by", v.is_exact ? "exact" : "item_buffers"},
                     {"frames", t.frames},
                     {"sizes", v.is_exact ? Json() : Json(v.sizes)},
                     {"offsets", v.is_exact ? Json() : Json(ItemBuffers::kOffsets)},
                     {"false_culls", t.false_culls},
                     {"wrong_pixels", v.is_exact ? Json() : Json(t.wrong_pixels)},
                     {"mean",
                      {{"view_frustum_polygons", t.mean(t.in_view)},
                       {"rendered_polygons", t.mean(t.drawn)},
                       {"visible_polygons", t.mean(t.visible)}}},
                     {"sum",
                      {{"view_frustum_polygons", t.in_view},
                       {"rendered_polygons", t.drawn},
                       {"visible_polygons", t.visible},
                       {"hidden_polygons", t.hidden},
                       {"hidden_polygons_culled", t.hidden_culled}}},
                     {"culled_share_of_hidden", t.culled_share_of_hidden()},
                     {"overestimate", t.overestimate()},
                     {"underestimate", t.underestimate()}};
  return Json{{"witnesses", v.proved + v.failed},
              {"proved", v.proved},
              {"failed", v.failed},
              {"visibility", t.frames == 0 ? Json() : visibility},
              {"missed", v.missed ? render::json_of(*v.missed) : Json()}}
             .dump(2) +
         "\n";
}

}  // namespace occlude::cli
