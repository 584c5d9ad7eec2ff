// SPDX-License-Identifier: MIT
#include "occlude/render/output_folder.h"

#include <fmt/format.h>

#include <algorithm>
#include <system_error>

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

void remove_empty(const std::vector<fs::path>& folders) {
  std::error_code not_empty;
  std::for_each(folders.rbegin(), folders.rend(), [&](const fs::path& folder) { fs::remove(folder, not_empty); });
}

}  // namespace

OutputFolder::OutputFolder(const fs::path& path) {
  for (const fs::path& folder : with_parents(path)) {
    std::error_code error;
    if (fs::create_directory(folder, error)) made_.push_back(folder);
    if (!error) continue;
    remove_empty(made_);
    throw InputError(fmt::format("{}: cannot create the folder: {}", path.string(), error.message()));
  }
}

OutputFolder::~OutputFolder() { remove_empty(made_); }

}  // namespace occlude::render
