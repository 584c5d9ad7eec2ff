// SPDX-License-Identifier: MIT
// The finished parts of a job, as files of a folder.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>

namespace occlude::render {

/// The place of a part in its job.
struct PartNumber {
  unsigned stage = 0;
  std::uint64_t part = 0;
};

class KeptParts {
 public:
  /// Throws as the constructor of Job.
  KeptParts(std::filesystem::path folder, std::uint64_t key, bool resume);
  /// Removes a folder without parts.
  ~KeptParts();
  KeptParts(const KeptParts&) = delete;
  KeptParts& operator=(const KeptParts&) = delete;

  /// The result of a part that was kept for this input. Throws InputError, naming the file, if it is damaged.
  [[nodiscard]] std::optional<std::string> find(PartNumber number, const std::string& input);
  /// Keeps a result, unless it is too large to be read again.
  void keep(PartNumber number, const std::string& input, const std::string& result);
  void remove();

  [[nodiscard]] std::uint64_t count() const { return count_; }
  [[nodiscard]] const std::filesystem::path& folder() const { return folder_; }
  [[nodiscard]] std::filesystem::path file_of(PartNumber number) const;

 private:
  std::filesystem::path folder_;
  std::uint64_t count_ = 0;  ///< parts that this run has found or kept
};

}  // namespace occlude::render
