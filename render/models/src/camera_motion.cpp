// SPDX-License-Identifier: MIT
#include "camera_motion.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "path_readers.h"

namespace occlude::render {

std::string add_name(CameraMotion& motion, const std::string& name) {
  const bool is_there = std::ranges::find(motion.names, name) != motion.names.end();
  motion.names.push_back(is_there ? fmt::format("{} #{}", name, motion.names.size()) : name);
  return motion.names.back();
}

void hand_over(const CameraMotion& motion, HandoverWriter& writer) {
  writer.put_texts(motion.names);
  const CameraMotion::Lens& lens = motion.lens;
  writer.put(std::array{lens.is_perspective ? 1.0 : 0.0, lens.fov_y_deg, lens.height, lens.near, lens.far});
  writer.put(motion.poses);
}

void take_over(CameraMotion& motion, HandoverReader& reader) {
  reader.take_texts(motion.names);
  std::vector<double> lens;
  reader.take(lens);
  reader.take(motion.poses);
  if (lens.size() != 5 || motion.poses.size() > kMostFrames) refuse_damage();
  motion.lens = {lens[0] != 0, lens[1], lens[2], lens[3], lens[4]};
}

}  // namespace occlude::render
