// SPDX-License-Identifier: MIT
// occlude classify: cases in, the kernel's and the oracle's answers out, one line each.
#include <fmt/core.h>

#include <filesystem>
#include <fstream>
#include <iostream>
#include <memory>
#include <optional>

#include "commands.h"
#include "json_input.h"
#include "occlude/kernel/convex_polytope.h"
#include "occlude/kernel/overlap.h"
#include "occlude/render/errors.h"
#include "oracle_types.h"

namespace occlude::cli {
namespace {

using Json = nlohmann::ordered_json;

struct Case {
  kernel::Viewpoint viewpoint;
  Occluder occluder;
  kernel::Near near = kernel::Near::farthest;
  Box box;
  std::optional<std::string> expect;
};

Json id_of(const nlohmann::json& object) {
  if (!object.contains("id")) return nullptr;
  if (!object["id"].is_string() && !object["id"].is_number()) throw LineError("\"id\": expected a string or a number");
  return object["id"];
}

kernel::Near near_of(const nlohmann::json& object) {
  if (!object.contains("near")) return kernel::Near::farthest;
  if (object["near"] == "farthest") return kernel::Near::farthest;
  if (object["near"] == "surface") return kernel::Near::surface;
  throw LineError("\"near\": expected \"farthest\" or \"surface\"");
}

Case parse_case(const nlohmann::json& object) {
  Case c;
  c.viewpoint = viewpoint(object);
  c.occluder = occluder(member(object, "occluder"));
  c.near = near_of(object);
  c.box = box(object);
  if (object.contains("expect")) {
    const auto& expect = object["expect"];
    if (expect != "inside" && expect != "partial" && expect != "outside") {
      throw LineError("\"expect\": expected \"inside\", \"partial\" or \"outside\"");
    }
    c.expect = expect.get<std::string>();
  }
  return c;
}

std::string text(kernel::Relation relation) { return std::string(kernel::to_string(relation)); }

std::string text(const oracle::Answer& answer) {
  if (!answer.refusal.empty()) return "refused: " + answer.refusal;
  return answer.relation == oracle::Relation::inside    ? "inside"
         : answer.relation == oracle::Relation::partial ? "partial"
                                                        : "outside";
}

kernel::ShadowFrustumResult frustum_of(const Case& c) {
  if (const Polygon* polygon = std::get_if<Polygon>(&c.occluder)) {
    return kernel::ShadowFrustum::make(c.viewpoint, *polygon, c.near);
  }
  const auto [polytope, fault] = kernel::ConvexPolytope::make(std::get<kernel::Polytope>(c.occluder));
  if (!polytope) return {std::nullopt, fault};
  return kernel::ShadowFrustum::make(c.viewpoint, *polytope, c.near);
}

oracle::Answer judge(const Case& c, const oracle::Near& near) {
  return oracle::relation(to_oracle(c.viewpoint), to_oracle(c.occluder), near, to_oracle(c.box));
}

/// The kernel refuses: so must the oracle, and nobody may expect an answer.
bool refuse(const Case& c, kernel::Refusal refusal, Json& answer) {
  const oracle::Answer exact = judge(c, to_oracle(c.near));
  answer["error"] = kernel::to_string(refusal);
  if (exact.refusal.empty()) answer["oracle"] = text(exact);
  return !exact.refusal.empty() && !c.expect;
}

/// What the kernel answers.
template <class KindOfBox>
void ask_kernel(const kernel::ShadowFrustum& frustum, const KindOfBox& box, Json& answer) {
  const kernel::Decision certified = kernel::overlap_certified(frustum, box);
  answer["certified"] = text(certified.relation);
  answer["stage"] = certified.stage == kernel::Stage::filter ? "filter" : "exact";
  answer["plain"] = text(kernel::overlap_plain(frustum, box));
  answer["conservative"] = text(kernel::conservative_certified(frustum, box).relation);
}

/// Fills `answer`; returns whether everything that ought to agree does.
bool classify(const Case& c, Json& answer) {
  const auto box_fault = std::visit([](const auto& box) { return kernel::check(box); }, c.box);
  if (box_fault != kernel::Refusal::none) return refuse(c, box_fault, answer);
  const auto [frustum, fault] = frustum_of(c);
  if (!frustum) return refuse(c, fault, answer);
  std::visit([&, &f = *frustum](const auto& box) { ask_kernel(f, box, answer); }, c.box);
  const std::string judged =
      text(judge(c, frustum->support_plane() ? to_oracle(*frustum->support_plane()) : to_oracle(c.near)));
  answer["oracle"] = judged;
  return answer["certified"] == judged && (!c.expect || *c.expect == judged);
}

int classify_stream(std::istream& in, const std::string& name) {
  bool agree = true;
  std::string line;
  for (std::size_t number = 1; std::getline(in, line); ++number) {
    if (line.find_first_not_of(" \t\r") == std::string::npos) continue;
    Json answer;
    try {
      const nlohmann::json object = parse_object(line);
      answer["id"] = id_of(object);
      agree = classify(parse_case(object), answer) && agree;
    } catch (const LineError& error) {
      std::cout.flush();
      throw render::InputError(fmt::format("{}:{}: {}", name, number, error.what()));
    }
    std::cout << answer.dump(-1, ' ', false, Json::error_handler_t::replace) << '\n';
  }
  if (in.bad()) throw render::InputError(name + ": cannot be read");
  if (!std::cout.flush()) throw render::InputError("standard output: cannot be written");
  return agree ? 0 : 1;
}

int classify_file(const std::string& file) {
  if (file == "-") return classify_stream(std::cin, "standard input");
  std::ifstream in(file);
  if (!in || std::filesystem::is_directory(file)) throw render::InputError(file + ": cannot be opened");
  return classify_stream(in, file);
}

}  // namespace

void add_classify(CLI::App& app, int& exit_code) {
  CLI::App* command =
      app.add_subcommand("classify", "Answer cases (JSON Lines) by every arithmetic and by the exact oracle");
  command->footer(
      "Touching counts as sharing a point, on the near plane as well; \"near\" is \"farthest\" where a case does not say.\n"
      "Exit code 0; 1 when an \"expect\" or the oracle differs from `certified`; 2 for a line that is not a case.\n"
      "A box is {\"min\",\"max\"} or {\"center\",\"half_edges\"}, an occluder {\"polygon\"} or {\"vertices\",\"faces\"}.\n"
      R"(Example: echo '{"id":"wall","eye":[0,0,0],"occluder":{"polygon":[[2,-1,-1],[2,1,-1],[2,1,1],[2,-1,1]]},"near":"surface","box":{"min":[4,0,0],"max":[5,2,1]}}' | occlude classify)");
  const auto file = std::make_shared<std::string>("-");
  command->add_option("FILE", *file, "case file, - for standard input")->capture_default_str();
  command->callback([file, &exit_code] { exit_code = classify_file(*file); });
}

}  // namespace occlude::cli
