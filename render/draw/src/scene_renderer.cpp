// SPDX-License-Identifier: MIT
#include "occlude/render/scene_renderer.h"

#include <glm/geometric.hpp>
#include <limits>
#include <stdexcept>

#include "corner_buffer.h"
#include "frame_buffer.h"
#include "gl_program.h"
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

// Shared by pictures and item buffers: the same text and `invariant` give both the same geometry.
constexpr const char* kVertexShader = R"(#version 450 core
layout(location = 0) in vec3 position;
layout(location = 1) in uint polygon;
uniform vec3 eye_high, eye_low;  // their sum is the eye, in more than float precision
uniform mat4 clip_from_eye_relative;
invariant gl_Position;
flat out vec3 surface;
flat out uint item_of_polygon;
void main() {
  precise vec3 relative = (position - eye_high) - eye_low;
  gl_Position = clip_from_eye_relative * vec4(relative, 1);
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

}  // namespace

struct SceneRenderer::Impl {
  Impl(const TriangleList& list, int width, int height)
      : target(width, height),
        picture(kVertexShader, kPictureShader),
        items(kVertexShader, kItemShader),
        extent(list.extent),
        centre(list.centre),
        first_corner(list.first) {
    corners.upload(list.corners);
    use_reversed_depth();
  }

  void begin_polygons(const GlProgram& program, const culler::Camera& camera, const glm::dvec2& shift) const;
  void draw_polygons(std::span<const PolygonRange> ranges) const;

  FrameBuffer target;
  GlProgram picture, items;
  CornerBuffer corners;
  Extent extent;
  glm::dvec3 centre;
  std::vector<std::uint32_t> first_corner;  ///< of each polygon, and the end
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

void SceneRenderer::Impl::draw_polygons(std::span<const PolygonRange> ranges) const {
  DrawRanges runs;
  for (const PolygonRange& range : ranges) runs.add(first_corner[range.first], first_corner[range.first + range.count]);
  gl.MultiDrawArrays(GL_TRIANGLES, runs.first.data(), runs.count.data(), static_cast<GLsizei>(runs.first.size()));
}

SceneRenderer::SceneRenderer(culler::SoupView soup, int width, int height)
    : impl_(std::make_unique<Impl>(make_triangle_list(soup), width, height)) {}

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
  impl_->draw_polygons(ranges);
  gl.Finish();
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
