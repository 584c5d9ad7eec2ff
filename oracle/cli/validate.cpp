// SPDX-License-Identifier: MIT
// occlude validate: proves every cull of a walk in exact arithmetic and checks the culled sets against visibility.
#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <memory>
#include <numeric>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "command_arguments.h"
#include "commands.h"
#include "failures.h"
#include "item_buffers.h"
#include "occlude/culler/missed.h"
#include "occlude/culler/parallel.h"
#include "occlude/render/camera_path.h"
#include "occlude/render/console.h"
#include "occlude/render/errors.h"
#include "occlude/render/input_limits.h"
#include "occlude/render/model_io.h"
#include "occlude/render/printable.h"
#include "occlude/render/progress.h"
#include "occlude/render/view_along_path.h"
#include "occlude/render/walk.h"
#include "occlude/render/witness.h"
#include "proof.h"
#include "validation.h"
#include "visibility_check.h"
#include "witness_file.h"

namespace occlude::cli {
namespace {

struct Arguments {
  std::string model, path, witness, shard = "1/1", out;
  WalkArguments walk;
  /// Exact visibility then takes half a minute for the 300 frames of a path through random triangles. Lattices take longer.
  std::size_t exact_up_to = 2000;
  bool json = false;
};

/// The frames whose index in the walk is `index` more than a multiple of `count`. Each of several machines takes one shard.
struct Shard {
  std::size_t index, count;
  Turns turns;

  /// A frame that the walk does not have belongs to the first shard.
  [[nodiscard]] bool has(std::optional<std::size_t> frame) const {
    return (frame ? turns.place(*frame) : 0) % count == index;
  }
};

Shard parse_shard(const std::string& text, const Turns& turns) {
  const std::size_t slash = text.find('/');
  if (slash == std::string::npos) refuse("--shard", "expected I/N");
  const std::size_t i = whole_number("--shard", text.substr(0, slash)), n = whole_number("--shard", text.substr(slash + 1));
  if (i == 0 || i > n) refuse("--shard", "expected I/N with I from 1 to N");
  return {i - 1, n, turns};
}

/// Proves witnesses and collects what they cull. The outcome does not depend on the number of threads.
class Proving {
 public:
  /// The first failure is reported at once and sets the exit code to 1.
  Proving(const proof::Prover& prover, const Shard& shard, int& exit_code)
      : prover_(prover), shard_(shard), exit_code_(exit_code) {}

  /// Throws InputError for a line that is not a witness.
  void prove(const std::vector<Place>& places) {
    struct Verdict {
      std::optional<proof::Proof> proof;  ///< empty for other shards
      std::string unreadable;
    };
    std::vector<Verdict> verdicts(places.size());
    const auto prove_one = [&](std::size_t i) {
      try {
        verdicts[i].proof = prover_.prove(places[i].line, [&](auto frame) { return shard_.has(frame); });
      } catch (const cases::LineError& error) {
        verdicts[i].unreadable = error.what();
      }
    };
    culler::parallel_for(places.size(), prove_one, render::check_interrupt);
    for (std::size_t i = 0; i < places.size(); ++i) {
      const auto& [proof, unreadable] = verdicts[i];
      if (!unreadable.empty()) throw render::InputError(fmt::format("{}: {}", places[i].name, unreadable));
      if (proof) add(*proof, places[i]);
    }
  }

  /// Makes the frame count even if nothing is culled in it.
  void visit(std::size_t frame) { culled_.try_emplace(frame); }

  [[nodiscard]] const CulledSets& culled() const { return culled_; }
  std::size_t proved = 0, failed = 0;

 private:
  void add(const proof::Proof& proof, const Place& place) {
    if (proof.count != 0) culled_[proof.frame].push_back({proof.first, proof.count, place.number});
    if (proof.failure.empty()) {
      ++proved;
    } else if (failed++ == 0) {
      exit_code_ = kCheckFailed;
      render::say(render::printable(fmt::format("{}: {}", place.name, proof.failure)) + "\n");
    }
  }

  const proof::Prover& prover_;
  const Shard& shard_;
  int& exit_code_;
  CulledSets culled_;
};

/// A batch has enough lines to keep all threads busy, and few enough to keep memory small. It also ends when it has as many
/// bytes as the longest legal line, because parsed JSON takes many times that.
constexpr std::size_t kBatch = 16384;
constexpr std::size_t kBatchBytes = render::kMostJson;

void prove_file(Proving& proving, WitnessFile& file) {
  render::Progress progress("proved MB", file.size() >> 20U);
  std::vector<Place> places;
  std::size_t bytes = 0;
  const auto prove_batch = [&] {
    proving.prove(places);
    places.clear();
    bytes = 0;
    progress.update(file.read() >> 20U);
  };
  while (std::optional<Place> place = file.next()) {
    bytes += place->line.size();
    places.push_back(std::move(*place));
    if (places.size() == kBatch || bytes >= kBatchBytes) prove_batch();
  }
  prove_batch();
}

/// The model, the path, and the options for culling its frames anew.
struct Walked {
  const culler::Culler& culler;
  const render::CameraPath& path;
  const render::WalkOptions& options;
};

/// Culls the frames of the walk in order, because each frame depends on the frames before it.
template <class OnFrame>
void cull_frames(const Walked& walked, const char* label, OnFrame&& on_frame) {
  const std::vector<std::size_t> frames = render::frames_of(walked.path, walked.options);
  render::Progress progress(label, frames.size());
  render::ViewAlongPath along(walked.culler, walked.path, walked.options, walked.options.cull);
  for (std::size_t i = 0; i < frames.size(); ++i) {
    render::check_interrupt();
    const culler::Camera camera = walked.path.camera(frames[i], render::aspect(walked.options));
    on_frame(frames[i], camera, walked.culler.cull(camera, walked.options.cull, along.before(frames[i])));
    progress.update(i + 1);
  }
}

void append_witnesses(std::vector<std::string>& lines, const Walked& walked, std::size_t frame, const culler::Camera& camera,
                      const culler::CullResult& culled) {
  const auto covers = render::covers_of(walked.culler, camera, culled, walked.options.cull);
  render::append_witnesses(lines, frame, camera, walked.culler, culled, walked.options.cull, covers);
}

void prove_anew(Proving& proving, const Walked& walked, const Shard& shard) {
  std::vector<std::string> lines;
  std::vector<Place> places;
  cull_frames(walked, "proved frame",
              [&](std::size_t frame, const culler::Camera& camera, const culler::CullResult& culled) {
                if (!shard.has(frame)) return;
                proving.visit(frame);
                lines.clear();
                append_witnesses(lines, walked, frame, camera, culled);
                for (std::size_t i = 0; i < lines.size(); ++i) {
                  places.push_back({std::move(lines[i]), fmt::format("frame {}", frame), i + 1});
                }
                if (places.size() < kBatch) return;
                proving.prove(places);
                places.clear();
              });
  proving.prove(places);
}

/// Counts on the reference frames of `visibility`.
render::MissedCounts count_missed(const Walked& walked, const Visibility& visibility) {
  std::map<std::size_t, const std::vector<bool>*> shows;
  for (const FrameVisibility& frame : visibility.frames) {
    if (!frame.shows.empty()) shows[frame.frame] = &frame.shows;
  }
  render::MissedCounts missed{.method = walked.options.cull.method, .counts = {}};
  cull_frames(walked, "reasons, frame",
              [&](std::size_t frame, const culler::Camera& camera, const culler::CullResult& culled) {
                const auto found = shows.find(frame);
                if (found == shows.end()) return;
                ++missed.frames;
                const culler::MissedReasons reasons(walked.culler, camera, walked.options.cull, culled);
                missed.counts += culler::MissedReasons::count(reasons.answers(*found->second, render::check_interrupt));
              });
  return missed;
}

/// The witnesses of every frame that has a false cull.
WitnessText witnesses_anew(const Walked& walked, const Visibility& visibility) {
  std::map<std::size_t, std::vector<std::string>> lines;
  for (const FalseCull& failure : visibility.false_culls) lines[failure.frame];
  if (!lines.empty()) {
    cull_frames(walked, "witnesses, frame",
                [&](std::size_t frame, const culler::Camera& camera, const culler::CullResult& culled) {
                  const auto found = lines.find(frame);
                  if (found == lines.end()) return;
                  append_witnesses(found->second, walked, frame, camera, culled);
                });
  }
  return [lines = std::move(lines)](std::size_t frame, std::size_t number) { return lines.at(frame).at(number - 1); };
}

/// The place of a witness in the file.
WitnessText witnesses_of(const std::string& file) {
  return [name = render::printable(file)](std::size_t, std::size_t number) { return fmt::format("{}:{}", name, number); };
}

/// Every frame of the path. Which of them a witness file is about is unknown before it is read.
std::vector<std::size_t> all_frames(const render::CameraPath& path) {
  std::vector<std::size_t> frames(path.frames);
  std::iota(frames.begin(), frames.end(), std::size_t{0});
  return frames;
}

/// The files about false culls. They are opened before the work, so that a folder that cannot be written to is reported at
/// once.
std::optional<FailureFiles> failure_files(const std::string& folder) {
  return folder.empty() ? std::nullopt : std::optional<FailureFiles>(std::in_place, folder);
}

void validate(Arguments& arguments, int& exit_code) {
  render::WalkOptions options = arguments.walk.options();
  const render::CameraPath path = render::read_camera_path(arguments.path);
  const bool is_anew = arguments.witness.empty();
  std::optional<WitnessFile> witnesses;
  if (!is_anew) options.build.hierarchy.leaf_size = witnesses.emplace(arguments.witness).leaf_size();
  const Turns turns(is_anew ? render::frames_of(path, options) : all_frames(path));
  const Shard shard = parse_shard(arguments.shard, turns);
  std::optional<FailureFiles> files = failure_files(arguments.out);
  const culler::Culler culler = render::make_culler(render::read_model(arguments.model), options);
  const culler::Hierarchy& hierarchy = culler.hierarchy();
  warn_of_misfit(path, arguments.path, arguments.model, hierarchy.soup());
  const Walked walked{culler, path, options};
  const CheckedWalk checked{culler, path, render::aspect(options), turns};

  const proof::Prover prover(hierarchy,
                             {path.frames, [&](std::size_t frame) { return path.camera(frame, checked.aspect); }});
  Proving proving(prover, shard, exit_code);
  if (is_anew) {
    prove_anew(proving, walked, shard);
  } else {
    prove_file(proving, *witnesses);
  }

  Validation result;
  result.proved = proving.proved;
  result.failed = proving.failed;
  result.is_exact = hierarchy.first_triangle(hierarchy.soup().size()) <= arguments.exact_up_to;
  std::optional<ItemBuffers> made;
  const auto buffers = [&]() -> ItemBuffers& {
    return made ? *made : made.emplace(hierarchy.soup(), options.width, options.height);
  };
  if (!result.is_exact) result.sizes = buffers().sizes();
  result.visibility =
      result.is_exact ? check_exactly(checked, proving.culled()) : check_rendered(checked, proving.culled(), buffers());
  if (is_anew) result.missed = count_missed(walked, result.visibility);

  if (!passed(result)) exit_code = kCheckFailed;
  arguments.json ? render::print(to_json(result)) : render::tell(to_text(result));
  const WitnessText witness = is_anew ? witnesses_anew(walked, result.visibility) : witnesses_of(arguments.witness);
  if (!result.visibility.false_culls.empty()) {
    render::say(describe(result.visibility.false_culls.front(), hierarchy, witness) + "\n");
  }
  if (files) files->write(result.visibility, checked, witness, buffers);
}

}  // namespace

void add_validate(Command app, int& exit_code) {
  Command command =
      app.add_command("validate", "Prove every cull of a walk in exact arithmetic, and that nothing culled shows");
  command.footer(
      "Exit code 0; 1 when a witness is not proved or a culled triangle shows (it is printed); 2 for bad input.\n" +
      limits_help() +
      "\n"
      "Example: occlude validate city.ply --path city.json --witness witness.jsonl");
  const auto a = std::make_shared<Arguments>();
  add_input(command, "MODEL", a->model, "the model walked through").required();
  add_input(command, "--path", a->path, "camera path (JSON)").required();
  Option witness = add_input(command, "--witness", a->witness,
                             "prove this file of `occlude walk --witness`; without it, cull anew and prove that");
  command
      .add("--exact-up-to", a->exact_up_to,
           "triangles of the largest model whose culled triangles are held against exact visibility; 0: none")
      .show_default()
      .in_range(std::size_t{0}, std::size_t{1000000});
  command
      .add("--shard", a->shard,
           "I/N: of N runs, on one machine or several, the one that takes frames I - 1, I - 1 + N, ...; their counts add up")
      .show_default();
  add_output(command, "--out", a->out, "folder for what is culled and shows: frame, polygon, witness and picture");
  a->walk.add_size_to(command);
  for (Option option : a->walk.add_culling_to(command)) option.excludes(witness);
  a->walk.add_preprocess_to(command).excludes(witness);
  command.add_flag("--json", a->json, "print the counts as JSON");
  command.run([a, &exit_code] { validate(*a, exit_code); });
}

}  // namespace occlude::cli
