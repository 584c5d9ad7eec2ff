// SPDX-License-Identifier: MIT
#include "view.h"

PYBIND11_MODULE(_occlude, module) {
  using namespace occlude::python;
  module.attr("__version__") = OCCLUDE_PROJECT_VERSION;
  define_cameras(module);
  define_matrix_cameras(module);
  define_views(module);
  define_scenes(module);
  define_models(module);
  define_held_culls(module);
  define_faces(module);
  define_simplified(module);
  define_kernel(module);
}
