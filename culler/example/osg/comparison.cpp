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
  cull_occluded(ours.town.root(), {.misplaced = {misplaced, misplaced, 0}});
}

Way& Comparison::add(std::string name, TownKind kind, osg::CullSettings::CullingMode culling) {
  ways_.push_back(std::make_unique<Way>(std::move(name), kind, size_.side));
  Way& way = *ways_.back();
  way.renderer = std::make_unique<Renderer>(*context_, way.town.root(), culling);
  for (std::size_t i = 0; i < way.town.things().size(); ++i) way.things.emplace(way.town.things()[i].drawable.get(), i);
  return way;
}

double Comparison::time_of(int frame) const { return flight_.seconds() * frame / std::max(1, size_.frames - 1); }

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
  // The first frames upload what they draw.
  for (int i = 0; is_counted && i < 2; ++i) way.renderer->draw(++frame_number_, 0, flight_.view(0));
  FrameTimes sum;
  for (int frame = 0; frame < size_.frames; ++frame) {
    const double time = time_of(frame);
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
  if (&way == ways_.front().get()) in_view_.push_back(drawn);
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
