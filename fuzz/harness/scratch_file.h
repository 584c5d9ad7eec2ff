// SPDX-License-Identifier: MIT
// Bytes as a file with a name, for readers that take nothing else.
#pragma once

#include <unistd.h>

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <span>
#include <string>

namespace occlude::harness {

/// In the folder for temporary files, removed with the object; one process uses the same name again and again.
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
