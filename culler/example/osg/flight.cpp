// SPDX-License-Identifier: MIT
#include "flight.h"

#include <algorithm>
#include <cmath>

#include "town.h"

namespace occlude::example {
namespace {

constexpr double kSpeed = 10;  // metres a second
constexpr double kClimb = 5;   // seconds, at the end
constexpr double kRise = 25;   // metres

osg::Vec3d crossing(int column, int row) {
  constexpr double kMiddle = static_cast<double>(Town::kStreet) / 2, kHead = 1.7;
  const double x = Town::kBlockX, y = Town::kBlockY;
  return {x * column + kMiddle, y * row + kMiddle, kHead};
}

}  // namespace

Flight::Flight(int side)
    : start_(crossing(std::max(1, side / 4), side / 2)),
      corner_(crossing(side / 2, side / 2)),
      end_(crossing(side / 2, std::max(side * 3 / 4, side / 2 + 1))) {}

double Flight::seconds() const { return ((corner_ - start_).length() + (end_ - corner_).length()) / kSpeed + kClimb; }

osg::Vec3d Flight::eye(double time) const {
  const double first = (corner_ - start_).length() / kSpeed, second = (end_ - corner_).length() / kSpeed;
  if (time < first) return start_ + (corner_ - start_) * (time / first);
  if (time < first + second) return corner_ + (end_ - corner_) * ((time - first) / second);
  return end_ + osg::Vec3d(0, 0, kRise * (time - first - second) / kClimb);
}

osg::Matrixd Flight::view(double time) const {
  const double first = (corner_ - start_).length() / kSpeed, second = (end_ - corner_).length() / kSpeed;
  // It turns within a second and looks from side to side.
  const double turn = std::clamp(time - first + 0.5, 0.0, 1.0), sway = 0.5 * std::sin(time / 2);
  const double heading = osg::PI_2 * turn + sway, down = std::max(0.0, time - first - second) / kClimb * 0.25;
  const osg::Vec3d at = eye(time), ahead(std::cos(heading), std::sin(heading), 0.04 - down);
  return osg::Matrixd::lookAt(at, at + ahead, osg::Vec3d(0, 0, 1));
}

}  // namespace occlude::example
