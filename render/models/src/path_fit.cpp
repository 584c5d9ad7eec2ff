// SPDX-License-Identifier: MIT
#include "occlude/render/path_fit.h"

#include <fmt/format.h>

#include <algorithm>
#include <glm/common.hpp>
#include <glm/vector_relational.hpp>
#include <span>

namespace occlude::render {
namespace {

/// A box larger than that of the vertices by its longest side, in every direction.
class Surroundings {
 public:
  explicit Surroundings(std::span<const glm::dvec3> vertices) : low_(vertices.front()), high_(low_) {
    for (const glm::dvec3& v : vertices) {
      low_ = glm::min(low_, v);
      high_ = glm::max(high_, v);
    }
    const glm::dvec3 sides = high_ - low_;
    const double size = std::max({sides.x, sides.y, sides.z});
    low_ -= size;
    high_ += size;
  }

  [[nodiscard]] bool have(const glm::dvec3& point) const {
    return glm::all(glm::lessThanEqual(low_, point)) && glm::all(glm::lessThanEqual(point, high_));
  }

 private:
  glm::dvec3 low_, high_;
};

/// Whether the path is drawn from or looks at a place near the model.
bool comes_near(const CameraPath& path, culler::SoupView model) {
  const Surroundings surroundings(model.vertices);
  const auto is_near = [&](const CameraPath::Keyframe& k) {
    return surroundings.have(k.eye) || surroundings.have(k.target);
  };
  if (std::ranges::any_of(path.keyframes, is_near)) return true;
  for (std::size_t frame = 0; frame < path.frames; ++frame) {
    if (surroundings.have(path.camera(frame, 1).eye)) return true;
  }
  return false;
}

}  // namespace

std::string doubt_about(const CameraPath& path, const std::filesystem::path& file, culler::SoupView model) {
  const std::filesystem::path meant(path.model);
  if (!path.model.empty()) {
    return meant.stem() == file.stem()
               ? ""
               : fmt::format("made for {}, not for {}", meant.filename().string(), file.filename().string());
  }
  if (!comes_near(path, model)) return fmt::format("the path is nowhere near {}", file.filename().string());
  return "";
}

}  // namespace occlude::render
