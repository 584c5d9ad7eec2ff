// SPDX-License-Identifier: MIT
// Imports in a child process: what they take is limited, and their crashes do not end this process.
#pragma once

#include <filesystem>
#include <functional>
#include <string_view>

#include "counted_files.h"
#include "handover.h"
#include "model_handover.h"

namespace occlude::render {

/// What a child process does, and how what it has made comes back.
struct ImportSteps {
  std::function<void(CountedFiles&)> import;       ///< in the child; its files are to be counted
  std::function<void(HandoverWriter&)> hand_over;  ///< in the child
  std::function<void(HandoverReader&)> take_over;  ///< in this process
};

/// Does the steps within the limits. Throws the InputError that the import throws, and one that says how `importer` ("the
/// import library") fails if it ends in any other way.
void import_by(const ImportSteps& steps, const std::filesystem::path& file, std::string_view importer);

/// What import(CountedFiles&) returns, made in a child process. Throws as import_by().
template <class Import>
[[nodiscard]] auto import_in_child(const std::filesystem::path& file, std::string_view importer, const Import& import) {
  std::invoke_result_t<Import, CountedFiles&> made;
  import_by({.import = [&](CountedFiles& files) { made = import(files); },
             .hand_over = [&](HandoverWriter& writer) { hand_over(made, writer); },
             .take_over = [&](HandoverReader& reader) { take_over(made, reader); }},
            file, importer);
  return made;
}

}  // namespace occlude::render
