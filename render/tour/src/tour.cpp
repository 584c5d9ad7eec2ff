// SPDX-License-Identifier: MIT
#include "occlude/render/tour.h"

#include <stdexcept>

#include "around.h"
#include "on_foot.h"
#include "place.h"
#include "through_air.h"

namespace occlude::render {

Tour make_tour(culler::SoupView soup, const glm::dvec3& up, TourKind kind, const culler::Checkpoint& checkpoint) {
  const Place place(soup, up);
  if (kind == TourKind::walk || kind == TourKind::automatic) {
    if (auto path = on_foot(place, kind == TourKind::automatic, checkpoint)) return {TourKind::walk, std::move(*path)};
  }
  if (kind != TourKind::orbit) {
    if (auto path = through_air(place, checkpoint)) return {TourKind::fly, std::move(*path)};
  }
  if (auto path = around(place)) return {TourKind::orbit, std::move(*path)};
  throw std::invalid_argument(
      "an eye outside of the model has no legal coordinates: it is too large, or too small where it is");
}

}  // namespace occlude::render
