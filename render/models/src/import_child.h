// SPDX-License-Identifier: MIT
// Imports of models in a child process: what it takes is limited, and its crashes do not end this process.
#pragma once

#include <filesystem>
#include <functional>
#include <string_view>

#include "counted_files.h"
#include "occlude/render/model.h"

namespace occlude::render {

/// The model that `import` returns, which it makes in a child process within the limits. Its files are to be counted. Throws
/// the InputError that it throws, and one that says how `importer` ("the import library") fails if it ends in any other way.
[[nodiscard]] Model import_in_child(const std::filesystem::path& file, std::string_view importer,
                                    const std::function<Model(CountedFiles&)>& import);

}  // namespace occlude::render
