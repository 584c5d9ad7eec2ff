// SPDX-License-Identifier: MIT
#include "occlude/render/picture_set.h"

#include <algorithm>
#include <system_error>
#include <utility>

#include "occlude/render/output_place.h"

namespace occlude::render {
namespace fs = std::filesystem;

PictureSet::PictureSet(fs::path folder, IsSuch is_such) : folder_(std::move(folder)), is_such_(std::move(is_such)) {
  require_places(folder_, is_such_);
}

void PictureSet::add(const std::string& name, const Image& image) {
  OutputFile& file = files_.emplace_back(folder_ / name);
  write_png(file, image);
  file.close();
}

void PictureSet::commit() {
  for (OutputFile& file : files_) file.commit();
  const auto is_new = [&](const fs::path& picture) {
    return std::ranges::any_of(files_, [&](const OutputFile& file) { return file.path().filename() == picture.filename(); });
  };
  std::error_code ignored;  // the pictures of this run are complete; old ones do no harm
  for (const auto& entry : fs::directory_iterator(folder_, ignored)) {
    const fs::path& picture = entry.path();
    if (is_such_(picture.filename().string()) && !is_new(picture) && is_own_png(picture)) fs::remove(picture, ignored);
  }
}

}  // namespace occlude::render
