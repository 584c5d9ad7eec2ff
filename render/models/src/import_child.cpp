// SPDX-License-Identifier: MIT
#include "import_child.h"

#include <fmt/format.h>

#include <cstdio>
#include <stdexcept>
#include <string>

#include "model_check.h"
#include "model_handover.h"
#include "occlude/render/child_process.h"
#include "occlude/render/errors.h"
#include "occlude/render/input_file.h"
#include "occlude/render/model_io.h"

namespace occlude::render {

Model import_in_child(const std::filesystem::path& file, std::string_view importer,
                      const std::function<Model(CountedFiles&)>& import) {
  require_readable(file);
  const auto work = [&](std::FILE* out) {
    CountedFiles files;
    std::string failure;
    Model model;
    try {
      model = import(files);
    } catch (const InputError& error) {
      failure = error.what();
    } catch (const std::length_error& error) {
      failure = file.string() + ": " + error.what();
    }
    hand_over(failure, model, out);
  };
  try {
    const File handed_over = run_in_child(import_limits_for(0), work);
    Model model = take_over(handed_over.get());
    require_usable(file, model.soup);
    return model;
  } catch (const ChildFailure& failure) {
    throw InputError(fmt::format("{}: cannot import: {} {}{}", file.string(), importer, failure.what(),
                                 failure.at_limit ? ": " + import_limits() : ""));
  }
}

}  // namespace occlude::render
