// SPDX-License-Identifier: MIT
// Judges what a frame of another culler culled: what our own cull proves hidden is, item buffers and rays into the rest say
// where to look, and exact rays decide.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

#include "cull_log.h"
#include "frame_rays.h"
#include "occlude/culler/culler.h"
#include "occlude/render/image.h"
#include "occlude/render/offscreen_context.h"
#include "occlude/render/scene_renderer.h"

namespace occlude::cli {

/// A polygon of the model file that is culled and visible: the ray through a point meets it first.
struct SeenPolygon {
  std::uint32_t polygon = 0;
  std::uint32_t in_tree = 0;  ///< it, or the piece of it that is seen
  glm::dvec3 through{};
  glm::dvec2 pixel{};  ///< where that is in the picture, from its upper left corner
};

/// Counts are of polygons of the model file in view, or so near it that our own cull does not tell.
struct FrameAudit {
  std::uint32_t frame = 0;
  std::size_t culled = 0;               ///< all that follow together
  std::size_t hidden = 0;               ///< proved by our own cull
  std::vector<SeenPolygon> visible;     ///< in ascending order
  std::size_t unsettled = 0;            ///< neither proved hidden nor seen
  std::size_t drawn = 0, needless = 0;  ///< and those of them that our own cull proves hidden
};

struct AuditOptions {
  std::size_t item_buffers = 16;  ///< for each frame, a quarter of a pixel apart
  std::size_t rays = 16;          ///< into each triangle, and one to each corner and side
  culler::CoverOptions cover;
};

class Auditor {
 public:
  /// REQUIRES: `culler` outlives this object, and was made for covers.
  Auditor(const culler::Culler& culler, const AuditOptions& options) : culler_(culler), options_(options) {}

  /// Throws Interrupted on Ctrl-C.
  [[nodiscard]] FrameAudit judge(const LoggedFrame& frame);

  /// The frame as it is without culling, with these polygons in magenta, and rings around where they show.
  [[nodiscard]] render::Image picture(const LoggedFrame& frame, const std::vector<SeenPolygon>& marked);

 private:
  const culler::CullResult& cull(const proof::AnyCamera& camera);
  [[nodiscard]] render::SceneRenderer& renderer(const LoggedFrame& frame);

  const culler::Culler& culler_;
  AuditOptions options_;
  culler::View view_;
  std::unique_ptr<render::OffscreenContext> context_;
  std::unique_ptr<render::SceneRenderer> renderer_;
};

}  // namespace occlude::cli
