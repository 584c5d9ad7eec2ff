// SPDX-License-Identifier: MIT
#include "failures.h"

#include <fmt/format.h>

#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>
#include <vector>

#include "occlude/render/image.h"

namespace occlude::cli {
namespace {

constexpr std::size_t kPictures = 16;  // the first few tell what is wrong

std::string picture_name(std::size_t frame) { return fmt::format("failure_{:06}.png", frame); }

/// Those of an earlier run would be taken for this one's.
void remove_old_pictures(const std::filesystem::path& folder) {
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    const std::string name = entry.path().filename().string();
    if (name.starts_with("failure_") && name.ends_with(".png")) std::filesystem::remove(entry.path());
  }
}

}  // namespace

std::string describe(const FalseCull& failure, const culler::Hierarchy& hierarchy, const WitnessText& witness) {
  return fmt::format("frame {}: polygon {} is culled and shows {}: {}", failure.frame, hierarchy.original(failure.polygon),
                     failure.where, witness(failure.frame, failure.witness));
}

FailureFiles::FailureFiles(const std::string& folder) : folder_(folder), path_(folder), lines_(path_ / "failures.jsonl") {}

void FailureFiles::write(const Visibility& visibility, const CheckedWalk& walk, const WitnessText& witness,
                         const std::function<ItemBuffers&()>& buffers) {
  remove_old_pictures(path_);
  const culler::Hierarchy& hierarchy = walk.culler.hierarchy();
  std::map<std::size_t, std::vector<culler::PolygonRange>> marked;
  for (const FalseCull& failure : visibility.false_culls) {
    if (marked.contains(failure.frame) || marked.size() < kPictures) marked[failure.frame].push_back({failure.polygon, 1});
    const bool has_picture = marked.contains(failure.frame);
    lines_.stream() << nlohmann::ordered_json{{"frame", failure.frame},
                                              {"polygon", hierarchy.original(failure.polygon)},
                                              {"shows", failure.where},
                                              {"witness", witness(failure.frame, failure.witness)},
                                              {"picture", has_picture ? nlohmann::ordered_json(picture_name(failure.frame))
                                                                      : nlohmann::ordered_json()}}
                           .dump()
                    << '\n';
  }
  for (const auto& [frame, polygons] : marked) {
    write_png(path_ / picture_name(frame), buffers().picture(walk.path.camera(frame, walk.aspect), polygons));
  }
  lines_.commit();
}

}  // namespace occlude::cli
