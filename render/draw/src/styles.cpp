// SPDX-License-Identifier: MIT
#include "styles.h"

#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace occlude::render {
namespace {

using glm::dvec3;

// The weights of red, green and blue in what is seen as lightness (ITU-R BT.709).
constexpr dvec3 kLightness{0.2126, 0.7152, 0.0722};

constexpr dvec3 kWhite{1, 1, 1};

/// Whether a place is on a stripe of a pattern whose period is `period` pixels in a picture 720 high.
bool is_on_stripe(double along, int height, double period, double share) {
  const double at = along * 720 / height / period;
  return at - std::floor(at) < share;
}

}  // namespace

dvec3 styled(Style style, const dvec3& own, double x, double y, int height) {
  const dvec3 grey = dvec3(glm::dot(own, kLightness));
  switch (style) {
    case Style::plain:
      return own;
    case Style::drawn:
      return glm::mix(glm::mix(grey, own, 0.35), kWhite, 0.25);
    case Style::culled:
      return is_on_stripe(x + y, height, 9, 0.28) ? dvec3(0.86, 0.45, 0.40) : dvec3(0.56, 0.16, 0.14);
    case Style::out_of_view:
      return glm::mix(grey, kWhite, 0.82);
    case Style::occluder: {
      const bool is_dot = is_on_stripe(x, height, 8, 0.4) && is_on_stripe(y, height, 8, 0.4);
      return is_dot ? dvec3(0.78, 0.53, 0) : dvec3(1, 0.80, 0.10);
    }
    case Style::missed:
      return is_on_stripe(x - y, height, 9, 0.28) ? dvec3(0.60, 0.76, 0.95) : dvec3(0.13, 0.34, 0.62);
    case Style::marked:
      return {0.90, 0, 0.78};
  }
  return own;
}

double relief(Style style) { return style == Style::out_of_view ? 0.35 : 1; }

}  // namespace occlude::render
