// SPDX-License-Identifier: MIT
// A world that streams: a town of which most stands, tiles of things that come and go along a path, and traffic.
#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <memory>
#include <random>
#include <vector>

#include "occlude/culler/scene.h"

namespace occlude::experiments {

struct WorldSize {
  std::size_t objects = 1'000'000;     ///< in all
  std::size_t streamed = 100'000;      ///< of these, in tiles that come and go
  std::size_t moving = 10'000;         ///< of these, those that move
  std::size_t moving_occluders = 100;  ///< of the moving objects, those that hide
};

/// Tiles of 1,000 objects. Nine in ten stand in the town: each such tile is a block of nine buildings, which hide, with what
/// is in them and in the streets around them. The others hold small things and two kiosks, which hide; one comes and one
/// goes in each frame, around a camera that flies along the streets. Traffic drives through all of the town, buses in it
/// hide. The same seed gives the same world on every machine.
class SceneWorld {
 public:
  static constexpr std::size_t kOfTile = 1000;
  static constexpr std::size_t kViews = 2;

  SceneWorld(const WorldSize& size, std::uint64_t seed);

  /// Thinks of the next frame: what comes, and where everything will be.
  void prepare();
  /// Changes the scene so. It is not updated.
  void change();

  [[nodiscard]] culler::Scene& scene() { return scene_; }
  [[nodiscard]] const culler::Scene& scene() const { return scene_; }
  /// The camera of a view in the frame: one flies with the tiles, one walks across the town.
  [[nodiscard]] culler::Camera camera(std::size_t view) const;

  /// A scene with the same content, made at once. `ids` becomes the ids of the objects in this world, by slots of that one.
  [[nodiscard]] culler::Scene made_anew(std::vector<culler::ObjectId>& ids) const;
  /// The box of an object of the scene.
  [[nodiscard]] culler::Box box(culler::ObjectId object) const { return things_[object.slot()].box; }
  [[nodiscard]] std::size_t occluders() const { return scene_.occluders(); }

 private:
  using Box = culler::Box;

  /// What made_anew() needs to know of an object.
  struct Thing {
    culler::ObjectId id;
    Box box;
    bool moves = false;
    bool is_occluder = false;
    culler::Placement placement;
  };
  struct Tile {
    std::vector<culler::ObjectId> objects;
    std::vector<culler::OccluderId> occluders;
  };
  struct Mover {
    culler::ObjectId id;
    culler::OccluderId occluder;
    double start, speed, street;  ///< metres, metres a frame, metres
    bool is_along_x, is_bus;
    kernel::Aabb box = {};  ///< in the next frame
  };

  double uniform(double low, double high);
  kernel::Aabb thing_within(const kernel::Aabb& room, double size);
  void add_block(int column, int row, std::size_t objects);
  void prepare_tile(std::size_t number);
  Tile add_tile();
  void remove_tile(const Tile& tile);
  void add_mover(bool is_bus);
  void prepare(Mover& mover) const;
  void place(const Mover& mover);
  culler::OccluderId add_occluder(const kernel::Aabb& box, culler::ObjectId object, bool moves);
  void note(culler::ObjectId id, const Box& box, bool moves);

  std::mt19937_64 random_;
  WorldSize size_;
  int side_;                                          ///< blocks along each side of the town
  std::shared_ptr<const culler::OccluderMesh> unit_;  ///< the box from 0 to 1 on each axis
  culler::Scene scene_;
  std::vector<Thing> things_;  ///< by slots
  std::deque<Tile> tiles_;     ///< the oldest first
  std::size_t next_tile_ = 0;
  std::vector<Mover> movers_;
  std::size_t frame_ = 0;
  std::vector<Box> boxes_;  ///< of the tile or block that comes next
};

}  // namespace occlude::experiments
