// SPDX-License-Identifier: MIT
#include "floors.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include "rounds.h"

namespace occlude::render {
namespace {

using glm::dvec3;

// Columns and spans: some 200 MB at most, and a second.
constexpr double kMostColumns = 1 << 20;
constexpr double kMostSpans = 8e6;
// Columns of an eighth of the eye height, 0.21 m, or finer where the model is small, down to a third of that. Wider than
// kWidestColumn none goes through a door.
constexpr double kColumn = 1.0 / 8, kFinest = 1.0 / 24, kWidestColumn = 1.0 / 5;
constexpr double kLevel = 0.7;  // the cosine of 45 degrees: floors are no steeper

bool is_level(const dvec3& normal) { return std::fabs(normal.z) >= kLevel * glm::length(normal) && normal.z != 0; }

/// The square of width `width` with the most polygons, of those of a raster. Its low corner.
glm::dvec2 densest_square(const Place& place, double width) {
  constexpr std::size_t kRaster = 256;
  const dvec3 size = place.size();
  std::vector<std::uint64_t> sums((kRaster + 1) * (kRaster + 1));  // of all polygons at lower cells
  const auto cell = [&](double at, double extent) {
    return extent > 0 ? std::min<std::size_t>(kRaster - 1, static_cast<std::size_t>(at / extent * kRaster)) : 0;
  };
  const auto at = [](std::size_t i, std::size_t j) { return j * (kRaster + 1) + i; };
  for (std::size_t p = 0; p < place.soup.size(); ++p) {
    const dvec3 corner = place.points[place.soup.loop(p)[0]] - place.low;
    ++sums[at(cell(corner.x, size.x) + 1, cell(corner.y, size.y) + 1)];
  }
  for (std::size_t j = 1; j <= kRaster; ++j) {
    for (std::size_t i = 1; i <= kRaster; ++i)
      sums[at(i, j)] += sums[at(i - 1, j)] + sums[at(i, j - 1)] - sums[at(i - 1, j - 1)];
  }
  const auto cells = [&](double extent) {
    return extent > width ? std::max<std::size_t>(1, static_cast<std::size_t>(width / extent * kRaster)) : kRaster;
  };
  const std::size_t wide = cells(size.x), deep = cells(size.y);
  std::uint64_t most = 0;
  std::size_t best_i = 0, best_j = 0;
  for (std::size_t j = 0; j + deep <= kRaster; ++j) {
    for (std::size_t i = 0; i + wide <= kRaster; ++i) {
      const std::uint64_t count =
          sums[at(i + wide, j + deep)] - sums[at(i, j + deep)] - sums[at(i + wide, j)] + sums[at(i, j)];
      if (count <= most) continue;
      most = count;
      best_i = i;
      best_j = j;
    }
  }
  return {place.low.x + size.x * static_cast<double>(best_i) / kRaster,
          place.low.y + size.y * static_cast<double>(best_j) / kRaster};
}

/// The columns over the rectangle, and one more on each side.
Columns columns_over(const glm::dvec2& corner, double width, double depth, double cell) {
  const auto count = [&](double extent) { return static_cast<std::uint32_t>(extent / cell) + 3; };
  return {corner.x - cell, corner.y - cell, cell, count(width), count(depth)};
}

/// About how many spans the triangles over the columns have.
double spans(const Place& place, const Columns& columns) {
  const double right = columns.x + columns.cell * columns.nx, back = columns.y + columns.cell * columns.ny;
  double sum = 0;
  place.for_each_triangle([&](const dvec3& a, const dvec3& b, const dvec3& c) {
    const dvec3 low = glm::min(a, glm::min(b, c)), high = glm::max(a, glm::max(b, c));
    if (low.x > right || high.x < columns.x || low.y > back || high.y < columns.y) return;
    const double width = std::min(high.x, right) - std::max(low.x, columns.x);
    const double depth = std::min(high.y, back) - std::max(low.y, columns.y);
    const double area = std::min(width * depth, 0.5 * std::fabs(glm::cross(b - a, c - a).z));
    sum += cells_of(area, 2 * (width + depth), columns.cell);
  });
  return sum;
}

}  // namespace

std::optional<Floors> Floors::find(const Place& place, const culler::Checkpoint& checkpoint) {
  const dvec3 size = place.size();
  const double eye = place.eye_height;
  double cell = std::max(std::sqrt(size.x * size.y / kMostColumns), kFinest * eye);
  double width = size.x, depth = size.y;
  glm::dvec2 corner(place.low);
  if (cell > kColumn * eye) {
    cell = kColumn * eye;
    const double side = cell * std::sqrt(kMostColumns);
    corner = densest_square(place, side);
    width = std::min(width, side);
    depth = std::min(depth, side);
  }
  for (; cell <= kWidestColumn * eye; cell *= 1.25) {
    const Columns columns = columns_over(corner, width, depth, cell);
    checkpoint();
    if (spans(place, columns) <= kMostSpans) return Floors(place, columns, checkpoint);
  }
  return std::nullopt;
}

Floors::Floors(const Place& place, const Columns& columns, const culler::Checkpoint& checkpoint)
    : place_(place), columns_(columns) {
  find_spans(checkpoint);
  merge_spans();
  find_stands();
  checkpoint();
  link_stands();
  checkpoint();
  find_clearance(checkpoint);
  find_enclosure();
  checkpoint();
  find_air();
}

/// Spans of single triangles, column by column: they are counted, and then put in their places.
void Floors::find_spans(const culler::Checkpoint& checkpoint) {
  std::size_t triangle = 0;
  const auto for_each_span = [&](auto&& visit) {
    place_.for_each_triangle([&](const dvec3& a, const dvec3& b, const dvec3& c) {
      checkpoint.at(triangle++);
      const dvec3 normal = glm::cross(b - a, c - a);
      const unsigned up = normal.z > 0 ? kTopUp | kBottomUp : 0;
      const auto bits = static_cast<std::uint8_t>(up | (is_level(normal) ? kLevelTop : 0));
      for_each_column(columns_, a, b, c, [&](std::size_t column, double low, double high) {
        visit(column, Span{static_cast<float>(low), static_cast<float>(high), bits});
      });
    });
  };
  first_span_.assign(columns_.size() + 1, 0);
  for_each_span([&](std::size_t column, const Span&) { ++first_span_[column + 1]; });
  for (std::size_t c = 0; c < columns_.size(); ++c) first_span_[c + 1] += first_span_[c];
  spans_.resize(first_span_.back());
  std::vector<std::uint32_t> next(first_span_.begin(), first_span_.end() - 1);
  for_each_span([&](std::size_t column, const Span& span) { spans_[next[column]++] = span; });
}

/// Spans of a column that meet become one.
void Floors::merge_spans() {
  // What is lower than this above a floor, 7 mm, does not hide that it is level.
  const auto same = static_cast<float>(0.004 * place_.eye_height);
  std::uint32_t kept = 0;
  for (std::size_t c = 0; c < columns_.size(); ++c) {
    const std::uint32_t begin = first_span_[c], end = first_span_[c + 1];
    std::sort(spans_.begin() + begin, spans_.begin() + end, [](const Span& a, const Span& b) {
      return std::pair(a.low, a.high) != std::pair(b.low, b.high) ? std::pair(a.low, a.high) < std::pair(b.low, b.high)
                                                                  : a.bits < b.bits;
    });
    const std::uint32_t first = kept;
    for (std::uint32_t s = begin; s < end; ++s) {
      const Span span = spans_[s];
      if (kept == first || span.low > spans_[kept - 1].high) {
        spans_[kept++] = span;
        continue;
      }
      Span& below = spans_[kept - 1];
      unsigned bits = below.bits;
      if (span.high > below.high + same) bits &= ~static_cast<unsigned>(kLevelTop);
      if (span.high >= below.high - same) bits |= span.bits & static_cast<unsigned>(kLevelTop);
      if (span.high > below.high)
        bits = (bits & ~static_cast<unsigned>(kTopUp)) | (span.bits & static_cast<unsigned>(kTopUp));
      below.bits = static_cast<std::uint8_t>(bits);
      below.high = std::max(below.high, span.high);
    }
    first_span_[c] = first;
  }
  first_span_.back() = kept;
  spans_.resize(kept);
}

/// One stands on level spans with headroom, and on what lies on such a span and is no higher than a step.
void Floors::find_stands() {
  const auto headroom = static_cast<float>(walker::kHeadroom * place_.eye_height);
  const auto step = static_cast<float>(walker::kStep * place_.eye_height);
  first_stand_.assign(columns_.size() + 1, 0);
  for (std::uint32_t c = 0; c < columns_.size(); ++c) {
    float level = -std::numeric_limits<float>::infinity();  // of the last level span
    for (std::uint32_t s = first_span_[c]; s < first_span_[c + 1]; ++s) {
      if ((spans_[s].bits & kLevelTop) != 0) level = spans_[s].high;
      if (spans_[s].high - level > step) continue;
      const float ceiling = s + 1 < first_span_[c + 1] ? spans_[s + 1].low : std::numeric_limits<float>::infinity();
      if (ceiling - spans_[s].high >= headroom)
        stands_.push_back({spans_[s].high, ceiling, c, s, {kNone, kNone, kNone, kNone}});
    }
    first_stand_[c + 1] = static_cast<std::uint32_t>(stands_.size());
  }
}

std::uint32_t Floors::neighbour(std::uint32_t column, int dx, int dy) const {
  const auto i = static_cast<std::int64_t>(column % columns_.nx) + dx,
             j = static_cast<std::int64_t>(column / columns_.nx) + dy;
  if (i < 0 || j < 0 || i >= columns_.nx || j >= columns_.ny) return kNone;
  return static_cast<std::uint32_t>(j * columns_.nx + i);
}

namespace {
constexpr std::array<std::pair<int, int>, 4> kDirections = {{{1, 0}, {0, 1}, {-1, 0}, {0, -1}}};
}

void Floors::link_stands() {
  const auto headroom = static_cast<float>(walker::kHeadroom * place_.eye_height);
  const auto step = static_cast<float>(walker::kStep * place_.eye_height);
  for (Stand& stand : stands_) {
    for (unsigned d = 0; d < 4; ++d) {
      const std::uint32_t column = neighbour(stand.column, kDirections[d].first, kDirections[d].second);
      if (column == kNone) continue;
      // Stands in one column are farther apart than two steps, so that there is one at most.
      for (std::uint32_t s = first_stand_[column]; s < first_stand_[column + 1]; ++s) {
        const Stand& other = stands_[s];
        const float room = std::min(stand.ceiling, other.ceiling) - std::max(stand.floor, other.floor);
        if (std::fabs(other.floor - stand.floor) <= step && room >= headroom) stand.next[d] = s;
      }
    }
  }
}

std::uint32_t Floors::diagonal(std::uint32_t stand, unsigned d) const {
  const auto then = [&](std::uint32_t from, unsigned direction) {
    return from == kNone ? kNone : stands_[from].next[direction % 4];
  };
  const std::uint32_t one = then(then(stand, d), d + 1), other = then(then(stand, d + 1), d);
  return one == other ? one : kNone;
}

void Floors::find_clearance(const culler::Checkpoint& checkpoint) {
  std::vector<std::uint32_t> border;
  for (std::uint32_t s = 0; s < stands_.size(); ++s) {
    const auto& next = stands_[s].next;
    if (std::find(next.begin(), next.end(), kNone) != next.end()) border.push_back(s);
  }
  clearance_ = costs(*this, border, checkpoint);
}

bool Floors::is_wall(std::uint32_t column, const Stand& before) const {
  const auto eye = static_cast<float>(place_.eye_height);
  const float low = before.floor + eye / 2, high = before.floor + eye;
  for (std::uint32_t s = first_span_[column]; s < first_span_[column + 1]; ++s) {
    if (spans_[s].low <= high && spans_[s].high >= low) return true;
  }
  return false;
}

/// How far walls are in the eight directions: one column more than from the next stand on.
void Floors::find_enclosure() {
  constexpr std::uint8_t kNever = 255;
  const auto limit = static_cast<unsigned>(std::min(254.0, walker::kSurroundings * place_.eye_height / columns_.cell));
  const auto ceiling = static_cast<float>(walker::kCeiling * place_.eye_height);
  std::vector<std::array<std::uint8_t, 8>> walls(stands_.size());
  const auto look = [&](std::uint32_t s, unsigned d, bool is_diagonal) {
    const auto [dx, dy] = kDirections[d];
    const auto [ex, ey] = kDirections[(d + 1) % 4];
    const unsigned way = 2 * d + (is_diagonal ? 1 : 0);
    const std::uint32_t next = is_diagonal ? diagonal(s, d) : stands_[s].next[d];
    std::uint8_t& wall = walls[s][way];
    wall = kNever;
    if (next != kNone) {
      if (walls[next][way] < limit) wall = static_cast<std::uint8_t>(walls[next][way] + 1);
      return;
    }
    const std::uint32_t column =
        is_diagonal ? neighbour(stands_[s].column, dx + ex, dy + ey) : neighbour(stands_[s].column, dx, dy);
    if (column != kNone && is_wall(column, stands_[s])) wall = 1;
  };
  // +x, +x +y, +y and +y -x lead to later stands, their opposites to earlier ones.
  const auto count = static_cast<std::uint32_t>(stands_.size());
  for (std::uint32_t s = count; s-- > 0;) {
    for (const unsigned d : {0U, 1U}) look(s, d, false), look(s, d, true);
  }
  enclosure_.resize(count);
  for (std::uint32_t s = 0; s < count; ++s) {
    for (const unsigned d : {2U, 3U}) look(s, d, false), look(s, d, true);
    const auto seen = std::count_if(walls[s].begin(), walls[s].end(), [](std::uint8_t wall) { return wall != kNever; });
    const int above = stands_[s].ceiling - stands_[s].floor <= ceiling ? 2 : 0;
    enclosure_[s] = static_cast<std::uint8_t>(seen + above);
  }
}

/// Air spreads from above and below all spans into the gaps between spans, from column to column.
void Floors::find_air() {
  const auto crack = static_cast<float>(columns_.cell / 2);  // what is lower lets no air through
  std::vector<std::uint32_t> column_of(spans_.size());
  std::vector<std::uint32_t> waiting;
  is_airy_.assign(spans_.size(), 0);
  for (std::uint32_t c = 0; c < columns_.size(); ++c) {
    for (std::uint32_t s = first_span_[c]; s < first_span_[c + 1]; ++s) column_of[s] = c;
    if (first_span_[c] < first_span_[c + 1]) {
      waiting.push_back(first_span_[c + 1] - 1);
      is_airy_[waiting.back()] = 1;
    }
  }
  const auto top = [&](std::uint32_t span) {
    return span + 1 < first_span_[column_of[span] + 1] ? spans_[span + 1].low : std::numeric_limits<float>::infinity();
  };
  const auto spread = [&](std::uint32_t column, float low, float high) {
    for (std::uint32_t s = first_span_[column]; s < first_span_[column + 1]; ++s) {
      if (is_airy_[s] != 0 || std::min(high, top(s)) - std::max(low, spans_[s].high) < crack) continue;
      is_airy_[s] = 1;
      waiting.push_back(s);
    }
  };
  const auto spread_around = [&](std::uint32_t column, float low, float high) {
    for (const auto& [dx, dy] : kDirections) {
      if (const std::uint32_t next = neighbour(column, dx, dy); next != kNone) spread(next, low, high);
    }
  };
  constexpr float kDeep = -std::numeric_limits<float>::infinity();
  for (std::uint32_t c = 0; c < columns_.size(); ++c) {
    const bool is_empty = first_span_[c] == first_span_[c + 1];
    spread_around(c, kDeep, is_empty ? -kDeep : spans_[first_span_[c]].low);
  }
  while (!waiting.empty()) {
    const std::uint32_t span = waiting.back();
    waiting.pop_back();
    spread_around(column_of[span], spans_[span].high, top(span));
  }
}

int Floors::fronts(std::uint32_t stand) const {
  const std::uint32_t s = stands_[stand].span;
  const bool has_ceiling = s + 1 < first_span_[stands_[stand].column + 1];
  const int floor = (spans_[s].bits & kTopUp) != 0 ? 1 : 0;
  return floor + (has_ceiling && (spans_[s + 1].bits & kBottomUp) == 0 ? 1 : 0);
}

}  // namespace occlude::render
