// SPDX-License-Identifier: MIT
// Reads a line of a case file. It must be refused with a message, or read back as it is written.
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

#include "cases/case_line.h"
#include "finding.h"

namespace occlude::harness {
namespace {

void read(std::string_view line) {
  const nlohmann::json object = cases::parse_object(line);
  const cases::CaseLine taken = cases::read_case(object);
  const std::string id = cases::case_id(object).dump();
  const std::string text = cases::write_case(id, taken.question, taken.expect.value_or(""));
  try {
    const cases::CaseLine again = cases::read_case(cases::parse_object(text));
    if (cases::write_case(id, again.question, again.expect.value_or("")) != text) finding("reads back as another: " + text);
  } catch (const cases::LineError& error) {
    finding(std::string(error.what()) + ", in a case that was written: " + text);
  }
}

}  // namespace
}  // namespace occlude::harness

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace occlude;
  try {
    harness::read({reinterpret_cast<const char*>(data), size});
  } catch (const cases::LineError&) {
    // This is the only way to refuse a line.
  }
  return 0;
}
