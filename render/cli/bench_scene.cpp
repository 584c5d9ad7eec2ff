// SPDX-License-Identifier: MIT
// occlude bench scene
#include <glm/geometric.hpp>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "cases/to_oracle.h"
#include "command_arguments.h"
#include "commands.h"
#include "occlude/oracle/cover.h"
#include "occlude/render/console.h"
#include "occlude/render/progress.h"
#include "scene_bench.h"

namespace occlude::cli {
namespace {

struct Arguments {
  experiments::SceneBenchOptions options;
  std::string seed = "1";
  bool json = false;
};

oracle::Point point_of(const glm::dvec3& v) { return {v.x, v.y, v.z}; }

/// Asks the oracle whether the polygons hide the box beyond the camera's near plane.
bool is_proved(const culler::Camera& camera, const culler::ObjectFate& fate, const culler::Box& box) {
  std::vector<oracle::Loop> polygons;
  for (const auto& hiding : fate.by) polygons.push_back(cases::to_oracle(hiding.corners));
  const glm::dvec3 forward = camera.axes().forward;
  const oracle::HalfSpaceCoefficients drawn{forward.x, forward.y, forward.z, -glm::dot(forward, camera.eye) - camera.near};
  const oracle::Answer answer =
      oracle::relation_to_cover({point_of(camera.eye), false}, polygons, cases::to_oracle(box), drawn);
  return answer.refusal.empty() && answer.relation == oracle::Relation::inside;
}

void bench_scene(Arguments& arguments, int& exit_code) {
  experiments::SceneBenchOptions& options = arguments.options;
  const experiments::WorldSize& world = options.world;
  options.seed = whole_number("--seed", arguments.seed);
  if (world.streamed + world.moving > world.objects) refuse("--objects", "fewer than --streamed and --moving together");
  if (world.moving_occluders > world.moving) refuse("--moving-occluders", "more than --moving");
  std::optional<render::Progress> progress(std::in_place, "frame", options.settling + options.frames);
  const experiments::SceneBenchResult result =
      experiments::bench_scene(options, is_proved, [&](std::size_t done, std::size_t) {
        render::check_interrupt();
        progress->update(done);
      });
  progress.reset();
  if (result.different != 0 || result.unproved != 0) exit_code = kCheckFailed;
  arguments.json ? render::print(json_of(result, options)) : render::tell(text_of(result, options));
}

}  // namespace

void add_bench_scene(Command bench, int& exit_code) {
  Command command = bench.add_command("scene", "A world of objects that changes: tiles that stream, traffic, two views");
  command.footer(
      "In a town of buildings, tiles of small things come and go around a camera that flies, and traffic drives. Every\n"
      "--check-every frames the culls are compared with those of a scene made anew, and some are proved by the exact "
      "oracle;\n"
      "exit code 1 when one is wrong.\n"
      "Example: occlude bench scene\n"
      "Example: occlude bench scene --objects 100000 --streamed 20000 --moving 1000 --frames 100 --json");
  const auto a = std::make_shared<Arguments>();
  experiments::SceneBenchOptions& options = a->options;
  constexpr std::size_t kMost = 20'000'000;
  command.add("--objects", options.world.objects, "objects in all").show_default().in_range(std::size_t{1000}, kMost);
  command.add("--streamed", options.world.streamed, "of these, in tiles of 1,000 that come and go")
      .show_default()
      .in_range(std::size_t{0}, kMost);
  command.add("--moving", options.world.moving, "of these, those that move").show_default().in_range(std::size_t{0}, kMost);
  command.add("--moving-occluders", options.world.moving_occluders, "of the moving ones, those that hide")
      .show_default()
      .in_range(std::size_t{0}, kMost);
  command.add("--frames", options.frames, "frames that are measured").show_default().in_range(std::size_t{1}, kMost);
  command.add("--settling", options.settling, "frames before these").show_default().in_range(std::size_t{0}, kMost);
  command.add("--check-every", options.check_every, "frames between checks; 0: none")
      .show_default()
      .in_range(std::size_t{0}, kMost);
  command.add("--seed", a->seed, "whole number; the same seed gives the same world").show_default();
  command.add_flag("--json", a->json, "print everything measured as JSON");
  command.run([a, &exit_code] { bench_scene(*a, exit_code); });
}

}  // namespace occlude::cli
