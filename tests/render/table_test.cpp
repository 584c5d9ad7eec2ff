// SPDX-License-Identifier: MIT
// One table for a terminal, a page and programs.
#include "occlude/render/table.h"

#include <gtest/gtest.h>

#include <optional>
#include <string>

namespace table_test {

using namespace occlude::render;

std::optional<Colour> red_if_far(const std::string& shown) {
  return shown == "far" ? std::optional(Colour::red) : std::nullopt;
}

Table some_table() {
  return {"Some",
          {{"name", "name"},
           {"drawn", "drawn"},
           {"culled", "culled_share", percent},
           {"", "exact"},
           {"size", "size"},
           {"where", "", grouped, red_if_far}},
          {{"a", 12345, 0.25, 0.125, {576, 360}, "near"},
           {"a <b>", nullptr, 1, if_known(std::optional<double>()), {2, 1}, linked("far", "#frame=\"6\"")}},
          {"A note & more."}};
}

TEST(Table, AsTextHasAlignedColumnsWithoutWhatIsForPrograms) {
  EXPECT_EQ(text_of(some_table()),
            "Some\n"
            "name    drawn   culled     size  where\n"
            "a      12,345   25.0 %  576x360   near\n"
            "a <b>       -  100.0 %      2x1    far\n"
            "A note & more.\n");
}

TEST(Table, LinesHaveNoBlanksAtTheirEnd) {
  const Table table{"", {{"name"}, {"mark"}}, {{"a", ""}, {"b", "worse"}}};
  EXPECT_EQ(text_of(table), "name   mark\na\nb     worse\n");
}

TEST(Table, AsHtmlIsEscaped) {
  EXPECT_EQ(section(some_table()),
            "<h2>Some</h2><div class=\"wide\"><table><thead><tr><th>name</th><th>drawn</th><th>culled</th><th>size</th>"
            "<th>where</th></tr></thead><tbody>\n"
            "<tr><td>a</td><td>12,345</td><td>25.0 %</td><td>576x360</td><td>near</td></tr>\n"
            "<tr><td>a &lt;b&gt;</td><td>&ndash;</td><td>100.0 %</td><td>2x1</td>"
            "<td><a href=\"#frame=&quot;6&quot;\">far</a></td></tr>\n"
            "</tbody></table></div><p class=\"soft\">A note &amp; more.</p>");
}

TEST(Table, AsJsonHasTheNumbersThemselves) {
  EXPECT_EQ(json_of(some_table()).dump(),
            R"([{"name":"a","drawn":12345,"culled_share":0.25,"exact":0.125,"size":[576,360]},)"
            R"({"name":"a <b>","drawn":null,"culled_share":1,"exact":null,"size":[2,1]}])");
  EXPECT_EQ(json_of(Table{}).dump(), "[]");
}

TEST(Formats, RoundedNumbersHaveNoSignOfZero) {
  EXPECT_EQ(rounded<2>(-0.001), "0.00");
  EXPECT_EQ(rounded<1>(2.25), "2.3");
  EXPECT_EQ(short_of(0.000125), "0.000125");
  EXPECT_EQ(grouped(1234567), "1,234,567");
}

}  // namespace table_test
