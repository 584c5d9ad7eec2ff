// SPDX-License-Identifier: MIT
#include "view_spread.h"

#include <nlohmann/json.hpp>

namespace occlude::experiments {

void ViewSamples::add(double cull_ms, const culler::SceneStats& stats) {
  cull_ms_.push_back(cull_ms);
  drawn_.push_back(static_cast<double>(stats.drawn));
  hidden_.push_back(static_cast<double>(stats.hidden));
  out_of_view_.push_back(static_cast<double>(stats.out_of_view));
}

ViewSpread ViewSamples::spread() const {
  return {spread_of(cull_ms_), spread_of(drawn_), spread_of(hidden_), spread_of(out_of_view_)};
}

std::vector<std::vector<render::Cell>> rows_of(const std::string& of, const ViewSpread& view) {
  return {row_of(of + "cull, ms", view.cull_ms, 2), row_of(of + "objects drawn", view.drawn, 0),
          row_of(of + "objects hidden", view.hidden, 0), row_of(of + "objects out of view", view.out_of_view, 0)};
}

nlohmann::ordered_json json_of(const ViewSpread& view) {
  return {{"cull_ms", json_of(view.cull_ms)},
          {"drawn", json_of(view.drawn)},
          {"hidden", json_of(view.hidden)},
          {"out_of_view", json_of(view.out_of_view)}};
}

}  // namespace occlude::experiments
