// SPDX-License-Identifier: MIT
#include "town.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <osg/BlendColor>
#include <osg/BlendFunc>
#include <osg/ConvexPlanarOccluder>
#include <osg/Light>
#include <osg/LightSource>
#include <osg/Material>
#include <osg/MatrixTransform>
#include <osg/OccluderNode>
#include <osg/OcclusionQueryNode>
#include <random>

#include "house.h"
#include "town_mesh.h"
#include "traffic.h"

namespace occlude::example {
namespace {

constexpr int kHousesInRow = 6;

osg::ref_ptr<osg::MatrixTransform> placed(const osg::Matrixd& place, osg::Node& below) {
  osg::ref_ptr<osg::MatrixTransform> transform = new osg::MatrixTransform(place);
  transform->addChild(&below);
  return transform;
}

osg::Matrixd turned(float degrees, const osg::Vec3& at) {
  return osg::Matrixd::rotate(osg::DegreesToRadians(static_cast<double>(degrees)), osg::Vec3d(0, 0, 1)) *
         osg::Matrixd::translate(at);
}

/// Puts `below` under an occluder node for each wall of the house, in the house's coordinates.
osg::ref_ptr<osg::Node> under_occluders(const House& house, osg::ref_ptr<osg::Node> below) {
  const float w = house.width, d = house.depth, e = house.eaves;
  const std::array<osg::Vec3, 5> foot = {osg::Vec3(0, 0, 0), {w, 0, 0}, {w, d, 0}, {0, d, 0}, {0, 0, 0}};
  const osg::Vec3 up(0, 0, e);
  for (std::size_t i = 0; i < 4; ++i) {
    osg::ref_ptr<osg::ConvexPlanarOccluder> wall = new osg::ConvexPlanarOccluder;
    for (const osg::Vec3& corner : {foot[i], foot[i + 1], foot[i + 1] + up, foot[i] + up}) wall->getOccluder().add(corner);
    if (i == 0) {
      for (const auto& [left, bottom, right, top] : house.openings) {
        osg::ConvexPlanarPolygon hole;
        for (const osg::Vec3& corner : {osg::Vec3(left, 0, bottom), {right, 0, bottom}, {right, 0, top}, {left, 0, top}}) {
          hole.add(corner);
        }
        wall->addHole(hole);
      }
    }
    osg::ref_ptr<osg::OccluderNode> node = new osg::OccluderNode;
    node->setOccluder(wall);
    node->addChild(below);
    below = node;
  }
  return below;
}

TownMesh box_mesh(const osg::Vec3& size, const Colour& colour) {
  TownMesh mesh;
  mesh.box({-size.x() / 2, -size.y() / 2, 0}, {size.x() / 2, size.y() / 2, size.z()}, colour);
  return mesh;
}

TownMesh tree_mesh(float height) {
  TownMesh mesh;
  mesh.box({-0.15F, -0.15F, 0}, {0.15F, 0.15F, height / 2}, {0.35F, 0.25F, 0.15F});
  const float r = height / 4;
  const osg::Vec3 top(0, 0, height), bottom(0, 0, height / 3);
  for (int i = 0; i < 6; ++i) {
    const auto at = [&](int k) {
      const float angle = static_cast<float>(k) * 1.0471976F;
      return osg::Vec3(r * std::cos(angle), r * std::sin(angle), height * 0.6F);
    };
    mesh.triangle({at(i), at(i + 1), top}, {0.24F, 0.42F, 0.18F});
    mesh.triangle({at(i + 1), at(i), bottom}, {0.20F, 0.36F, 0.15F});
  }
  return mesh;
}

TownMesh shed_mesh() {
  TownMesh mesh = box_mesh({3, 2.4F, 2}, {0.45F, 0.34F, 0.22F});
  mesh.box({-1.7F, -1.4F, 2}, {1.7F, 1.4F, 2.2F}, {0.25F, 0.25F, 0.25F});
  return mesh;
}

/// The ground of a block, and the streets to the west and south of it.
TownMesh ground_mesh() {
  constexpr float kX = Town::kBlockX, kY = Town::kBlockY, kS = Town::kStreet;
  TownMesh mesh;
  const auto ground = [&](float west, float south, float east, float north, const Colour& colour) {
    mesh.quad({osg::Vec3(west, south, 0), {east, south, 0}, {east, north, 0}, {west, north, 0}}, colour);
  };
  ground(kS, kS, kX, kY, {0.36F, 0.47F, 0.26F});
  ground(0, 0, kX, kS, {0.33F, 0.33F, 0.34F});
  ground(0, kS, kS, kY, {0.33F, 0.33F, 0.34F});
  return mesh;
}

void light(osg::Group& root) {
  osg::ref_ptr<osg::Material> material = new osg::Material;
  material->setColorMode(osg::Material::AMBIENT_AND_DIFFUSE);
  root.getOrCreateStateSet()->setAttributeAndModes(material);
  root.getOrCreateStateSet()->setMode(GL_LIGHTING, osg::StateAttribute::ON);
  root.getOrCreateStateSet()->setMode(GL_LIGHT0, osg::StateAttribute::ON);
  osg::ref_ptr<osg::LightSource> sun = new osg::LightSource;
  sun->getLight()->setPosition({0.4F, -0.7F, 0.9F, 0});
  sun->getLight()->setAmbient({0.35F, 0.36F, 0.42F, 1});
  sun->getLight()->setDiffuse({0.75F, 0.72F, 0.66F, 1});
  root.addChild(sun);
}

}  // namespace

struct Town::Builder {
  Town& town;
  TownKind kind;
  std::mt19937 random{1};
  std::vector<House> houses = {};
  std::vector<TownMesh> furniture = {}, trees = {};
  TownMesh shed = shed_mesh(), ground = ground_mesh();
  TownMesh plants = box_mesh({1.6F, 1.2F, 1.4F}, {0.5F, 0.2F, 0.25F});
  TownMesh glasshouse = box_mesh({3, 2.4F, 2.2F}, {0.6F, 0.8F, 0.75F});
  osg::ref_ptr<osg::StateSet> glass = new osg::StateSet;

  Builder(Town& of, TownKind of_kind) : town(of), kind(of_kind) {
    for (int i = 0; i < 24; ++i) houses.push_back(make_house(uniform(random, 8.5F, 10.4F), random));
    for (int i = 0; i < 12; ++i) {
      const auto shade = [&] { return uniform(random, 0.2F, 0.8F); };
      const osg::Vec3 size(uniform(random, 0.4F, 1.8F), uniform(random, 0.4F, 1.2F), uniform(random, 0.5F, 2));
      furniture.push_back(box_mesh(size, {shade(), shade(), shade()}));
    }
    for (int i = 0; i < 4; ++i) trees.push_back(tree_mesh(uniform(random, 4, 9)));
    glass->setRenderingHint(osg::StateSet::TRANSPARENT_BIN);
    glass->setAttribute(new osg::BlendColor(osg::Vec4(0, 0, 0, 0.5F)));
    glass->setAttributeAndModes(new osg::BlendFunc(GL_CONSTANT_ALPHA, GL_ONE_MINUS_CONSTANT_ALPHA));
  }

  void add(osg::Group& group, const osg::Matrixd& place, const TownMesh& mesh, bool is_glass = false) {
    osg::ref_ptr<osg::Geometry> drawable = mesh.geometry();
    if (is_glass) drawable->setStateSet(glass);
    osg::ref_ptr<osg::Node> node = placed(place, *drawable);
    group.addChild(node);
    town.things_.push_back({node, drawable, is_glass});
  }

  /// A house with its front at y = 0 of `lot`, three things in it, and two or three behind it.
  void add_lot(osg::Group& block, const osg::Matrixd& lot) {
    osg::ref_ptr<osg::Group> group = new osg::Group;
    if (kind == TownKind::occlusion_query) {
      osg::ref_ptr<osg::OcclusionQueryNode> query = new osg::OcclusionQueryNode;
      query->setVisibilityThreshold(0);
      group = query;
    }
    const House& house = houses[random() % houses.size()];
    osg::ref_ptr<osg::Geometry> drawable = house.mesh.geometry();
    osg::ref_ptr<osg::Node> below = drawable;
    if (kind == TownKind::occluder_nodes) below = under_occluders(house, below);
    osg::ref_ptr<osg::Node> node = placed(lot, *below);
    group->addChild(node);
    town.things_.push_back({node, drawable});
    ++town.houses_;
    const auto somewhere = [&](float low, float high) {
      const float x = uniform(random, 1.5F, house.width - 1.5F);
      return osg::Vec3(x, uniform(random, low, high), 0);
    };
    for (int i = 0; i < 3; ++i) {
      const osg::Vec3 at = somewhere(1.5F, house.depth - 1.5F);
      add(*group, turned(uniform(random, 0, 90), at) * lot, furniture[random() % furniture.size()]);
    }
    const osg::Vec3 yard = somewhere(house.depth + 2.5F, house.depth + 6);
    const bool is_glass = random() % 4 == 0;
    add(*group, turned(uniform(random, -20, 20), yard) * lot, is_glass ? glasshouse : shed, is_glass);
    if (is_glass) add(*group, osg::Matrixd::translate(yard) * lot, plants);
    add(*group, osg::Matrixd::translate(somewhere(house.depth + 7, house.depth + 13)) * lot, trees[random() % trees.size()]);
    block.addChild(group);
  }

  /// Two rows of houses, back to back.
  osg::ref_ptr<osg::Group> block(int column, int row) {
    osg::ref_ptr<osg::Group> group = new osg::Group;
    const float x = kBlockX * static_cast<float>(column), y = kBlockY * static_cast<float>(row);
    add(*group, osg::Matrixd::translate(x, y, 0), ground);
    constexpr float kLot = (kBlockX - kStreet) / kHousesInRow, kPavement = 2;
    for (int i = 0; i < kHousesInRow; ++i) {
      const float along = kLot * static_cast<float>(i);
      add_lot(*group, osg::Matrixd::translate(x + kStreet + along, y + kStreet + kPavement, 0));
      add_lot(*group, turned(180, {x + kBlockX - along, y + kBlockY - kPavement, 0}));
    }
    return group;
  }

  /// Blocks from (column, row) on, in a square with `side` a power of two, as a tree.
  osg::ref_ptr<osg::Group> square(int column, int row, int side, int blocks) {
    if (column >= blocks || row >= blocks) return nullptr;
    if (side == 1) return block(column, row);
    osg::ref_ptr<osg::Group> group = new osg::Group;
    const int half = side / 2;
    for (int i = 0; i < 4; ++i) {
      const osg::ref_ptr<osg::Group> quarter = square(column + i % 2 * half, row + i / 2 * half, half, blocks);
      if (quarter) group->addChild(quarter);
    }
    return group;
  }
};

Town::Town(int side, TownKind kind) {
  light(*root_);
  Builder builder(*this, kind);
  const auto square = static_cast<int>(std::bit_ceil(static_cast<unsigned int>(side)));
  root_->addChild(builder.square(0, 0, square, side));
  for (Thing& thing : make_traffic(side)) {
    root_->addChild(thing.node);
    things_.push_back(std::move(thing));
  }
}

}  // namespace occlude::example
