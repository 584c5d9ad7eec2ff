// SPDX-License-Identifier: MIT
#include "occlude/render/line_reader.h"

#include <gtest/gtest.h>
#include <unistd.h>
#include <zlib.h>

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

/// As gzip writes it.
std::string zipped(const std::string& text) {
  z_stream stream{};
  constexpr int kGzip = 16 + MAX_WBITS, kMemory = 8;
  EXPECT_EQ(deflateInit2(&stream, Z_BEST_COMPRESSION, Z_DEFLATED, kGzip, kMemory, Z_DEFAULT_STRATEGY), Z_OK);
  std::string plain = text, result(text.size() + 1000, '\0');
  stream.next_in = reinterpret_cast<Bytef*>(plain.data());
  stream.avail_in = static_cast<uInt>(plain.size());
  stream.next_out = reinterpret_cast<Bytef*>(result.data());
  stream.avail_out = static_cast<uInt>(result.size());
  EXPECT_EQ(deflate(&stream, Z_FINISH), Z_STREAM_END);
  result.resize(stream.total_out);
  deflateEnd(&stream);
  return result;
}

TEST_F(LineReaderTest, CompressedLines) {
  using Lines = std::vector<std::string>;
  EXPECT_EQ(lines(zipped("a\n\nb")), (Lines{"a", "", "b"}));
  EXPECT_EQ(lines(zipped("a\nb") + zipped("c\nd\n")), (Lines{"a", "bc", "d"}));
  EXPECT_EQ(lines(zipped("")), Lines{});
  EXPECT_EQ(lines(zipped("a\nb") + std::string(100000, '\0')), (Lines{"a", "b"})) << "padded";
  const std::string large(std::size_t{1} << 20U, 'x');  // several blocks of a few bytes
  EXPECT_EQ(lines(zipped(large + "\n" + large)), (Lines{large, large}));
}

TEST_F(LineReaderTest, CompressedLinesThatAreDamaged) {
  const std::string whole = zipped("a line\nanother\n");
  const auto failure_of = [&](const std::string& bytes) {
    std::ofstream(file_, std::ios::binary) << bytes;
    return failure(file_.string());
  };
  EXPECT_EQ(failure_of(whole), "no error");
  for (std::size_t size = 2; size < whole.size(); ++size) {
    EXPECT_EQ(failure_of(whole.substr(0, size)), file_.string() + ": the compressed data are cut off") << size;
  }
  std::string wrong = whole;
  wrong[whole.size() - 6] ^= 1;  // of the checksum
  EXPECT_EQ(failure_of(wrong), file_.string() + ": the compressed data are damaged");
  EXPECT_EQ(failure_of(whole + "more"), file_.string() + ": the compressed data are damaged");
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
