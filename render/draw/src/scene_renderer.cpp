// SPDX-License-Identifier: MIT
#include "occlude/render/scene_renderer.h"

#include <algorithm>
#include <glm/geometric.hpp>
#include <limits>

#include "corner_buffer.h"
#include "frame_buffer.h"
#include "gl_program.h"
#include "glass.h"
#include "model/append_range.h"
#include "pixel_counter.h"
#include "projection.h"
#include "triangle_list.h"

namespace occlude::render {
namespace {

constexpr Rgba kSky = {196, 216, 234, 255};

// A rasteriser that rounds vertices to 1/256 pixel paints pixels whose centre is up to 1/512 beside the polygon on each
// axis, with the depth of its plane there. On a polygon seen nearly edge-on that can be any depth, and hidden polygons would
// show. Depths are therefore moved away by the change of the plane over 1/256 pixel, which is at least its change over 1/512
// on both axes. Nothing is then drawn nearer than it is.
constexpr float kDepthSlope = -1.0F / 256;  // of the reversed depth

constexpr const char* kVersion = "#version 450 core\n";
constexpr const char* kIsCut = "#define IS_CUT\n";

// Shared by pictures and item buffers: the same text and `invariant` give both the same geometry.
constexpr const char* kVertexShader = R"(
layout(location = 0) in vec3 position;
layout(location = 1) in uint polygon;
uniform vec3 eye_high, eye_low;  // their sum is the eye, in more than float precision
uniform mat4 clip_from_eye_relative;
invariant gl_Position;
flat out vec3 surface;
flat out uint item_of_polygon;
#ifdef IS_CUT
uniform vec3 cut_up;
uniform float cut_height;  // above the eye
#endif
void main() {
  precise vec3 relative = (position - eye_high) - eye_low;
  gl_Position = clip_from_eye_relative * vec4(relative, 1);
#ifdef IS_CUT
  gl_ClipDistance[0] = cut_height - dot(cut_up, relative);
#endif
  // Neighbours have unlike colours, so that a polygon too few or too many shows. The factor is odd: the lowest 24 bits of
  // 2^24 polygons in a row all differ.
  surface = unpackUnorm4x8(polygon * 0x9E3779B9u).rgb;
  item_of_polygon = polygon;
}
)";

constexpr const char* kPictureShader = R"(#version 450 core
flat in vec3 surface;
uniform vec3 sky;
uniform float haze;  // halvings of the surface's share per unit of distance
out vec4 colour;
void main() {
  float distance = 1 / gl_FragCoord.w;
  colour = vec4(mix(sky, surface, exp2(-haze * distance)), 1);
}
)";

constexpr const char* kItemShader = R"(#version 450 core
flat in uint item_of_polygon;
out uint item;
void main() { item = item_of_polygon; }
)";

constexpr const char* kCountShader = R"(#version 450 core
layout(early_fragment_tests) in;
flat in uint item_of_polygon;
layout(std430, binding = 0) buffer Counts { uint pixels[]; };
void main() { atomicAdd(pixels[item_of_polygon], 1u); }
)";

/// Ranges of corners in the form of glMultiDrawArrays.
struct DrawRanges {
  std::vector<GLint> first;
  std::vector<GLsizei> count;

  /// Adds corners [begin, end); extends the last range if they follow it.
  void add(std::uint32_t begin, std::uint32_t end) {
    if (begin == end) return;
    if (!first.empty() && first.back() + count.back() == static_cast<GLint>(begin)) {
      count.back() += static_cast<GLsizei>(end - begin);
    } else {
      first.push_back(static_cast<GLint>(begin));
      count.push_back(static_cast<GLsizei>(end - begin));
    }
  }
};

void set_eye(const GlProgram& program, const glm::dvec3& eye_from_centre) {
  const glm::vec3 high(eye_from_centre);
  program.set("eye_high", high);
  program.set("eye_low", glm::vec3(eye_from_centre - glm::dvec3(high)));
}

void use_reversed_depth() {
  gl.ClipControl(GL_LOWER_LEFT, GL_ZERO_TO_ONE);
  gl.Enable(GL_DEPTH_TEST);
  gl.Enable(GL_POLYGON_OFFSET_FILL);
  gl.PolygonOffset(kDepthSlope, 0);
}

/// While one lives, drawing leaves the depths as they are.
class DepthsKept {
 public:
  DepthsKept() { gl.DepthMask(GL_FALSE); }
  ~DepthsKept() { gl.DepthMask(GL_TRUE); }
  DepthsKept(const DepthsKept&) = delete;
  DepthsKept& operator=(const DepthsKept&) = delete;
};

/// While one lives, what is cut is not drawn.
class Clipped {
 public:
  explicit Clipped(bool is_cut) : is_cut_(is_cut) {
    if (is_cut_) gl.Enable(GL_CLIP_DISTANCE0);
  }
  ~Clipped() {
    if (is_cut_) gl.Disable(GL_CLIP_DISTANCE0);
  }
  Clipped(const Clipped&) = delete;
  Clipped& operator=(const Clipped&) = delete;

 private:
  bool is_cut_;
};

enum class Kind { opaque, see_through };

}  // namespace

struct SceneRenderer::Impl {
  /// For item buffers.
  struct ItemPrograms {
    explicit ItemPrograms(const std::string& vertex_shader)
        : items(vertex_shader.c_str(), kItemShader), counter(vertex_shader.c_str(), kCountShader) {}

    GlProgram items, counter;
  };

  Impl(culler::SoupView soup, const TriangleList& list, int width, int height)
      : target(width, height),
        picture((std::string(kVersion) + kVertexShader).c_str(), kPictureShader),
        whole(std::string(kVersion) + kVertexShader),
        cut_open(std::string(kVersion) + kIsCut + kVertexShader),
        pixels(soup.size()),
        extent(list.extent),
        centre(list.centre),
        first_corner(list.first) {
    for (std::uint32_t p = 0; p < soup.size(); ++p) {
      if (!soup.is_opaque(p)) culler::append_range(see_through, {p, 1});
    }
    corners.upload(list.corners);
    use_reversed_depth();
  }

  void begin_polygons(const GlProgram& program, const culler::Camera& camera, const glm::dvec2& shift) const;
  void draw_polygons(std::span<const PolygonRange> ranges, Kind kind) const;
  void blend_polygons(std::span<const PolygonRange> ranges) const;
  void begin_items(const GlProgram& program, const culler::Camera& camera, const glm::dvec2& shift,
                   const std::optional<Cut>& cut) const;
  void add_see_through(ItemBuffer& result, const culler::Camera& camera, std::span<const PolygonRange> ranges,
                       const glm::dvec2& shift, const std::optional<Cut>& cut);

  FrameBuffer target;
  GlProgram picture;
  ItemPrograms whole, cut_open;
  PixelCounter pixels;
  CornerBuffer corners;
  Extent extent;
  glm::dvec3 centre;
  std::vector<std::uint32_t> first_corner;  ///< of each polygon, and the end
  std::vector<PolygonRange> see_through;    ///< ascending
};

/// The state that pictures and item buffers share.
void SceneRenderer::Impl::begin_polygons(const GlProgram& program, const culler::Camera& camera,
                                         const glm::dvec2& shift) const {
  program.use();
  program.set("clip_from_eye_relative", clip_from_eye_relative(camera, extent, shift));
  set_eye(program, camera.eye - centre);
  corners.bind();
  gl.DepthFunc(GL_GREATER);
}

void SceneRenderer::Impl::begin_items(const GlProgram& program, const culler::Camera& camera, const glm::dvec2& shift,
                                      const std::optional<Cut>& cut) const {
  begin_polygons(program, camera, shift);
  if (!cut) return;
  program.set("cut_up", glm::vec3(cut->up));
  program.set("cut_height", static_cast<float>(cut->height - glm::dot(cut->up, camera.eye)));
}

/// Draws those of a kind.
void SceneRenderer::Impl::draw_polygons(std::span<const PolygonRange> ranges, Kind kind) const {
  DrawRanges runs;
  const auto add = [&](std::uint32_t begin, std::uint32_t end, Kind own) {
    if (own == kind) runs.add(first_corner[begin], first_corner[end]);
  };
  const auto end_of = [](const PolygonRange& range) { return range.first + range.count; };
  for (const PolygonRange& range : ranges) {
    std::uint32_t at = range.first;
    for (auto run = std::ranges::upper_bound(see_through, at, {}, end_of); run != see_through.end(); ++run) {
      if (run->first >= end_of(range)) break;
      const std::uint32_t begin = std::max(run->first, at);
      add(at, begin, Kind::opaque);
      at = std::min(end_of(*run), end_of(range));
      add(begin, at, Kind::see_through);
    }
    add(at, end_of(range), Kind::opaque);
  }
  gl.MultiDrawArrays(GL_TRIANGLES, runs.first.data(), runs.count.data(), static_cast<GLsizei>(runs.first.size()));
}

/// Draws the see-through ones over the picture. Each takes part where no opaque one hides it, in the order of the ranges, so
/// that leaving out hidden polygons changes nothing.
void SceneRenderer::Impl::blend_polygons(std::span<const PolygonRange> ranges) const {
  const DepthsKept kept;
  gl.Enable(GL_BLEND);
  gl.BlendColor(0, 0, 0, static_cast<float>(kGlassShare));
  gl.BlendFunc(GL_CONSTANT_ALPHA, GL_ONE_MINUS_CONSTANT_ALPHA);
  draw_polygons(ranges, Kind::see_through);
  gl.Disable(GL_BLEND);
}

/// The opaque ones have been drawn.
void SceneRenderer::Impl::add_see_through(ItemBuffer& result, const culler::Camera& camera,
                                          std::span<const PolygonRange> ranges, const glm::dvec2& shift,
                                          const std::optional<Cut>& cut) {
  const ItemPrograms& programs = cut ? cut_open : whole;
  target.begin_nothing();
  pixels.begin();
  begin_items(programs.counter, camera, shift, cut);
  {
    const DepthsKept kept;
    draw_polygons(ranges, Kind::see_through);
  }
  result.see_through = pixels.counts();
  target.begin_items_before();
  begin_items(programs.items, camera, shift, cut);
  draw_polygons(ranges, Kind::see_through);
  result.before = target.items();
}

SceneRenderer::SceneRenderer(culler::SoupView soup, int width, int height)
    : impl_(std::make_unique<Impl>(soup, make_triangle_list(soup), width, height)) {}

SceneRenderer::~SceneRenderer() = default;

int SceneRenderer::width() const { return impl_->target.width(); }
int SceneRenderer::height() const { return impl_->target.height(); }

double SceneRenderer::haze_depth(const culler::Camera& camera) const {
  const double half = glm::length(impl_->extent.max - impl_->extent.min) / 2;
  const bool has_distance = camera.projection == culler::Projection::perspective && half > 0;
  return has_distance ? half : std::numeric_limits<double>::infinity();
}

void SceneRenderer::draw(const culler::Camera& camera, std::span<const PolygonRange> ranges) {
  impl_->target.begin_picture(kSky);
  impl_->begin_polygons(impl_->picture, camera, {0, 0});
  impl_->picture.set("haze", static_cast<float>(1 / haze_depth(camera)));
  impl_->picture.set("sky", glm::vec3(kSky.r, kSky.g, kSky.b) / 255.0F);
  impl_->draw_polygons(ranges, Kind::opaque);
  if (!impl_->see_through.empty()) impl_->blend_polygons(ranges);
  gl.Finish();
}

Image SceneRenderer::image() const { return impl_->target.image(); }

ItemBuffer SceneRenderer::item_buffer(const culler::Camera& camera, std::span<const PolygonRange> ranges,
                                      const glm::dvec2& offset, const std::optional<Cut>& cut) {
  const glm::dvec2 shift = 2.0 * offset / glm::dvec2(impl_->target.width(), impl_->target.height());
  const Clipped clipped(cut.has_value());
  impl_->target.begin_items();
  impl_->begin_items((cut ? impl_->cut_open : impl_->whole).items, camera, shift, cut);
  impl_->draw_polygons(ranges, Kind::opaque);
  ItemBuffer result{impl_->target.items(), {}, {}};
  if (!impl_->see_through.empty()) impl_->add_see_through(result, camera, ranges, shift, cut);
  return result;
}

}  // namespace occlude::render
