// SPDX-License-Identifier: MIT
// occlude bake: what is seen from anywhere in each of many cells.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <fstream>
#include <iterator>
#include <memory>
#include <mutex>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "base/parallel.h"
#include "cell_map.h"
#include "cells.h"
#include "command_arguments.h"
#include "commands.h"
#include "held/hidden_search.h"
#include "hidden_proofs.h"
#include "model/bounds.h"
#include "model/curve_order.h"
#include "object_list.h"
#include "occlude/culler/culler.h"
#include "occlude/kernel/validity.h"
#include "occlude/render/console.h"
#include "occlude/render/digest.h"
#include "occlude/render/errors.h"
#include "occlude/render/hidden_witness.h"
#include "occlude/render/image.h"
#include "occlude/render/input_limits.h"
#include "occlude/render/interrupt.h"
#include "occlude/render/job.h"
#include "occlude/render/packing.h"
#include "occlude/render/progress.h"
#include "occlude/render/range_parts.h"
#include "occlude/render/ranks.h"
#include "occlude/render/stopwatch.h"
#include "occlude/render/store.h"
#include "path_arguments.h"
#include "visible_sets.h"

namespace occlude::cli {
namespace {

constexpr const char *kGrid = "grid", *kCorridor = "corridor";

struct BakeArguments {
  std::string model, out, map, cells, heights, objects;
  CellGrid grid;
  double reach = 5, piece = 2;
  double closer = 0.02;
  std::size_t cover_size = 256;
  ReadArguments read;
  PathArguments path;
  PartsArguments parts;
  ProofArguments proofs;
  bool json = false;
  std::string given;  ///< the options on which the sets depend
};

/// The axis that is up in the model, for an option that needs one.
UpAxis up_for(const char* option, const render::ModelFile& model) {
  const auto up = axis_of(up_of(model.notes));
  if (!up) refuse(option, "what is up in the model is no axis");
  return *up;
}

/// The layer "LOW:HIGH" along the axis that is up.
CellGrid::Layer layer_of(const std::string& text, const UpAxis& up) {
  const std::size_t colon = text.find(':');
  const auto low = parse_number(text.substr(0, colon)),
             high = colon == std::string::npos ? std::nullopt : parse_number(text.substr(colon + 1));
  const auto is_number = [](double x) { return kernel::check(kernel::flushed(x)) == kernel::Refusal::none; };
  if (!low || !high || !is_number(*low) || !is_number(*high) || *low > *high) {
    refuse("--heights", "expected LOW:HIGH, two numbers up to 2^100");
  }
  return {kernel::flushed(*low), kernel::flushed(*high), up.axis, up.is_down};
}

/// The sets are of the polygons of the model's file, or of objects.
struct Items {
  std::uint32_t count;
  std::vector<std::uint32_t> of_polygon;  ///< of each polygon of the tree; `count` if it is in none
};

Items items_of(const culler::Hierarchy& hierarchy, const std::string& objects) {
  Items items{static_cast<std::uint32_t>(hierarchy.face_count()), std::vector<std::uint32_t>(hierarchy.soup().size())};
  for (std::size_t p = 0; p < items.of_polygon.size(); ++p) items.of_polygon[p] = hierarchy.face(p);
  if (objects.empty()) return items;
  const ObjectList list = read_objects(objects, hierarchy.face_count());
  items.count = list.count;
  for (std::uint32_t& item : items.of_polygon) item = list.of_polygon[item];
  return items;
}

/// The box of each polygon of the tree.
std::vector<kernel::Aabb> boxes_of(culler::SoupView soup) {
  std::vector<kernel::Aabb> boxes;
  boxes.reserve(soup.size());
  for (std::size_t p = 0; p < soup.size(); ++p) boxes.push_back(soup.box(p));
  return boxes;
}

/// Bakes groups of cells that lie together. What is hidden from all of them is found at once, and not asked again.
class Baker {
 public:
  Baker(const culler::Culler& culler, const Items& items, std::vector<kernel::Aabb> cells, const BakeArguments& arguments)
      : culler_(culler),
        items_(items),
        cells_(std::move(cells)),
        boxes_(boxes_of(culler.hierarchy().soup())),
        piece_(arguments.piece),
        search_{static_cast<int>(arguments.cover_size), arguments.closer, render::check_interrupt} {
    boxes_.insert(boxes_.end(), cells_.begin(), cells_.end());
    curve_.sort(cells_);
    groups_ = curve_.runs(kOfGroup);
  }

  [[nodiscard]] const std::vector<kernel::Aabb>& cells() const { return cells_; }
  [[nodiscard]] std::size_t groups() const { return groups_.size(); }
  /// The numbers of the cells of a group.
  [[nodiscard]] std::span<const std::uint32_t> group(std::size_t i) const {
    return curve_.order().subspan(groups_[i].first, groups_[i].count);
  }

  /// The cells of a group, in its order.
  [[nodiscard]] std::vector<BakedCell> bake(std::size_t group) const {
    culler::HiddenSearch search(culler_, boxes_, search_);
    Known known = search.nothing();
    if (const auto box = common_box(this->group(group))) search.look_from(*box, known);
    std::vector<BakedCell> baked;
    for (const std::uint32_t cell : this->group(group)) baked.push_back(bake(cell, search, known));
    return baked;
  }

  /// For cells of a group, the claim that what the sets lack is hidden, and what proves it: the searches of bake(),
  /// repeated.
  [[nodiscard]] std::vector<std::string> proofs(const std::vector<std::uint32_t>& of_group,
                                                const std::vector<BakedCell>& baked, std::size_t group) const {
    const culler::Hierarchy& tree = culler_.hierarchy();
    std::vector<std::string> lines;
    std::vector<std::vector<bool>> hidden;  // polygons that are said to be hidden, of each cell, and of any of them
    std::vector<bool> of_any(items_.of_polygon.size());
    for (const std::uint32_t cell : of_group) {
      hidden.push_back(hidden_polygons(baked[cell]));
      std::vector<bool> faces(tree.face_count());
      for (std::size_t p = 0; p < of_any.size(); ++p) {
        if (hidden.back()[p]) of_any[p] = faces[tree.face(p)] = true;
      }
      std::ranges::move(render::claims_from(std::span(&cells_[cell], 1), faces), std::back_inserter(lines));
    }
    kernel::Aabb from{};
    const std::vector<bool>* wanted = &of_any;
    culler::HiddenSearch::Options options = search_;
    options.most_corners = render::kMostCoverVertices;
    options.found = [&](const culler::Camera& picture, std::span<const std::uint32_t> found,
                        std::span<const culler::CoverWitness> covers) {
      std::vector<std::uint32_t> polygons;
      std::ranges::copy_if(found, std::back_inserter(polygons), [&](std::uint32_t p) { return (*wanted)[p]; });
      append_hidden(lines, tree, from, picture, polygons, covers);
    };
    culler::HiddenSearch search(culler_, boxes_, options);
    Known from_all = search.nothing();
    if (const auto box = common_box(this->group(group))) {
      from = *box;
      search.look_from(from, from_all);
    }
    for (std::size_t i = 0; i < of_group.size(); ++i) {
      wanted = &hidden[i];
      for (const kernel::Aabb& piece : pieces_of(cells_[of_group[i]], piece_)) {
        Known known = from_all;
        from = piece;
        search.look_from(piece, known);
      }
    }
    return lines;
  }

 private:
  using Known = culler::HiddenSearch::Known;
  static constexpr std::uint32_t kOfGroup = 16;

  /// The box of several cells, if something is hidden from all of them: hardly anything is where they lie far apart.
  [[nodiscard]] std::optional<kernel::Aabb> common_box(std::span<const std::uint32_t> group) const {
    constexpr double kMostApart = 8;
    kernel::Aabb box = culler::empty_box();
    double longest = 0;
    for (const std::uint32_t cell : group) {
      culler::grow(box, cells_[cell]);
      longest = std::max(longest, culler::length_of(cells_[cell]));
    }
    return group.size() > 1 && culler::length_of(box) <= kMostApart * longest ? std::optional(box) : std::nullopt;
  }

  /// The polygons of the items that the set of the cell lacks.
  [[nodiscard]] std::vector<bool> hidden_polygons(const BakedCell& cell) const {
    const std::vector<bool> seen = members_of(cell.items, items_.count);
    std::vector<bool> hidden(items_.of_polygon.size());
    for (std::size_t p = 0; p < hidden.size(); ++p) {
      const std::uint32_t item = items_.of_polygon[p];
      hidden[p] = item < items_.count && !seen[item];
    }
    return hidden;
  }

  [[nodiscard]] BakedCell bake(std::uint32_t cell, culler::HiddenSearch& search, const Known& hidden_from_all) const {
    std::vector<bool> seen(items_.count + std::size_t{1}), cells(cells_.size());
    cells[cell] = true;
    for (const kernel::Aabb& piece : pieces_of(cells_[cell], piece_)) {
      Known known = hidden_from_all;
      search.look_from(piece, known);
      const std::size_t polygons = items_.of_polygon.size();
      for (std::size_t p = 0; p < polygons; ++p) {
        if (known.is_hidden[p] == 0) seen[items_.of_polygon[p]] = true;
      }
      for (std::size_t other = 0; other < cells_.size(); ++other) {
        if (known.is_hidden[polygons + other] == 0) cells[other] = true;
      }
    }
    seen.pop_back();  // what is in no object
    return {cells_[cell], changes_of(seen), changes_of(cells)};
  }

  const culler::Culler& culler_;
  const Items& items_;
  std::vector<kernel::Aabb> cells_, boxes_;  ///< boxes of polygons, then the cells
  double piece_;
  culler::HiddenSearch::Options search_;
  culler::CurveOrder curve_;  ///< of the cells
  std::vector<culler::ItemRange> groups_;
};

Changes unpacked(render::Unpacker& unpacker, std::size_t count) {
  Changes changes = unpacker.list<std::uint32_t>();
  const bool is_set = changes.size() % 2 == 0 && (changes.empty() || changes.back() <= count) &&
                      std::ranges::adjacent_find(changes, std::greater_equal<>()) == changes.end();
  render::require_part(is_set, "what a cell sees is no set");
  return changes;
}

/// All cells, on the first rank; the others only help.
std::vector<BakedCell> bake_all(render::Job& job, const Baker& baker, std::uint32_t items) {
  constexpr std::size_t kOfPart = 16;
  const std::size_t cells = baker.cells().size();
  render::RangeParts parts(baker.groups(), kOfPart);
  render::Progress progress("cell", cells);
  std::vector<BakedCell> baked(cells);
  std::size_t done = 0;
  const auto work = [&](const std::string& part) {
    const auto [first, end] = parts.of(part);
    std::vector<std::vector<BakedCell>> groups(end - first);
    std::mutex telling;
    std::size_t here = 0;
    const auto bake = [&, first = first](std::size_t i) {
      groups[i] = baker.bake(first + i);
      const std::lock_guard alone(telling);
      progress.update(done + (here += groups[i].size()));
    };
    culler::parallel_for(groups.size(), bake, render::check_interrupt);
    render::Packer packer;
    for (const std::vector<BakedCell>& group : groups) {
      for (const BakedCell& cell : group) packer.put(cell.items).put(cell.cells);
    }
    return packer.bytes();
  };
  const auto take = [&](const std::string& result) {
    render::Unpacker unpacker(result);
    const auto [first, end] = parts.take();
    for (std::size_t group = first; group < end; ++group) {
      for (const std::uint32_t cell : baker.group(group)) {
        Changes seen = unpacked(unpacker, items);
        baked[cell] = {baker.cells()[cell], std::move(seen), unpacked(unpacker, cells)};
        ++done;
      }
    }
    unpacker.finish();
    progress.update(done);
  };
  job.run({[&] { return parts.next(); }, work, take});
  return baked;
}

/// Writes what proves what the sets of a share of the cells lack.
void write_set_proofs(render::OutputFile& file, const Baker& baker, const std::vector<BakedCell>& baked,
                      const ProofArguments& arguments) {
  constexpr std::size_t kTogether = 16;  // groups
  render::Progress progress("proofs, group", baker.groups());
  for (std::size_t first = 0; first < baker.groups(); first += kTogether) {
    std::vector<std::vector<std::string>> lines(std::min(kTogether, baker.groups() - first));
    const auto prove = [&](std::size_t i) {
      std::vector<std::uint32_t> cells;
      std::ranges::copy_if(baker.group(first + i), std::back_inserter(cells),
                           [&](auto cell) { return arguments.has(cell); });
      if (!cells.empty()) lines[i] = baker.proofs(cells, baked, first + i);
    };
    culler::parallel_for(lines.size(), prove, render::check_interrupt);
    for (const std::vector<std::string>& of_group : lines) write_lines(file, of_group);
    progress.update(first + lines.size());
  }
  file.close();
}

std::vector<kernel::Aabb> cells_of(BakeArguments& arguments, const render::ModelFile& model,
                                   const culler::Hierarchy& hierarchy) {
  if (!arguments.heights.empty()) arguments.grid.layer = layer_of(arguments.heights, up_for("--heights", model));
  std::vector<kernel::Aabb> cells;
  try {
    cells = arguments.cells == kGrid ? arguments.grid.cells_of(hierarchy.nodes()[0].box)
            : arguments.cells == kCorridor
                ? arguments.grid.cells_along(way_of_eyes(arguments.path, model, hierarchy.soup()), arguments.reach)
                : read_cells(arguments.cells);
    for (const kernel::Aabb& cell : cells) static_cast<void>(pieces_of(cell, arguments.piece));
  } catch (const std::length_error& error) {
    refuse("--cells", error.what());
  }
  std::ranges::sort(cells, is_before);
  return cells;
}

std::uint64_t hash_of_file(const std::string& file) {
  std::ifstream in(file, std::ios::binary);
  std::string bytes(std::size_t{1} << 20U, '\0');
  std::uint64_t hash = render::kFnvOfNothing;
  while (in.read(bytes.data(), static_cast<std::streamsize>(bytes.size())) || in.gcount() > 0) {
    hash = render::fnv1a(std::string_view(bytes).substr(0, static_cast<std::size_t>(in.gcount())), hash);
  }
  return hash;
}

struct Told {
  std::size_t cells, items, seen = 0, most = 0, bytes = 0;
  double seconds = 0;

  [[nodiscard]] std::string json() const {
    const nlohmann::ordered_json told{{"cells", cells}, {"items", items}, {"seen", seen},
                                      {"most", most},   {"bytes", bytes}, {"seconds", seconds}};
    return told.dump(2) + "\n";
  }
  [[nodiscard]] std::string text(const std::string& file) const {
    const auto per = [](std::size_t sum, std::size_t count) {
      return static_cast<double>(sum) / static_cast<double>(std::max<std::size_t>(count, 1));
    };
    return fmt::format(
        "{}: {} cells, each sees {:.1f} of {} on average, and {} at most; {} bytes, {:.2f} for each of these; {:.1f} s\n",
        file, cells, per(seen, cells), items, most, bytes, per(bytes, seen), seconds);
  }
};

/// The files that are written, on the first rank.
struct Outputs {
  explicit Outputs(const BakeArguments& arguments) : sets(arguments.out) {
    if (!arguments.map.empty()) map.emplace(arguments.map);
    if (!arguments.proofs.file.empty()) proofs.emplace(arguments.proofs.file);
  }

  render::OutputFile sets;
  std::optional<render::OutputFile> map, proofs;
};

/// Writes what was baked.
Told write(Outputs& outputs, const VisibleSets& sets, const std::optional<UpAxis>& up) {
  Told told{sets.cells.size(), sets.items};
  std::vector<MapCell> map;
  for (const BakedCell& cell : sets.cells) {
    map.push_back({cell.box, size_of(cell.items)});
    told.seen += map.back().number;
    told.most = std::max(told.most, map.back().number);
  }
  told.bytes = write_visible_sets(outputs.sets, sets);
  if (outputs.map) {
    render::write_png(*outputs.map, map_of(map, *up));
    outputs.map->close();
  }
  outputs.sets.commit();
  if (outputs.map) outputs.map->commit();
  if (outputs.proofs) outputs.proofs->commit();
  return told;
}

void bake(BakeArguments& arguments) {
  std::optional<Outputs> outputs;
  if (render::is_first_rank()) outputs.emplace(arguments);
  render::WalkOptions walk;
  walk.read = arguments.read.options(arguments.model);
  walk.cull.method = culler::Method::cover;
  walk.build.hierarchy.leaf_size = leaf_size_for(culler::Method::cover);
  const render::ModelFile model = open_model(arguments.model, walk);
  const auto up = arguments.map.empty() ? std::nullopt : std::optional(up_for("--map", model));
  const culler::Culler culler = render::make_culler(model, walk);
  const Items items = items_of(culler.hierarchy(), arguments.objects);
  std::vector<kernel::Aabb> cells = cells_of(arguments, model, culler.hierarchy());
  const std::uint64_t hash = hash_of_file(arguments.model);
  render::Job job(arguments.parts.keeping(), [&] {
    const std::span<const kernel::Aabb> boxes = cells;
    const std::span<const std::uint32_t> of_polygon = items.of_polygon;
    render::Digest digest;
    add(digest.add(arguments.given).add(std::to_string(hash)), culler.hierarchy().soup());
    return digest.add(boxes).add(of_polygon).value();
  });
  const render::Stopwatch stopwatch;
  culler.prepare(culler::Method::cover, render::check_interrupt);
  const Baker baker(culler, items, std::move(cells), arguments);
  VisibleSets sets{hash, items.count, bake_all(job, baker, items.count)};
  if (!outputs) return;
  make_mutual(sets.cells);
  if (outputs->proofs) write_set_proofs(*outputs->proofs, baker, sets.cells, arguments.proofs);
  Told told = write(*outputs, sets, up);
  told.seconds = stopwatch.seconds();
  job.finish();
  arguments.json ? render::print(told.json()) : render::tell(told.text(arguments.out));
}

}  // namespace

void add_bake(Command app, int&) {
  Command command = app.add_command("bake", "Make visible sets: what is seen from anywhere in each of many cells");
  command.footer(
      "A set has what may be seen from a cell. What is not in it is hidden from every eye in the cell, in all directions.\n"
      "It also has the other cells of which something may be seen. docs/bake.md has the layout of the file, and programs\n"
      "that read it.\n" +
      limits_help() +
      "\n"
      "Example: occlude bake city.ply --cells corridor --path city.json --cell-size 2 --heights 1:3 --out city.pvs\n"
      "Example: occlude bake house.glb --cells rooms.json --objects furniture.json --out house.pvs");
  const auto a = std::make_shared<BakeArguments>();
  add_input(command, "MODEL", a->model, "PLY, OBJ, glTF, COLLADA, STL, ..., or a store").required();
  command
      .add("--cells", a->cells,
           "grid: the fewest cubes that cover the box of the model; corridor: those along a path; or a JSON file of boxes")
      .required()
      .check(check_named)
      .each([](const std::string& cells) {
        if (cells != kGrid && cells != kCorridor) render::keep_input(cells);
      });
  add_output(command, "--out", a->out, "file to write").required();
  add_output(command, "--map", a->map,
             "PNG of the cells from above, from dark blue over red to yellow by how much each sees", ".png");
  const Option size =
      command.add("--cell-size", a->grid.size, "side of a cube, in units of the model").show_default().in_range(1e-6, 1e9);
  const Option heights = command.add("--heights", a->heights, "LOW:HIGH: one layer of cells, from and to these heights");
  a->path.add_to(command, "of --cells corridor");
  const Option reach = command.add("--reach", a->reach, "how far to each side of its path a corridor has cells")
                           .show_default()
                           .in_range(0.0, 1e9);
  add_input(command, "--objects", a->objects,
            "JSON file of objects, for sets of objects and not of polygons: for each a list of polygons and ranges [first, "
            "count]");
  a->read.add_to(command);
  command.under(kTuning, [&] {
    command.add("--piece", a->piece, "cells are culled in pieces of at most this side: smaller ones may hide more")
        .show_default()
        .in_range(1e-6, 1e9);
    command.add("--cover-size", a->cover_size, "side of the coarse pictures in pixels: larger ones hide more")
        .show_default()
        .in_range(std::size_t{culler::kLeastCoverSide}, std::size_t{culler::kMostCoverSide});
    command
        .add("--closer", a->closer,
             "pictures of parts of what is seen are made where this share of it is: smaller ones leave out more, and take "
             "longer")
        .show_default()
        .in_range(1e-6, 1.0);
  });
  a->proofs.add_to(command, "the cells");
  command.add_flag("--json", a->json, "print the counts as JSON");
  a->parts.add_to(command, "bake");
  command.run_on_all_ranks([=] {
    const bool is_corridor = a->cells == kCorridor, are_cubes = is_corridor || a->cells == kGrid;
    for (const Option& option : {size, heights, reach}) {
      if (option.is_given() && !(option.name() == reach.name() ? is_corridor : are_cubes)) {
        refuse(option.name(), "does nothing with --cells " + a->cells);
      }
    }
    if (a->path.is_given() && !is_corridor) refuse("--path", "does nothing with --cells " + a->cells);
    a->given = command.given_but(
        {"MODEL", "--out", "--map", "--witness", "--witness-share", "--json", "--quiet", "--parts", "--resume"});
    bake(*a);
  });
}

}  // namespace occlude::cli
