// SPDX-License-Identifier: MIT
// Bytes as a named file, for readers that only take files.
#pragma once

#include <unistd.h>

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <span>
#include <string>

namespace occlude::harness {

/// The file is in the folder for temporary files and is removed with the object. A process always uses the same name.
class ScratchFile {
 public:
  ScratchFile(std::span<const std::uint8_t> bytes, const std::string& extension)
      : path_(std::filesystem::temp_directory_path() / ("occlude_harness_" + std::to_string(getpid()) + extension)) {
    std::ofstream(path_, std::ios::binary)
        .write(reinterpret_cast<const char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
  }
  ~ScratchFile() { std::filesystem::remove(path_); }
  ScratchFile(const ScratchFile&) = delete;
  ScratchFile& operator=(const ScratchFile&) = delete;

  [[nodiscard]] const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

}  // namespace occlude::harness
