// SPDX-License-Identifier: MIT
// A glTF file and what it names.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "counted_files.h"
#include "gltf_buffers.h"
#include "gltf_document.h"
#include "occlude/render/input_file.h"
#include "occlude/render/printable.h"

namespace occlude::render::gltf {

/// As messages name it.
inline constexpr std::string_view kReader = "the reader of glTF";

/// What work(document, buffers) returns of the file. Its InputErrors get the name of the file, but for OldVersion.
template <class Work>
auto of_file(const std::filesystem::path& file, CountedFiles& files, const Work& work) {
  files.count(file);
  std::string bytes = read_input(file);
  try {
    const Document document(std::move(bytes));
    Buffers buffers(document, file.has_parent_path() ? file.parent_path() : ".", files);
    return work(document, buffers);
  } catch (const OldVersion&) {
    throw;
  } catch (const InputError& error) {
    throw InputError(file.string() + ": " + printable(error.what()));
  }
}

}  // namespace occlude::render::gltf
