// SPDX-License-Identifier: MIT
#include "occlude/render/line_reader.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "occlude/render/errors.h"
#include "occlude/render/input_limits.h"

namespace occlude::render {
namespace line_reader_test {

namespace fs = std::filesystem;

class LineReaderTest : public testing::Test {
 protected:
  ~LineReaderTest() override { fs::remove(file_); }

  [[nodiscard]] std::vector<std::string> lines(const std::string& text) const {
    std::ofstream(file_, std::ios::binary) << text;
    LineReader reader(file_.string());
    EXPECT_EQ(reader.size(), text.size());
    std::vector<std::string> result;
    for (std::string line; reader.next(line);) {
      result.push_back(line);
      EXPECT_EQ(reader.number(), result.size());
    }
    EXPECT_EQ(reader.read(), text.size());
    return result;
  }
  static std::string failure(const std::string& file) {
    try {
      LineReader reader(file);
      for (std::string line; reader.next(line);) {
      }
    } catch (const InputError& error) {
      return error.what();
    }
    return "no error";
  }

  fs::path file_ = fs::temp_directory_path() / ("occlude_lines_" + std::to_string(getpid()));
};

TEST_F(LineReaderTest, LinesWithAndWithoutTheLastBreak) {
  using Lines = std::vector<std::string>;
  EXPECT_EQ(lines(""), Lines{});
  EXPECT_EQ(lines("\n"), Lines{""});
  EXPECT_EQ(lines("a\n\nb"), (Lines{"a", "", "b"}));
  EXPECT_EQ(lines("a\r\n" + std::string("b\0c", 3) + "\n"), (Lines{"a\r", std::string("b\0c", 3)}));
}

TEST_F(LineReaderTest, LinesOfAnyLength) {
  std::vector<std::string> expected;
  std::string text;
  for (const std::size_t length : {65535, 65536, 65537, 0, 1, 200000, 131071}) {
    expected.emplace_back(length, static_cast<char>('a' + expected.size()));
    text += expected.back() + '\n';
  }
  EXPECT_EQ(lines(text), expected);
}

TEST_F(LineReaderTest, ALineWithoutEndIsRefused) {
  EXPECT_EQ(failure("/dev/zero"), "/dev/zero:1: the line is longer than 16 MiB");
  std::ofstream(file_) << "short\n" << std::string(kMostJson, 'x') << '\n' << std::string(kMostJson + 1, 'x') << '\n';
  EXPECT_EQ(failure(file_.string()), file_.string() + ":3: the line is longer than 16 MiB");
}

TEST_F(LineReaderTest, WhatCannotBeReadIsNamed) {
  EXPECT_EQ(failure("/none"), "/none: cannot be opened: No such file or directory");
  EXPECT_EQ(failure("/tmp"), "/tmp: cannot be opened: Is a directory");
}

}  // namespace line_reader_test
}  // namespace occlude::render
