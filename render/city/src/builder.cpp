// SPDX-License-Identifier: MIT
#include "builder.h"

#include <array>
#include <cstdint>
#include <cstdlib>

namespace occlude::render::city {
namespace {

constexpr double kMetresPerUnit = 1.0 / 1024.0;  // exact

glm::dvec3 metres(const Point& p) {
  return {static_cast<double>(p.x) * kMetresPerUnit, static_cast<double>(p.y) * kMetresPerUnit,
          static_cast<double>(p.z) * kMetresPerUnit};
}

}  // namespace

void Builder::polygon(std::span<const Point> loop) {
  for (const Point& p : loop) soup_.indices.push_back(soup_.add_vertex(metres(p)));
  soup_.first.push_back(static_cast<std::uint32_t>(soup_.indices.size()));
}

void Builder::quad(const Point& a, const Point& b, const Point& c, const Point& d) {
  const std::array loop{a, b, c, d};
  polygon(loop);
}

void Builder::triangle(const Point& a, const Point& b, const Point& c) {
  const std::array loop{a, b, c};
  polygon(loop);
}

void Builder::facing(const Frame& f, Length along0, Length along1, Length up0, Length up1, Length out) {
  quad(f.at(along0, out, up0), f.at(along1, out, up0), f.at(along1, out, up1), f.at(along0, out, up1));
}

void Builder::across(const Frame& f, Length along, Length out0, Length out1, Length up0, Length up1) {
  quad(f.at(along, out0, up0), f.at(along, out1, up0), f.at(along, out1, up1), f.at(along, out0, up1));
}

void Builder::level(const Frame& f, Length along0, Length along1, Length out0, Length out1, Length up) {
  quad(f.at(along0, out0, up), f.at(along0, out1, up), f.at(along1, out1, up), f.at(along1, out0, up));
}

void Builder::box(const Frame& f, const Extent& e, unsigned faces) {
  // Corner i: bit 0 along, bit 1 out, bit 2 up.
  std::array<std::uint32_t, 8> corner{};
  for (unsigned i = 0; i < 8; ++i) {
    corner[i] = soup_.add_vertex(
        metres(f.at((i & 1) != 0 ? e.along1 : e.along0, (i & 2) != 0 ? e.out1 : e.out0, (i & 4) != 0 ? e.up1 : e.up0)));
  }
  struct Face {
    unsigned flag;
    std::array<unsigned, 4> loop;  // counter-clockwise from outside
  };
  static constexpr std::array<Face, 6> kFaces{{{kFront, {2, 3, 7, 6}},
                                               {kBack, {1, 0, 4, 5}},
                                               {kLeft, {0, 2, 6, 4}},
                                               {kRight, {3, 1, 5, 7}},
                                               {kTop, {4, 6, 7, 5}},
                                               {kBottom, {0, 1, 3, 2}}}};
  for (const Face& face : kFaces) {
    if ((faces & face.flag) == 0) continue;
    for (const unsigned i : face.loop) soup_.indices.push_back(corner[i]);
    soup_.first.push_back(static_cast<std::uint32_t>(soup_.indices.size()));
  }
}

void Builder::ground(const Rect& rect, Length z, Length cell) {
  if (rect.width() <= 0 || rect.depth() <= 0) return;
  const Length columns = divide_up(rect.width(), cell);
  const Length rows = divide_up(rect.depth(), cell);
  for (Length j = 0; j < rows; ++j) {
    const Length y0 = rect.y0 + rect.depth() * j / rows;
    const Length y1 = rect.y0 + rect.depth() * (j + 1) / rows;
    for (Length i = 0; i < columns; ++i) {
      const Length x0 = rect.x0 + rect.width() * i / columns;
      const Length x1 = rect.x0 + rect.width() * (i + 1) / columns;
      quad({x0, y0, z}, {x1, y0, z}, {x1, y1, z}, {x0, y1, z});
    }
  }
}

void Builder::band(const Point& a, const Point& b, Length height, Length cell) {
  const Length length = std::abs(b.x - a.x) + std::abs(b.y - a.y);  // the sides run along an axis
  const Length pieces = divide_up(length, cell);
  for (Length i = 0; i < pieces; ++i) {
    const Point p{a.x + (b.x - a.x) * i / pieces, a.y + (b.y - a.y) * i / pieces, a.z};
    const Point q{a.x + (b.x - a.x) * (i + 1) / pieces, a.y + (b.y - a.y) * (i + 1) / pieces, a.z};
    quad(p, q, {q.x, q.y, q.z + height}, {p.x, p.y, p.z + height});
  }
}

}  // namespace occlude::render::city
