// SPDX-License-Identifier: MIT
// Why hidden polygons were drawn, in words and in JSON.
#pragma once

#include <cstddef>
#include <nlohmann/json_fwd.hpp>

#include "occlude/culler/culler.h"

namespace occlude::render {

/// For each reason, how many of the hidden polygons that some frames drew have it.
struct MissedCounts {
  culler::Method method = culler::Method::frusta;
  std::size_t frames = 0;
  culler::MissedReasons::Counts counts;
};

/// The reason in words.
[[nodiscard]] const char* text_of(culler::Missed reason);

/// In place of a reason.
inline constexpr const char* kUnasked = "not asked: the work for this frame was spent";

/// Frames, polygons, how many of them were asked, and the number for each reason that the method can have.
[[nodiscard]] nlohmann::ordered_json json_of(const MissedCounts& missed);

}  // namespace occlude::render
