// SPDX-License-Identifier: MIT
// The cases of data/cases: the answer of each was worked out by hand, and the cheapest stage that can give it.
#pragma once

#include <ostream>
#include <string>
#include <vector>

#include "cases/case.h"

namespace occlude {

/// What a line says is right.
struct HandAnswer {
  std::string id;  ///< of letters, digits and underscores
  kernel::Relation relation;
  kernel::Stage stage;
};

/// A box and the shadow of one occluder.
struct HandCase : HandAnswer {
  cases::Case question;

  friend void PrintTo(const HandCase& c, std::ostream* out) { *out << c.id; }
};

/// A box and the joined shadow of several polygons.
struct HandCover : HandAnswer {
  kernel::Viewpoint viewpoint;
  std::vector<cases::Polygon> polygons;
  cases::Box box;

  friend void PrintTo(const HandCover& c, std::ostream* out) { *out << c.id; }
};

/// A box and the umbra or penumbra for a region of viewpoints.
struct HandRegion : HandAnswer {
  cases::RegionCase question;

  friend void PrintTo(const HandRegion& c, std::ostream* out) { *out << c.id; }
};

/// In the order of the files. Throws std::runtime_error, naming file and line, for a line that is not such a case.
[[nodiscard]] const std::vector<HandCase>& hand_cases();
[[nodiscard]] const std::vector<HandCover>& hand_covers();
[[nodiscard]] const std::vector<HandRegion>& hand_regions();

/// Those of an occluder or a group: whose ids begin so.
[[nodiscard]] std::vector<HandCase> hand_cases(const std::string& beginning);

}  // namespace occlude
