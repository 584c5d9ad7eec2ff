// SPDX-License-Identifier: MIT
// What may be seen from an eye, by the visible sets of `occlude bake`. Usage: print_visible_sets FILE X Y Z
#include <cstdlib>
#include <exception>
#include <fstream>
#include <iostream>
#include <iterator>
#include <string>

#include "visible_sets.h"

namespace {

double number(const std::string& text) {
  char* end = nullptr;
  const double value = std::strtod(text.c_str(), &end);
  if (text.empty() || *end != '\0') throw std::runtime_error(text + ": no number");
  return value;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 5) return std::cerr << "usage: print_visible_sets FILE X Y Z\n", 2;
  std::ifstream file(argv[1], std::ios::binary);
  const std::vector<char> bytes{std::istreambuf_iterator<char>(file), {}};
  try {
    const visible_sets::Reader sets(bytes.data(), bytes.size());
    sets.check();
    const visible_sets::Number cell = sets.cell_at(number(argv[2]), number(argv[3]), number(argv[4]));
    if (cell == visible_sets::kNone) return std::cout << "in no cell\n", 0;
    const auto print = [](const char* name, const std::vector<bool>& set) {
      std::cout << name;
      for (std::size_t i = 0; i < set.size(); ++i) {
        if (set[i]) std::cout << ' ' << i;
      }
      std::cout << '\n';
    };
    std::cout << "cell " << cell << '\n';
    print("items", sets.visible(cell));
    print("cells", sets.visible_cells(cell));
  } catch (const std::exception& error) {
    return std::cerr << argv[1] << ": " << error.what() << '\n', 2;
  }
}
