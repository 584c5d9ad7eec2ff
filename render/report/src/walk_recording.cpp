// SPDX-License-Identifier: MIT
#include "occlude/render/walk_recording.h"

#include <fmt/format.h>

#include <iterator>
#include <nlohmann/json.hpp>

#include "page_camera.h"
#include "page_frames.h"
#include "page_model.h"

namespace occlude::render {
namespace {

using Json = nlohmann::ordered_json;

}  // namespace

struct WalkRecording::Impl {
  explicit Impl(const culler::Culler& culler) : model(culler.hierarchy()), frames(culler, model) {}

  /// Each occluder that was chosen: its polygons by their places in the page, and what it did. `numbers` gets its place in
  /// the list.
  [[nodiscard]] Json occluders(std::map<std::uint32_t, std::size_t>& numbers) const {
    Json list = Json::array();
    for (const auto& [index, record] : frames.occluders()) {
      numbers.emplace(index, list.size());
      list.push_back({{"polygons", record.places},
                      {"shell", record.is_shell},
                      {"frames", record.frames},
                      {"useless", record.useless},
                      {"hidden", record.hidden},
                      {"best_frame", record.best_frame},
                      {"best_hidden", record.best_hidden}});
    }
    return list;
  }

  [[nodiscard]] Json outlines(const std::map<std::uint32_t, std::size_t>& numbers) const {
    Json list = Json::array();
    for (const PageFrames::Outline& outline : frames.outlines()) {
      list.push_back({{"occluder", numbers.at(outline.occluder)}, {"corners", outline.corners}});
    }
    return list;
  }

  PageModel model;
  PageFrames frames;
  culler::Camera camera;      ///< of the last frame
  std::string eyes, targets;  ///< of all frames, numbers with commas
};

WalkRecording::WalkRecording(const culler::Culler& culler) : impl_(std::make_unique<Impl>(culler)) {}
WalkRecording::~WalkRecording() = default;
WalkRecording::WalkRecording(WalkRecording&&) noexcept = default;
WalkRecording& WalkRecording::operator=(WalkRecording&&) noexcept = default;

void WalkRecording::add_frame(const culler::Camera& camera, const culler::CullResult& culled) {
  impl_->frames.add(culled);
  impl_->camera = camera;
  const auto append = [](std::string& list, const glm::dvec3& v) {
    fmt::format_to(std::back_inserter(list), "{}{:.9g},{:.9g},{:.9g}", list.empty() ? "" : ",", v.x, v.y, v.z);
  };
  append(impl_->eyes, camera.eye);
  append(impl_->targets, camera.target);
}

std::size_t WalkRecording::polygons() const { return impl_->model.polygons(); }

std::size_t WalkRecording::every() const { return impl_->frames.every(); }

std::vector<std::pair<std::string, std::string>> WalkRecording::parts() const {
  const PageModel& model = impl_->model;
  std::map<std::uint32_t, std::size_t> numbers;
  const Json occluders = impl_->occluders(numbers);
  const Json scene = {{"low", page_json(model.grid().low)},
                      {"step", page_json(model.grid().step)},
                      {"every", every()},
                      {"camera", page_lens(impl_->camera)},
                      {"occluders", occluders},
                      {"outlines", impl_->outlines(numbers)}};
  return {{"scene", scene.dump()},
          {"path", fmt::format(R"({{"eyes":[{}],"targets":[{}]}})", impl_->eyes, impl_->targets)},
          {"vertices", model.vertices()},
          {"leaves", model.leaf_sizes()},
          {"sides", model.sides()},
          {"corners", model.corners()},
          {"numbers", model.numbers()},
          {"frames", impl_->frames.packed()}};
}

}  // namespace occlude::render
