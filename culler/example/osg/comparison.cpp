// SPDX-License-Identifier: MIT
#include "comparison.h"

#include <algorithm>
#include <osg/CollectOccludersVisitor>
#include <osgDB/WriteFile>
#include <utility>

#include "occlusion_callbacks.h"

namespace occlude::example {
namespace {

constexpr auto kFrustum = osg::CullSettings::VIEW_FRUSTUM_CULLING;
constexpr auto kOccluders = kFrustum | osg::CullSettings::SHADOW_OCCLUSION_CULLING;
// Metres. Houses, buses and ground hide, cars and furniture do not.
constexpr double kLeastOccluder = 2.2;

// The flight is too long to draw each of its frames. So frames are taken in excerpts, spread evenly, of so many that follow
// each other as on a screen. Before each come some that are neither measured nor counted: queries answer late, and what is
// drawn first is uploaded.
constexpr int kExcerpt = 20, kBefore = 8;
constexpr double kFrameSeconds = 1.0 / 30;

/// REQUIRES: two pictures of one size, three bytes a pixel.
std::size_t different_pixels(const osg::Image& a, const osg::Image& b) {
  std::size_t different = 0;
  for (unsigned int i = 0; i < a.getTotalSizeInBytes(); i += 3) {
    different += std::equal(a.data() + i, a.data() + i + 3, b.data() + i) ? 0U : 1U;
  }
  return different;
}

}  // namespace

Comparison::Comparison(const ComparisonSize& size, osg::GraphicsContext& context, double misplaced)
    : size_(size), flight_(size.side), context_(&context) {
  add("view frustum alone", TownKind::plain, kFrustum);
  add("OccluderNode, the 10 best", TownKind::occluder_nodes, kOccluders);  // OpenSceneGraph's default
  Way& more = add("OccluderNode, the 64 best", TownKind::occluder_nodes, kOccluders);
  osg::ref_ptr<osg::CollectOccludersVisitor> collect = new osg::CollectOccludersVisitor;
  collect->setMaximumNumberOfActiveOccluders(64);
  more.renderer->scene_view().setCollectOccludersVisitor(collect);
  add("OcclusionQueryNode", TownKind::occlusion_query, kFrustum);
  Way& ours = add("occlude", TownKind::plain, kFrustum);
  cull_occluded(ours.town.root(), {.least_occluder = kLeastOccluder, .misplaced = {misplaced, misplaced, 0}});
}

Way& Comparison::add(std::string name, TownKind kind, osg::CullSettings::CullingMode culling) {
  ways_.push_back(std::make_unique<Way>(std::move(name), kind, size_.side));
  Way& way = *ways_.back();
  way.renderer = std::make_unique<Renderer>(*context_, way.town.root(), culling);
  for (std::size_t i = 0; i < way.town.things().size(); ++i) way.things.emplace(way.town.things()[i].drawable.get(), i);
  return way;
}

double Comparison::time_of(int frame) const {
  const int excerpts = (size_.frames + kExcerpt - 1) / kExcerpt;
  const double start = flight_.seconds() * (frame / kExcerpt + 0.5) / excerpts;
  return start + kFrameSeconds * (frame % kExcerpt);
}

void Comparison::run() {
  {
    ItemBuffer items(*context_, ways_.front()->town.things());
    for (int frame = 0; frame < size_.frames; ++frame) {
      const double time = time_of(frame);
      shows_.push_back(items.visible(time, flight_.view(time)));
      visible_ += static_cast<std::size_t>(std::ranges::count(shows_.back(), true));
    }
  }
  for (int round = 0; round < size_.rounds; ++round) {
    for (const std::unique_ptr<Way>& way : ways_) fly(*way, round == 0);
  }
}

void Comparison::fly(Way& way, bool is_counted) {
  FrameTimes sum;
  for (int frame = 0; frame < size_.frames; ++frame) {
    const double time = time_of(frame);
    for (int i = frame % kExcerpt == 0 ? kBefore : 0; i > 0; --i) {
      const double earlier = time - kFrameSeconds * i;
      way.renderer->draw(++frame_number_, earlier, flight_.view(earlier));
    }
    const FrameTimes times = way.renderer->draw(++frame_number_, time, flight_.view(time));
    sum.update += times.update / size_.frames;
    sum.cull += times.cull / size_.frames;
    sum.frame += times.frame / size_.frames;
    if (is_counted) count(way, frame);
  }
  way.runs.push_back(sum);
}

void Comparison::count(Way& way, int frame) {
  std::vector<bool> drawn(way.town.things().size());
  for (const osg::Drawable* const drawable : way.renderer->drawn()) {
    if (const auto thing = way.things.find(drawable); thing != way.things.end()) drawn[thing->second] = true;
  }
  const osg::ref_ptr<osg::Image> picture = way.renderer->picture();
  if (&way == ways_.front().get()) {
    in_view_.push_back(drawn);
    pictures_.push_back(picture);
  }
  way.wrong_pixels += different_pixels(*picture, *pictures_[static_cast<std::size_t>(frame)]);
  const auto& in_view = in_view_[static_cast<std::size_t>(frame)];
  const auto& shows = shows_[static_cast<std::size_t>(frame)];
  for (std::size_t i = 0; i < drawn.size(); ++i) {
    const bool is_hidden = in_view[i] && !shows[i];
    way.drawn += drawn[i] ? 1U : 0U;
    way.culled_hidden += is_hidden && !drawn[i] ? 1U : 0U;
    way.false_culls += shows[i] && !drawn[i] ? 1U : 0U;
    if (&way == ways_.front().get() && is_hidden) ++hidden_;
  }
}

bool Comparison::write_picture(int frame, const std::string& file) {
  const double time = time_of(frame);
  ours().renderer->draw(++frame_number_, time, flight_.view(time));
  return osgDB::writeImageFile(*ours().renderer->picture(), file);
}

FrameTimes median(const std::vector<FrameTimes>& runs) {
  const auto middle = [&](double FrameTimes::*time) {
    std::vector<double> times;
    for (const FrameTimes& run : runs) times.push_back(run.*time);
    const auto at = times.begin() + static_cast<std::ptrdiff_t>(times.size() / 2);
    std::ranges::nth_element(times, at);
    return *at;
  };
  return {middle(&FrameTimes::update), middle(&FrameTimes::cull), middle(&FrameTimes::frame)};
}

}  // namespace occlude::example
