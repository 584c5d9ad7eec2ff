// SPDX-License-Identifier: MIT
#include "occlude/render/scene_renderer.h"

#include <glm/geometric.hpp>
#include <glm/vec4.hpp>
#include <stdexcept>

#include "corner_buffer.h"
#include "frame_buffer.h"
#include "gl_program.h"
#include "projection.h"
#include "triangle_list.h"

namespace occlude::render {
namespace {

constexpr Rgba kSky = {196, 216, 234, 255};

// The opacity of the hidden part of a line.
constexpr float kHiddenLineOpacity = 0.25F;

// The reversed depth of lines is multiplied by this, so that they lie in front of their surfaces.
constexpr float kLineLift = 1.001F;

constexpr float kLineWidth = 2;  // pixels

// A rasteriser that rounds vertices to 1/256 pixel paints pixels whose centre is up to 1/512 beside the polygon on each
// axis, with the depth of its plane there. On a polygon seen nearly edge-on that can be any depth, and hidden polygons would
// show. Depths are therefore moved away by the change of the plane over 1/256 pixel, which is at least its change over 1/512
// on both axes. Nothing is then drawn nearer than it is.
constexpr float kDepthSlope = -1.0F / 256;  // of the reversed depth

// Haze: a surface has half the colour of the sky at a distance of half the diagonal of the model's box.
constexpr double kHazeHalvings = 2;  // over the whole diagonal

// Shared by pictures and item buffers: the same text and `invariant` give both the same geometry.
constexpr const char* kVertexShader = R"(#version 450 core
layout(location = 0) in vec3 position;
layout(location = 1) in vec4 colour;
layout(location = 2) in uint polygon;
uniform vec3 eye_high, eye_low;  // their sum is the eye, in more than float precision
uniform mat4 clip_from_eye_relative;
uniform float lift;
uniform vec4 tint;  // alpha: its share
uniform float opacity;
invariant gl_Position;
flat out vec4 surface;
flat out uint item_of_polygon;
void main() {
  precise vec3 relative = (position - eye_high) - eye_low;
  gl_Position = clip_from_eye_relative * vec4(relative, 1);
  gl_Position.z *= lift;
  surface = vec4(mix(colour.rgb, tint.rgb, tint.a), opacity * colour.a);
  item_of_polygon = polygon;
}
)";

constexpr const char* kPictureShader = R"(#version 450 core
flat in vec4 surface;
uniform vec3 sky;
uniform float haze;  // halvings of the surface's share per unit of distance
out vec4 colour;
void main() {
  float distance = 1 / gl_FragCoord.w;
  colour = vec4(mix(sky, surface.rgb, exp2(-haze * distance)), surface.a);
}
)";

constexpr const char* kItemShader = R"(#version 450 core
flat in uint item_of_polygon;
out uint item;
void main() { item = item_of_polygon; }
)";

glm::vec4 to_float(const Rgba& colour) { return glm::vec4(colour.r, colour.g, colour.b, colour.a) / 255.0F; }

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

/// glClipControl is loaded by name: not every OpenGL library exports it.
void use_reversed_depth() {
  const auto clip_control = reinterpret_cast<PFNGLCLIPCONTROLPROC>(gl_function("glClipControl"));
  if (clip_control == nullptr) throw std::runtime_error("OpenGL offers no glClipControl");
  clip_control(GL_LOWER_LEFT, GL_ZERO_TO_ONE);
  glEnable(GL_DEPTH_TEST);
  glEnable(GL_POLYGON_OFFSET_FILL);
  glPolygonOffset(kDepthSlope, 0);
}

}  // namespace

struct SceneRenderer::Impl {
  Impl(const TriangleList& list, int width, int height)
      : target(width, height),
        picture(kVertexShader, kPictureShader),
        items(kVertexShader, kItemShader),
        extent(list.extent),
        centre(list.centre),
        first_corner(list.first) {
    corners.upload(list.corners, GL_STATIC_DRAW);
    use_reversed_depth();
    glLineWidth(kLineWidth);
    // The alpha of the picture stays opaque.
    glBlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ZERO, GL_ONE);
  }

  void begin_polygons(const GlProgram& program, const culler::Camera& camera, const glm::dvec2& shift) const;
  void draw_polygons(std::span<const PolygonRange> ranges) const;
  void set_shading(const culler::Camera& camera) const;
  void draw_lines(const glm::dvec3& eye, std::span<const Line> lines);

  FrameBuffer target;
  GlProgram picture, items;
  CornerBuffer corners, line_ends;
  Extent extent;
  glm::dvec3 centre;
  std::vector<std::uint32_t> first_corner;  ///< of each polygon, and the end
};

/// The state that pictures and item buffers share.
void SceneRenderer::Impl::begin_polygons(const GlProgram& program, const culler::Camera& camera,
                                         const glm::dvec2& shift) const {
  program.use();
  program.set("clip_from_eye_relative", clip_from_eye_relative(camera, extent, shift));
  program.set("lift", 1.0F);
  set_eye(program, camera.eye - centre);
  corners.bind();
  glDepthFunc(GL_GREATER);
}

void SceneRenderer::Impl::draw_polygons(std::span<const PolygonRange> ranges) const {
  DrawRanges runs;
  for (const PolygonRange& range : ranges) runs.add(first_corner[range.first], first_corner[range.first + range.count]);
  glMultiDrawArrays(GL_TRIANGLES, runs.first.data(), runs.count.data(), static_cast<GLsizei>(runs.first.size()));
}

void SceneRenderer::Impl::set_shading(const culler::Camera& camera) const {
  const double diagonal = glm::length(extent.max - extent.min);
  // A parallel projection has no distance from the eye.
  const bool hazy = camera.projection == culler::Projection::perspective && diagonal > 0;
  picture.set("haze", hazy ? static_cast<float>(kHazeHalvings / diagonal) : 0.0F);
  picture.set("sky", glm::vec3(to_float(kSky)));
  picture.set("opacity", 1.0F);
}

/// Draws the hidden parts of the lines faintly, then the visible parts.
void SceneRenderer::Impl::draw_lines(const glm::dvec3& eye, std::span<const Line> lines) {
  std::vector<Corner> ends;
  for (const Line& line : lines) {
    for (const glm::dvec3& end : {line.from - eye, line.to - eye}) {
      const glm::vec3 narrowed(end);
      ends.push_back({{narrowed.x, narrowed.y, narrowed.z}, line.colour, kNothing});
    }
  }
  line_ends.upload(ends, GL_STREAM_DRAW);
  set_eye(picture, {0, 0, 0});
  picture.set("haze", 0.0F);
  picture.set("tint", glm::vec4(0));
  picture.set("lift", kLineLift);
  glEnable(GL_BLEND);
  glDepthMask(GL_FALSE);
  for (const auto& [depth_test, opacity] : {std::pair{GL_LEQUAL, kHiddenLineOpacity}, std::pair{GL_GREATER, 1.0F}}) {
    glDepthFunc(static_cast<GLenum>(depth_test));
    picture.set("opacity", opacity);
    glDrawArrays(GL_LINES, 0, static_cast<GLsizei>(ends.size()));
  }
  glDepthMask(GL_TRUE);
  glDisable(GL_BLEND);
}

SceneRenderer::SceneRenderer(const culler::PolygonSoup& soup, int width, int height)
    : impl_(std::make_unique<Impl>(make_triangle_list(soup), width, height)) {}

SceneRenderer::~SceneRenderer() = default;

void SceneRenderer::draw(const culler::Camera& camera, std::span<const Layer> layers, std::span<const Line> lines) {
  impl_->target.begin_picture(kSky);
  impl_->begin_polygons(impl_->picture, camera, {0, 0});
  impl_->set_shading(camera);
  for (const Layer& layer : layers) {
    impl_->picture.set("tint", layer.tint ? to_float(*layer.tint) : glm::vec4(0));
    impl_->draw_polygons(layer.ranges);
  }
  if (!lines.empty()) impl_->draw_lines(camera.eye, lines);
  glFinish();
}

Image SceneRenderer::image() const { return impl_->target.image(); }

ItemBuffer SceneRenderer::item_buffer(const culler::Camera& camera, std::span<const PolygonRange> ranges,
                                      const glm::dvec2& offset) {
  impl_->target.begin_items();
  impl_->begin_polygons(impl_->items, camera, 2.0 * offset / glm::dvec2(impl_->target.width(), impl_->target.height()));
  impl_->draw_polygons(ranges);
  return impl_->target.item_buffer();
}

}  // namespace occlude::render
