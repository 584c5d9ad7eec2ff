// SPDX-License-Identifier: MIT
#include "occlude/render/walk_recording.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <nlohmann/json.hpp>

#include "occlude/render/missed_report.h"
#include "occlude/render/view_planes.h"
#include "page_camera.h"
#include "page_details.h"
#include "page_frames.h"
#include "page_model.h"
#include "page_pieces.h"
#include "page_vain.h"

namespace occlude::render {
namespace {

using Json = nlohmann::ordered_json;

Json json_of(const HiderRecord& record) {
  return {{"frames", record.frames},
          {"useless", record.useless},
          {"hidden", record.hidden},
          {"best_frame", record.best_frame},
          {"best_hidden", record.best_hidden}};
}

/// In words, by their numbers, and last what stands in place of one.
Json reasons() {
  Json list = Json::array();
  for (std::size_t r = 0; r < culler::kMissedReasons; ++r) list.push_back(text_of(static_cast<culler::Missed>(r)));
  list.push_back(kUnasked);
  return list;
}

Json json_of(const PageOccluder& occluder) { return {{"polygons", occluder.places}, {"shell", occluder.is_shell}}; }

}  // namespace

struct WalkRecording::Impl {
  explicit Impl(const culler::Culler& culler)
      : model(culler.hierarchy()), frames(culler, model), details(culler, model), pieces(model), vain(model) {}

  /// Each occluder that was chosen: its polygons by their places in the page, and what it did. `numbers` gets its place in
  /// the list.
  [[nodiscard]] Json occluders(std::map<std::uint32_t, std::size_t>& numbers) const {
    Json list = Json::array();
    for (const auto& [index, record] : frames.occluders()) {
      numbers.emplace(index, list.size());
      list.push_back(json_of(record.occluder));
      list.back().update(json_of(record.did));
    }
    return list;
  }

  /// The pieces that hid most, and the useless ones used most often. Null if there are no covers.
  [[nodiscard]] Json ranked_pieces() const {
    constexpr std::size_t kMost = 15;  // of each kind
    if (!has_covers) return nullptr;
    const PagePieces::Ranking ranking = pieces.ranking(kMost);
    const auto list = [&](const std::vector<std::uint32_t>& leaves) {
      Json result = Json::array();
      for (const std::uint32_t leaf : leaves) {
        result.push_back(json_of(pieces.records()[leaf]));
        result.back()["leaf"] = leaf;
      }
      return result;
    };
    return {{"used", ranking.used}, {"useless", ranking.useless}, {"uses", ranking.uses},
            {"idle", ranking.idle}, {"best", list(ranking.best)}, {"worst", list(ranking.worst)}};
  }

  [[nodiscard]] Json outlines(const std::map<std::uint32_t, std::size_t>& numbers) const {
    Json list = Json::array();
    for (const PageFrames::Outline& outline : frames.outlines()) {
      list.push_back({{"occluder", numbers.at(outline.occluder)}, {"corners", outline.corners}});
    }
    return list;
  }

  /// The occluders that the details name.
  [[nodiscard]] Json hiders_alone() const {
    Json list = Json::array();
    for (const PageOccluder& occluder : details.occluders()) list.push_back(json_of(occluder));
    return list;
  }

  /// The names of the half-spaces of a frame.
  [[nodiscard]] Json planes() const {
    Json list = Json::array();
    for (std::size_t i = 0; i < most_planes; ++i) list.push_back(name_of_plane(i, camera));
    return list;
  }

  PageModel model;
  PageFrames frames;
  PageDetails details;
  PagePieces pieces;
  bool has_covers = false;
  PageVain vain;
  std::size_t drawn = 0;           ///< frames
  std::size_t most_planes = 0;     ///< of a frame's view
  culler::Camera camera;           ///< of the last frame
  std::string eyes, targets, ups;  ///< of all frames, numbers with commas
  bool is_tilted = false;          ///< whether `up` changes
};

WalkRecording::WalkRecording(const culler::Culler& culler) : impl_(std::make_unique<Impl>(culler)) {}
WalkRecording::~WalkRecording() = default;
WalkRecording::WalkRecording(WalkRecording&&) noexcept = default;
WalkRecording& WalkRecording::operator=(WalkRecording&&) noexcept = default;

void WalkRecording::add_frame(const ShownFrame& frame) {
  impl_->frames.add(frame.culled);
  impl_->details.add(frame, frame.visible ? frame.record.frame_ms : frame.record.cull_ms);
  if (frame.culled.method == culler::Method::cover) {
    impl_->has_covers = true;
    impl_->pieces.add(frame.culled, frame.covers);
  }
  if (frame.visible) {
    impl_->vain.add(frame.culled, *frame.visible);
    ++impl_->drawn;
  }
  if (!impl_->eyes.empty()) impl_->is_tilted = impl_->is_tilted || frame.camera.up != impl_->camera.up;
  impl_->camera = frame.camera;
  impl_->most_planes = std::max(impl_->most_planes, frame.culled.view.size());
  const auto append = [](std::string& list, const glm::dvec3& v) {
    fmt::format_to(std::back_inserter(list), "{}{:.9g},{:.9g},{:.9g}", list.empty() ? "" : ",", v.x, v.y, v.z);
  };
  append(impl_->eyes, frame.camera.eye);
  append(impl_->targets, frame.camera.target);
  append(impl_->ups, frame.camera.up);
}

std::size_t WalkRecording::polygons() const { return impl_->model.polygons(); }

std::size_t WalkRecording::every() const { return impl_->frames.every(); }

std::vector<std::pair<std::string, std::string>> WalkRecording::parts() const {
  const PageModel& model = impl_->model;
  std::map<std::uint32_t, std::size_t> numbers;
  const Json occluders = impl_->occluders(numbers);
  const Json scene = {{"low", page_json(model.grid().low)},
                      {"step", model.grid().step},
                      {"steps", model.grid().steps},
                      {"every", every()},
                      {"camera", page_lens(impl_->camera)},
                      {"occluders", occluders},
                      {"pieces", impl_->ranked_pieces()},
                      {"drawn_frames", impl_->drawn},
                      {"outlines", impl_->outlines(numbers)},
                      {"alone", impl_->hiders_alone()},
                      {"reasons", reasons()},
                      {"planes", impl_->planes()}};
  return {{"scene", scene.dump()},
          {"path", fmt::format(R"({{"eyes":[{}],"targets":[{}]{}}})", impl_->eyes, impl_->targets,
                               impl_->is_tilted ? fmt::format(R"(,"ups":[{}])", impl_->ups) : "")},
          {"vertices", model.vertices()},
          {"leaves", model.leaf_sizes()},
          {"sides", model.sides()},
          {"corners", model.corners()},
          {"numbers", model.numbers()},
          {"vain", impl_->vain.packed()},
          {"frames", impl_->frames.packed()},
          {"details", impl_->details.packed()}};
}

}  // namespace occlude::render
