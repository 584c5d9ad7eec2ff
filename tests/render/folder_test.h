// SPDX-License-Identifier: MIT
// Tests that read files.
#pragma once

#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <string>

#include "occlude/render/errors.h"

namespace occlude::render {

/// A test with an empty folder of its own.
class FolderTest : public testing::Test {
 protected:
  FolderTest() { std::filesystem::create_directories(folder_); }
  ~FolderTest() override { std::filesystem::remove_all(folder_); }

  /// Writes a file and returns its name with the folder.
  std::filesystem::path save(const std::string& name, const std::string& bytes) const {
    std::ofstream(folder_ / name, std::ios::binary) << bytes;
    return folder_ / name;
  }
  /// The message of the InputError that work() throws, without the beginning, which is the name of a file or folder.
  template <class Work>
  [[nodiscard]] static std::string failure_after(const std::filesystem::path& beginning, const Work& work) {
    try {
      static_cast<void>(work());
    } catch (const InputError& error) {
      const std::string what = error.what();
      return what.substr(std::min(what.size(), beginning.string().size()));
    }
    return "no error";
  }

  const std::filesystem::path folder_ =
      std::filesystem::path(testing::TempDir()) /
      (std::string("occlude_") + testing::UnitTest::GetInstance()->current_test_info()->name() + "_" +
       std::to_string(getpid()));
};

}  // namespace occlude::render
