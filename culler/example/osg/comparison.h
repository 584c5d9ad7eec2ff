// SPDX-License-Identifier: MIT
// Several ways of culling the same town on the same flight.
#pragma once

#include <cstddef>
#include <memory>
#include <osg/GraphicsContext>
#include <osg/Image>
#include <osg/ref_ptr>
#include <string>
#include <unordered_map>
#include <vector>

#include "flight.h"
#include "item_buffer.h"
#include "renderer.h"
#include "town.h"

namespace occlude::example {

struct ComparisonSize {
  int side = 16;     ///< blocks along each side of the town
  int frames = 120;  ///< of the flight, in excerpts of 20
  int rounds = 5;    ///< how often each way flies
  int width = 640, height = 360;
};

/// One way of culling, and what came of it.
struct Way {
  std::string name;
  Town town;
  std::unique_ptr<Renderer> renderer;
  std::unordered_map<const osg::Drawable*, std::size_t> things = {};
  std::vector<FrameTimes> runs = {};  ///< for each round, means of its frames
  /// Of all frames of the first round:
  std::size_t drawn = 0, culled_hidden = 0, false_culls = 0;
  std::size_t wrong_pixels = 0;  ///< other than by the view frustum alone

  Way(std::string called, TownKind kind, int side) : name(std::move(called)), town(side, kind) {}
};

class Comparison {
 public:
  /// Occluders of the culler are `misplaced` metres away from the houses.
  Comparison(const ComparisonSize& size, osg::GraphicsContext& context, double misplaced);

  /// The ways fly in turn, so that what else the machine does meets all of them.
  void run();
  /// Writes what the culler's way draws in the frame to a PNG or PPM file.
  [[nodiscard]] bool write_picture(int frame, const std::string& file);

  [[nodiscard]] const std::vector<std::unique_ptr<Way>>& ways() const { return ways_; }
  [[nodiscard]] const Way& ours() const { return *ways_.back(); }
  /// Things that pass the view frustum and have no pixel, and those that have one, in all frames.
  [[nodiscard]] std::size_t hidden() const { return hidden_; }
  [[nodiscard]] std::size_t visible() const { return visible_; }

 private:
  Way& add(std::string name, TownKind kind, osg::CullSettings::CullingMode culling);
  void fly(Way& way, bool is_counted);
  void count(Way& way, int frame);
  [[nodiscard]] double time_of(int frame) const;

  ComparisonSize size_;
  Flight flight_;
  osg::ref_ptr<osg::GraphicsContext> context_;
  std::vector<std::unique_ptr<Way>> ways_;          ///< the first by the view frustum alone, the last by the culler
  std::vector<std::vector<bool>> shows_, in_view_;  ///< for each frame and thing
  std::vector<osg::ref_ptr<osg::Image>> pictures_;  ///< for each frame, by the view frustum alone
  std::size_t hidden_ = 0, visible_ = 0;
  unsigned int frame_number_ = 0;
};

/// The middle one of the runs, by each time.
[[nodiscard]] FrameTimes median(const std::vector<FrameTimes>& runs);

}  // namespace occlude::example
