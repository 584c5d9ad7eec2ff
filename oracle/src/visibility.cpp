// SPDX-License-Identifier: MIT
// The rays that meet a triangle form a cone, which is one convex piece. Every other triangle is subtracted from it, as far
// as that triangle is in front. The triangle shows as soon as some part is left by all others. A piece is stored as the
// lines that bound it, and a corner as the two lines that meet there. So every sign is that of a determinant of three lines
// of the input, however often pieces are cut.
#include "occlude/oracle/visibility.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <optional>
#include <utility>

#include "rays.h"

namespace occlude::oracle {
namespace {

constexpr std::size_t kEdges = 3;

template <class N>
Form<N> form_of(const HalfSpaceCoefficients& h) {
  return {N(h[0]), N(h[1]), N(h[2]), N(h[3])};
}

/// A triangle that is not seen edge-on, turned so that its rays run anticlockwise.
class Surface {
 public:
  /// Empty for a triangle seen edge-on.
  static std::optional<Surface> make(const Rays& rays, const Triangle& triangle) {
    const auto turn = [&]<class N>() -> N {
      return CGAL::determinant(rays.through<N>(triangle[0]), rays.through<N>(triangle[1]), rays.through<N>(triangle[2]));
    };
    const CGAL::Sign sign = sign_of(turn);
    if (sign == CGAL::ZERO) return std::nullopt;
    Surface surface(triangle);
    if (sign == CGAL::NEGATIVE) std::swap(surface.corners_[1], surface.corners_[2]);
    surface.faces_away_ = sign_of([&]<class N>() -> N { return rays.at_viewpoint(surface.plane<N>()); }) == CGAL::NEGATIVE;
    return surface;
  }

  [[nodiscard]] const Triangle& corners() const { return corners_; }

  /// Its plane, with the sign that is positive at W (rays.h).
  template <class N>
  [[nodiscard]] Form<N> plane() const {
    const Vector<N> normal =
        CGAL::cross_product(difference<N>(corners_[0], corners_[1]), difference<N>(corners_[0], corners_[2]));
    const N offset = -(normal * vector_of<N>(corners_[0]));
    const Form<N> form{normal.x(), normal.y(), normal.z(), offset};
    return faces_away_ ? Form<N>{-form[0], -form[1], -form[2], -form[3]} : form;
  }

  /// A line among the rays, positive for rays on the inner side of edge `i`.
  template <class N>
  [[nodiscard]] Vector<N> edge(const Rays& rays, std::size_t i) const {
    return CGAL::cross_product(rays.through<N>(corners_[i]), rays.through<N>(corners_[(i + 1) % kEdges]));
  }

 private:
  explicit Surface(const Triangle& triangle) : corners_(triangle) {}

  Triangle corners_;
  bool faces_away_ = false;
};

/// A line among the rays, positive inside: the edge of a surface, or the line where the surface crosses a half-space's plane
/// or the plane of another surface.
struct Line {
  enum class Kind { edge, half_space, plane };
  Kind kind;
  std::uint32_t surface, other;  ///< `other` is the number of the edge, of the half-space or of the other surface

  Vector<Interval> approximate;
  std::optional<Vector<Exact>> exact;
};

using LineIndex = std::uint32_t;

/// A line, and the side of it on which a piece lies.
struct Bound {
  LineIndex line;
  CGAL::Sign inner = CGAL::POSITIVE;
};

/// A convex piece by its bounds, anticlockwise. Corner i is where bound i meets the next.
using Piece = std::vector<Bound>;

class Scene {
 public:
  Scene(const Viewpoint& view, std::span<const Triangle> triangles, const Picture& picture,
        const std::vector<bool>& see_through)
      : rays_(view), half_spaces_(picture.depth), depths_(picture.depth.size()) {
    half_spaces_.insert(half_spaces_.end(), picture.sides.begin(), picture.sides.end());
    for (std::uint32_t i = 0; i < triangles.size(); ++i) {
      std::optional<Surface> surface = Surface::make(rays_, triangles[i]);
      if (!surface || is_clipped_away(*surface)) continue;
      surfaces_.push_back(*surface);
      triangle_.push_back(i);
      std::ranges::transform(surface->corners(), corners_.emplace_back().begin(),
                             [&](const Point& p) { return rays_.through<Interval>(p); });
    }
    for (std::uint32_t s = 0; s < surfaces_.size(); ++s) {
      for (std::uint32_t e = 0; e < kEdges; ++e) add_line(Line::Kind::edge, s, e);
    }
    order_by_size();
    std::erase_if(order_, [&](std::uint32_t s) { return !see_through.empty() && see_through[triangle_[s]]; });
  }

  [[nodiscard]] std::size_t size() const { return surfaces_.size(); }
  /// The index of the triangle of surface s.
  [[nodiscard]] std::uint32_t triangle(std::uint32_t s) const { return triangle_[s]; }

  bool shows(std::uint32_t s) {
    lines_.resize(kEdges * surfaces_.size());
    std::optional<Piece> whole = piece_of(s);
    for (const LineIndex line : clipping_lines(s, half_spaces_.size())) {
      if (whole) whole = split(*whole, line).inner;
    }
    if (!whole) return false;
    return survives(std::move(*whole), hiders_of(s));
  }

 private:
  struct Split {
    std::optional<Piece> inner, outer;
  };

  [[nodiscard]] CGAL::Sign side(const HalfSpaceCoefficients& h, const Point& p) const {
    return sign_of([&]<class N>() -> N { return N(h[0]) * N(p[0]) + N(h[1]) * N(p[1]) + N(h[2]) * N(p[2]) + N(h[3]); });
  }

  /// Whether the whole surface is outside a depth plane, or on it.
  [[nodiscard]] bool is_clipped_away(const Surface& surface) const {
    return std::ranges::any_of(std::span(half_spaces_).first(depths_), [&](const HalfSpaceCoefficients& h) {
      return std::ranges::all_of(surface.corners(), [&](const Point& p) { return side(h, p) != CGAL::POSITIVE; });
    });
  }

  /// Large surfaces come first. What they hide need not be tested against the others.
  void order_by_size() {
    std::vector<double> size(surfaces_.size());
    for (std::size_t s = 0; s < surfaces_.size(); ++s) {
      std::array<Vector<double>, kEdges> r;
      std::ranges::transform(corners_[s], r.begin(), [](const Vector<Interval>& ray) -> Vector<double> {
        const Vector<double> middle{CGAL::to_double(ray.x()), CGAL::to_double(ray.y()), CGAL::to_double(ray.z())};
        return middle / std::sqrt(middle.squared_length());
      });
      const double determinant = CGAL::determinant(r[0], r[1], r[2]);
      size[s] = std::isfinite(determinant) ? determinant : 0;  // it overflowed the range of doubles
    }
    order_.resize(surfaces_.size());
    std::iota(order_.begin(), order_.end(), 0U);
    std::ranges::stable_sort(order_, [&](std::uint32_t a, std::uint32_t b) { return size[a] > size[b]; });
  }

  template <class N>
  [[nodiscard]] Vector<N> vector(const Line& line) const {
    const Surface& surface = surfaces_[line.surface];
    switch (line.kind) {
      case Line::Kind::edge:
        return surface.edge<N>(rays_, line.other);
      case Line::Kind::half_space:
        return rays_.side_of_meeting(surface.plane<N>(), form_of<N>(half_spaces_[line.other]));
      case Line::Kind::plane:
        break;
    }
    return rays_.side_of_meeting(surface.plane<N>(), surfaces_[line.other].plane<N>());
  }

  LineIndex add_line(Line::Kind kind, std::uint32_t surface, std::uint32_t other) {
    Line line{kind, surface, other, {}, std::nullopt};
    line.approximate = vector<Interval>(line);
    lines_.push_back(std::move(line));
    return static_cast<LineIndex>(lines_.size() - 1);
  }

  const Vector<Exact>& exact(LineIndex i) {
    if (!lines_[i].exact) lines_[i].exact = vector<Exact>(lines_[i]);
    return *lines_[i].exact;
  }

  [[nodiscard]] static Piece piece_of(std::uint32_t s) {
    const auto first = static_cast<LineIndex>(kEdges * s);
    return {{first}, {first + 1}, {first + 2}};
  }

  /// The lines of those of the first `count` half-spaces that do not contain all of surface s.
  std::vector<LineIndex> clipping_lines(std::uint32_t s, std::size_t count) {
    std::vector<LineIndex> lines;
    for (std::uint32_t h = 0; h < count; ++h) {
      const auto is_outside = [&](const Point& p) { return side(half_spaces_[h], p) == CGAL::NEGATIVE; };
      if (std::ranges::any_of(surfaces_[s].corners(), is_outside)) lines.push_back(add_line(Line::Kind::half_space, s, h));
    }
    return lines;
  }

  /// The side of `line` on which the corner between two others lies.
  CGAL::Sign side(LineIndex line, const Bound& a, const Bound& b) {
    const CGAL::Uncertain<CGAL::Sign> sign =
        CGAL::sign(CGAL::determinant(lines_[a.line].approximate, lines_[b.line].approximate, lines_[line].approximate));
    if (CGAL::is_certain(sign)) return a.inner * b.inner * CGAL::get_certain(sign);
    return a.inner * b.inner * CGAL::sign(CGAL::determinant(exact(a.line), exact(b.line), exact(line)));
  }

  std::vector<CGAL::Sign> sides(const Piece& piece, LineIndex line) {
    std::vector<CGAL::Sign> signs;
    for (std::size_t i = 0; i < piece.size(); ++i) signs.push_back(side(line, piece[i], piece[(i + 1) % piece.size()]));
    return signs;
  }

  /// The parts of the piece on either side of the line. A part without area is empty.
  Split split(const Piece& piece, LineIndex line) {
    const std::vector<CGAL::Sign> signs = sides(piece, line);
    Split result;
    if (std::ranges::count(signs, CGAL::NEGATIVE) == 0) {
      result.inner = piece;
    } else if (std::ranges::count(signs, CGAL::POSITIVE) == 0) {
      result.outer = piece;
    } else {
      result.inner = cut(piece, signs, CGAL::POSITIVE, line);
      result.outer = cut(piece, signs, CGAL::NEGATIVE, line);
    }
    return result;
  }

  /// Keeps the lines that have a corner on the `kept` side, and adds the line itself where the boundary leaves that side.
  static Piece cut(const Piece& piece, const std::vector<CGAL::Sign>& signs, CGAL::Sign kept, LineIndex line) {
    Piece result;
    const std::size_t n = piece.size();
    for (std::size_t i = 0; i < n; ++i) {
      const CGAL::Sign before = signs[(i + n - 1) % n], after = signs[i];
      if (before == kept || after == kept) result.push_back(piece[i]);
      if (before == kept && after != kept) result.push_back({line, kept});
    }
    return result;
  }

  [[nodiscard]] bool is_beyond(const Piece& piece, LineIndex line) {
    return std::ranges::none_of(sides(piece, line), [](CGAL::Sign s) { return s == CGAL::POSITIVE; });
  }

  /// Whether intervals prove that some edge of a has all corners of b on its outer side or on its line.
  [[nodiscard]] bool are_surely_apart(std::uint32_t a, std::uint32_t b) const {
    return std::ranges::any_of(piece_of(a), [&](const Bound& edge) {
      const Vector<Interval>& line = lines_[edge.line].approximate;
      return std::ranges::all_of(corners_[b], [&](const Vector<Interval>& corner) { return (line * corner).sup() <= 0; });
    });
  }

  /// For each surface that hides something of s, large ones first, the lines that bound what it hides.
  std::vector<std::vector<LineIndex>> hiders_of(std::uint32_t s) {
    std::vector<std::vector<LineIndex>> hiders;
    const Piece all = piece_of(s);
    for (const std::uint32_t other : order_) {
      if (other == s || are_surely_apart(s, other) || are_surely_apart(other, s)) continue;
      std::vector<LineIndex> lines;
      for (const Bound& edge : piece_of(other)) lines.push_back(edge.line);
      if (std::ranges::any_of(lines, [&](LineIndex edge) { return is_beyond(all, edge); })) continue;
      lines.push_back(add_line(Line::Kind::plane, s, other));
      if (is_beyond(all, lines.back())) continue;
      for (const LineIndex line : clipping_lines(other, depths_)) lines.push_back(line);
      hiders.push_back(std::move(lines));
    }
    return hiders;
  }

  /// Whether some part of the piece is left by all hiders. One part is followed to the end before the next, because a part
  /// that shows is usually found first.
  bool survives(Piece whole, const std::vector<std::vector<LineIndex>>& hiders) {
    struct Part {
      Piece piece;
      std::size_t hider;  ///< the next one to subtract
    };
    std::vector<Part> parts{{std::move(whole), 0}};
    while (!parts.empty()) {
      Part part = std::move(parts.back());
      parts.pop_back();
      std::optional<std::vector<Piece>> rest;
      while (!rest && part.hider < hiders.size()) rest = without(part.piece, hiders[part.hider++]);
      if (!rest) return true;
      for (Piece& piece : *rest) parts.push_back({std::move(piece), part.hider});
    }
    return false;
  }

  /// The parts of the piece outside at least one of the lines. Empty when the whole piece is outside.
  std::optional<std::vector<Piece>> without(const Piece& piece, const std::vector<LineIndex>& lines) {
    std::vector<Piece> outside;
    Piece rest = piece;
    for (const LineIndex line : lines) {
      auto [inner, outer] = split(rest, line);
      if (!inner) return std::nullopt;
      if (outer) outside.push_back(std::move(*outer));
      rest = std::move(*inner);
    }
    return outside;
  }

  Rays rays_;
  std::vector<HalfSpaceCoefficients> half_spaces_;  ///< those of depth come first
  std::size_t depths_;
  std::vector<Surface> surfaces_;
  std::vector<std::array<Vector<Interval>, kEdges>> corners_;  ///< for each surface, the rays through its corners
  std::vector<std::uint32_t> triangle_;
  std::vector<std::uint32_t> order_;  ///< who hides, large ones first
  std::vector<Line> lines_;
};

}  // namespace

std::vector<bool> visible_triangles(const Viewpoint& view, std::span<const Triangle> triangles, const Picture& picture,
                                    const std::vector<bool>& see_through) {
  const RoundUpward protect;
  Scene scene(view, triangles, picture, see_through);
  std::vector<bool> visible(triangles.size(), false);
  for (std::uint32_t s = 0; s < scene.size(); ++s) visible[scene.triangle(s)] = scene.shows(s);
  return visible;
}

}  // namespace occlude::oracle
