// SPDX-License-Identifier: MIT
#include "failures.h"

#include <fmt/format.h>

#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>
#include <vector>

#include "occlude/render/image.h"
#include "occlude/render/output_file.h"
#include "occlude/render/output_folder.h"

namespace occlude::cli {
namespace {

constexpr std::size_t kPictures = 16;  // the first few tell what is wrong

std::string picture_name(std::size_t frame) { return fmt::format("failure_{:06}.png", frame); }

}  // namespace

std::string describe(const FalseCull& failure, const culler::Hierarchy& hierarchy, const WitnessText& witness) {
  return fmt::format("frame {}: polygon {} is culled and shows {}: {}", failure.frame, hierarchy.original(failure.polygon),
                     failure.where, witness(failure.frame, failure.witness));
}

void write_failures(const std::string& folder, const Visibility& visibility, const culler::Hierarchy& hierarchy,
                    const render::CameraPath& path, double aspect, const WitnessText& witness, ItemBuffers& buffers) {
  const render::OutputFolder made(folder);
  render::OutputFile lines(std::filesystem::path(folder) / "failures.jsonl");
  std::map<std::size_t, std::vector<culler::PolygonRange>> marked;
  for (const FalseCull& failure : visibility.false_culls) {
    if (marked.contains(failure.frame) || marked.size() < kPictures) marked[failure.frame].push_back({failure.polygon, 1});
    const bool has_picture = marked.contains(failure.frame);
    lines.stream() << nlohmann::ordered_json{{"frame", failure.frame},
                                             {"polygon", hierarchy.original(failure.polygon)},
                                             {"shows", failure.where},
                                             {"witness", witness(failure.frame, failure.witness)},
                                             {"picture", has_picture ? nlohmann::ordered_json(picture_name(failure.frame))
                                                                     : nlohmann::ordered_json()}}
                          .dump()
                   << '\n';
  }
  for (const auto& [frame, polygons] : marked) {
    write_png(std::filesystem::path(folder) / picture_name(frame), buffers.picture(path.camera(frame, aspect), polygons));
  }
  lines.commit();
}

}  // namespace occlude::cli
