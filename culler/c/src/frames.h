// SPDX-License-Identifier: MIT
// Frames as arrays, and how they are asked for.
#pragma once

#include <vector>

#include "occlude.h"
#include "occlude/culler/executor.h"
#include "occlude/culler/scene.h"

namespace occlude::c {

/// A frame that is kept. Its memory grows as that of the library's frame does.
class KeptFrame {
 public:
  void keep(const culler::SceneResult& result);
  /// Fills in what the caller's struct has room for.
  void write_to(occlude_frame* frame) const;
  void write_to(occlude_statistics* statistics) const;

 private:
  std::vector<occlude_object> objects_;
  std::vector<float> sizes_, distances_;
  std::vector<occlude_half_space> planes_;
  std::vector<occlude_occluder> idle_occluders_;
  culler::SceneStats stats_;
};

/// How the caller asks for frames. Null: defaults. `name` is for the message.
[[nodiscard]] occlude_cull_options read_cull_options(const occlude_cull_options* given, const char* name);
/// Where their objects are tested.
[[nodiscard]] culler::Executor executor_of(const occlude_cull_options& options);
/// The rest of them.
[[nodiscard]] culler::SceneOptions to_scene_options(const occlude_cull_options& options);

}  // namespace occlude::c
