// SPDX-License-Identifier: MIT
#include "import_child.h"

#include <fmt/format.h>

#include <cstdio>
#include <stdexcept>
#include <string>

#include "occlude/render/child_process.h"
#include "occlude/render/errors.h"
#include "occlude/render/input_file.h"
#include "occlude/render/model_io.h"

namespace occlude::render {

void import_by(const ImportSteps& steps, const std::filesystem::path& file, std::string_view importer) {
  require_readable(file);
  const auto work = [&](std::FILE* out) {
    CountedFiles files;
    std::string failure;
    try {
      steps.import(files);
    } catch (const InputError& error) {
      failure = error.what();
    } catch (const std::length_error& error) {
      failure = file.string() + ": " + error.what();
    }
    HandoverWriter writer(out);
    writer.put(failure);
    if (failure.empty()) steps.hand_over(writer);
  };
  try {
    const File handed_over = run_in_child(import_limits_for(0), work);
    HandoverReader reader(handed_over.get());
    std::string failure;
    reader.take(failure);
    if (!failure.empty()) throw InputError(failure);
    steps.take_over(reader);
  } catch (const ChildFailure& failure) {
    throw InputError(fmt::format("{}: cannot import: {} {}{}", file.string(), importer, failure.what(),
                                 failure.at_limit ? ": " + import_limits() : ""));
  }
}

}  // namespace occlude::render
