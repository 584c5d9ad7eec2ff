// SPDX-License-Identifier: MIT
#include "hand_cases.h"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <stdexcept>

#include "cases/case_json.h"

namespace occlude {
namespace {

using Json = nlohmann::json;

template <class Value>
Value value_of(const Json& object, const char* name, const std::vector<std::pair<const char*, Value>>& values) {
  const Json& given = cases::member(object, name);
  for (const auto& [text, value] : values) {
    if (given == text) return value;
  }
  throw cases::LineError('"' + std::string(name) + "\": " + given.dump());
}

HandAnswer answer_of(const Json& object) {
  using enum kernel::Relation;
  using enum kernel::Stage;
  return {cases::member(object, "id").get<std::string>(),
          value_of<kernel::Relation>(object, "expect", {{"inside", inside}, {"partial", partial}, {"outside", outside}}),
          value_of<kernel::Stage>(object, "expect_stage", {{"filter", filter}, {"exact", exact}})};
}

struct Corpus {
  std::vector<HandCase> cases;
  std::vector<HandCover> covers;
  std::vector<HandRegion> regions;

  void add(const Json& object) {
    if (cases::is_cover(object)) {
      auto [viewpoint, polygons, box, expect] = cases::read_cover(object);
      covers.push_back({answer_of(object), viewpoint, std::move(polygons), box});
    } else if (cases::is_region(object)) {
      regions.push_back({answer_of(object), cases::read_region(object).question});
    } else {
      cases.push_back({answer_of(object), cases::read_case(object).question});
    }
  }
};

Corpus read_corpus() {
  std::vector<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::directory_iterator(OCCLUDE_HAND_CASES)) {
    if (entry.path().extension() == ".jsonl") files.push_back(entry.path());
  }
  std::ranges::sort(files);
  Corpus corpus;
  for (const std::filesystem::path& path : files) {
    std::ifstream file(path);
    std::size_t number = 1;
    for (std::string line; std::getline(file, line); ++number) {
      try {
        corpus.add(Json::parse(line));
      } catch (const std::exception& error) {
        throw std::runtime_error(path.string() + ":" + std::to_string(number) + ": " + error.what());
      }
    }
  }
  return corpus;
}

const Corpus& corpus() {
  static const Corpus read = read_corpus();
  return read;
}

}  // namespace

const std::vector<HandCase>& hand_cases() { return corpus().cases; }
const std::vector<HandCover>& hand_covers() { return corpus().covers; }
const std::vector<HandRegion>& hand_regions() { return corpus().regions; }

std::vector<HandCase> hand_cases(const std::string& beginning) {
  std::vector<HandCase> some;
  std::ranges::copy_if(hand_cases(), std::back_inserter(some),
                       [&](const HandCase& c) { return c.id.starts_with(beginning); });
  return some;
}

}  // namespace occlude
