// SPDX-License-Identifier: MIT
#include "camera/frame_view.h"
#include "camera/matrix_eye.h"
#include "model/bounds.h"
#include "occlude/culler/camera.h"

namespace occlude::culler {

glm::dvec3 MatrixCamera::eye() const { return MatrixEye(*this).eye(); }

kernel::Viewpoint MatrixCamera::viewpoint() const { return FrameView(*this, 0).viewpoint; }

void append_view_frustum(const MatrixCamera& camera, double depth, std::vector<HalfSpace>& planes) {
  FrameView(camera, depth).append_half_spaces(planes);
}

std::string fault(const MatrixCamera& camera) { return std::string(MatrixEye(camera).fault()); }

std::string fault(const MatrixCamera& camera, Method method) {
  std::string found = fault(camera);
  if (found.empty() && method == Method::frusta && camera.eye_radius > 0)
    return "shadow frusta are from one eye: a radius of eyes is for covers";
  return found;
}

}  // namespace occlude::culler
