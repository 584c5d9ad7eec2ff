// SPDX-License-Identifier: MIT
#include "route.h"

#include <algorithm>
#include <cstddef>

#include "plan.h"

namespace occlude::render::city {
namespace {

constexpr std::size_t kFrames = 2748;  // the paper's
constexpr Length kEyeHeight = m(1.7);
constexpr Length kKeyframeSpacing = m(3);  // short enough that straight lines between keyframes keep to the bends
constexpr Length kLookAhead = m(11);       // the camera looks this far ahead along the route, so that it turns before a bend
constexpr Length kBendRadius = m(6);       // corners are rounded from this far before to this far after

Length distance(const Point& a, const Point& b) {
  return integer_sqrt((b.x - a.x) * (b.x - a.x) + (b.y - a.y) * (b.y - a.y));
}

Point between(const Point& a, const Point& b, Length part, Length whole) {
  return {a.x + (b.x - a.x) * part / whole, a.y + (b.y - a.y) * part / whole, a.z + (b.z - a.z) * part / whole};
}

/// The corners of the route up to the lane. The streets are those of plan.cpp; some stretches run along a pavement.
std::vector<Point> corners() {
  const Length pave = kPavementLevel;
  return {
      // London: south on the avenue between the western and the middle column.
      {m(-404), m(128), 0},
      {m(-406), m(40), 0},
      {m(-402), m(-60), 0},
      {m(-404), m(-165), 0},
      // North through the middle column from street to street, the last block of it a garden square.
      {m(-360), m(-166), 0},
      {m(-317), m(-165), 0},
      {m(-316), m(-55), 0},
      {m(-304), m(-54), 0},
      {m(-303), m(54), 0},
      {m(-326), m(55), 0},
      {m(-350), m(54), 0},
      {m(-352), m(104), pave},
      {m(-341), m(130), pave},
      {m(-340), m(165), 0},
      {m(-280), m(164), 0},
      {m(-215), m(165), 0},
      // South on the avenue between the middle and the eastern column, near its houses for a while.
      {m(-217), m(110), 0},
      {m(-213), m(60), 0},
      {m(-211.5), m(-40), 0},
      {m(-216), m(-80), 0},
      {m(-215), m(-129), 0},
      // North through the eastern column, and back along the quay.
      {m(-170), m(-130), 0},
      {m(-131), m(-130), 0},
      {m(-130), m(-20), 0},
      {m(-114), m(-19), 0},
      {m(-113), m(90), 0},
      {m(-70), m(90), 0},
      {m(-26), m(89), 0},
      {m(-25), m(40), 0},
      {m(-26), m(0), 0},
      // Over the causeway and round the north side of the great pyramid.
      {m(60), m(1), 0},
      {m(96), m(0), 0},
      {m(136), m(0), 0},
      {m(152), m(36), 0},
      {m(200), m(58), 0},
      {m(306), m(56), 0},
      {m(307), m(0), 0},
      {m(395), m(0), 0},
  };
}

}  // namespace

const std::vector<Point>& lane() {
  static const std::vector<Point> kLane{{m(404), m(0), 0},  {m(440), m(4), 0},  {m(476), m(24), 0},  {m(516), m(34), 0},
                                        {m(552), m(22), 0}, {m(586), m(-6), 0}, {m(624), m(-24), 0}, {m(666), m(-24), 0},
                                        {m(704), m(-2), 0}, {m(740), m(22), 0}, {m(780), m(30), 0},  {m(818), m(16), 0}};
  return kLane;
}

Route::Route(const Terrain& terrain) {
  std::vector<Point> chain = corners();
  chain.insert(chain.end(), lane().begin(), lane().end());
  // A quadratic curve replaces each corner.
  std::vector<Point> rounded{chain.front()};
  for (std::size_t i = 1; i + 1 < chain.size(); ++i) {
    const Length before = distance(chain[i - 1], chain[i]);
    const Length after = distance(chain[i], chain[i + 1]);
    const Length radius = std::min({kBendRadius, before / 2, after / 2});
    const Point a = between(chain[i], chain[i - 1], radius, before);
    const Point b = between(chain[i], chain[i + 1], radius, after);
    constexpr Length kSteps = 8;
    for (Length s = 0; s <= kSteps; ++s) {
      rounded.push_back(between(between(a, chain[i], s, kSteps), between(chain[i], b, s, kSteps), s, kSteps));
    }
  }
  rounded.push_back(chain.back());
  // The chain is cut finely and laid on the ground.
  for (std::size_t i = 0; i + 1 < rounded.size(); ++i) {
    const Length pieces = std::max<Length>(1, distance(rounded[i], rounded[i + 1]) / m(1));
    for (Length s = 0; s < pieces; ++s) points_.push_back(between(rounded[i], rounded[i + 1], s, pieces));
  }
  points_.push_back(rounded.back());
  Length sum = 0;
  for (std::size_t i = 0; i < points_.size(); ++i) {
    Point& p = points_[i];
    if (p.x >= terrain.extent().x0) p.z = terrain.height(p.x, p.y);
    if (i > 0) sum += distance(points_[i - 1], p);
    at_.push_back(sum);
    if (i % kChunk == 0) chunks_.push_back({p.x, p.y, p.x, p.y});
    Rect& chunk = chunks_.back();
    chunk = {std::min(chunk.x0, p.x), std::min(chunk.y0, p.y), std::max(chunk.x1, p.x), std::max(chunk.y1, p.y)};
  }
}

Point Route::point(Length along) const {
  if (along <= 0) return points_.front();
  if (along >= length()) return points_.back();
  const std::size_t i = static_cast<std::size_t>(std::upper_bound(at_.begin(), at_.end(), along) - at_.begin());
  return between(points_[i - 1], points_[i], along - at_[i - 1], at_[i] - at_[i - 1]);
}

bool Route::crosses(const Rect& rect, Length margin) const {
  const Rect wide = rect.inset(-margin);
  for (std::size_t chunk = 0; chunk < chunks_.size(); ++chunk) {
    if (!chunks_[chunk].meets(wide)) continue;
    const std::size_t end = std::min(points_.size(), (chunk + 1) * kChunk);
    for (std::size_t i = chunk * kChunk; i < end; ++i) {
      const Point& p = points_[i];
      if (wide.meets({p.x, p.y, p.x, p.y})) return true;
    }
  }
  return false;
}

void build_pavement(Builder& b, const Route& route, const Rect& rect, Length z, Length cell, Length parts) {
  constexpr Length kNear = m(9);
  if (rect.width() <= 0 || rect.depth() <= 0) return;
  const Length columns = divide_up(rect.width(), cell);
  const Length rows = divide_up(rect.depth(), cell);
  for (Length j = 0; j < rows; ++j) {
    for (Length i = 0; i < columns; ++i) {
      const Rect piece{rect.x0 + rect.width() * i / columns, rect.y0 + rect.depth() * j / rows,
                       rect.x0 + rect.width() * (i + 1) / columns, rect.y0 + rect.depth() * (j + 1) / rows};
      b.ground(piece, z, route.crosses(piece, kNear) ? divide_up(cell, parts) : cell);
    }
  }
}

bool Route::crosses(const Rect& rect) const { return crosses(rect, kClearance); }

CameraPath film(const Route& route, const Terrain& terrain) {
  CameraPath path;
  path.frames = kFrames;
  // The camera only looks at the last stretch of the route.
  const Length walked = route.length() - 2 * kLookAhead;
  const Length pieces = walked / kKeyframeSpacing;
  const auto metres = [](const Point& p) {
    return glm::dvec3(static_cast<double>(p.x) / 1024.0, static_cast<double>(p.y) / 1024.0,
                      static_cast<double>(p.z) / 1024.0);
  };
  for (Length i = 0; i <= pieces; ++i) {
    const Length along = walked * i / pieces;
    Point eye = route.point(along);
    Point target = route.point(along + kLookAhead);
    // Every 150 m the camera looks to one side, alternately left and right: within 30 m the target swings out by up to 8 m
    // and back.
    constexpr Length kEvery = m(150);
    constexpr Length kSwing = m(30);
    const Length phase = along % kEvery;
    if (phase < kSwing) {
      const Length part = std::min(phase, kSwing - phase) * m(8) / (kSwing / 2);
      const Length sign = (along / kEvery) % 2 == 0 ? 1 : -1;
      const Length reach = std::max<Length>(1, distance(eye, target));
      const Point ahead = target;
      target.x += sign * (eye.y - ahead.y) * part / reach;
      target.y += sign * (ahead.x - eye.x) * part / reach;
      if (target.x >= terrain.extent().x0) target.z = terrain.height(target.x, target.y);
    }
    eye.z += kEyeHeight;
    target.z += kEyeHeight;
    path.keyframes.push_back({metres(eye), metres(target)});
  }
  path.interpolation = CameraPath::Interpolation::linear;
  path.fov_y_deg = 60;
  path.near = 0.1;
  return path;
}

}  // namespace occlude::render::city
