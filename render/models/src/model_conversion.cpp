// SPDX-License-Identifier: MIT
#include "model_conversion.h"

#include "model_check.h"
#include "occlude/render/errors.h"

namespace occlude::render {
namespace {

void require_known(const Convention& convention, const Conversion& conversion, const std::filesystem::path& file) {
  if (conversion.to_z_up && convention.up == glm::dvec3(0))
    throw InputError(file.string() + ": does not say which axis is up: name it, --up y");
  if (conversion.to_metres && convention.metres == 0)
    throw InputError(file.string() + ": does not say what its unit is: name it, --unit cm");
}

}  // namespace

void convert(Model& model, const Conversion& conversion, const std::filesystem::path& file) {
  Convention& said = model.notes.file;
  if (conversion.file.metres != 0) said.metres = conversion.file.metres;
  if (conversion.file.up != glm::dvec3(0)) said.up = conversion.file.up;
  require_known(said, conversion, file);
  Convention& convention = model.notes.convention = said;
  if (conversion.to_z_up) {
    for (glm::dvec3& v : model.soup.vertices) v = turned_to_z_up(v, convention.up);
    convention.up = {0, 0, 1};
  }
  if (!conversion.to_metres) return;
  std::size_t tiny = 0;
  for (glm::dvec3& v : model.soup.vertices) {
    v *= convention.metres;
    tiny += drop_tiny(v);
    if (const auto fault = vertex_fault(v)) throw InputError(file.string() + ": in metres, " + *fault);
  }
  if (tiny != 0) require_coarse(file, model.soup);
  model.notes.tiny_numbers += tiny;
  model.notes.rounding *= convention.metres;
  convention.metres = 1;
}

}  // namespace occlude::render
