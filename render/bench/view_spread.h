// SPDX-License-Identifier: MIT
// What the frames of a view of a scene take, and what they draw.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "occlude/culler/scene.h"
#include "spread.h"

namespace occlude::experiments {

/// Over the frames of a view: milliseconds of a cull, and what became of the objects.
struct ViewSpread {
  Spread cull_ms, drawn, hidden, out_of_view;
};

/// Collects the frames.
class ViewSamples {
 public:
  void add(double cull_ms, const culler::SceneStats& stats);
  [[nodiscard]] ViewSpread spread() const;

 private:
  std::vector<double> cull_ms_, drawn_, hidden_, out_of_view_;
};

/// Rows of a table, each named after `of` and what it shows.
[[nodiscard]] std::vector<std::vector<render::Cell>> rows_of(const std::string& of, const ViewSpread& view);
/// A member for each.
[[nodiscard]] nlohmann::ordered_json json_of(const ViewSpread& view);

}  // namespace occlude::experiments
