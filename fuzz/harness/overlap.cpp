// SPDX-License-Identifier: MIT
// Asks the kernel's main question of everyone: one shadow, some boxes.
#include "differential/overlap.h"

#include <vector>

#include "cases/case_line.h"
#include "decode.h"
#include "finding.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace occlude;
  harness::Decoder decoder({data, size});
  const fuzz::Case question = decoder.question();
  std::vector<fuzz::Box> boxes;
  for (std::size_t i = 0, count = 1 + decoder.below(6); i < count; ++i) boxes.push_back(decoder.box());
  fuzz::Report report;
  fuzz::judge_overlap(question, boxes, 0, report);
  if (report.findings.empty()) return 0;
  const fuzz::Finding& first = report.findings[0];
  harness::finding(first.what + ": " + cases::write_case("overlap", *first.question, first.expect));
}
