// SPDX-License-Identifier: MIT
#include "occlude/render/walk_comparison.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <initializer_list>
#include <map>
#include <numeric>
#include <utility>

#include "occlude/render/errors.h"
#include "occlude/render/image.h"
#include "occlude/render/json_text.h"
#include "occlude/render/output_place.h"
#include "occlude/render/plates.h"
#include "occlude/render/printable.h"

namespace occlude::render {
namespace {

using Values = std::vector<double>;

/// Changes of a mean below this are not worth a mark.
constexpr double kLeastChange = 0.001;
/// Two runs of one walk on one machine differ by up to so much.
constexpr double kLeastChangeOfTime = 0.05;

enum class Better { neither, less, more };
/// By which the times of the control may differ.
constexpr double kMostChangeOfPace = 0.1;

/// A ratio of times of one walk does not hang on the machine as times do.
enum class Kind { fault, count, time, processor_time, ratio };
/// What a member of summary.json may be, beside null.
enum class Type { text, flag, whole, amount, share, size };

/// A figure of summary.json, and how frames.csv has it: a column, the ratio of two, or `1 - ratio`; or not at all.
struct Figure {
  const char* name;
  Type type = Type::amount;
  Better better = Better::neither;
  Kind kind = Kind::count;
  const char* column = nullptr;
  const char* divisor = nullptr;
  bool is_rest = false;
};

constexpr auto kFigures = std::to_array<Figure>({
    {"mean.view_frustum_polygons", Type::amount, Better::neither, Kind::count, "view_frustum_polygons"},
    {"mean.rendered_polygons", Type::amount, Better::less, Kind::count, "rendered_polygons"},
    {"mean.visible_polygons", Type::amount, Better::neither, Kind::count, "visible_polygons"},
    {"mean.hidden_polygons", Type::amount},
    {"culled_share", Type::share, Better::more, Kind::count, "rendered_polygons", "view_frustum_polygons", true},
    {"culled_share_of_hidden", Type::amount, Better::more},
    {"mean.occluders", Type::amount, Better::neither, Kind::count, "occluders"},
    {"mean.candidates", Type::amount, Better::neither, Kind::count, "candidates"},
    {"mean.sort_moves", Type::amount, Better::neither, Kind::count, "sort_moves"},
    {"mean.cull_ms", Type::amount, Better::less, Kind::time, "cull_ms"},
    {"mean.cull_processor_ms", Type::amount, Better::less, Kind::processor_time, "cull_processor_ms"},
    {"mean.view_frustum_cull_ms", Type::amount, Better::neither, Kind::time, "view_frustum_cull_ms"},
    {"mean.witness_ms", Type::amount, Better::less, Kind::time},
    {"mean.frame_ms", Type::amount, Better::less, Kind::time, "frame_ms"},
    {"mean.frame_ms_view_frustum_only", Type::amount, Better::neither, Kind::time, "view_frustum_frame_ms"},
    {"mean.frame_ms_visible_only", Type::amount, Better::neither, Kind::time, "visible_frame_ms"},
    {"mean.frame_processor_ms", Type::amount, Better::less, Kind::processor_time, "frame_processor_ms"},
    {"mean.frame_processor_ms_view_frustum_only", Type::amount, Better::neither, Kind::processor_time,
     "view_frustum_frame_processor_ms"},
    {"speedup", Type::amount, Better::more, Kind::ratio, "view_frustum_frame_ms", "frame_ms"},
    {"speedup_limit.polygons", Type::amount},
    {"speedup_limit.visible", Type::amount},
    {"held.regions", Type::whole},
    {"held.frames_a_region", Type::amount},
    {"held.frames_by_point", Type::whole},
    {"held.region_ms", Type::amount, Better::less, Kind::time},
    {"held.between_ms", Type::amount, Better::less, Kind::time},
    {"wrong_pixels", Type::whole, Better::less, Kind::fault},
    {"wrong_pixels_explained_by_snapping", Type::whole},
    {"false_culls", Type::whole, Better::less, Kind::fault},
    {"witnesses", Type::whole},
    {"operations.tests", Type::whole},
    {"operations.dot_per_test", Type::amount},
    {"operations.scalar_per_test", Type::amount},
    {"operations.vector_per_test", Type::amount},
    {"operations.cross_per_test", Type::amount},
    {"preprocess_s", Type::amount, Better::less, Kind::time},
});

/// What tells how and where it was measured.
struct Condition {
  const char* name;
  Type type;
};

constexpr auto kConditions = std::to_array<Condition>({
    {"model", Type::text},
    {"polygons", Type::whole},
    {"see_through_polygons", Type::whole},
    {"triangles", Type::whole},
    {"frames", Type::whole},
    {"method", Type::text},
    {"options.size", Type::size},
    {"options.cover_size", Type::size},
    {"options.budget_work", Type::whole},
    {"options.budget_ms", Type::amount},
    {"options.leaf", Type::whole},
    {"options.occluders", Type::whole},
    {"options.probes", Type::whole},
    {"options.solid_angle", Type::text},
    {"options.weights.solid_angle", Type::amount},
    {"options.weights.depth_complexity", Type::amount},
    {"options.weights.coherence", Type::amount},
    {"options.pixel_margin", Type::amount},
    {"options.near", Type::text},
    {"options.arithmetic", Type::text},
    {"options.test", Type::text},
    {"options.bounds", Type::text},
    {"options.shapes", Type::text},
    {"options.regions", Type::text},
    {"options.unions", Type::flag},
    {"options.hold", Type::amount},
    {"options.region", Type::amount},
    {"options.preprocess", Type::text},
    {"machine.processor", Type::text},
    {"machine.threads", Type::whole},
    {"machine.renderer", Type::text},
    {"machine.compiler", Type::text},
    {"load", Type::amount},
    {"busy", Type::text},
});

/// The member that a dotted name means; null if there is none.
const nlohmann::json* member(const nlohmann::json& object, const std::string& name) {
  const std::size_t dot = name.find('.');
  const auto found = object.find(name.substr(0, dot));
  if (found == object.end()) return nullptr;
  return dot == std::string::npos ? &*found : member(*found, name.substr(dot + 1));
}

std::optional<double> number(const nlohmann::json& summary, const std::string& name) {
  const nlohmann::json* const value = member(summary, name);
  return value && value->is_number() ? std::optional(value->get<double>()) : std::nullopt;
}

/// The members of an object by dotted names; those of objects within it too.
void flatten(const nlohmann::json& object, const std::string& prefix, std::map<std::string, std::string>& members) {
  for (const auto& [key, value] : object.items()) {
    if (value.is_object()) {
      flatten(value, prefix + key + ".", members);
    } else {
      members[printable(prefix + key)] = printable(value.is_string() ? value.get<std::string>() : value.dump());
    }
  }
}

/// What was measured and how.
std::map<std::string, std::string> conditions(const nlohmann::json& summary) {
  std::map<std::string, std::string> members;
  nlohmann::json told = nlohmann::json::object();
  for (const char* name :
       {"model", "polygons", "see_through_polygons", "triangles", "frames", "method", "options", "machine"}) {
    if (summary.contains(name)) told[name] = summary[name];
  }
  flatten(told, "", members);
  return members;
}

std::vector<Difference> differences_of(const nlohmann::json& a, const nlohmann::json& b) {
  const std::map<std::string, std::string> of_a = conditions(a), of_b = conditions(b);
  std::map<std::string, std::string> all = of_a;
  all.insert(of_b.begin(), of_b.end());
  const auto value = [](const std::map<std::string, std::string>& members, const std::string& name) {
    const auto found = members.find(name);
    return found == members.end() ? std::string("-") : found->second;
  };
  std::vector<Difference> differences;
  for (const auto& entry : all) {
    Difference d{entry.first, value(of_a, entry.first), value(of_b, entry.first)};
    if (d.a != d.b) differences.push_back(std::move(d));
  }
  return differences;
}

/// Two tables of frames, and the rows of the frames that both have.
struct Frames {
  const FrameTable &a, &b;
  std::vector<std::size_t> rows_of_a, rows_of_b;

  Frames(const FrameTable& first, const FrameTable& second) : a(first), b(second) {
    for (std::size_t i = 0, k = 0; i < a.frames().size() && k < b.frames().size();) {
      const double left = a.frames()[i], right = b.frames()[k];
      if (left == right) {
        rows_of_a.push_back(i);
        rows_of_b.push_back(k);
      }
      if (left <= right) ++i;
      if (right <= left) ++k;
    }
  }

  [[nodiscard]] bool are_all() const {
    return rows_of_a.size() == a.frames().size() && rows_of_b.size() == b.frames().size();
  }
};

/// The figure on the given frames; empty if the table lacks a column.
Values values_of(const Figure& figure, const FrameTable& table, const std::vector<std::size_t>& rows) {
  const Values* const column = figure.column ? table.column(figure.column) : nullptr;
  const Values* const divisor = figure.divisor ? table.column(figure.divisor) : nullptr;
  if (!column || (figure.divisor && !divisor)) return {};
  Values values;
  for (const std::size_t row : rows) {
    const double value = divisor ? (*column)[row] / (*divisor)[row] : (*column)[row];
    values.push_back(figure.is_rest ? 1 - value : value);
  }
  return values;
}

Verdict verdict_of(Better better, bool has_fallen, bool has_risen) {
  if (better == Better::neither) return Verdict::unjudged;
  if (!has_fallen && !has_risen) return Verdict::same;
  return has_risen == (better == Better::more) ? Verdict::better : Verdict::worse;
}

Verdict judge_change(Better better, double a, double b, double least) {
  return verdict_of(better, b<a - least * std::abs(a), b> a + least * std::abs(a));
}

Verdict judge_times(Better better, Values ratios) {
  std::erase_if(ratios, [](double ratio) { return !std::isfinite(ratio); });
  std::ranges::sort(ratios);
  const std::optional<Interval> surely = median_interval(ratios);
  if (!surely) return Verdict::unjudged;
  const double median = quantile(ratios, 0.5), most = 1 + kLeastChangeOfTime;
  return verdict_of(better, surely->high < 1 && median<1 / most, surely->low> 1 && median > most);
}

double mean(const Values& values) { return std::reduce(values.begin(), values.end()) / static_cast<double>(values.size()); }

/// Judges a figure that both summaries have.
Verdict judge(const Figure& figure, const ComparedFigure& compared, const Values& ratios, bool has_same_frames) {
  if (figure.kind == Kind::fault) return judge_change(figure.better, *compared.a, *compared.b, 0);
  if (figure.kind != Kind::count) return judge_times(figure.better, ratios);
  if (!ratios.empty()) {
    return judge_change(figure.better, mean(compared.frames_of_a), mean(compared.frames_of_b), kLeastChange);
  }
  return has_same_frames ? judge_change(figure.better, *compared.a, *compared.b, kLeastChange) : Verdict::unjudged;
}

ComparedFigure compare(const Figure& figure, const WalkReading& a, const WalkReading& b, const Frames* frames) {
  ComparedFigure compared;
  compared.name = figure.name;
  compared.a = number(a.summary, figure.name);
  compared.b = number(b.summary, figure.name);
  if (!compared.a || !compared.b) return compared;
  Values ratios;
  if (frames) {
    compared.frames_of_a = values_of(figure, frames->a, frames->rows_of_a);
    compared.frames_of_b = values_of(figure, frames->b, frames->rows_of_b);
    std::vector<FrameValue> named;
    for (std::size_t i = 0; i < std::min(compared.frames_of_a.size(), compared.frames_of_b.size()); ++i) {
      ratios.push_back(compared.frames_of_b[i] / compared.frames_of_a[i]);
      named.push_back({static_cast<std::size_t>(frames->a.frames()[frames->rows_of_a[i]]), ratios.back()});
    }
    compared.per_frame = spread_of(std::move(named), figure.better == Better::more ? Worst::least : Worst::most);
  }
  const bool has_same_frames =
      frames ? frames->are_all()
             : a.summary.value("frames", nlohmann::json()) == b.summary.value("frames", nlohmann::json());
  compared.verdict = judge(figure, compared, ratios, has_same_frames);
  return compared;
}

/// Of the first of these figures that is known.
std::optional<double> control_of(const std::vector<ComparedFigure>& figures, std::initializer_list<const char*> names) {
  for (const char* name : names) {
    const auto figure = std::ranges::find(figures, name, &ComparedFigure::name);
    if (figure->per_frame) return figure->per_frame->median;
    if (const std::optional<double> ratio = figure->ratio()) return ratio;
  }
  return std::nullopt;
}

/// Takes back what was found of a kind.
void forget(std::vector<ComparedFigure>& figures, Kind kind) {
  for (std::size_t i = 0; i < kFigures.size(); ++i) {
    if (kFigures[i].kind == kind) figures[i].verdict = Verdict::unjudged;
  }
}

/// The plates of the two frames that are nearest to each other.
void choose_plates(const WalkReading& a, const WalkReading& b, WalkComparison& comparison) {
  std::size_t least = SIZE_MAX;
  for (const auto& of_a : a.plates) {
    for (const auto& of_b : b.plates) {
      const std::size_t apart = std::max(of_a.first, of_b.first) - std::min(of_a.first, of_b.first);
      if (apart >= least) continue;
      least = apart;
      comparison.a.plate = of_a;
      comparison.b.plate = of_b;
    }
  }
}

ComparedWalk compared(const WalkReading& walk, bool has_own_label) {
  const auto busy = walk.summary.find("busy");
  return {walk.name, has_own_label ? walk.label : walk.name,
          busy != walk.summary.end() && busy->is_string() ? printable(busy->get<std::string>()) : std::string(),
          std::nullopt};
}

/// The plates from outside in a folder, by their frames.
std::map<std::size_t, std::filesystem::path> plates_in(const std::filesystem::path& folder) {
  std::map<std::size_t, std::filesystem::path> plates;
  if (!std::filesystem::is_directory(folder)) return plates;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    const std::optional<std::size_t> frame = frame_of_outside_plate(entry.path().filename().native());
    if (!frame || !is_own_png(entry.path())) continue;
    keep_input(entry.path());
    plates.emplace(*frame, entry.path());
  }
  return plates;
}

/// "before" of before/ and of before/summary.json.
std::string label_of(const std::filesystem::path& place) {
  const bool is_inside = !place.has_filename() || place.filename() == "summary.json";
  const std::filesystem::path folder = is_inside ? place.parent_path() : place;
  return printable((folder.has_filename() ? folder : std::filesystem::absolute(folder)).filename().native());
}

[[noreturn]] void refuse(const std::filesystem::path& file, const std::string& why) {
  throw InputError(file.string() + ": not a summary of `occlude walk`: " + why);
}

bool is_text(const nlohmann::json& value) { return value.is_string(); }
bool is_flag(const nlohmann::json& value) { return value.is_boolean(); }
bool is_whole(const nlohmann::json& value) { return value.is_number_unsigned(); }
bool is_amount(const nlohmann::json& value) { return value.is_number() && value.get<double>() >= 0; }
bool is_share(const nlohmann::json& value) { return is_amount(value) && value.get<double>() <= 1; }
bool is_size(const nlohmann::json& value) {
  return value.is_array() && value.size() == 2 && std::ranges::all_of(value, is_whole);
}

/// Whether a value is of the type, and what to call it.
struct TypeTest {
  bool (*is)(const nlohmann::json& value);
  const char* name;
};

/// In the order of Type.
constexpr std::array<TypeTest, 6> kTypeTests{{{is_text, "a text"},
                                              {is_flag, "true or false"},
                                              {is_whole, "a whole number"},
                                              {is_amount, "a number that is not negative"},
                                              {is_share, "a number from 0 to 1"},
                                              {is_size, "two whole numbers"}}};

/// Refuses a member of another type, and one within what is no object.
void require(const std::filesystem::path& file, const nlohmann::json& summary, const std::string& name, Type type) {
  for (std::size_t dot = name.find('.'); dot != name.npos; dot = name.find('.', dot + 1)) {
    const std::string around = name.substr(0, dot);
    const nlohmann::json* const value = member(summary, around);
    if (!value) return;
    if (!value->is_object()) refuse(file, around + ": expected an object");
  }
  const nlohmann::json* const value = member(summary, name);
  const TypeTest& test = kTypeTests[static_cast<std::size_t>(type)];
  if (value && !value->is_null() && !test.is(*value)) refuse(file, fmt::format("{}: expected {}", name, test.name));
}

}  // namespace

WalkReading read_walk(const std::filesystem::path& place) {
  const bool is_folder = std::filesystem::is_directory(place);
  const std::filesystem::path file = is_folder ? place / "summary.json" : place, table = place / "frames.csv";
  keep_input(file);
  WalkReading reading{printable(place.string()), label_of(place), read_json(file), {}, std::nullopt};
  if (!reading.summary.is_object()) refuse(file, "expected a JSON object");
  for (const Condition& condition : kConditions) require(file, reading.summary, condition.name, condition.type);
  for (const Figure& figure : kFigures) require(file, reading.summary, figure.name, figure.type);
  for (const char* name : {"mean.rendered_polygons", "mean.cull_ms", "culled_share"}) {
    if (!number(reading.summary, name)) refuse(file, std::string(name) + ": missing");
  }
  if (is_folder) reading.plates = plates_in(place / "plates");
  if (is_folder && std::filesystem::exists(table)) {
    keep_input(table);
    reading.frames.emplace(table);
  }
  return reading;
}

std::optional<double> ComparedFigure::ratio() const { return a && b && *a != 0 ? std::optional(*b / *a) : std::nullopt; }

std::vector<std::string> WalkComparison::worse() const {
  std::vector<std::string> names;
  for (const ComparedFigure& figure : figures) {
    if (figure.verdict == Verdict::worse) names.push_back(figure.name);
  }
  return names;
}

bool is_same_pace(const std::optional<double>& control) {
  return !control || (*control <= 1 + kMostChangeOfPace && *control >= 1 / (1 + kMostChangeOfPace));
}

WalkComparison compare_walks(const WalkReading& a, const WalkReading& b) {
  const bool have_own_labels = a.label != b.label;
  WalkComparison comparison{
      compared(a, have_own_labels), compared(b, have_own_labels), differences_of(a.summary, b.summary), {}, {}, {}, {}};
  choose_plates(a, b, comparison);
  std::optional<Frames> frames;
  if (a.frames && b.frames) frames.emplace(*a.frames, *b.frames);
  for (const Figure& figure : kFigures) comparison.figures.push_back(compare(figure, a, b, frames ? &*frames : nullptr));
  comparison.control = control_of(comparison.figures, {"mean.frame_ms_view_frustum_only", "mean.view_frustum_cull_ms"});
  comparison.control_of_processor = control_of(comparison.figures, {"mean.frame_processor_ms_view_frustum_only"});
  if (!is_same_pace(comparison.control)) forget(comparison.figures, Kind::time);
  if (!is_same_pace(comparison.control_of_processor)) forget(comparison.figures, Kind::processor_time);
  if (!frames) return comparison;
  comparison.frames.emplace();
  for (const std::size_t row : frames->rows_of_a) comparison.frames->push_back(frames->a.frames()[row]);
  return comparison;
}

}  // namespace occlude::render
