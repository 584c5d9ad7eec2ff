// SPDX-License-Identifier: MIT
#include "occlude/render/output_folder.h"

#include <fmt/format.h>

#include <optional>
#include <system_error>
#include <utility>

#include "occlude/render/errors.h"

namespace occlude::render {
namespace fs = std::filesystem;
namespace {

/// The folder and its parents, the outermost first.
std::vector<fs::path> with_parents(const fs::path& folder) {
  std::vector<fs::path> folders;
  fs::path path;
  for (const fs::path& name : folder) folders.push_back(path /= name);
  return folders;
}

}  // namespace

OutputFolder::OutputFolder(const fs::path& path) {
  for (const fs::path& folder : with_parents(path)) {
    std::error_code error;
    std::optional<Leftover> made = Leftover::make(folder, [&] { return fs::create_directory(folder, error); });
    if (made) made_.push_back(std::move(*made));
    if (!error) continue;
    remove_empty();
    throw InputError(fmt::format("{}: cannot create the folder: {}", path.string(), error.message()));
  }
}

OutputFolder::~OutputFolder() { remove_empty(); }

void OutputFolder::remove_empty() {
  while (!made_.empty()) made_.pop_back();
}

}  // namespace occlude::render
