// SPDX-License-Identifier: MIT
#include "command_arguments.h"

#include <charconv>
#include <map>
#include <vector>

namespace occlude::cli {
namespace {

/// The numbers of "A:B:STEP" or "WxH"; throws CLI::ValidationError for anything else.
std::vector<std::size_t> numbers(const std::string& option, const std::string& text, char separator) {
  std::vector<std::size_t> values;
  const char* at = text.data();
  const char* const end = at + text.size();
  for (;;) {
    std::size_t value = 0;
    const auto [next, error] = std::from_chars(at, end, value);
    if (error != std::errc()) throw CLI::ValidationError(option, "cannot read '" + text + "'");
    values.push_back(value);
    if (next == end) return values;
    if (*next != separator) throw CLI::ValidationError(option, "cannot read '" + text + "'");
    at = next + 1;
  }
}

void parse_frames(const std::string& text, render::WalkOptions& options) {
  const auto values = numbers("--frames", text, ':');
  if (values.size() < 2 || values.size() > 3) throw CLI::ValidationError("--frames", "expected A:B or A:B:STEP");
  options.begin = values[0];
  options.end = values[1];
  options.step = values.size() == 3 ? values[2] : 1;
  if (options.step == 0) throw CLI::ValidationError("--frames", "STEP must be at least 1");
}

void parse_size(const std::string& text, render::WalkOptions& options) {
  constexpr std::size_t kLargest = 8192;  // side of a picture; llvmpipe's limit is 16384, memory's is lower
  const auto values = numbers("--size", text, 'x');
  if (values.size() != 2 || values[0] == 0 || values[1] == 0 || values[0] > kLargest || values[1] > kLargest) {
    throw CLI::ValidationError("--size", "expected WxH, each from 1 to 8192");
  }
  options.width = static_cast<int>(values[0]);
  options.height = static_cast<int>(values[1]);
}

}  // namespace

void WalkArguments::add_to(CLI::App& command) {
  command.add_option("--frames", frames_, "A:B:STEP, frames A, A+STEP, ... below B (default: all)");
  command.add_option("--size", size_, "WxH, size of the pictures in pixels")->default_val("640x360");
  constexpr std::size_t kMostOccluders = 4096;  // each costs a test at every node that it does not decide
  command.add_option("--occluders", cull_.occluders, "occluders a frame; 0: view-frustum culling alone")
      ->capture_default_str()
      ->check(CLI::Range(std::size_t{0}, kMostOccluders));
  const std::map<std::string, kernel::Near> nears{{"surface", kernel::Near::surface}, {"farthest", kernel::Near::farthest}};
  command.add_option("--near", cull_.near, "where a shadow begins: surface, farthest (the paper's)")
      ->transform(CLI::CheckedTransformer(nears))
      ->default_str("surface");
  const std::map<std::string, kernel::Arithmetic> arithmetics{{"certified", kernel::Arithmetic::certified},
                                                              {"plain", kernel::Arithmetic::plain}};
  command.add_option("--arithmetic", cull_.arithmetic, "certified, or plain (the paper's, to be measured)")
      ->transform(CLI::CheckedTransformer(arithmetics))
      ->default_str("certified");
  const std::map<std::string, kernel::Test> tests{{"conservative", kernel::Test::conservative},
                                                  {"overlap", kernel::Test::overlap}};
  command.add_option("--test", cull_.test, "conservative (planes alone) or overlap (all three relations exact)")
      ->transform(CLI::CheckedTransformer(tests))
      ->default_str("conservative");
}

render::WalkOptions WalkArguments::options() const {
  render::WalkOptions options;
  if (!frames_.empty()) parse_frames(frames_, options);
  parse_size(size_, options);
  options.cull = cull_;
  return options;
}

}  // namespace occlude::cli
