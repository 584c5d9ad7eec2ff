// SPDX-License-Identifier: MIT
#include "audit_report.h"

#include <fmt/format.h>

#include <cmath>

#include "occlude/render/formats.h"
#include "occlude/render/interrupt.h"

namespace occlude::cli {
namespace {

using nlohmann::ordered_json;

constexpr std::size_t kAuditPictures = 16;  // the first few are enough to see what is wrong

std::string picture_name(std::uint32_t frame) { return fmt::format("false_culls_{:06}.png", frame); }

bool is_audit_picture(const std::string& name) { return name.starts_with("false_culls_") && name.ends_with(".png"); }

/// The counts that a frame has and all of them together.
template <class Counts>
ordered_json counts_of(const Counts& counts, std::size_t visible) {
  return {{"culled", counts.culled},       {"proved_hidden", counts.hidden}, {"false_culls", visible},
          {"unsettled", counts.unsettled}, {"drawn", counts.drawn},          {"needless", counts.needless}};
}

ordered_json point(const glm::dvec3& v) { return {v.x, v.y, v.z}; }

}  // namespace

void AuditSums::add(const FrameAudit& frame) {
  ++frames;
  wrong_frames += !frame.visible.empty();
  visible += frame.visible.size();
  culled += frame.culled;
  hidden += frame.hidden;
  unsettled += frame.unsettled;
  drawn += frame.drawn;
  needless += frame.needless;
}

std::string to_text(const AuditSums& sums) {
  const auto line = [](std::size_t count, const std::string& text) { return fmt::format("{:>14}  {}\n", count, text); };
  return line(sums.frames, "frames") + line(sums.wrong_frames, "frames with a false cull") +
         line(sums.culled, "polygons culled in view or near it, over all frames; of them") +
         line(sums.visible, "visible: false culls, each with an exact ray") + line(sums.hidden, "proved hidden") +
         line(sums.unsettled, "neither proved hidden nor found visible") +
         line(sums.drawn, "polygons drawn in view or near it; of them") +
         line(sums.needless, "proved hidden: at least these were drawn in vain");
}

std::string to_json(const AuditSums& sums) {
  ordered_json result{{"frames", sums.frames}, {"wrong_frames", sums.wrong_frames}};
  result.update(counts_of(sums, sums.visible));
  return result.dump(2) + "\n";
}

ordered_json json_of(const SeenPolygon& polygon, const LoggedFrame& frame, const CullLog& log) {
  ordered_json line{{"frame", frame.number}, {"polygon", polygon.polygon}};
  if (const std::uint32_t object = log.object_of(polygon.polygon); object != CullLog::kNoObject) line["object"] = object;
  const oracle::Viewpoint view = proof::viewpoint_of(frame.camera);
  line[view.at_infinity ? "direction" : "eye"] = view.value;
  line["through"] = point(polygon.through);
  line["pixel"] = {std::lround(std::floor(polygon.pixel.x)), std::lround(std::floor(polygon.pixel.y))};
  return line;
}

AuditFiles::AuditFiles(const std::filesystem::path& folder)
    : folder_(folder),
      summary_(folder / "summary.json"),
      frames_(folder / "frames.jsonl"),
      lines_(folder / "false_culls.jsonl"),
      pictures_(folder, is_audit_picture) {}

void AuditFiles::add(const FrameAudit& audit, const LoggedFrame& frame, const CullLog& log, Auditor& auditor) {
  ordered_json counts{{"frame", frame.number}};
  counts.update(counts_of(audit, audit.visible.size()));
  frames_.write(counts.dump() + '\n');
  const bool has_picture = !audit.visible.empty() && drawn_ < kAuditPictures;
  for (const SeenPolygon& polygon : audit.visible) {
    ordered_json line = json_of(polygon, frame, log);
    if (has_picture) line["picture"] = picture_name(frame.number);
    lines_.write(line.dump() + '\n');
  }
  if (!has_picture) return;
  pictures_.add(picture_name(frame.number), auditor.picture(frame, audit.visible));
  ++drawn_;
}

void AuditFiles::commit(const AuditSums& sums) {
  summary_.write(to_json(sums));
  for (render::OutputFile* file : {&summary_, &frames_, &lines_}) file->close();
  const render::Uninterrupted together;
  pictures_.commit();
  for (render::OutputFile* file : {&summary_, &frames_, &lines_}) file->commit();
}

}  // namespace occlude::cli
