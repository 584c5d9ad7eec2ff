// SPDX-License-Identifier: MIT
#include "failures.h"

#include <fmt/format.h>

#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>
#include <vector>

#include "occlude/render/interrupt.h"

namespace occlude::cli {
namespace {

constexpr std::size_t kPictures = 16;  // the first few are enough to see what is wrong

std::string picture_name(std::size_t frame) { return fmt::format("failure_{:06}.png", frame); }

bool is_picture(const std::string& name) { return name.starts_with("failure_") && name.ends_with(".png"); }

}  // namespace

std::string describe(const FalseCull& failure, const culler::Hierarchy& hierarchy, const WitnessText& witness,
                     const SeenText& seen) {
  return fmt::format("frame {}: polygon {} is culled and shows {}: {}", failure.frame, hierarchy.face(failure.polygon),
                     seen(failure.frame), witness(failure.frame, failure.witness));
}

FailureFiles::FailureFiles(const std::filesystem::path& folder)
    : folder_(folder), lines_(folder / "failures.jsonl"), pictures_(folder, is_picture) {}

void FailureFiles::write(const Visibility& visibility, const CheckedWalk& walk, const WitnessText& witness,
                         const SeenText& seen, const std::function<ItemBuffers&()>& buffers) {
  const culler::Hierarchy& hierarchy = walk.culler.hierarchy();
  std::map<std::size_t, std::vector<culler::PolygonRange>> marked;
  for (const FalseCull& failure : visibility.false_culls) {
    if (marked.contains(failure.frame) || marked.size() < kPictures) marked[failure.frame].push_back({failure.polygon, 1});
    const bool has_picture = marked.contains(failure.frame);
    const nlohmann::ordered_json line{
        {"frame", failure.frame},
        {"polygon", hierarchy.face(failure.polygon)},
        {"shows", seen(failure.frame)},
        {"witness", witness(failure.frame, failure.witness)},
        {"picture", has_picture ? nlohmann::ordered_json(picture_name(failure.frame)) : nlohmann::ordered_json()}};
    lines_.write(line.dump(-1, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + '\n');
  }
  for (const auto& [frame, polygons] : marked) {
    pictures_.add(picture_name(frame), buffers().picture(walk.path.camera(frame, walk.aspect), polygons));
  }
  lines_.close();
  const render::Uninterrupted together;
  pictures_.commit();
  lines_.commit();
}

}  // namespace occlude::cli
