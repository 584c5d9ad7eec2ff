// SPDX-License-Identifier: MIT
#include "occlude/render/model_io.h"

#include <algorithm>
#include <new>
#include <stdexcept>

#include "model_readers.h"
#include "occlude/render/errors.h"
#include "occlude/render/store.h"

namespace occlude::render {
namespace {

std::string lower_case(std::string text) {
  std::ranges::transform(text, text.begin(),
                         [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; });
  return text;
}

Model read_as_it_is(const std::filesystem::path& file) {
  if (is_store(file)) return {model_of(read_store(file, culler::Method::frusta)), {}};
  const std::string extension = lower_case(file.extension().string());
  if (extension == ".ply") return read_ply(file);
  if (extension == ".obj") return read_obj(file);
  if (extension == ".gltf" || extension == ".glb") return read_gltf(file);
  return read_with_assimp(file);
}

}  // namespace

Model read_model(const std::filesystem::path& file, const ReadOptions& options) try {
  Model model = read_as_it_is(file);
  if (options.is_opaque_all) make_opaque(model.soup);
  return model;
} catch (const std::bad_alloc&) {
  throw InputError(file.string() + ": out of memory");
} catch (const std::length_error& error) {
  throw InputError(file.string() + ": " + error.what());
}

}  // namespace occlude::render
