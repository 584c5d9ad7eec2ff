// SPDX-License-Identifier: MIT
// Forges stores and judges what is made of them.
//
// Usage: forged_stores [FIRST COUNT [FOLDER]]
// Stores FIRST, ..., FIRST + COUNT - 1, of which each is the same everywhere; without arguments, 100 from 1 on. Prints how
// many of each kind were refused, and how many were taken and kept every promise. Those that did not stay in FOLDER, which
// is made, and the exit code is 1. A store that ends the process stays there too. Usage: forged_stores --write NUMBER FILE
// Writes one store, and prints its kind.
#include <unistd.h>

#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <map>
#include <span>
#include <string>
#include <string_view>

#include "forged_store.h"
#include "judged_store.h"
#include "occlude/render/stopwatch.h"

namespace {

namespace fs = std::filesystem;
using namespace occlude;

struct Row {
  std::size_t refused = 0, taken = 0, wrong = 0;
  double seconds = 0;  ///< the longest
};

void write(const fs::path& file, const harness::ForgedStore& forged) {
  std::ofstream(file, std::ios::binary)
      .write(reinterpret_cast<const char*>(forged.bytes.data()), static_cast<std::streamsize>(forged.bytes.size()));
}

bool judge(std::uint64_t number, const fs::path& folder, std::map<std::string, Row>& rows) {
  const render::Stopwatch stopwatch;
  const fs::path file = folder / (std::to_string(number) + ".store");
  fuzz::Random random(number);
  const harness::ForgedStore forged = harness::forged_store(random);
  write(file, forged);
  const harness::JudgedStore judged = harness::judged(file, forged.has_oriented_boxes, random);
  Row& row = rows[forged.what];
  row.seconds = std::max(row.seconds, stopwatch.seconds());
  ++(!judged.fault.empty() ? row.wrong : judged.is_refused ? row.refused : row.taken);
  if (judged.fault.empty()) {
    fs::remove(file);
  } else {
    std::printf("store %llu (%s): %s\n", static_cast<unsigned long long>(number), forged.what.c_str(), judged.fault.c_str());
  }
  return judged.fault.empty();
}

}  // namespace

int main(int count, char** arguments) {
  const std::span all(arguments, static_cast<std::size_t>(count));
  const auto number = [&](std::size_t i) { return std::strtoull(all[i], nullptr, 10); };
  if (count == 4 && std::string_view(all[1]) == "--write") {
    fuzz::Random random(number(2));
    const harness::ForgedStore forged = harness::forged_store(random);
    write(all[3], forged);
    std::puts(forged.what.c_str());
    return 0;
  }
  const std::uint64_t first = count > 2 ? number(1) : 1, stores = count > 2 ? number(2) : 100;
  const fs::path folder =
      count > 3 ? fs::path(all[3]) : fs::temp_directory_path() / ("occlude_forged_stores_" + std::to_string(getpid()));
  fs::create_directories(folder);
  std::printf("stores %llu to %llu\n", static_cast<unsigned long long>(first),
              static_cast<unsigned long long>(first + stores - 1));
  std::map<std::string, Row> rows;
  bool are_right = true;
  for (std::uint64_t i = first; i < first + stores; ++i) are_right &= judge(i, folder, rows);
  std::puts("| forged | refused | taken | wrong | longest, s |\n|---|---|---|---|---|");
  Row sum;
  const auto print = [](const char* name, const Row& row) {
    std::printf("| %s | %zu | %zu | %zu | %.2f |\n", name, row.refused, row.taken, row.wrong, row.seconds);
  };
  for (const auto& [what, row] : rows) {
    print(what.c_str(), row);
    sum = {sum.refused + row.refused, sum.taken + row.taken, sum.wrong + row.wrong, std::max(sum.seconds, row.seconds)};
  }
  print("all", sum);
  if (are_right) fs::remove(folder);
  return are_right ? 0 : 1;
}
