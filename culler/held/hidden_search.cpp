// SPDX-License-Identifier: MIT
//
// Whatever a picture is of, a box that it hides is hidden: all of it lies in the picture, and each of its pixels is closed
// nearer. So which pictures there are decides how much is found, and nothing else. From a street most of what is left after
// the first six lies along the horizon, a few pixels high. A picture of that part alone, with as many pixels, hides it.
#include "held/hidden_search.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <optional>
#include <utility>

#include "cover/asked_box.h"
#include "frame/cover_witness.h"
#include "frame/view_memory.h"
#include "held/around_box.h"
#include "model/bounds.h"
#include "occlude/kernel/validity.h"

namespace occlude::culler {
namespace {

/// A closer picture has at most this share of the area of the one before.
constexpr double kCloser = 0.25;
/// What is wider or higher than this share of a picture would not fit into closer ones.
constexpr double kLargest = 0.25;
/// A picture that hides less than this share of what it is for is not looked at closer: most of that is really seen.
constexpr double kLeastGain = 0.1;
/// Nothing nearer than this share of the distance of what is asked hides it. Layers of pictures are as much closer to what
/// is far.
constexpr double kNearOfDistance = 1.0 / 16;
/// No picture is more than so many times as wide as high, or as high as wide.
constexpr double kLongestPicture = 8;
/// The tangent of half the least opening of a camera is 2^-17; a picture has more.
constexpr double kLeastOpening = 0x1p-14;

glm::dvec2 opening_of(const Camera& camera) {
  const double up = std::tan(glm::radians(camera.fov_y_deg) / 2);
  return {up * camera.aspect, up};
}

/// A camera with the same eyes that has a rectangle of the picture in its own. None if that is too narrow.
std::optional<Camera> closer(Camera camera, const glm::dvec2& low, const glm::dvec2& high) {
  const Camera::Axes from = camera.axes();
  const auto ray = [&](double x, double y) { return from.forward + x * from.right + y * from.up; };
  const glm::dvec2 middle = (low + high) / 2.0;
  camera.target = camera.eye + std::max(1.0, glm::length(camera.eye)) * ray(middle.x, middle.y);
  const Camera::Axes axes = camera.axes();
  glm::dvec2 half{kLeastOpening, kLeastOpening};
  for (const glm::dvec3& corner : {ray(low.x, low.y), ray(low.x, high.y), ray(high.x, low.y), ray(high.x, high.y)}) {
    const double away = glm::dot(corner, axes.forward);
    if (!(away > 0)) return std::nullopt;
    half = glm::max(half, glm::abs(glm::dvec2(glm::dot(corner, axes.right), glm::dot(corner, axes.up))) / away);
  }
  half = glm::max(half, glm::dvec2(half.y, half.x) / kLongestPicture);
  camera.fov_y_deg = glm::degrees(2 * std::atan(half.y));
  camera.aspect = half.x / half.y;
  return fault(camera).empty() ? std::optional(camera) : std::nullopt;
}

}  // namespace

HiddenSearch::HiddenSearch(const Culler& culler, std::span<const kernel::Aabb> boxes, Options options)
    : culler_(culler), boxes_(boxes), options_(std::move(options)) {
  cull_.method = Method::cover;
}

void HiddenSearch::look_from(const kernel::Aabb& eyes, Known& known) {
  eyes_ = eyes;
  known_ = &known;
  const auto cameras = cameras_around(eyes);
  const bool is_first = !std::exchange(known.has_looked, true);
  if (is_first) {
    for (const Camera& camera : cameras) look(camera, options_.side, options_.side);
  }
  Polygons seen;
  for (std::uint32_t p = 0; p < culler_.hierarchy().soup().size(); ++p) {
    if (!is_hidden(p)) seen.push_back(p);
  }
  few_ = std::max<std::size_t>(1, static_cast<std::size_t>(options_.closer * static_cast<double>(seen.size())));
  for (const Camera& camera : cameras) {
    Places places = places_of(camera, seen);
    if (!is_first && places.large >= few_) look(camera, options_.side, options_.side);
    look_closer(camera, places.small);
  }
}

/// Names what hides those that the frame found.
void HiddenSearch::tell(const Camera& camera, const CullResult& frame, std::span<const std::uint32_t> by_themselves) {
  if (found_.empty()) return;
  std::vector<CoverWitness> covers;
  append_covers(culler_, frame, camera, cull_, options_.most_corners, by_themselves, covers);
  std::ranges::sort(found_);
  options_.found(camera, found_, covers);
}

/// Asks all that a frame draws, and all other boxes, by themselves.
void HiddenSearch::look(const Camera& camera, int width, int height) {
  if (options_.before) options_.before();
  found_.clear();
  const std::size_t polygons = culler_.hierarchy().soup().size();
  const auto hide = [&](std::uint32_t first, std::uint32_t count) {
    for (std::uint32_t i = first; options_.found && i < first + count; ++i) {
      if (!is_hidden(i) && i < polygons) found_.push_back(i);
    }
    std::fill_n(known_->is_hidden.begin() + first, count, std::uint8_t{1});
  };
  cull_.cover.width = width;
  cull_.cover.height = height;
  const CullResult& frame = culler_.cull(camera, cull_, view_);
  const std::span nodes = culler_.hierarchy().nodes();
  for (const Culled& culled : frame.culled) {
    if (culled.by == Culled::By::cover) hide(nodes[culled.node].first, nodes[culled.node].count);
  }
  const std::size_t by_nodes = found_.size();
  asked_.clear();
  const auto ask = [&](std::size_t first, std::size_t end) {
    for (auto i = static_cast<std::uint32_t>(first); i < end; ++i) {
      if (!is_hidden(i)) asked_.push_back(i);
    }
  };
  for (const auto& [first, count] : frame.drawn) ask(first, first + count);
  ask(polygons, boxes_.size());
  for_each_hidden(memory_of(view_).cover.buffer, boxes_, asked_, [&](std::uint32_t i) { hide(i, 1); });
  const Polygons by_themselves(found_.begin() + static_cast<std::ptrdiff_t>(by_nodes), found_.end());
  tell(camera, frame, by_themselves);
}

/// Where those of the polygons are that are not hidden, have their middle in the picture and are not too near.
HiddenSearch::Places HiddenSearch::places_of(const Camera& camera, const Polygons& polygons) const {
  const Camera::Axes axes = camera.axes();
  const glm::dvec2 half = opening_of(camera), most = 2 * kLargest * half;
  const double nearest = 2 * camera.eyes.reach(axes.forward);
  Places places;
  for (const std::uint32_t p : polygons) {
    if (is_hidden(p)) continue;
    const glm::dvec3 to = to_glm(middle(boxes_[p])) - camera.eye;
    const double away = glm::dot(to, axes.forward);
    if (!(away > nearest) || std::fabs(glm::dot(to, axes.right)) > half.x * away ||
        std::fabs(glm::dot(to, axes.up)) > half.y * away)
      continue;
    Place place{p, HUGE_VAL, HUGE_VAL, -HUGE_VAL, -HUGE_VAL};
    bool is_near = false;
    for (unsigned i = 0; i < 8; ++i) {
      const glm::dvec3 at = to_glm(corner(boxes_[p], i)) - camera.eye;
      const double forward = glm::dot(at, axes.forward), x = glm::dot(at, axes.right) / forward,
                   y = glm::dot(at, axes.up) / forward;
      is_near = is_near || !(forward > nearest);
      place = {p, std::min(place.low_x, x), std::min(place.low_y, y), std::max(place.high_x, x), std::max(place.high_y, y)};
    }
    if (is_near) continue;
    if (place.high_x - place.low_x > most.x || place.high_y - place.low_y > most.y) {
      ++places.large;
    } else {
      places.small.push_back(place);
    }
  }
  return places;
}

/// Divides the places until a picture of them is closer, and looks.
void HiddenSearch::look_closer(const Camera& camera, std::span<Place> places) {
  if (places.size() < few_) return;
  glm::dvec2 low{HUGE_VAL, HUGE_VAL}, high = -low;
  for (const Place& place : places) {
    low = glm::min(low, glm::dvec2(place.low_x, place.low_y));
    high = glm::max(high, glm::dvec2(place.high_x, place.high_y));
  }
  const glm::dvec2 share = (high - low) / (2.0 * opening_of(camera));
  if (share.x * share.y > kCloser) {
    const bool is_across = share.x >= share.y;
    const auto before = [&](const Place& a, const Place& b) {
      const double at = is_across ? a.low_x + a.high_x : a.low_y + a.high_y,
                   of = is_across ? b.low_x + b.high_x : b.low_y + b.high_y;
      return at != of ? at < of : a.polygon < b.polygon;
    };
    const std::size_t half = places.size() / 2;
    std::ranges::nth_element(places, places.begin() + static_cast<std::ptrdiff_t>(half), before);
    look_closer(camera, places.first(half));
    return look_closer(camera, places.subspan(half));
  }
  Polygons polygons;
  double nearest = HUGE_VAL;
  for (const Place& place : places) {
    if (is_hidden(place.polygon)) continue;  // since then
    polygons.push_back(place.polygon);
    nearest = std::min(nearest, distance(eyes_, boxes_[place.polygon]));
  }
  auto picture = closer(camera, low, high);
  if (polygons.size() < few_ || !picture) return;
  picture->near_plane = std::max(picture->near_plane, kNearOfDistance * nearest);
  const double wider = std::sqrt(picture->aspect), side = options_.side;
  look(*picture, static_cast<int>(side * wider), static_cast<int>(side / wider));
  const auto hidden = std::ranges::count_if(polygons, [&](std::uint32_t p) { return is_hidden(p); });
  if (static_cast<double>(hidden) < kLeastGain * static_cast<double>(polygons.size())) return;
  Places left = places_of(*picture, polygons);
  look_closer(*picture, left.small);
}

}  // namespace occlude::culler
