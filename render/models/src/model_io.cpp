// SPDX-License-Identifier: MIT
#include "occlude/render/model_io.h"

#include <new>
#include <stdexcept>

#include "extension.h"
#include "model_conversion.h"
#include "model_readers.h"
#include "occlude/render/errors.h"
#include "occlude/render/store.h"

namespace occlude::render {
namespace {

Model read_as_it_is(const std::filesystem::path& file, bool with_colours) {
  if (is_store(file)) return {model_of(read_store(file, culler::Method::frusta)), {}};
  const std::string extension = extension_of(file);
  if (extension == ".ply") return read_ply(file, with_colours);
  if (extension == ".obj") return read_obj(file, with_colours);
  if (is_gltf(file)) return read_gltf(file, with_colours);
  return read_with_assimp(file, with_colours);
}

}  // namespace

Model read_model(const std::filesystem::path& file, const ReadOptions& options) try {
  Model model = read_as_it_is(file, options.with_colours);
  if (options.is_opaque_all) make_opaque(model.soup);
  convert(model, options.conversion, file);
  return model;
} catch (const std::bad_alloc&) {
  throw InputError(file.string() + ": out of memory");
} catch (const std::length_error& error) {
  throw InputError(file.string() + ": " + error.what());
}

}  // namespace occlude::render
