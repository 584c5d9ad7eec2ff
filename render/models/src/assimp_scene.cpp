// SPDX-License-Identifier: MIT
#include "assimp_scene.h"

#include <assimp/DefaultIOSystem.h>
#include <assimp/MemoryIOWrapper.h>
#include <assimp/importerdesc.h>

#include <algorithm>
#include <cstdint>
#include <exception>
#include <new>
#include <string>
#include <system_error>

#include "assimp_convention.h"
#include "extension.h"
#include "occlude/render/errors.h"
#include "occlude/render/input_file.h"
#include "occlude/render/printable.h"

namespace occlude::render {
namespace {

/// The content of an XML file without the blanks that follow a tag: the importer of COLLADA takes a number behind them for
/// none.
std::string without_blanks_after_tags(std::string xml) {
  if (xml.find('\0') != std::string::npos) return xml;  // not of single bytes
  bool is_after_tag = false;
  std::erase_if(xml, [&](char c) {
    const bool is_blank = c == ' ' || c == '\t' || c == '\r' || c == '\n';
    is_after_tag = c == '>' || (is_after_tag && is_blank);
    return is_after_tag && is_blank;
  });
  return xml;
}

/// A file that was read before the importer asked for it.
Assimp::IOStream* in_memory(const std::string& bytes) {
  auto* const copy = new std::uint8_t[bytes.size()];
  std::ranges::copy(bytes, copy);
  constexpr bool kOwnsBytes = true;
  return new Assimp::MemoryIOStream(copy, bytes.size(), kOwnsBytes);
}

/// Opens files for an importer.
class ImporterFiles : public Assimp::DefaultIOSystem {
 public:
  explicit ImporterFiles(CountedFiles& files) : files_(files) {}

  bool Exists(const char* file) const override {
    std::error_code error;
    return std::filesystem::is_regular_file(file, error);
  }

  Assimp::IOStream* Open(const char* file, const char* mode) override {
    try {
      files_.count(file);
    } catch (const InputError& error) {
      // Importers can do without missing files.
      if (fault_.empty() && Exists(file)) fault_ = error.what();
      return nullptr;
    }
    if (extension_of(file) == ".dae") return in_memory(without_blanks_after_tags(read_input(file)));
    return DefaultIOSystem::Open(file, mode);
  }

  /// Why an existing file could not be opened; empty if all could.
  [[nodiscard]] const std::string& fault() const { return fault_; }

 private:
  CountedFiles& files_;
  std::string fault_;
};

}  // namespace

ImportedScene::ImportedScene(const std::filesystem::path& file, CountedFiles& counted) {
  auto* const files = new ImporterFiles(counted);  // owned by the importer
  importer_.SetIOHandler(files);
  constexpr unsigned kNoPostProcessing = 0;  // in particular no triangulation
  scene_ = importer_.ReadFile(file.string(), kNoPostProcessing);
  try {
    // Assimp stores what importers throw. Running out of memory is our error, not one of the file.
    if (importer_.GetException()) std::rethrow_exception(importer_.GetException());
  } catch (const std::bad_alloc&) {
    throw;
  } catch (...) {
  }
  if (scene_ == nullptr || scene_->mRootNode == nullptr) {
    const std::string reason = printable(files->fault().empty() ? importer_.GetErrorString() : files->fault());
    throw InputError(file.string() +
                     ": cannot import: " + (reason.empty() ? "the import library does not say why" : reason));
  }
  const aiImporterDesc* const used =
      importer_.GetImporterInfo(static_cast<std::size_t>(importer_.GetPropertyInteger("importerIndex")));
  convention_ = take_convention(*scene_, used == nullptr ? "" : used->mName);
}

}  // namespace occlude::render
