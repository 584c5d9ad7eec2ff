// SPDX-License-Identifier: MIT
// Ways to draw the same frames, side by side: view-frustum culling alone, the paper's frusta, joined shadows, and the ideal:
// drawing only visible polygons.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "occlude/render/table.h"
#include "occlude/render/walk.h"

namespace occlude::render {

/// Means per frame. The optional numbers need pictures.
struct MethodRow {
  std::string method;
  std::optional<culler::Method> by;         ///< by which what is hidden is culled; none: it is not
  double in_view = 0;                       ///< polygons that pass the view frustum: more of them in larger leaves
  double drawn = 0;                         ///< of these
  double culled_share = 0;                  ///< of the polygons in the view frustum
  std::optional<double> hidden_culled;      ///< share of the hidden polygons in view
  double cull_ms = 0, worst_cull_ms = 0;    ///< 0 if nothing was culled
  std::optional<double> cull_processor_ms;  ///< of culling what is hidden
  /// And by the view frustum alone in the same walk, as the machine was then; their ratio is the speedup.
  std::optional<double> frame_ms, frame_ms_view_frustum_only, speedup;
  /// Over all frames; pixels that the renderer's rounding does not explain. Empty where nothing is culled by shadow.
  std::optional<std::size_t> wrong_pixels, false_culls;
};

using Methods = std::vector<MethodRow>;

/// A walk, and the options by which it culled.
struct MethodWalk {
  const WalkOptions* options;
  const WalkResult* walk;
};

/// A row for each of these walks of the same frames, below that of view-frustum culling alone; that of the ideal comes last
/// if frames were drawn. REQUIRES: at least one walk.
[[nodiscard]] Methods methods_of(const std::vector<MethodWalk>& walks, bool is_drawn);

/// The options of the same walk by each other method, with leaves of the size that is best for it if that is so now. Of a
/// walk that holds: by the same method, culled in each frame. What they find goes nowhere but into the report.
[[nodiscard]] std::vector<WalkOptions> options_beside(const WalkOptions& options);
/// Walks without a report. REQUIRES: the culler is that of make_culler() with these options.
[[nodiscard]] WalkResult walk_beside(const culler::Culler& culler, const CameraPath& path, const WalkOptions& options);

inline constexpr std::array kMethods{culler::Method::automatic, culler::Method::frusta, culler::Method::cover};
/// As options and files have it.
[[nodiscard]] const char* name_of(culler::Method method);
/// In words.
[[nodiscard]] const char* text_of(culler::Method method);
/// The same of a walk, and whether it holds.
[[nodiscard]] std::string method_text(const WalkOptions& options);

[[nodiscard]] Table table_of(const Methods& methods);

}  // namespace occlude::render
