// SPDX-License-Identifier: MIT
#include "occlude/render/printable.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <string>

namespace occlude::render {
namespace printable_test {

TEST(Printable, TextStays) {
  for (const char* const text : {"", "city.ply", "a b\\c\"d<e>",
                                 "Stra\xc3\x9f"
                                 "e",
                                 "\xe2\x82\xac", "\xf0\x9f\x8f\x9b", "\xc2\xa0"}) {
    EXPECT_EQ(printable(text), text);
  }
}

TEST(Printable, ControlCharactersAndBrokenUtf8AreNamed) {
  EXPECT_EQ(printable("a\nb\x1b[2J\x7f"), "a\\x0ab\\x1b[2J\\x7f");
  EXPECT_EQ(printable(std::string("a\0b", 3)), "a\\x00b");
  EXPECT_EQ(printable("\xc2\x9b"), "\\xc2\\x9b");  // a control character in two bytes
  EXPECT_EQ(printable("odd\xff.ply"), "odd\\xff.ply");
  EXPECT_EQ(printable("\xc3"), "\\xc3");  // the end is missing
  EXPECT_EQ(printable("\xc3("), "\\xc3(");
  EXPECT_EQ(printable("\xc1\xbf"), "\\xc1\\xbf");  // an overlong form
  EXPECT_EQ(printable("\xe0\x80\xaf"), "\\xe0\\x80\\xaf");
  EXPECT_EQ(printable("\xed\xa0\x80"), "\\xed\\xa0\\x80");  // half of a surrogate pair
  EXPECT_EQ(printable("\xf4\x90\x80\x80"), "\\xf4\\x90\\x80\\x80");
  EXPECT_EQ(printable("\x80"), "\\x80");
  EXPECT_EQ(printable("\xf8\x88\x80\x80\x80"), "\\xf8\\x88\\x80\\x80\\x80");
}

TEST(Printable, AnyBytesAreJson) {
  for (int first = 0; first < 256; ++first) {
    for (int second = 0; second < 256; ++second) {
      const std::string text = printable(std::string{static_cast<char>(first), static_cast<char>(second), '\x80', 'x'});
      EXPECT_NO_THROW(static_cast<void>(nlohmann::json(text).dump())) << first << ' ' << second;
    }
  }
}

TEST(Printable, LongTextKeepsBothEnds) {
  const std::string text = printable("begin" + std::string(10'000'000, 'x') + "end");
  EXPECT_TRUE(text.starts_with("begin"));
  EXPECT_TRUE(text.ends_with("end"));
  EXPECT_NE(text.find("x ... x"), std::string::npos);
  EXPECT_LT(text.size(), 2100U);
}

}  // namespace printable_test
}  // namespace occlude::render
