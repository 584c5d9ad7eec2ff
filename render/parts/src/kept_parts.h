// SPDX-License-Identifier: MIT
// The finished parts of a job, as files of a folder. Each is sealed: only what a run of this user has kept is used again.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

#include "seal.h"

namespace occlude::render {

/// The place of a part in its job.
struct PartNumber {
  unsigned stage = 0;
  std::uint64_t part = 0;
};

class KeptParts {
 public:
  /// Throws as the constructors of Job and of Seal.
  KeptParts(std::filesystem::path folder, std::uint64_t key, bool resume);
  /// Removes a folder without parts.
  ~KeptParts();
  KeptParts(const KeptParts&) = delete;
  KeptParts& operator=(const KeptParts&) = delete;

  /// The result of a part that was kept for this input. Throws InputError, naming the file, if no run of
  /// this user has kept it so.
  [[nodiscard]] std::optional<std::string> find(PartNumber number, const std::string& input) const;
  /// Keeps a result, unless it is too large to be read again.
  void keep(PartNumber number, const std::string& input, const std::string& result);
  void remove();

  /// The parts in the folder, also those that this run has not come to.
  [[nodiscard]] std::size_t count() const;
  [[nodiscard]] const std::filesystem::path& folder() const { return folder_; }
  [[nodiscard]] std::filesystem::path file_of(PartNumber number) const;

 private:
  /// The first line of a part: a seal of its input, and one of all that it is.
  [[nodiscard]] std::string head_of(PartNumber number, const std::string& input, std::string_view result) const;

  std::filesystem::path folder_;
  std::uint64_t key_;
  Seal seal_;
};

}  // namespace occlude::render
