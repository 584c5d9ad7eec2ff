// SPDX-License-Identifier: MIT
// The parts of a hierarchy, and the checks of parts that are said to be of one.
#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>
#include <stdexcept>
#include <string_view>
#include <vector>

#include "base/part_checks.h"
#include "model/bounds.h"
#include "model/legal_soup.h"
#include "model/part_list.h"
#include "occlude/culler/hierarchy.h"

namespace occlude::culler {
namespace {

constexpr std::string_view kTreeVertices = "vertices", kTreeIndices = "indices", kTreeFirst = "first", kTreeOrder = "order",
                           kTreeFaces = "faces", kTreeSeeThrough = "see-through", kTreeNodes = "nodes",
                           kTreeOrientedBoxes = "oriented boxes", kTreeOriented = "oriented";
constexpr std::array kTreeParts{kTreeVertices,   kTreeIndices, kTreeFirst,         kTreeOrder,   kTreeFaces,
                                kTreeSeeThrough, kTreeNodes,   kTreeOrientedBoxes, kTreeOriented};

/// The soup where its parts lie.
SharedSoup soup_of(const PartReader& parts, const Checkpoint& checkpoint) {
  const auto vertices = parts.get<glm::dvec3>(kTreeVertices);
  const auto indices = parts.get<std::uint32_t>(kTreeIndices), first = parts.get<std::uint32_t>(kTreeFirst);
  const SoupView soup{vertices, indices, first, {}, parts.get<std::uint8_t>(kTreeSeeThrough)};
  if (!is_legal(soup, checkpoint)) require_legal(soup);
  if (soup.empty()) throw std::invalid_argument("the soup has no polygon");
  return {soup, parts.keep()};
}

bool is_permutation(const Array<std::uint32_t>& order, std::size_t size) {
  std::vector<bool> is_there(size);
  for (const std::uint32_t i : order) {
    if (i >= size || is_there[i]) return false;
    is_there[i] = true;
  }
  return order.size() == size;
}

/// Whether the nodes are depth-first and divide `count` polygons among them, so that no node has none. Throws
/// std::invalid_argument if they are deeper than kMostLevels.
bool are_tree(std::span<const HierarchyNode> nodes, std::size_t count) {
  /// A subtree that is still to come: its polygons, its depth, and the node whose right child it is, or kNoParent.
  struct Pending {
    std::uint32_t first, count, depth;
    std::size_t parent;
  };
  constexpr std::size_t kNoParent = std::numeric_limits<std::size_t>::max();
  std::vector<Pending> pending{{0, static_cast<std::uint32_t>(count), 0, kNoParent}};
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    if (pending.empty()) return false;
    const Pending at = pending.back();
    pending.pop_back();
    const HierarchyNode& node = nodes[i];
    if (node.first != at.first || node.count != at.count) return false;
    if (at.parent != kNoParent && nodes[at.parent].right != i) return false;
    if (node.is_leaf()) continue;
    if (at.depth == kMostLevels) refuse_depth(kTreeNodes);
    if (i + 1 == nodes.size()) return false;
    const std::uint32_t left = nodes[i + 1].count;
    if (left == 0 || left >= at.count) return false;
    pending.push_back({at.first + left, at.count - left, at.depth + 1, i});
    pending.push_back({at.first, left, at.depth + 1, kNoParent});
  }
  return pending.empty();
}

/// The smallest box that holds the polygons of a node, if those of its children are such boxes. REQUIRES: are_tree().
kernel::Aabb smallest_box(SoupView soup, std::span<const HierarchyNode> nodes, std::size_t i) {
  kernel::Aabb box = empty_box();
  const HierarchyNode& node = nodes[i];
  if (node.is_leaf()) {
    for (std::size_t s = soup.first[node.first]; s < soup.first[std::size_t{node.first} + node.count]; ++s) {
      grow(box, to_kernel(soup.vertices[soup.indices[s]]));
    }
  } else {
    grow(box, nodes[i + 1].box);
    grow(box, nodes[node.right].box);
  }
  return box;
}

}  // namespace

bool Hierarchy::is_part(std::string_view name) { return std::ranges::find(kTreeParts, name) != kTreeParts.end(); }

void Hierarchy::append_parts(PartWriter& parts) const {
  parts.put(kTreeVertices, soup().vertices);
  parts.put(kTreeIndices, soup().indices);
  parts.put(kTreeFirst, soup().first);
  parts.put(kTreeOrder, order_);
  parts.put(kTreeFaces, faces_);
  parts.put(kTreeSeeThrough, soup().see_through);
  parts.put(kTreeNodes, nodes_);
  parts.put(kTreeOrientedBoxes, oriented_boxes_);
  parts.put(kTreeOriented, oriented_);
}

Hierarchy Hierarchy::from_parts(const PartReader& parts, const Config& config, const Checkpoint& checkpoint) {
  Hierarchy result;
  result.soup_ = soup_of(parts, checkpoint);
  result.leaf_size_ = config.leaf_size;
  result.order_ = parts.get<std::uint32_t>(kTreeOrder);
  result.faces_ = parts.get<std::uint32_t>(kTreeFaces);
  result.nodes_ = parts.get<Node>(kTreeNodes);
  result.oriented_boxes_ = parts.get<kernel::Obb>(kTreeOrientedBoxes);
  result.oriented_ = parts.get<std::uint32_t>(kTreeOriented);

  const SoupView& soup = result.soup();
  if (!is_permutation(result.order_, soup.size())) refuse_part(kTreeOrder, "it does not number the polygons");
  if (!are_faces(result.faces_, soup.size())) refuse_part(kTreeFaces, "it does not number the faces");
  const auto nodes = result.nodes();
  if (!are_tree(nodes, soup.size())) refuse_part(kTreeNodes, "it is not a tree of these polygons");
  const auto is_smallest = [&](std::size_t i) { return nodes[i].box == smallest_box(soup, nodes, i); };
  if (!are_all(nodes.size(), is_smallest, checkpoint)) refuse_part(kTreeNodes, "a box is not that of its polygons");
  const auto& boxes = result.oriented_boxes_;
  const auto is_box = [&](std::uint32_t i) { return i == kNone || i < boxes.size(); };
  if (result.oriented_.size() != (config.bounds == Bounds::obb ? nodes.size() : 0) ||
      !std::ranges::all_of(result.oriented_, is_box)) {
    refuse_part(kTreeOriented, "it does not number the oriented boxes");
  }
  const auto is_legal = [](const kernel::Obb& box) { return kernel::check(box) == kernel::Refusal::none; };
  if (!std::ranges::all_of(boxes, is_legal)) refuse_part(kTreeOrientedBoxes, "a box is not legal");
  return result;
}

}  // namespace occlude::culler
