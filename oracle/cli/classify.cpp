// SPDX-License-Identifier: MIT
// occlude classify: reads cases and writes the answers of the kernel and of the oracle, one line each.
#include <fmt/core.h>
#include <unistd.h>

#include <memory>
#include <optional>
#include <variant>

#include "cases/ask.h"
#include "cases/case_line.h"
#include "cases/to_oracle.h"
#include "command_arguments.h"
#include "commands.h"
#include "occlude/kernel/cover.h"
#include "occlude/oracle/cover.h"
#include "occlude/oracle/region_shadow.h"
#include "occlude/render/console.h"
#include "occlude/render/input_limits.h"

namespace occlude::cli {
namespace {

using Json = nlohmann::ordered_json;
using cases::Case;
using cases::to_oracle;

std::string text(kernel::Relation relation) { return std::string(kernel::to_string(relation)); }

std::string text(kernel::Stage stage) { return stage == kernel::Stage::filter ? "filter" : "exact"; }

std::string text(const oracle::Answer& answer) {
  if (!answer.refusal.empty()) return "refused: " + answer.refusal;
  return answer.relation == oracle::Relation::inside    ? "inside"
         : answer.relation == oracle::Relation::partial ? "partial"
                                                        : "outside";
}

oracle::Answer judge(const Case& c, const kernel::ShadowFrustumResult& made) {
  return oracle::relation(to_oracle(c.viewpoint), to_oracle(c.occluder), to_oracle(c.near, made), to_oracle(c.box));
}

/// The answer when the kernel refuses. Returns whether the oracle refuses too and the line expects no answer.
bool refuse(const oracle::Answer& exact, const std::optional<std::string>& expect, kernel::Refusal refusal, Json& answer) {
  answer["error"] = kernel::to_string(refusal);
  if (exact.refusal.empty()) answer["oracle"] = text(exact);
  return !exact.refusal.empty() && !expect;
}

/// Fills `answer` with what the kernel says of the shadow and the box. Returns whether everything agrees that should.
template <class Shadow>
bool ask_all(const Shadow& shadow, const cases::Box& box, const oracle::Answer& truth,
             const std::optional<std::string>& expect, Json& answer) {
  const kernel::Decision certified = cases::overlap(shadow, box);
  answer["certified"] = text(certified.relation);
  answer["stage"] = text(certified.stage);
  answer["plain"] = text(cases::overlap_plain(shadow, box));
  const std::string conservative = text(cases::conservative(shadow, box).relation);
  answer["conservative"] = conservative;
  const std::string judged = text(truth);
  answer["oracle"] = judged;
  const bool is_sound = conservative == judged || (conservative == "partial" && judged == "outside");
  return answer["certified"] == judged && is_sound && (!expect || *expect == judged);
}

/// Fills `answer`. Returns whether everything agrees that should.
bool classify(const cases::CaseLine& line, Json& answer) {
  const Case& c = line.question;
  const auto refused = [&](kernel::Refusal refusal) { return refuse(judge(c, {}), line.expect, refusal, answer); };
  if (const kernel::Refusal fault = cases::check(c.box); fault != kernel::Refusal::none) return refused(fault);
  const kernel::ShadowFrustumResult made = cases::make_frustum(c);
  if (!made.frustum) return refused(made.refusal);
  return ask_all(*made.frustum, c.box, judge(c, made), line.expect, answer);
}

/// The same for the umbra or penumbra for a region of viewpoints.
bool classify(const cases::RegionLine& line, Json& answer) {
  const cases::RegionCase& c = line.question;
  const oracle::Answer truth =
      oracle::RegionShadow(to_oracle(c.region), to_oracle(c.occluder), to_oracle(c.kind)).relation(to_oracle(c.box));
  if (const kernel::Refusal fault = cases::check(c.box); fault != kernel::Refusal::none) {
    return refuse(truth, line.expect, fault, answer);
  }
  const auto [shadow, refusal] = cases::make_shadow(c);
  if (!shadow) return refuse(truth, line.expect, refusal, answer);
  return ask_all(*shadow, c.box, truth, line.expect, answer);
}

/// The same for a joined shadow. It has only certified arithmetic and only the exact test.
bool classify(const cases::CoverLine& line, Json& answer) {
  const oracle::Answer truth =
      oracle::relation_to_cover(to_oracle(line.viewpoint), to_oracle(line.polygons), to_oracle(line.box));
  const auto [cover, refused] = kernel::Cover::make(line.viewpoint, line.polygons);
  const kernel::Refusal refusal = refused != kernel::Refusal::none ? refused : cases::check(line.box);
  if (refusal != kernel::Refusal::none) return refuse(truth, line.expect, refusal, answer);
  const kernel::Decision certified =
      std::visit([&hides = *cover](const auto& box) { return kernel::overlap_certified(hides, box); }, line.box);
  answer["certified"] = text(certified.relation);
  answer["stage"] = text(certified.stage);
  const std::string judged = text(truth);
  answer["oracle"] = judged;
  return answer["certified"] == judged && (!line.expect || *line.expect == judged);
}

void classify_file(const std::string& file, int& exit_code) {
  const bool prints_to_terminal = isatty(STDOUT_FILENO) != 0;
  cases::for_each_case(file, prints_to_terminal, [&](std::size_t number, const nlohmann::json& object) {
    Json answer;
    answer["id"] = cases::case_id(object);
    const bool agree = cases::is_cover(object)    ? classify(cases::read_cover(object), answer)
                       : cases::is_region(object) ? classify(cases::read_region(object), answer)
                                                  : classify(cases::read_case(object), answer);
    if (!agree) exit_code = kCheckFailed;
    if (!agree && object.contains("expect")) {
      const std::string name = file == "-" ? "standard input" : file;
      render::say(fmt::format("{}:{}: expected {}\n", name, number, object["expect"].get<std::string>()));
    }
    render::tell(answer.dump(-1, ' ', false, Json::error_handler_t::replace) + '\n');
  });
}

}  // namespace

void add_classify(Command app, int& exit_code) {
  Command command = app.add_command("classify", "Answer cases (JSON Lines) by every arithmetic and by the exact oracle");
  command.footer(
      "Touching counts as sharing a point, on the near plane as well; \"near\" is \"farthest\" where a case does not say.\n"
      "Exit code 0; 1 when the oracle differs from `certified`, refutes `conservative` or is not what a case has in "
      "\"expect\";\n"
      "2 for a line that is not a case, or no case at all. Members that a case does not need are ignored.\n"
      "A box is {\"min\",\"max\"} or {\"center\",\"half_edges\"}, an occluder {\"polygon\"} or {\"vertices\",\"faces\"}; "
      "or\n"
      "{\"cover\":[polygon, ...]}, polygons that hide together: then the box is `inside` their joined shadow or `partial`,\n"
      "and there is neither `plain` nor `conservative`.\n"
      "For a region of viewpoints, \"eyes\" or \"directions\" is {\"center\",\"half_edges\"}, and \"shadow\" is \"umbra\", "
      "what "
      "all of\n"
      "them have in shadow, or \"penumbra\", what at least one has; it begins at the \"surface\".\n" +
      fmt::format(
          "A polytope has at most {} vertices, those of its faces counted, a cover {}, an occluder seen from a region {}.\n",
          cases::kMostCorners, render::kMostCoverVertices, cases::kMostRegionVertices) +
      limits_help() +
      "\n"
      R"(Example: echo '{"id":"wall","eye":[0,0,0],"occluder":{"polygon":[[2,-1,-1],[2,1,-1],[2,1,1],[2,-1,1]]},)"
      R"("near":"surface","box":{"min":[4,0,0],"max":[5,2,1]}}' | occlude classify)");
  const auto file = std::make_shared<std::string>("-");
  add_input(command, "FILE", *file, "case file, - for standard input").show_default();
  command.run([file, &exit_code] { classify_file(*file, exit_code); });
}

}  // namespace occlude::cli
