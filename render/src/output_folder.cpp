// SPDX-License-Identifier: MIT
#include "occlude/render/output_folder.h"

#include <fmt/format.h>

#include <system_error>
#include <utility>

#include "occlude/render/errors.h"

namespace occlude::render {

OutputFolder::OutputFolder(std::filesystem::path path) : path_(std::move(path)) {
  if (path_.empty()) throw InputError("no folder named to write to");
  std::error_code error;
  is_new_ = std::filesystem::create_directories(path_, error);
  if (error) throw InputError(fmt::format("{}: cannot create the folder: {}", path_.string(), error.message()));
}

OutputFolder::~OutputFolder() {
  std::error_code not_empty;
  if (is_new_) std::filesystem::remove(path_, not_empty);
}

}  // namespace occlude::render
