// SPDX-License-Identifier: MIT
#include "occlude/render/model_io.h"

#include <algorithm>
#include <new>

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

}  // namespace

culler::PolygonSoup read_model(const std::filesystem::path& file) try {
  if (is_store(file)) return model_of(read_store(file, culler::Method::frusta));
  const std::string extension = lower_case(file.extension().string());
  if (extension == ".ply") return read_ply(file);
  if (extension == ".obj") return read_obj(file);
  return read_with_assimp(file);
} catch (const std::bad_alloc&) {
  throw InputError(file.string() + ": out of memory");
}

}  // namespace occlude::render
