// SPDX-License-Identifier: MIT
// A town of some thousand houses as a scene graph: streets, houses, what is in them and behind them, and traffic.
#pragma once

#include <cstddef>
#include <osg/Geometry>
#include <osg/Group>
#include <osg/Node>
#include <osg/ref_ptr>
#include <vector>

namespace occlude::example {

/// What OpenSceneGraph has for occlusion, built into the graph.
enum class TownKind {
  plain,
  occluder_nodes,   ///< each house stands under osg::OccluderNodes, one for each of its four walls
  occlusion_query,  ///< each house, with all that belongs to it, stands under an osg::OcclusionQueryNode
};

/// A thing of its own: it is drawn or not.
struct Thing {
  osg::ref_ptr<osg::Node> node;  ///< a transform that places it, or the drawable itself
  osg::ref_ptr<osg::Geometry> drawable;
  bool is_glass = false;  ///< shows what is behind it
};

/// The same number of blocks gives the same things, in the same order, on every machine.
class Town {
 public:
  /// `side` blocks of twelve houses along each side.
  Town(int side, TownKind kind);

  /// The whole. Blocks are groups of groups of four, and so on up.
  [[nodiscard]] osg::Group& root() const { return *root_; }
  [[nodiscard]] const std::vector<Thing>& things() const { return things_; }
  [[nodiscard]] std::size_t houses() const { return houses_; }

  static constexpr float kBlockX = 78, kBlockY = 66, kStreet = 12;  ///< metres; blocks with their streets

 private:
  struct Builder;

  osg::ref_ptr<osg::Group> root_ = new osg::Group;
  std::vector<Thing> things_;
  std::size_t houses_ = 0;
};

}  // namespace occlude::example
