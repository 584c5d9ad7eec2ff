// SPDX-License-Identifier: MIT
#include "packed_reports.h"

#include <cstdint>
#include <nlohmann/json.hpp>
#include <utility>

#include "cases/case_line.h"
#include "occlude/render/packing.h"

namespace occlude::cli {
namespace {

void put(render::Packer& packer, const fuzz::Finding& finding) {
  packer.put(finding.kind).put(finding.what).put(finding.expect).put(finding.family).put(finding.seed);
  packer.put(finding.question ? cases::write_case("", *finding.question, "") : "");
}

fuzz::Finding get_finding(render::Unpacker& unpacker) {
  fuzz::Finding finding;
  finding.kind = unpacker.text();
  finding.what = unpacker.text();
  finding.expect = unpacker.text();
  finding.family = unpacker.text();
  finding.seed = unpacker.get<std::uint64_t>();
  const std::string question = unpacker.text();
  if (!question.empty()) finding.question = cases::read_case(nlohmann::json::parse(question)).question;
  return finding;
}

}  // namespace

std::string pack(const std::vector<fuzz::Report>& reports) {
  render::Packer packer;
  for (const fuzz::Report& report : reports) {
    packer.put(report.tally).put(report.core_seconds).put(std::uint64_t{report.findings.size()});
    for (const fuzz::Finding& finding : report.findings) put(packer, finding);
  }
  return packer.bytes();
}

std::vector<fuzz::Report> unpack(const std::string& bytes) {
  std::vector<fuzz::Report> reports;
  for (render::Unpacker unpacker(bytes); !unpacker.is_empty();) {
    fuzz::Report& report = reports.emplace_back();
    report.tally = unpacker.get<fuzz::Tally>();
    report.core_seconds = unpacker.get<double>();
    for (auto left = unpacker.get<std::uint64_t>(); left > 0; --left) report.findings.push_back(get_finding(unpacker));
  }
  return reports;
}

}  // namespace occlude::cli
