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
#include "occlude/kernel/overlap.h"
#include "occlude/render/errors.h"
#include "oracle_types.h"

namespace occlude::cli {
namespace {

using Json = nlohmann::ordered_json;

struct Case {
  kernel::Viewpoint viewpoint;
  std::vector<kernel::Vec3> polygon;
  kernel::Near near = kernel::Near::farthest;
  kernel::Aabb box;
  std::optional<std::string> expect;
};

/// A case of a kind that this version does not answer.
struct Unsupported : std::runtime_error {
  Unsupported(const char* what, bool is_expected) : std::runtime_error(what), expected(is_expected) {}
  bool expected;  ///< whether the line says what the answer should be
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
  const nlohmann::json& occluder = member(object, "occluder");
  if (!occluder.is_object()) throw LineError("\"occluder\": expected an object");
  if (occluder.contains("vertices"))
    throw Unsupported("polytope occluders are not supported yet", object.contains("expect"));
  c.polygon = vec3s(member(occluder, "polygon"), "polygon");
  c.near = near_of(object);
  if (member(object, "box").contains("center"))
    throw Unsupported("oriented boxes are not supported yet", object.contains("expect"));
  c.box = std::get<kernel::Aabb>(box(object));
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

/// The kernel refuses: so must the oracle, and nobody may expect an answer.
bool refuse(const Case& c, kernel::Refusal refusal, Json& answer) {
  const oracle::Answer exact =
      oracle::relation(to_oracle(c.viewpoint), to_oracle(c.polygon), to_oracle(c.near), to_oracle(c.box));
  answer["error"] = kernel::to_string(refusal);
  if (exact.refusal.empty()) answer["oracle"] = text(exact);
  return !exact.refusal.empty() && !c.expect;
}

/// Fills `answer`; returns whether everything that ought to agree does.
bool classify(const Case& c, Json& answer) {
  if (const kernel::Refusal fault = kernel::check(c.box); fault != kernel::Refusal::none) return refuse(c, fault, answer);
  const auto [frustum, fault] = kernel::ShadowFrustum::make(c.viewpoint, c.polygon, c.near);
  if (!frustum) return refuse(c, fault, answer);
  const kernel::Decision certified = kernel::overlap_certified(*frustum, c.box);
  const oracle::Near near = frustum->support_plane() ? to_oracle(*frustum->support_plane()) : to_oracle(c.near);
  const std::string judged = text(oracle::relation(to_oracle(c.viewpoint), to_oracle(c.polygon), near, to_oracle(c.box)));
  answer["certified"] = text(certified.relation);
  answer["stage"] = certified.stage == kernel::Stage::filter ? "filter" : "exact";
  answer["plain"] = text(kernel::overlap_plain(*frustum, c.box));
  answer["conservative"] = text(kernel::conservative_certified(*frustum, c.box).relation);
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
    } catch (const Unsupported& error) {
      answer["error"] = error.what();
      agree = agree && !error.expected;
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
      R"(Example: echo '{"id":"wall","eye":[0,0,0],"occluder":{"polygon":[[2,-1,-1],[2,1,-1],[2,1,1],[2,-1,1]]},"near":"surface","box":{"min":[4,0,0],"max":[5,2,1]}}' | occlude classify)");
  const auto file = std::make_shared<std::string>("-");
  command->add_option("FILE", *file, "case file, - for standard input")->capture_default_str();
  command->callback([file, &exit_code] { exit_code = classify_file(*file); });
}

}  // namespace occlude::cli
