// SPDX-License-Identifier: MIT
#include "culling.h"

#include <fmt/format.h>

#include <cmath>
#include <variant>

#include "cases/to_oracle.h"
#include "occlude/render/errors.h"
#include "occlude/render/progress.h"
#include "occlude/render/witness.h"

namespace occlude::cli {
namespace {

/// The matrix of a camera for OpenGL. With parallel rays it has a far plane; `beyond` is how far that is where the camera
/// has none.
culler::MatrixCamera matrix_of(culler::Camera camera, double beyond) {
  const bool is_endless = camera.projection == culler::Projection::orthographic && std::isinf(camera.far_plane);
  if (is_endless) camera.far_plane = beyond;
  return culler::MatrixCamera::from_camera(camera, culler::ClipDepth::minus_w_to_w, culler::Nearer::less);
}

}  // namespace

proof::AnyCamera Walked::camera(std::size_t frame) const {
  const culler::Camera camera = path.camera(frame, render::aspect(options));
  if (!by_matrix) return camera;
  const double reach = proof::depth_of(cases::to_oracle(culler.hierarchy().nodes()[0].box), camera);
  const culler::MatrixCamera matrix = matrix_of(camera, camera.near_plane + 2 * reach);
  if (const std::string reason = culler::fault(matrix); !reason.empty()) {
    throw render::InputError(fmt::format("frame {}: the matrix of the camera cannot be used: {}", frame, reason));
  }
  return matrix;
}

Culling::Culling(const Walked& walked)
    : walked_(walked), along_(walked.culler, walked.path, walked.options, walked.options.cull) {
  if (walked.as_scene) scene_.emplace(walked.culler.hierarchy());
}

const culler::CullResult& Culling::cull(std::size_t frame) {
  render::check_interrupt();
  culler::View& view = along_.before(frame);
  std::visit([&](const auto& camera) { walked_.culler.cull(camera, walked_.options.cull, view); }, walked_.camera(frame));
  return view.result();
}

void Culling::append_witnesses(std::vector<std::string>& lines, std::size_t frame) {
  const proof::AnyCamera any = walked_.camera(frame);
  if (scene_) return scene_->append_witnesses(lines, frame, any, walked_.options.cull);
  const culler::CullResult& culled = cull(frame);
  const auto append = [&](const auto& camera) {
    const auto covers = render::covers_of(walked_.culler, camera, culled, walked_.options.cull);
    render::append_witnesses(lines, frame, camera, walked_.culler, culled, walked_.options.cull, covers);
  };
  std::visit(append, any);
}

}  // namespace occlude::cli
