// SPDX-License-Identifier: MIT
#include "scene_world.h"

#include <algorithm>
#include <cmath>

namespace occlude::experiments {
namespace {

using culler::Camera;
using culler::ObjectId;
using culler::OccluderId;
using culler::Placement;
using kernel::Aabb;

constexpr double kBlock = 100;  // metres
constexpr int kBuildings = 3;   // along each side of a block
constexpr double kPitch = kBlock / kBuildings, kStreet = 7;
constexpr std::size_t kAbreast = 10;                                // tiles beside each other around the flight
constexpr double kFlight = kBlock / static_cast<double>(kAbreast);  // metres a frame: one tile comes in each

std::shared_ptr<const culler::OccluderMesh> unit_box() {
  culler::PolygonSoup soup;
  soup.add_box({0, 0, 0}, {1, 1, 1});
  return std::make_shared<culler::OccluderMesh>(std::move(soup));
}

Placement placement_of(const Aabb& box) {
  return {{box.max.x - box.min.x, 0, 0}, {0, box.max.y - box.min.y, 0}, {0, 0, box.max.z - box.min.z}, box.min};
}

/// The walls of a building, which its box holds.
Aabb walls_of(const Aabb& building) {
  constexpr double kEaves = 0.3;
  return {{building.min.x + kEaves, building.min.y + kEaves, building.min.z},
          {building.max.x - kEaves, building.max.y - kEaves, building.max.z - kEaves}};
}

}  // namespace

SceneWorld::SceneWorld(const WorldSize& size, std::uint64_t seed) : random_(seed), size_(size), unit_(unit_box()) {
  const std::size_t standing = size.objects - size.streamed - size.moving, blocks = (standing + kOfTile - 1) / kOfTile;
  side_ = static_cast<int>(std::ceil(std::sqrt(static_cast<double>(std::max<std::size_t>(blocks, 1)))));
  for (std::size_t b = 0; b < blocks; ++b) {
    add_block(static_cast<int>(b) % side_, static_cast<int>(b) / side_, std::min(kOfTile, standing - b * kOfTile));
  }
  while (tiles_.size() < size.streamed / kOfTile) {
    prepare_tile(next_tile_++);
    tiles_.push_back(add_tile());
  }
  while (movers_.size() < size.moving) add_mover(movers_.size() < size.moving_occluders);
  scene_.update();
}

double SceneWorld::uniform(double low, double high) {
  return low + (high - low) * (static_cast<double>(random_() >> 11U) * 0x1p-53);
}

void SceneWorld::note(ObjectId id, const Box& box, bool moves) {
  if (things_.size() <= id.slot()) things_.resize(id.slot() + std::size_t{1});
  things_[id.slot()] = {id, box, moves, false, {}};
}

OccluderId SceneWorld::add_occluder(const Aabb& box, ObjectId object, bool moves) {
  things_[object.slot()].is_occluder = true;
  things_[object.slot()].placement = placement_of(box);
  return scene_.add(unit_, placement_of(box), {.moves = moves, .is_one_sided = true, .object = object});
}

Aabb SceneWorld::thing_within(const Aabb& room, double size) {
  kernel::Vec3 low{}, high{};
  for (int axis = 0; axis < 3; ++axis) {
    const double length = uniform(0.1, size);
    low[axis] = uniform(room.min[axis], room.max[axis] - length);
    high[axis] = low[axis] + length;
  }
  return {low, high};
}

/// A block of buildings, with eight tenths of its things in them and the others in the streets.
void SceneWorld::add_block(int column, int row, std::size_t objects) {
  const double x = kBlock * column, y = kBlock * row;
  std::vector<Aabb> buildings;
  boxes_.clear();
  for (int i = 0; i < kBuildings * kBuildings && boxes_.size() < objects; ++i) {
    const double west = x + kPitch * (i % kBuildings) + kStreet, south = y + kPitch * (i / kBuildings) + kStreet;
    const Aabb building{{west, south, 0}, {west + kPitch - kStreet, south + kPitch - kStreet, uniform(8, 40)}};
    buildings.push_back(building);
    boxes_.emplace_back(building);
  }
  while (boxes_.size() < objects) {
    if (boxes_.size() % 5 != 0) {
      boxes_.emplace_back(thing_within(walls_of(buildings[random_() % buildings.size()]), 2));
    } else {
      const bool is_along_x = random_() % 2 == 0;
      const double street = kPitch * static_cast<double>(random_() % kBuildings);
      Aabb strip{{x, y + street, 0}, {x + kBlock, y + street + kStreet, 3}};
      if (!is_along_x) strip = {{x + street, y, 0}, {x + street + kStreet, y + kBlock, 3}};
      boxes_.emplace_back(thing_within(strip, 1));
    }
  }
  std::vector<ObjectId> ids(boxes_.size());
  scene_.add(boxes_, {}, ids);
  for (std::size_t i = 0; i < ids.size(); ++i) note(ids[i], boxes_[i], false);
  for (std::size_t i = 0; i < buildings.size(); ++i) add_occluder(walls_of(buildings[i]), ids[i], false);
}

/// Tile `number` of those along the flight: kAbreast beside each other across each block of the way.
void SceneWorld::prepare_tile(std::size_t number) {
  const double along = kBlock * static_cast<double>(number / kAbreast % static_cast<std::size_t>(side_));
  const double aside = kBlock * (side_ / 2 + static_cast<double>(number % kAbreast) - static_cast<double>(kAbreast) / 2);
  const Aabb ground{{along, aside, 0}, {along + kBlock, aside + kBlock, 2}};
  boxes_.clear();
  for (int i = 0; i < 2; ++i) {
    const double x = uniform(along, along + kBlock - 6), y = aside + kPitch * (i + 1) + 1;
    boxes_.emplace_back(Aabb{{x, y, 0}, {x + 6, y + 3, 3}});
  }
  while (boxes_.size() < kOfTile) boxes_.emplace_back(thing_within(ground, 1));
}

SceneWorld::Tile SceneWorld::add_tile() {
  Tile tile;
  tile.objects.resize(boxes_.size());
  scene_.add(boxes_, {}, tile.objects);
  for (std::size_t i = 0; i < boxes_.size(); ++i) note(tile.objects[i], boxes_[i], false);
  for (std::size_t i = 0; i < 2; ++i) {
    tile.occluders.push_back(add_occluder(walls_of(std::get<Aabb>(boxes_[i])), tile.objects[i], false));
  }
  return tile;
}

void SceneWorld::remove_tile(const Tile& tile) {
  for (const OccluderId id : tile.occluders) scene_.remove(id);
  for (const ObjectId id : tile.objects) {
    scene_.remove(id);
    things_[id.slot()].id = {};
  }
}

void SceneWorld::add_mover(bool is_bus) {
  const bool is_along_x = random_() % 2 == 0;
  const double streets = kPitch * std::floor(uniform(0, kBuildings * side_));
  Mover mover{{},         {},    uniform(0, kBlock * side_), uniform(0.02, 0.3), streets + (random_() % 2 == 0 ? 0.5 : 4),
              is_along_x, is_bus};
  mover.id = scene_.add(Aabb{}, {.moves = true});
  note(mover.id, Aabb{}, true);
  if (is_bus) mover.occluder = add_occluder(Aabb{}, mover.id, true);
  prepare(mover);
  place(mover);
  movers_.push_back(mover);
}

void SceneWorld::prepare(Mover& mover) const {
  const double town = kBlock * side_, at = std::fmod(mover.start + mover.speed * static_cast<double>(frame_), town);
  const double length = mover.is_bus ? 12 : 4.2, width = mover.is_bus ? 2.5 : 1.8, height = mover.is_bus ? 3 : 1.5;
  mover.box = {{at, mover.street, 0}, {at + length, mover.street + width, height}};
  if (!mover.is_along_x) mover.box = {{mover.street, at, 0}, {mover.street + width, at + length, height}};
}

void SceneWorld::place(const Mover& mover) {
  scene_.move(mover.id, mover.box);
  things_[mover.id.slot()].box = mover.box;
  if (!mover.is_bus) return;
  const Placement placement = placement_of(walls_of(mover.box));
  scene_.move(mover.occluder, placement);
  things_[mover.id.slot()].placement = placement;
}

void SceneWorld::prepare() {
  ++frame_;
  if (!tiles_.empty()) prepare_tile(next_tile_++);
  for (Mover& mover : movers_) prepare(mover);
}

void SceneWorld::change() {
  if (!tiles_.empty()) {
    remove_tile(tiles_.front());
    tiles_.pop_front();
    tiles_.push_back(add_tile());
  }
  for (const Mover& mover : movers_) place(mover);
}

Camera SceneWorld::camera(std::size_t view) const {
  const double frame = static_cast<double>(frame_), town = kBlock * side_, middle = kBlock * (side_ / 2) + kStreet / 2;
  Camera camera;
  if (view == 0) {
    // In the middle of the tiles, looking along the way and from side to side.
    const double behind = kBlock * static_cast<double>(tiles_.size()) / (2 * kAbreast);
    camera.eye = {std::fmod(kFlight * frame + behind, town), middle, 1.7};
    camera.target = camera.eye + glm::dvec3{1, 0.4 * std::sin(frame / 20), 0.05};
  } else {
    camera.eye = {middle, std::fmod(0.4 * frame + town / 4, town), 1.7};
    camera.target = camera.eye + glm::dvec3{std::sin(frame / 50), std::cos(frame / 50), 0.05};
  }
  return camera;
}

culler::Scene SceneWorld::made_anew(std::vector<ObjectId>& ids) const {
  culler::Scene scene;
  ids.clear();
  for (const Thing& thing : things_) {
    if (thing.id.is_none()) continue;
    const ObjectId id = scene.add(thing.box, {.moves = thing.moves});
    ids.push_back(thing.id);
    if (!thing.is_occluder) continue;
    scene.add(unit_, thing.placement, {.moves = thing.moves, .is_one_sided = true, .object = id});
  }
  scene.update();
  return scene;
}

}  // namespace occlude::experiments
