// SPDX-License-Identifier: MIT
#include "traffic.h"

#include <cmath>
#include <osg/Callback>
#include <osg/FrameStamp>
#include <osg/MatrixTransform>
#include <osg/NodeVisitor>
#include <random>

#include "flight.h"
#include "house.h"
#include "town_mesh.h"

namespace occlude::example {
namespace {

/// Drives along a street from one end of the town to the other, again and again.
class Drive : public osg::NodeCallback {
 public:
  struct Way {
    bool is_along_x;
    double street, length, start, speed;  ///< metres, seconds; backwards if the speed is negative
  };
  explicit Drive(const Way& way) : way_(way) {}

  void operator()(osg::Node* node, osg::NodeVisitor* visitor) override {
    const double time = visitor->getFrameStamp() != nullptr ? visitor->getFrameStamp()->getSimulationTime() : 0;
    double at = std::fmod(way_.start + way_.speed * time, way_.length);
    if (at < 0) at += way_.length;
    const osg::Vec3d place = way_.is_along_x ? osg::Vec3d(at, way_.street, 0) : osg::Vec3d(way_.street, at, 0);
    const double heading = (way_.is_along_x ? 0 : osg::PI_2) + (way_.speed < 0 ? osg::PI : 0);
    static_cast<osg::MatrixTransform*>(node)->setMatrix(osg::Matrixd::rotate(heading, osg::Vec3d(0, 0, 1)) *
                                                        osg::Matrixd::translate(place));
    traverse(node, visitor);
  }

 private:
  Way way_;
};

TownMesh car_mesh(const Colour& colour) {
  TownMesh mesh;
  mesh.box({-2.1F, -0.9F, 0.3F}, {2.1F, 0.9F, 0.9F}, colour);
  mesh.box({-1.2F, -0.8F, 0.9F}, {1, 0.8F, 1.5F}, {0.2F, 0.24F, 0.3F});
  for (const float x : {-1.4F, 1.4F}) mesh.box({x - 0.35F, -0.92F, 0}, {x + 0.35F, 0.92F, 0.6F}, {0.08F, 0.08F, 0.08F});
  return mesh;
}

TownMesh bus_mesh() {
  TownMesh mesh;
  mesh.box({-6, -1.25F, 0.3F}, {6, 1.25F, 3.2F}, {0.75F, 0.12F, 0.10F});
  mesh.box({-5.7F, -1.28F, 1.5F}, {5.7F, 1.28F, 2.5F}, {0.2F, 0.24F, 0.3F});
  for (const float x : {-3.8F, 3.8F}) mesh.box({x - 0.5F, -1.26F, 0}, {x + 0.5F, 1.26F, 0.9F}, {0.08F, 0.08F, 0.08F});
  return mesh;
}

Thing drives(const TownMesh& mesh, const Drive::Way& way) {
  osg::ref_ptr<osg::Geometry> drawable = mesh.geometry();
  osg::ref_ptr<osg::MatrixTransform> transform = new osg::MatrixTransform;
  transform->addChild(drawable);
  transform->setDataVariance(osg::Object::DYNAMIC);
  transform->addUpdateCallback(new Drive(way));
  return {transform, drawable};
}

}  // namespace

std::vector<Thing> make_traffic(int side) {
  std::mt19937 random(2);
  const TownMesh bus = bus_mesh();
  std::vector<TownMesh> cars;
  for (int i = 0; i < 6; ++i) {
    const auto shade = [&] { return uniform(random, 0.1F, 0.9F); };
    cars.push_back(car_mesh({shade(), shade(), shade()}));
  }
  std::vector<Thing> traffic;
  const double along_x = static_cast<double>(Town::kBlockX) * side, along_y = static_cast<double>(Town::kBlockY) * side;
  const osg::Vec3d flight = Flight(side).eye(0);
  traffic.push_back(drives(bus, {true, flight.y() - 2.2, along_x, flight.x() + 24, 9}));
  for (int i = 0; i < 20 * side; ++i) {
    const bool is_along_x = random() % 2 == 0, is_back = random() % 2 == 0;
    const double pitch = is_along_x ? Town::kBlockY : Town::kBlockX;
    const auto street = static_cast<double>(random() % static_cast<unsigned int>(side));
    // On the right: to the south when driving east, to the east when driving north.
    const double aside = is_along_x == is_back ? 2.2 : -2.2;
    const double speed = static_cast<double>(uniform(random, 6, 14)) * (is_back ? -1 : 1);
    const double length = is_along_x ? along_x : along_y, start = static_cast<double>(uniform(random, 0, 1)) * length;
    const Drive::Way way{is_along_x, street * pitch + Town::kStreet / 2 + aside, length, start, speed};
    traffic.push_back(drives(i % 16 == 0 ? bus : cars[random() % cars.size()], way));
  }
  return traffic;
}

}  // namespace occlude::example
