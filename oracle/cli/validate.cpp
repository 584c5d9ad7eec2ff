// SPDX-License-Identifier: MIT
// occlude validate: proves every cull of a walk in exact arithmetic and checks the culled sets against visibility.
#include <fmt/format.h>

#include <cstdint>
#include <deque>
#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <numeric>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "base/parallel.h"
#include "command_arguments.h"
#include "commands.h"
#include "culling.h"
#include "failures.h"
#include "hidden_validation.h"
#include "item_buffers.h"
#include "occlude/culler/culler.h"
#include "occlude/render/camera_path.h"
#include "occlude/render/console.h"
#include "occlude/render/digest.h"
#include "occlude/render/errors.h"
#include "occlude/render/job.h"
#include "occlude/render/packing.h"
#include "occlude/render/printable.h"
#include "occlude/render/progress.h"
#include "occlude/render/ranks.h"
#include "occlude/render/store.h"
#include "occlude/render/walk.h"
#include "packed_visibility.h"
#include "path_arguments.h"
#include "proof.h"
#include "validation.h"
#include "visibility_check.h"
#include "witness_file.h"

namespace occlude::cli {
namespace {

struct ValidateArguments {
  std::string model, witness, out;
  PathArguments path;
  WalkArguments walk;
  /// Exact visibility then takes half a minute for the 300 frames of a path through random triangles. Lattices take longer.
  std::size_t exact_up_to = 2000;
  bool matrix = false, scene = false, json = false;
  PartsArguments parts;
  std::string given;    ///< the options on which results depend
  std::string of_walk;  ///< those that are about walks
};

/// Where witnesses come from.
class Witnesses {
 public:
  virtual ~Witnesses() = default;
  [[nodiscard]] virtual std::optional<Place> next() = 0;
  virtual void show_progress() = 0;
};

class WitnessesOfFile final : public Witnesses {
 public:
  explicit WitnessesOfFile(WitnessFile& file) : file_(file), progress_("proved MB", file.size() >> 20U) {}

  std::optional<Place> next() override { return file_.next(); }
  void show_progress() override { progress_.update(file_.read() >> 20U); }

 private:
  WitnessFile& file_;
  render::Progress progress_;
};

/// Those of all frames of the walk, culled anew.
class WitnessesAnew final : public Witnesses {
 public:
  /// Makes every frame count, even if nothing is culled in it.
  WitnessesAnew(const Walked& walked, CulledSets& culled)
      : culling_(walked),
        culled_(culled),
        frames_(render::frames_of(walked.path, walked.options)),
        progress_("proved frame", frames_.size()) {}

  std::optional<Place> next() override {
    while (line_ == lines_.size()) {
      if (begun_ == frames_.size()) return std::nullopt;
      lines_.clear();
      line_ = 0;
      culled_.try_emplace(frames_[begun_]);
      culling_.append_witnesses(lines_, frames_[begun_++]);
    }
    const std::size_t number = ++line_;
    const std::size_t frame = frames_[begun_ - 1];
    return Place{std::move(lines_[number - 1]), fmt::format("frame {}", frame), number, frame};
  }
  void show_progress() override { progress_.update(begun_); }

 private:
  Culling culling_;
  CulledSets& culled_;
  std::vector<std::size_t> frames_;
  render::Progress progress_;
  std::vector<std::string> lines_;  ///< of the frame before the next one
  std::size_t begun_ = 0, line_ = 0;
};

/// Proves the witnesses of a part. The result has an entry for each line, up to the first that is not a witness.
std::string prove(const proof::Prover& prover, const std::vector<std::string>& lines) {
  struct Verdict {
    proof::Proof proof;
    std::string unreadable;
  };
  std::vector<Verdict> verdicts(lines.size());
  const auto prove_one = [&](std::size_t i) {
    try {
      verdicts[i].proof = prover.prove(lines[i]);
    } catch (const cases::LineError& error) {
      verdicts[i].unreadable = error.what();
    }
  };
  culler::parallel_for(lines.size(), prove_one, render::check_interrupt);
  render::Packer packer;
  for (const auto& [proof, unreadable] : verdicts) {
    packer.put(!unreadable.empty()).put(unreadable.empty() ? proof.failure : unreadable);
    if (!unreadable.empty()) break;
    packer.put(proof.frame).put(proof.first).put(proof.count);
  }
  return packer.bytes();
}

/// Frames of the path, and triangles of the model.
struct Extent {
  std::size_t frames, triangles;
};

/// The proofs of all witnesses, and what they cull.
class Proving {
 public:
  /// The first failure is reported at once and sets the exit code to 1.
  Proving(Extent extent, int& exit_code) : extent_(extent), exit_code_(exit_code) {}

  /// Throws InputError for a line that is not a witness. The outcome does not depend on who does the parts.
  void run(render::Job& job, const proof::Prover& prover, Witnesses& witnesses) {
    job.run({[&] { return next(witnesses); }, [&](const std::string& part) { return prove(prover, unpack_lines(part)); },
             [&](const std::string& result) {
               take(result);
               witnesses.show_progress();
             }});
  }

  CulledSets culled;
  std::size_t proved = 0, failed = 0;

 private:
  /// What is left of a place once its line is dealt.
  struct Asked {
    std::string name;
    std::size_t number;
    std::optional<std::size_t> frame;
  };

  [[nodiscard]] std::optional<std::string> next(Witnesses& witnesses) {
    const std::vector<Place> places = next_part([&] { return witnesses.next(); });
    if (places.empty()) return std::nullopt;
    asked_.emplace_back();
    for (const Place& place : places) asked_.back().push_back({place.name, place.number, place.frame});
    return pack_lines(places);
  }

  void take(const std::string& result) {
    render::Unpacker unpacker(result);
    for (const Asked& asked : asked_.front()) take(unpacker, asked);
    unpacker.finish();
    asked_.pop_front();
  }

  void take(render::Unpacker& unpacker, const Asked& asked) {
    const bool is_unreadable = unpacker.flag();
    const std::string fault = unpacker.text();
    if (is_unreadable) {
      render::require_part(!fault.empty(), "a line is no witness for no reason");
      unpacker.finish();
      throw render::InputError(fmt::format("{}: {}", asked.name, fault));
    }
    const auto frame = unpacker.get<std::size_t>(), first = unpacker.get<std::size_t>(), count = unpacker.get<std::size_t>();
    render::require_part(frame == asked.frame.value_or(frame) && frame < extent_.frames,
                         "a witness is of another frame than asked for");
    render::require_part(count <= extent_.triangles && first <= extent_.triangles - count,
                         "a witness culls triangles that the model does not have");
    if (count != 0) culled[frame].push_back({first, count, asked.number});
    add(fault, asked);
  }

  void add(const std::string& fault, const Asked& asked) {
    if (fault.empty()) {
      ++proved;
    } else if (failed++ == 0) {
      exit_code_ = kCheckFailed;
      render::say(render::printable(fmt::format("{}: {}", asked.name, fault)) + "\n");
    }
  }

  Extent extent_;
  int& exit_code_;
  std::deque<std::vector<Asked>> asked_;  ///< of the parts that are not taken yet
};

/// Few frames, because each may take a second.
constexpr std::size_t kFramesOfPart = 4;

/// What shows in the frames of `culled`.
Visibility check_visibility(render::Job& job, const CulledSets& culled, const CheckedWalk& walk,
                            const std::function<Visibility(const CulledSets&)>& check) {
  Visibility all;
  render::Progress progress("visibility, frame", culled.size());
  const auto part_at = [&](CulledSets::const_iterator& at) {
    CulledSets part;
    while (at != culled.end() && part.size() < kFramesOfPart) part.insert(*at++);
    return part;
  };
  auto begun = culled.begin(), taken = culled.begin();
  const auto next = [&]() -> std::optional<std::string> {
    if (begun == culled.end()) return std::nullopt;
    return pack(part_at(begun));
  };
  const auto take = [&](const std::string& result) {
    append(all, unpack_visibility(result, walk, part_at(taken)));
    progress.update(all.frames.size());
  };
  job.run({next, [&](const std::string& part) { return pack(check(unpack_culled(part))); }, take});
  return all;
}

/// Throws PartError unless the counts can be those of a frame by this method in which so many polygons do not show.
void require_counts(const culler::MissedReasons::Counts& counts, culler::Method method, std::size_t hidden) {
  std::size_t left = counts.missed;
  for (std::size_t r = 0; r < culler::kMissedReasons; ++r) {
    const std::size_t most = is_of(static_cast<culler::Missed>(r), method) ? left : 0;
    render::require_part(counts.reasons[r] <= most, "its reasons are of more polygons than were missed");
    left -= counts.reasons[r];
  }
  render::require_part(counts.missed <= hidden, "more polygons were missed than are hidden");
}

/// Counts on the reference frames of `visibility`.
render::MissedCounts count_missed(render::Job& job, const Walked& walked, const Visibility& visibility) {
  std::vector<const FrameVisibility*> references;
  for (const FrameVisibility& frame : visibility.frames) {
    if (!frame.shows.empty()) references.push_back(&frame);
  }
  render::MissedCounts missed{.method = walked.options.cull.method, .counts = {}};
  render::Progress progress("reasons, frame", references.size());
  std::size_t begun = 0;
  const auto next = [&]() -> std::optional<std::string> {
    if (begun == references.size()) return std::nullopt;
    const FrameVisibility& frame = *references[begun++];
    return render::Packer().put(frame.frame).put(frame.shows).bytes();
  };
  Culling culling(walked);
  const auto work = [&](const std::string& part) {
    render::Unpacker unpacker(part);
    const auto frame = unpacker.get<std::size_t>();
    const std::vector<bool> shows = unpacker.bits();
    unpacker.finish();
    const culler::CullResult& culled = culling.cull(frame);
    const auto count = [&](const auto& camera) {
      const culler::MissedReasons reasons(walked.culler, camera, walked.options.cull, culled);
      return culler::MissedReasons::count(reasons.answers(shows, render::check_interrupt));
    };
    return render::Packer().put(std::visit(count, walked.camera(frame))).bytes();
  };
  const auto take = [&](const std::string& result) {
    render::Unpacker unpacker(result);
    const auto counts = unpacker.get<culler::MissedReasons::Counts>();
    unpacker.finish();
    const FrameVisibility& frame = *references[missed.frames];
    require_counts(counts, missed.method, frame.shows.size() - frame.visible);
    missed.counts += counts;
    progress.update(++missed.frames);
  };
  job.run({next, work, take});
  return missed;
}

/// The witnesses of every frame that has a false cull.
WitnessText witnesses_anew(const Walked& walked, const Visibility& visibility) {
  std::map<std::size_t, std::vector<std::string>> lines;
  for (const FalseCull& failure : visibility.false_culls) lines[failure.frame];
  Culling culling(walked);
  for (auto& [frame, of_frame] : lines) culling.append_witnesses(of_frame, frame);
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
  return folder.empty() || !render::is_first_rank() ? std::nullopt : std::optional<FailureFiles>(std::in_place, folder);
}

/// Under mpirun every rank reads the tree's leaves from the file, which a pipe does not allow.
void require_readable_by_all(const std::string& file) {
  if (render::ranks() == 1 || file.empty() || std::filesystem::is_regular_file(file)) return;
  throw render::InputError(file + ": not a file, which mpirun needs because every rank reads it");
}

/// Throws InputError if witnesses are of another tree than that of a store.
void require_leaves(const WitnessFile& witnesses, const culler::Hierarchy& hierarchy, const ValidateArguments& arguments) {
  if (witnesses.leaf_size() == hierarchy.leaf_size()) return;
  throw render::InputError(fmt::format("{}: its leaves have {} polygons, those of {} have {}: give the model itself",
                                       arguments.model, hierarchy.leaf_size(), arguments.witness, witnesses.leaf_size()));
}

/// Tells jobs apart by what is not in the inputs of the parts.
std::uint64_t key_of(const ValidateArguments& arguments, const render::CameraPath& path, const render::WalkOptions& options,
                     const culler::Hierarchy& hierarchy) {
  render::Digest digest;
  add(digest.add(arguments.given).add(json_of(path)), hierarchy.soup()).add(hierarchy.faces());
  const std::string store = options.preprocess.empty() ? arguments.model : options.preprocess.string();
  if (render::is_store(store)) digest.add(std::to_string(render::hash_of_store(store)));
  return digest.value();
}

/// Proves a file of bake or prune, which has no path.
void validate_claims(const ValidateArguments& arguments, const render::WalkOptions& options, WitnessFile& witnesses,
                     int& exit_code) {
  if (!arguments.of_walk.empty()) {
    refuse(arguments.of_walk.substr(0, arguments.of_walk.find_first_of("=\n")), "is for witnesses of a walk");
  }
  const culler::Culler culler = render::make_culler(open_model(arguments.model, options), options);
  render::Job job(arguments.parts.keeping(), [&] {
    render::Digest digest;
    return add(digest.add(arguments.given), culler.hierarchy().soup()).add(culler.hierarchy().faces()).value();
  });
  const HiddenValidation result = validate_hidden(job, culler.hierarchy(), witnesses);
  if (!render::is_first_rank()) return;
  if (!passed(result)) exit_code = kCheckFailed;
  arguments.json ? render::print(to_json(result)) : render::tell(to_text(result));
  for (const std::string& fault : {result.line_fault, result.claim_fault}) {
    if (!fault.empty()) render::say(render::printable(fault) + "\n");
  }
  render::finish_printing();
  job.finish();
}

void validate(ValidateArguments& arguments, int& exit_code) {
  render::WalkOptions options = arguments.walk.options(arguments.model);
  if (arguments.scene && !culler::is_by_cover(options.cull.method)) refuse("--scene", "a scene is not culled by frusta");
  const bool is_anew = arguments.witness.empty();
  require_readable_by_all(arguments.witness);
  std::optional<WitnessFile> witnesses;
  if (!is_anew) options.build.hierarchy.leaf_size = witnesses.emplace(arguments.witness).leaf_size();
  if (witnesses && witnesses->has_claims()) return validate_claims(arguments, options, *witnesses, exit_code);
  std::optional<FailureFiles> files = failure_files(arguments.out);
  render::ModelFile model = open_model(arguments.model, options);
  const render::CameraPath path = arguments.path.through(model);
  const Turns turns(is_anew ? render::frames_of(path, options) : all_frames(path));
  const culler::Culler culler = render::make_culler(std::move(model), options);
  const culler::Hierarchy& hierarchy = culler.hierarchy();
  if (witnesses) require_leaves(*witnesses, hierarchy, arguments);
  warn_of_misfit(path, arguments.path, arguments.model, hierarchy.soup());
  const Walked walked{culler, path, options, arguments.matrix, arguments.scene};
  const CheckedWalk checked{culler, path, render::aspect(options), turns};
  render::Job job(arguments.parts.keeping(), [&] { return key_of(arguments, path, options, hierarchy); });

  const proof::Prover prover(hierarchy, {path.frames, [&](std::size_t frame) { return walked.camera(frame); }});
  Proving proving({path.frames, hierarchy.first_triangle(hierarchy.soup().size())}, exit_code);
  if (is_anew) {
    WitnessesAnew anew(walked, proving.culled);
    proving.run(job, prover, anew);
  } else {
    WitnessesOfFile of_file(*witnesses);
    proving.run(job, prover, of_file);
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
  result.visibility = check_visibility(job, proving.culled, checked, [&](const CulledSets& culled) {
    return result.is_exact ? check_exactly(checked, culled) : check_rendered(checked, culled, buffers());
  });
  if (is_anew && !walked.as_scene) result.missed = count_missed(job, walked, result.visibility);
  if (!render::is_first_rank()) return;

  if (!passed(result)) exit_code = kCheckFailed;
  arguments.json ? render::print(to_json(result)) : render::tell(to_text(result));
  const WitnessText witness = is_anew ? witnesses_anew(walked, result.visibility) : witnesses_of(arguments.witness);
  const SeenText seen = [&](std::size_t frame) {
    return result.is_exact ? "in exact arithmetic" : "in " + buffers().describe(turns.turn(frame));
  };
  if (!result.visibility.false_culls.empty()) {
    render::say(describe(result.visibility.false_culls.front(), hierarchy, witness, seen) + "\n");
  }
  if (files) files->write(result.visibility, checked, witness, seen, buffers);
  render::finish_printing();
  job.finish();
}

}  // namespace

void add_validate(Command app, int& exit_code) {
  Command command =
      app.add_command("validate", "Prove every cull of a walk in exact arithmetic, and that nothing culled shows");
  command.footer(
      "Exit code 0; 1 when a witness is not proved or a culled triangle shows (it is printed); 2 for bad input.\n" +
      limits_help() +
      "\n"
      "Example: occlude validate city.ply --path city.json --witness witness.jsonl\n"
      "Example: mpirun -n 4 occlude validate city.ply --path city.json     and, after a failure, with --resume");
  const auto a = std::make_shared<ValidateArguments>();
  add_input(command, "MODEL", a->model, "the model walked through").required();
  a->path.add_to(command, "camera path");
  Option region = a->path.add_region_to(command);
  Option witness =
      add_input(command, "--witness", a->witness,
                "prove this file of `occlude walk --witness`, or of bake or prune, which take no path; without it, cull "
                "anew and prove that");
  command
      .add("--exact-up-to", a->exact_up_to,
           "triangles of the largest model whose culled triangles are held against exact visibility; 0: none")
      .show_default()
      .in_range(std::size_t{0}, std::size_t{1000000});
  add_output(command, "--out", a->out, "folder for what is culled and shows: frame, polygon, witness and picture");
  command
      .add_flag("--matrix", a->matrix,
                "cull by the matrix of each camera, as an engine has it, and not by its eye and angles")
      .excludes(witness);
  command
      .add_flag("--scene", a->scene,
                "cull by --method cover a scene of which each leaf of the tree is an object, and all polygons hide")
      .excludes(witness)
      .excludes(region);
  a->walk.add_size_to(command);
  for (Option option : a->walk.add_culling_to(command)) option.excludes(witness);
  a->walk.add_model_to(command).excludes(witness);
  a->parts.add_to(command, "validate");
  command.add_flag("--json", a->json, "print the counts as JSON");
  command.run_on_all_ranks([a, command, &exit_code] {
    a->given = command.given_but(
        {"MODEL", "--path", "--preprocess", "--witness", "--out", "--json", "--quiet", "--parts", "--resume"});
    a->of_walk = command.given_but(
        {"MODEL", "--witness", "--opaque-all", "--up", "--unit", "--json", "--quiet", "--parts", "--resume"});
    validate(*a, exit_code);
  });
}

}  // namespace occlude::cli
