// SPDX-License-Identifier: MIT
#include "occlude/culler/scene.h"

#include <algorithm>
#include <memory>
#include <optional>
#include <span>
#include <utility>

#include "bounds.h"
#include "cull_frame.h"
#include "lazy.h"
#include "legal_soup.h"
#include "object_tree.h"
#include "outer_box.h"
#include "view_memory.h"

namespace occlude::culler {
namespace {

std::shared_ptr<const PolygonSoup> checked(PolygonSoup&& soup) {
  require_legal(soup);
  return std::make_shared<const PolygonSoup>(std::move(soup));
}

/// The box around the static objects and the occluders, which is about where cameras are; the origin if there are none.
kernel::Aabb extent(std::span<const Box> statics, const PolygonSoup& soup) {
  if (statics.empty() && soup.empty()) return {};
  kernel::Aabb box = empty_box();
  for (const Box& object : statics) grow(box, outer_box(object));
  for (std::size_t p = 0; p < soup.size(); ++p) grow(box, soup.box(p));
  return box;
}

OccluderSet set_of(const std::shared_ptr<const PolygonSoup>& soup, std::span<const Box> statics, const ObjectTree& objects,
                   const SceneConfig& config, const Checkpoint& checkpoint) {
  Space space{extent(statics, *soup)};
  if (!statics.empty()) {
    space.nodes = objects.nodes();
    space.root = objects.static_root();
  }
  return OccluderSet::build(soup, space, config.occluders, config.lists, checkpoint);
}

/// Turns ranges of drawn items into the ids of objects.
void list_objects(const ObjectTree& objects, std::span<const PolygonRange> drawn, SceneResult& result) {
  result.statics.clear();
  result.dynamics.clear();
  result.static_ranges.clear();
  const auto statics = static_cast<std::uint32_t>(objects.statics());
  result.statics.reserve(statics);
  result.dynamics.reserve(objects.dynamics());
  result.static_ranges.reserve(statics);
  for (const auto [first, count] : drawn) {
    const std::uint32_t end = first + count, middle = std::clamp(statics, first, end);
    if (first < middle) result.static_ranges.push_back({first, middle - first});
    for (std::uint32_t i = first; i < middle; ++i) result.statics.push_back(objects.order()[i]);
    for (std::uint32_t i = middle; i < end; ++i) result.dynamics.push_back(objects.order()[i] - statics);
  }
}

}  // namespace

/// A tree of the occluders, if there are any, and their triangles.
struct OccluderTree {
  std::optional<Hierarchy> tree;
  CoverTriangles triangles;

  OccluderTree(const PolygonSoup& soup, const Checkpoint& checkpoint) {
    if (soup.empty()) return;
    constexpr std::uint32_t kLeaf = 4;  // models are culled best with this size
    tree = Hierarchy::build(soup, {.leaf_size = kLeaf}, checkpoint);
    triangles = CoverTriangles::find(tree->soup(), tree->nodes(), checkpoint);
  }
  OccluderTree() = default;

  [[nodiscard]] CoverSource source() const { return {tree ? tree->nodes() : std::span<const HierarchyNode>{}, triangles}; }
};

class CoverOccluders : public Lazy<OccluderTree> {};

Scene::Scene(const SceneObjects& objects, PolygonSoup occluders, const Config& config, const Checkpoint& checkpoint)
    : objects_(std::make_unique<ObjectTree>(objects.statics, objects.dynamics, checkpoint)),
      occluders_(set_of(checked(std::move(occluders)), objects.statics, *objects_, config, checkpoint)),
      cover_(std::make_unique<CoverOccluders>()) {}

Scene::~Scene() = default;
Scene::Scene(Scene&&) noexcept = default;
Scene& Scene::operator=(Scene&&) noexcept = default;

const SceneResult& Scene::cull(const Camera& camera, const CullOptions& options, SceneView& view) const {
  require_sound(camera);
  View::Memory& memory = view.view_.memory_for(identity_);
  const auto ask = [&](std::uint32_t node, auto&& question) { return objects_->ask(node, question); };
  // No object is a part of an occluder. A box that contains what an occluder stands for reaches its near plane, so it is not
  // culled.
  const auto holds_no_part = [](std::uint32_t, std::uint32_t) { return false; };
  if (options.method == Method::cover) {
    const OccluderTree& occluders = cover_->get([&] { return OccluderTree(occluders_.soup(), {}); });
    cull_by_cover(objects_->nodes(), ask, occluders.source(), camera, options, memory);
  } else {
    cull_by_frusta(objects_->nodes(), ask, holds_no_part, occluders_, camera, options, memory);
  }
  list_objects(*objects_, memory.result.drawn, view.result_);
  return view.result_;
}

void Scene::prepare_cover(const Checkpoint& checkpoint) const {
  static_cast<void>(cover_->get([&] { return OccluderTree(occluders_.soup(), checkpoint); }));
}

void Scene::set_bounds(std::uint32_t dynamic, const Box& box) { objects_->set_bounds(dynamic, box); }
void Scene::update() { objects_->update(); }

std::size_t Scene::statics() const { return objects_->statics(); }
std::size_t Scene::dynamics() const { return objects_->dynamics(); }
std::span<const std::uint32_t> Scene::static_order() const { return objects_->order().first(objects_->statics()); }

}  // namespace occlude::culler
