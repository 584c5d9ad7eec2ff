// SPDX-License-Identifier: MIT
// occlude prune: the model without what is never seen.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <iterator>
#include <map>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "base/parallel.h"
#include "cells.h"
#include "command_arguments.h"
#include "commands.h"
#include "enclosed.h"
#include "hidden_proofs.h"
#include "model/bounds.h"
#include "never_seen.h"
#include "occlude/culler/culler.h"
#include "occlude/kernel/validity.h"
#include "occlude/render/console.h"
#include "occlude/render/errors.h"
#include "occlude/render/hidden_witness.h"
#include "occlude/render/interrupt.h"
#include "occlude/render/model_parts.h"
#include "occlude/render/printable.h"
#include "occlude/render/progress.h"
#include "occlude/render/witness.h"
#include "path_arguments.h"

namespace occlude::cli {
namespace {

namespace fs = std::filesystem;
using render::ModelPart;

constexpr const char *kOutside = "outside", *kCells = "cells", *kPath = "path";

struct PruneArguments {
  std::string model, out, from, cells;
  std::vector<std::string> keep;
  double reach = 0.5;
  bool touching = false;
  SearchOptions search;
  ReadArguments read;
  PathArguments path;
  ProofArguments proofs;
  bool json = false;
};

/// The sides of a box around the model: flat cells that every line of sight from outside of the model's hull crosses. Behind
/// an eye out there, there is nothing: what it sees is seen from any other place on the line farther out. So cells may be
/// far away, where they cost less.
std::vector<kernel::Aabb> cells_outside(const kernel::Aabb& box) {
  std::vector<kernel::Aabb> cells(6, box);
  for (std::size_t i = 0; i < 6; ++i) {
    const int axis = static_cast<int>(i / 2);
    (i % 2 == 0 ? cells[i].min[axis] : cells[i].max[axis]) = i % 2 == 0 ? box.max[axis] : box.min[axis];
  }
  return cells;
}

/// A box around that of the model, as far from it as the model is long.
kernel::Aabb box_around(const kernel::Aabb& box) {
  const double longest = culler::length_of(box);
  kernel::Aabb grown = box;
  for (int axis = 0; axis < 3; ++axis) {
    grown.min[axis] = kernel::flushed(box.min[axis] - longest);
    grown.max[axis] = kernel::flushed(box.max[axis] + longest);
  }
  return grown;
}

/// Boxes of all eyes no farther than `reach`, along each axis, from the way from each frame's eye to the next.
std::vector<kernel::Aabb> cells_along(const render::CameraPath& path, double reach) {
  std::vector<kernel::Aabb> cells;
  glm::dvec3 last = path.camera(0, 1).eye;
  const auto around = [&](const glm::dvec3& a, const glm::dvec3& b) {
    kernel::Aabb box;
    for (int axis = 0; axis < 3; ++axis) {
      box.min[axis] = kernel::flushed(std::min(a[axis], b[axis]) - reach);
      box.max[axis] = kernel::flushed(std::max(a[axis], b[axis]) + reach);
    }
    return box;
  };
  glm::dvec3 begin = last;
  for (std::size_t frame = 1; frame < path.frames; ++frame) {
    last = path.camera(frame, 1).eye;
    cells.push_back(around(begin, last));
    begin = last;
  }
  if (cells.empty()) cells.push_back(around(last, last));
  return cells;
}

/// What is left out of the faces of a file.
struct Cut {
  std::vector<bool> gone;
  std::size_t kept_by_name = 0;  ///< faces that are never seen, and stay
  std::size_t fixed = 0, shared = 0;
};

Cut cut_of(const std::vector<ModelPart>& parts, std::vector<bool> gone, const std::vector<std::string>& keep) {
  Cut cut;
  const auto stay = [&](const ModelPart& part, std::size_t& count) {
    const auto first = gone.begin() + static_cast<std::ptrdiff_t>(part.first),
               end = first + static_cast<std::ptrdiff_t>(part.count);
    count += static_cast<std::size_t>(std::count(first, end, true));
    std::fill(first, end, false);
  };
  std::set<std::string> missing(keep.begin(), keep.end());
  std::map<std::uint64_t, std::vector<const ModelPart*>> shapes;
  for (const ModelPart& part : parts) {
    shapes[part.shape].push_back(&part);
    for (const std::string& name : part.names) missing.erase(name);
    if (part.is_fixed) stay(part, cut.fixed);
    const auto is_named = [&](const std::string& name) { return std::ranges::count(keep, name) != 0; };
    if (std::ranges::any_of(part.names, is_named)) stay(part, cut.kept_by_name);
  }
  if (!missing.empty()) refuse("--keep", "nothing in the model has the name " + *missing.begin());
  const std::vector<bool> goes = render::owners_gone(parts, gone);
  for (auto& [shape, same] : shapes) {
    std::erase_if(same, [&](const ModelPart* part) { return goes[part->owner]; });
    for (std::uint64_t i = 0; same.size() > 1 && i < same.front()->count; ++i) {
      const auto is_gone = [&](const ModelPart* part) { return gone[part->first + i]; };
      if (std::ranges::all_of(same, is_gone)) continue;
      for (const ModelPart* part : same) {
        cut.shared += gone[part->first + i] ? 1 : 0;
        gone[part->first + i] = false;
      }
    }
  }
  cut.gone = std::move(gone);
  return cut;
}

/// The faces of what has one name.
struct Row {
  std::string node;
  std::size_t faces = 0, gone = 0;
};

std::vector<Row> rows_of(const std::vector<ModelPart>& parts, const Cut& cut) {
  std::vector<Row> rows;
  std::map<std::string, std::size_t> places;
  for (const ModelPart& part : parts) {
    const auto [place, is_new] = places.emplace(part.node, rows.size());
    if (is_new) rows.push_back({part.node});
    Row& row = rows[place->second];
    row.faces += part.count;
    const auto first = cut.gone.begin() + static_cast<std::ptrdiff_t>(part.first);
    row.gone += static_cast<std::size_t>(std::count(first, first + static_cast<std::ptrdiff_t>(part.count), true));
  }
  return rows;
}

std::string to_json(const Cut& cut, const std::vector<Row>& rows) {
  nlohmann::ordered_json told{{"faces", cut.gone.size()},
                              {"gone", std::ranges::count(cut.gone, true)},
                              {"kept_by_name", cut.kept_by_name},
                              {"kept_for_other_instances", cut.shared},
                              {"kept_as_they_cannot_go", cut.fixed},
                              {"nodes", nlohmann::ordered_json::array()}};
  for (const Row& row : rows) told["nodes"].push_back({{"node", row.node}, {"faces", row.faces}, {"gone", row.gone}});
  return told.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + "\n";
}

std::string to_text(const std::string& file, const Cut& cut, const std::vector<Row>& rows) {
  std::string text = fmt::format("{}: {} of {} faces are gone\n", file, std::ranges::count(cut.gone, true), cut.gone.size());
  for (const Row& row : rows) {
    if (row.gone != 0 && !row.node.empty())
      text += fmt::format("  {}: {} of {}\n", render::printable(row.node), row.gone, row.faces);
  }
  const auto add = [&](std::size_t count, const char* why) {
    if (count != 0) text += fmt::format("{} more are never seen, and stay: {}\n", count, why);
  };
  add(cut.kept_by_name, "--keep");
  add(cut.shared, "other nodes show the same mesh, and something of them is seen there");
  add(cut.fixed, "they are compressed by Draco, in strips, or shown by what is not shown now");
  return text;
}

std::string extension_of(const fs::path& file) { return file.extension().string(); }

/// The polygons of the tree that are never seen.
struct Unseen {
  Enclosed enclosed;  ///< from outside
  NeverSeen others;

  [[nodiscard]] bool has(std::size_t p) const { return enclosed.polygons[p] || others.polygons[p]; }
};

Unseen find_unseen(const PruneArguments& arguments, const culler::Culler& culler, const std::vector<kernel::Aabb>& cells) {
  const culler::Hierarchy& tree = culler.hierarchy();
  Unseen unseen{{std::vector<bool>(tree.soup().size()), {}, {}}, {}};
  std::optional<render::ShownStage> stage("looking for closed shells");
  if (arguments.from == kOutside) unseen.enclosed = enclosed_polygons(tree, arguments.touching, render::check_interrupt);
  std::vector<bool> candidates = unseen.enclosed.polygons;
  candidates.flip();
  culler.prepare(culler::Method::cover, render::check_interrupt);
  stage.emplace("looking from each cell");
  render::Watch watch("cells, part");
  const auto progress = [&](std::size_t done, std::size_t all) {
    stage.reset();
    watch(done, all);
  };
  unseen.others = never_seen(culler, cells, candidates, arguments.search, progress);
  return unseen;
}

/// A share of the faces that go.
std::vector<bool> chosen_faces(const std::vector<bool>& gone, const ProofArguments& proofs) {
  std::vector<bool> faces(gone.size());
  std::size_t number = 0;
  for (std::size_t i = 0; i < gone.size(); ++i) faces[i] = gone[i] && proofs.has(number++);
  return faces;
}

/// What proves that triangles of these faces are inside of closed shells. A shell is named again for as many triangles as it
/// has polygons.
std::vector<std::string> proofs_by_shells(const culler::Hierarchy& tree, const Enclosed& enclosed,
                                          const std::vector<bool>& faces) {
  constexpr std::size_t kLeast = 1024;
  std::vector<std::vector<culler::FanTriangle>> inside(enclosed.shells.size());
  for (const auto& [triangle, shell] : enclosed.triangles) {
    if (faces[tree.face(triangle.polygon)]) inside[shell].push_back(triangle);
  }
  std::vector<std::string> lines;
  for (std::size_t shell = 0; shell < inside.size(); ++shell) {
    const std::span<const culler::FanTriangle> all = inside[shell];
    const std::size_t of_line = std::clamp(enclosed.shells[shell].size(), kLeast, render::kMostInLine);
    for (std::size_t i = 0; i < all.size(); i += of_line) {
      lines.push_back(
          render::shell_witness(tree, all.subspan(i, std::min(of_line, all.size() - i)), enclosed.shells[shell]));
    }
  }
  return lines;
}

/// What proves that polygons of these faces are hidden from the cell of a look: its culls, repeated.
std::vector<std::string> proofs_of_look(const Look& look, const culler::Culler& culler, const culler::CullOptions& cull,
                                        const std::vector<bool>& faces) {
  const culler::Hierarchy& tree = culler.hierarchy();
  std::vector<std::uint32_t> wanted;
  std::ranges::copy_if(look.hidden, std::back_inserter(wanted), [&](std::uint32_t p) { return faces[tree.face(p)]; });
  std::vector<std::string> lines;
  for (const culler::Camera& camera : look.cameras) {
    if (wanted.empty()) break;
    culler::View view;
    const culler::CullResult& frame = culler.cull(camera, cull, view);
    const std::vector<culler::CoverWitness> covers = render::covers_of(culler, camera, frame, cull);
    append_hidden(lines, tree, look.cell, camera, wanted, covers);
    for (const culler::CoverWitness& cover : covers) {
      const auto [first, count] = cover.range;
      wanted.erase(std::ranges::lower_bound(wanted, first), std::ranges::lower_bound(wanted, first + count));
    }
  }
  return lines;
}

/// Writes what proves that a share of what goes is never seen.
void write_prune_proofs(render::OutputFile& file, const PruneArguments& arguments, const culler::Culler& culler,
                        const std::vector<kernel::Aabb>& cells, const Unseen& unseen, const std::vector<bool>& gone) {
  const culler::Hierarchy& tree = culler.hierarchy();
  const std::vector<bool> faces = chosen_faces(gone, arguments.proofs);
  const bool is_outside = arguments.from == kOutside;
  write_lines(file, is_outside ? render::claims_outside(box_around(tree.nodes()[0].box), arguments.touching, faces)
                               : render::claims_from(cells, faces));
  write_lines(file, proofs_by_shells(tree, unseen.enclosed, faces));
  constexpr std::size_t kTogether = 64;
  const culler::CullOptions cull = cull_options_of(arguments.search);
  const std::vector<Look>& looks = unseen.others.looks;
  render::Progress progress("proofs, cull", looks.size());
  for (std::size_t first = 0; first < looks.size(); first += kTogether) {
    std::vector<std::vector<std::string>> lines(std::min(kTogether, looks.size() - first));
    const auto prove = [&](std::size_t i) { lines[i] = proofs_of_look(looks[first + i], culler, cull, faces); };
    culler::parallel_for(lines.size(), prove, render::check_interrupt);
    for (const std::vector<std::string>& of_look : lines) write_lines(file, of_look);
    progress.update(first + lines.size());
  }
  file.close();
}

void prune(PruneArguments& arguments) {
  if (extension_of(arguments.out) != extension_of(arguments.model)) refuse("--out", "expected the format of the model");
  if ((arguments.from == kCells) != !arguments.cells.empty()) refuse("--cells", "goes with --from cells");
  if (arguments.touching && arguments.from != kOutside) refuse("--touching", "goes with --from outside");
  render::OutputFile file(arguments.out);
  std::optional<render::OutputFile> proofs;
  if (!arguments.proofs.file.empty()) proofs.emplace(arguments.proofs.file);
  const render::FileParts parts = render::parts_of(arguments.model);
  render::WalkOptions walk;
  walk.read = arguments.read.options(arguments.model);
  walk.cull.method = culler::Method::cover;
  walk.build.hierarchy.leaf_size = 1;  // polygon by polygon
  render::ModelFile model = open_model(arguments.model, walk);
  std::vector<kernel::Aabb> cells;
  if (arguments.from == kPath) cells = cells_along(way_of_eyes(arguments.path, model, *model.soup), arguments.reach);
  if (arguments.from == kCells) cells = read_cells(arguments.cells);
  const culler::Culler culler = render::make_culler(std::move(model), walk);
  const culler::Hierarchy& tree = culler.hierarchy();
  if (arguments.from == kOutside) cells = cells_outside(box_around(tree.nodes()[0].box));

  arguments.search.keeps_looks = proofs.has_value();
  const Unseen unseen = find_unseen(arguments, culler, cells);
  std::vector<bool> gone(tree.face_count(), true);
  for (std::size_t p = 0; p < tree.soup().size(); ++p) {
    if (!unseen.has(p)) gone[tree.face(p)] = false;
  }
  const Cut cut = cut_of(parts.parts, std::move(gone), arguments.keep);
  if (std::ranges::count(cut.gone, false) == 0) refuse("--from", "nothing of the model is seen from there");
  if (proofs) write_prune_proofs(*proofs, arguments, culler, cells, unseen, cut.gone);
  file.write(render::without_faces(arguments.model, cut.gone));
  file.close();
  file.commit();
  if (proofs) proofs->commit();
  if (!parts.files.empty() &&
      !fs::equivalent(fs::absolute(arguments.out).parent_path(), fs::absolute(arguments.model).parent_path())) {
    warn(arguments.out, fmt::format("it names files that lie beside {}: {}", arguments.model, fmt::join(parts.files, ", ")));
  }
  if (parts.has_motion) warn(arguments.model, "it has animations, and was taken as it is at rest");
  const std::vector<Row> rows = rows_of(parts.parts, cut);
  arguments.json ? render::print(to_json(cut, rows)) : render::tell(to_text(arguments.out, cut, rows));
}

}  // namespace

void add_prune(Command app, int&) {
  Command command = app.add_command("prune", "Write a model again, without the polygons that are never seen");
  command.footer(
      "Each polygon that goes is hidden from every eye that --from names, exactly, by polygons with two opaque sides; with\n"
      "--touching, but for points of its borders that are on others. The rest of the file stays as it is. Some polygons "
      "stay\n"
      "though they are hidden: docs/prune.md.\n" +
      limits_help() +
      "\n"
      "Example: occlude prune engine.glb --from outside --out shell.glb --keep label\n"
      "Example: occlude prune city.ply --from path --path drive.json --reach 2 --out drive.ply");
  const auto a = std::make_shared<PruneArguments>();
  add_input(command, "MODEL", a->model, "PLY, OBJ or glTF").required();
  command
      .add("--from", a->from,
           "outside: all eyes outside of the model's convex hull; path: those near a camera path; cells: those in boxes")
      .required()
      .one_of({kOutside, kPath, kCells});
  add_output(command, "--out", a->out, "file to write, of the same format").required();
  command.add_flag("--touching", a->touching,
                   "of --from outside: walls go, too, of which nothing is seen but edges that they share with what stays");
  command.add("--keep", a->keep, "name of a node, mesh, object, group or material of which all stays; may be repeated");
  add_input(command, "--cells", a->cells, "JSON file of boxes, as of bake");
  a->path.add_to(command, "of --from path");
  const Option reach =
      command.add("--reach", a->reach, "how far eyes of --from path are from its way at most, along each axis")
          .show_default()
          .in_range(0.0, 1e9);
  a->read.add_to(command);
  command.under(kTuning, [&] {
    command.add("--rays", a->search.rays, "rays to each polygon from random eyes: what one reaches is not looked at further")
        .show_default()
        .in_range(std::size_t{0}, std::size_t{1000000});
    command
        .add("--effort", a->search.effort,
             "culls of smaller parts of cells in all, at most, once each was asked: more find more")
        .show_default()
        .in_range(std::size_t{0}, std::size_t{1000000});
    command.add("--cover-size", a->search.cover_size, "side of the coarse pictures in pixels: larger ones hide more")
        .show_default()
        .in_range(std::size_t{culler::kLeastCoverSide}, std::size_t{culler::kMostCoverSide});
  });
  a->proofs.add_to(command, "the polygons that go");
  command.add_flag("--json", a->json, "print the counts as JSON");
  command.run([=] {
    if (a->from != kPath && (a->path.is_given() || reach.is_given())) {
      refuse(a->path.is_given() ? "--path" : "--reach", "goes with --from path");
    }
    prune(*a);
  });
}

}  // namespace occlude::cli
