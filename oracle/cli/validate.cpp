// SPDX-License-Identifier: MIT
// occlude validate: every cull of a walk proved in exact arithmetic, and of small models held against exact visibility.
#include <fmt/core.h>

#include <algorithm>
#include <exception>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "command_arguments.h"
#include "commands.h"
#include "exact_check.h"
#include "occlude/culler/parallel.h"
#include "occlude/render/camera_path.h"
#include "occlude/render/errors.h"
#include "occlude/render/line_reader.h"
#include "occlude/render/model_io.h"
#include "occlude/render/preprocess_file.h"
#include "occlude/render/progress.h"
#include "occlude/render/witness.h"
#include "proof.h"

namespace occlude::cli {
namespace {

struct Arguments {
  std::string model, path, witness;
  WalkArguments walk;
  /// Half a minute for the 300 frames of a path through random triangles; lattices take longer.
  std::size_t exact_up_to = 2000;
  bool json = false;
};

/// A witness and where it stands.
struct Place {
  std::string line, name;
};

struct Outcome {
  std::size_t proved = 0, failed = 0;
  std::string first_failure;  ///< of the lowest line
};

/// What judges witnesses.
struct Judges {
  Prover prover;
  std::optional<ExactCheck> exact;  ///< of small models
};

/// Proves witnesses and adds them to the outcome, which is the same for any number of threads. Throws InputError for a line
/// that is no witness.
void prove_all(Judges& judges, const std::vector<Place>& places, Outcome& outcome) {
  struct Verdict {
    Proof proof;
    std::string unreadable;
  };
  std::vector<Verdict> verdicts(places.size());
  culler::parallel_for(places.size(), [&](std::size_t i) {
    try {
      verdicts[i].proof = judges.prover.prove(places[i].line);
    } catch (const std::exception& error) {
      verdicts[i].unreadable = error.what();
    }
  });
  for (std::size_t i = 0; i < places.size(); ++i) {
    const auto& [proof, unreadable] = verdicts[i];
    if (!unreadable.empty()) throw render::InputError(fmt::format("{}: {}", places[i].name, unreadable));
    if (judges.exact) judges.exact->add(proof);
    if (proof.failure.empty()) {
      ++outcome.proved;
    } else if (outcome.failed++ == 0) {
      outcome.first_failure = fmt::format("{}: {}", places[i].name, proof.failure);
    }
  }
}

/// As many lines as keep all threads busy and memory small.
constexpr std::size_t kBatch = 16384;

Outcome prove_file(Judges& judges, const std::string& file) {
  render::LineReader lines(file);
  render::Progress progress("proved MB", lines.size() >> 20U);
  Outcome outcome;
  std::vector<Place> places;
  const auto prove_batch = [&] {
    prove_all(judges, places, outcome);
    places.clear();
    progress.update(lines.read() >> 20U);
  };
  for (std::string line; lines.next(line);) {
    if (line.find_first_not_of(" \t\r") == std::string::npos) continue;
    places.push_back({line, fmt::format("{}:{}", lines.name(), lines.number())});
    if (places.size() == kBatch) prove_batch();
  }
  prove_batch();
  if (outcome.proved + outcome.failed == 0) throw render::InputError(lines.name() + ": no witnesses");
  return outcome;
}

/// Culls every frame anew and proves what was culled.
Outcome prove_walk(Judges& judges, const culler::Culler& culler, const render::CameraPath& path,
                   const render::WalkOptions& options) {
  const std::vector<std::size_t> frames = render::frames_of(path, options);
  render::Progress progress("proved frame", frames.size());
  Outcome outcome;
  std::vector<std::string> lines;
  std::vector<Place> places;
  culler::View view;
  for (std::size_t i = 0; i < frames.size(); ++i) {
    render::check_interrupt();
    const culler::Camera camera = path.camera(frames[i], render::aspect(options));
    lines.clear();
    render::append_witnesses(lines, frames[i], camera, culler, culler.cull(camera, options.cull, view), options.cull.near);
    for (std::string& line : lines) places.push_back({std::move(line), fmt::format("frame {}", frames[i])});
    if (places.size() >= kBatch || i + 1 == frames.size()) {
      prove_all(judges, places, outcome);
      places.clear();
    }
    progress.update(i + 1);
  }
  return outcome;
}

void print(const Outcome& outcome, const std::optional<ExactCheck::Result>& exact, bool json) {
  using Json = nlohmann::ordered_json;
  const std::size_t total = outcome.proved + outcome.failed;
  if (json) {
    const Json visibility = exact ? Json{{"frames", exact->frames}, {"culled_showing", exact->culled_showing}} : Json();
    fmt::print(
        "{}\n",
        Json{{"witnesses", total}, {"proved", outcome.proved}, {"failed", outcome.failed}, {"exact_visibility", visibility}}
            .dump(2));
    return;
  }
  fmt::print("{} of {} witnesses proved\n", outcome.proved, total);
  if (exact) {
    fmt::print("exact visibility: {} culled triangles show in {} frames\n", exact->culled_showing, exact->frames);
  }
}

int validate(Arguments& arguments) {
  const render::WalkOptions options = arguments.walk.options();
  const render::CameraPath path = render::read_camera_path(arguments.path);
  const culler::Culler culler = render::make_culler(render::read_model(arguments.model), options.build, options.preprocess);
  const culler::Hierarchy& hierarchy = culler.hierarchy();
  Judges judges{Prover(hierarchy, path, render::aspect(options)), std::nullopt};
  if (hierarchy.first_triangle(hierarchy.soup().size()) <= arguments.exact_up_to) {
    judges.exact.emplace(hierarchy, path, render::aspect(options));
  }
  const Outcome outcome =
      arguments.witness.empty() ? prove_walk(judges, culler, path, options) : prove_file(judges, arguments.witness);
  std::optional<ExactCheck::Result> exact;
  if (judges.exact) exact = judges.exact->result();
  print(outcome, exact, arguments.json);
  if (outcome.failed != 0) fmt::print(stderr, "{}\n", outcome.first_failure);
  if (exact && exact->culled_showing != 0) fmt::print(stderr, "{}\n", exact->first);
  return outcome.failed == 0 && (!exact || exact->culled_showing == 0) ? 0 : 1;
}

}  // namespace

void add_validate(CLI::App& app, int& exit_code) {
  CLI::App* command =
      app.add_subcommand("validate", "Prove every cull of a walk in exact arithmetic, and that nothing culled shows");
  command->footer(
      "Exit code 0; 1 when a witness is not proved or a culled triangle shows (it is printed); 2 for bad input.\n"
      "Example: occlude validate city.ply --path city.json --witness witness.jsonl");
  const auto a = std::make_shared<Arguments>();
  command->add_option("MODEL", a->model, "the model walked through")->required();
  command->add_option("--path", a->path, "camera path (JSON)")->required();
  CLI::Option* witness = command->add_option(
      "--witness", a->witness, "prove this file of `occlude walk --witness`; without it, cull anew and prove that");
  command
      ->add_option("--exact-up-to", a->exact_up_to,
                   "triangles of the largest model whose culled triangles are held against exact visibility; 0: none")
      ->capture_default_str()
      ->check(CLI::Range(std::size_t{0}, std::size_t{1000000}));
  a->walk.add_size_to(*command);
  for (CLI::Option* option : a->walk.add_culling_to(*command)) option->excludes(witness);
  a->walk.add_preprocess_to(*command)->excludes(witness);
  command->add_flag("--json", a->json, "print the counts as JSON");
  command->callback([a, &exit_code] { exit_code = validate(*a); });
}

}  // namespace occlude::cli
