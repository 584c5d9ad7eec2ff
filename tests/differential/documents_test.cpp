// SPDX-License-Identifier: MIT
// The documents name the fuzzer's families and its other rows as they are.
#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <iterator>
#include <regex>
#include <string>
#include <vector>

#include "differential/experiment.h"
#include "occlude/fuzz/cases.h"

namespace occlude::fuzz {
namespace documents_test {

using Names = std::vector<std::string>;

Names lines_of(const std::string& document) {
  std::ifstream file(std::string(OCCLUDE_DOCUMENTS) + "/" + document);
  EXPECT_TRUE(file) << document;
  Names lines;
  for (std::string line; std::getline(file, line);) lines.push_back(line);
  return lines;
}

/// The first column of the document's tables with this head, sorted.
Names names_in_tables(const std::string& document, const std::string& head) {
  const std::regex row("\\| `([a-z0-9_]+)` \\|.*");
  Names names;
  bool in_table = false;
  for (const std::string& line : lines_of(document)) {
    in_table = line.starts_with(head) || (in_table && line.starts_with("|"));
    std::smatch parts;
    if (in_table && std::regex_match(line, parts, row)) names.push_back(parts[1]);
  }
  std::ranges::sort(names);
  return names;
}

/// The names that begin the items of the document's list after this line, sorted.
Names names_in_list(const std::string& document, const std::string& head) {
  const std::regex item("- `([a-z0-9_]+)`: .*");
  Names names;
  bool in_list = false;
  for (const std::string& line : lines_of(document)) {
    in_list = line == head || (in_list && (line.empty() || line.starts_with("- ") || line.starts_with("  ")));
    std::smatch parts;
    if (in_list && std::regex_match(line, parts, item)) names.push_back(parts[1]);
  }
  std::ranges::sort(names);
  return names;
}

Names names_of_families() {
  Names names;
  for (const Family family : families()) names.emplace_back(name(family));
  std::ranges::sort(names);
  return names;
}

Names names_of_experiments() {
  Names names;
  for (const Experiment& experiment : experiments()) names.push_back(experiment.name);
  std::ranges::sort(names);
  return names;
}

/// What only `names` have, or have more often.
Names without(const Names& names, const Names& others) {
  Names rest;
  std::ranges::set_difference(names, others, std::back_inserter(rest));
  return rest;
}

void expect_exactly(const Names& described, const Names& known) {
  EXPECT_EQ(without(described, known), Names{}) << "described twice, or there are none";
  EXPECT_EQ(without(known, described), Names{}) << "not described";
}

TEST(Documents, DescribeEveryFamilyOnce) {
  expect_exactly(names_in_tables("docs/families.md", "| family | what |"), names_of_families());
}

TEST(Documents, DescribeEveryOtherRowOnce) {
  const Names described = names_in_list("docs/families.md", "The last rows of the table are not about one family:");
  expect_exactly(described, without(names_of_experiments(), names_of_families()));
}

/// A campaign may be older than a family.
TEST(Documents, MeasureNothingThatIsNot) {
  const Names measured = names_in_tables("docs/measured.md", "| family | plain: culls |");
  EXPECT_GT(measured.size(), 90U);
  EXPECT_EQ(without(measured, names_of_experiments()), Names{});
}

TEST(Documents, CountTheFamilies) {
  const std::regex count("(.*[^0-9])?([0-9]+) families of degenerate cases.*");
  for (const char* document : {"README.md", "CHANGELOG.md"}) {
    int found = 0;
    for (const std::string& line : lines_of(document)) {
      std::smatch parts;
      if (!std::regex_match(line, parts, count)) continue;
      EXPECT_EQ(parts[2], std::to_string(families().size())) << document;
      ++found;
    }
    EXPECT_EQ(found, 1) << document;
  }
}

}  // namespace documents_test
}  // namespace occlude::fuzz
