// SPDX-License-Identifier: MIT
// occlude audit: judges the log of another culler.
#include <fmt/format.h>

#include <memory>
#include <optional>
#include <string>
#include <utility>

#include "audit_report.h"
#include "command_arguments.h"
#include "commands.h"
#include "cull_log.h"
#include "frame_audit.h"
#include "occlude/render/console.h"
#include "occlude/render/progress.h"
#include "occlude/render/walk.h"

namespace occlude::cli {
namespace {

struct AuditArguments {
  std::string model, log, out, cover_size = "1152x720";
  ReadArguments read;
  AuditOptions options;
  bool json = false;
};

/// It culls polygon by polygon. The tree of a store may have larger leaves.
culler::Culler culler_of(culler::PolygonSoup model) {
  render::WalkOptions walk;
  walk.build.hierarchy.leaf_size = 1;
  return render::make_culler(std::move(model), walk);
}

void audit(AuditArguments& arguments, int& exit_code) {
  set_cover_size(arguments.options.cover, arguments.cover_size);
  std::optional<AuditFiles> files;
  if (!arguments.out.empty()) files.emplace(arguments.out);
  const culler::Culler culler = culler_of(read_model(arguments.model, arguments.read.options(arguments.model)).soup);
  CullLog log(arguments.log, culler.hierarchy().face_count());
  Auditor auditor(culler, arguments.options);
  AuditSums sums;
  std::string first;
  {
    render::Progress progress("audited KiB", log.size() >> 10U);
    while (const std::optional<LoggedFrame> frame = log.next()) {
      const FrameAudit result = auditor.judge(*frame);
      sums.add(result);
      if (files) files->add(result, *frame, log, auditor);
      if (first.empty() && !result.visible.empty()) first = json_of(result.visible.front(), *frame, log).dump();
      progress.update(log.read() >> 10U);
    }
  }
  if (sums.visible > 0) exit_code = kCheckFailed;
  arguments.json ? render::print(to_json(sums)) : render::tell(to_text(sums));
  if (!first.empty()) render::say("the first false cull: " + first + "\n");
  if (files) files->commit(sums);
}

}  // namespace

void add_audit(Command app, int& exit_code) {
  Command command = app.add_command("audit", "Judge what another culler culled, frame by frame, by its log");
  command.footer(
      "A log says for each frame its camera and the polygons or objects that were culled, or drawn: docs/audit.md. It may "
      "be\n"
      "compressed by gzip. Each false cull that is told is borne out by an exact ray.\n"
      "Exit code 0; 1 when something visible was culled (the first is printed); 2 for bad input.\n" +
      limits_help() +
      "\n"
      "Example: occlude audit city.ply --log culled.jsonl --out audit");
  const auto a = std::make_shared<AuditArguments>();
  add_input(command, "MODEL", a->model, "the model that was drawn").required();
  add_input(command, "--log", a->log, "what was culled: JSON Lines or a binary log; -: standard input").required();
  add_output(
      command, "--out", a->out,
      "folder for false_culls.jsonl (frame, polygon, ray and pixel), pictures of them, frames.jsonl and summary.json");
  a->read.add_to(command);
  command.under(kTuning, [&] {
    command
        .add("--item-buffers", a->options.item_buffers,
             "item buffers of a frame in which false culls are looked for, a quarter of a pixel apart")
        .show_default()
        .in_range(std::size_t{0}, std::size_t{16});
    command
        .add("--rays", a->options.rays, "rays into each triangle that they do not show, beside those to corners and sides")
        .show_default()
        .in_range(std::size_t{0}, std::size_t{65536});
    command.add("--cover-size", a->cover_size, "WxH, size of the coarse picture of our own cull in pixels").show_default();
  });
  command.add_flag("--json", a->json, "print the counts as JSON");
  command.run([a, &exit_code] { audit(*a, exit_code); });
}

}  // namespace occlude::cli
