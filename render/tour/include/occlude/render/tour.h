// SPDX-License-Identifier: MIT
// A camera path for a model that comes without one.
#pragma once

#include <cstddef>
#include <glm/vec3.hpp>
#include <string_view>

#include "occlude/culler/executor.h"
#include "occlude/culler/polygon_soup.h"
#include "occlude/render/camera_path.h"

namespace occlude::render {

/// `walk`: through the model at eye height, where there is a floor. `fly`: once round the model, in by its largest openings
/// and out again. `orbit`: once round it. `automatic`: a walk between walls if there is room for one, else as `fly`.
enum class TourKind { automatic, walk, fly, orbit };

/// The name of the enumerator.
[[nodiscard]] constexpr std::string_view to_string(TourKind kind) {
  constexpr std::string_view kNames[] = {"automatic", "walk", "fly", "orbit"};
  return kNames[static_cast<std::size_t>(kind)];
}

struct Tour {
  TourKind kind = TourKind::orbit;  ///< what was made; never `automatic`
  CameraPath path;                  ///< a keyframe for each frame; `model` is empty
};

/// Makes a path of about 300 frames. Where the model has no way of the kind wanted, a walk becomes a flight and a flight an
/// orbit. It is a walk at 1.7 units above the floor if the model is from 3 to 100,000 units large.
///
/// 1. No straight line between the eyes of consecutive frames meets a triangle of the model, decided exactly.
/// 2. No triangle is as near to such a line as a corner of the near plane of a picture up to 2.8 times as wide as high.
/// 3. The path is the same for the same soup on every machine whose mathematical functions round alike.
///
/// What `checkpoint` throws is thrown on. Throws std::invalid_argument, with the reason, if an eye outside of the model
/// would have no legal coordinates. REQUIRES: the soup is well formed, legal and not empty; `up` is a unit vector.
[[nodiscard]] Tour make_tour(culler::SoupView soup, const glm::dvec3& up, TourKind kind,
                             const culler::Checkpoint& checkpoint = {});

}  // namespace occlude::render
