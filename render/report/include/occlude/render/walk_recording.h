// SPDX-License-Identifier: MIT
// What the page of a walk shows of its model and frames, kept while the walk runs.
#pragma once

#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "occlude/render/walk.h"

namespace occlude::render {

class WalkRecording {
 public:
  /// Before the first frame; `culler` must stay until the last one.
  explicit WalkRecording(const culler::Culler& culler);
  ~WalkRecording();
  WalkRecording(WalkRecording&&) noexcept;
  WalkRecording& operator=(WalkRecording&&) noexcept;

  void add_frame(const ShownFrame& frame);

  /// The polygons that the page has; the walk may have more.
  [[nodiscard]] std::size_t polygons() const;
  /// Of the frames of the walk, the page shows each `every`-th in the viewer.
  [[nodiscard]] std::size_t every() const;

  /// Parts for the page, by name: bytes as page/unpack.js reads them, before compression.
  [[nodiscard]] std::vector<std::pair<std::string, std::string>> parts() const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace occlude::render
