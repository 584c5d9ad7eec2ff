// SPDX-License-Identifier: MIT
#include "gltf_nodes.h"

#include <fmt/format.h>

#include <algorithm>
#include <glm/gtc/type_ptr.hpp>
#include <iterator>

#include "gltf_transform.h"

namespace occlude::render::gltf {
namespace {

glm::dvec3 vec3_in(const json& node, const char* name, double otherwise) {
  const auto numbers = find_numbers(node, name, 3);
  return numbers ? glm::make_vec3(numbers->data()) : glm::dvec3(otherwise);
}

glm::dmat4 local_matrix(const json& node) {
  if (const auto matrix = matrix_of(node)) {
    const glm::dmat4& m = *matrix;
    if (glm::dvec4(m[0].w, m[1].w, m[2].w, m[3].w) != glm::dvec4(0, 0, 0, 1))
      refuse("matrix: its last row is not 0, 0, 0, 1");
    return m;
  }
  return placement(translation_of(node), rotation_of(node), scale_of(node));
}

bool is_visible(const json& node) {
  const json* const visibility = find_extension(node, "KHR_node_visibility");
  return visibility == nullptr || flag_in(*visibility, "visible", true);
}

}  // namespace

glm::dvec3 translation_of(const json& node) { return vec3_in(node, "translation", 0); }
glm::dvec3 scale_of(const json& node) { return vec3_in(node, "scale", 1); }

glm::dvec4 rotation_of(const json& node) {
  const auto rotation = find_numbers(node, "rotation", 4);
  return rotation ? glm::make_vec4(rotation->data()) : glm::dvec4(0, 0, 0, 1);
}

std::optional<glm::dmat4> matrix_of(const json& node) {
  const auto matrix = find_numbers(node, "matrix", 16);
  return matrix ? std::optional<glm::dmat4>(glm::make_mat4(matrix->data())) : std::nullopt;
}

Nodes::Nodes(const Document& document) : document_(document), nodes_(document.count(kNodes)) {
  for (std::uint64_t i = 0; i < nodes_.size(); ++i) {
    at([&] { return document_.label(kNodes, i); }, [&] { read(i); });
  }
  const std::vector<std::uint64_t> all = trees_of(roots());
  // Parents come first.
  std::vector<bool> is_in_tree(nodes_.size());
  for (const std::uint64_t index : all) {
    const Node& node = nodes_[index];
    is_in_tree[index] = true;
    for (const std::uint64_t child : node.children) {
      nodes_[child].world = node.world * nodes_[child].world;
      nodes_[child].is_visible = nodes_[child].is_visible && node.is_visible;
    }
  }
  const auto lost = std::ranges::find(is_in_tree, false);
  if (lost != is_in_tree.end()) refuse(fmt::format("node {}: it is below itself", lost - is_in_tree.begin()));
}

void Nodes::read(std::uint64_t index) {
  const json& node = document_.item(kNodes, index);
  nodes_[index].world = local_matrix(node);
  nodes_[index].is_visible = is_visible(node);
  nodes_[index].children = listed_in(node, "children");
  for (const std::uint64_t child : nodes_[index].children) {
    if (nodes_[child].has_parent) refuse(fmt::format("children: node {} has another parent", child));
    nodes_[child].has_parent = true;
  }
}

std::vector<std::uint64_t> Nodes::listed_in(const json& object, const char* name) const {
  std::vector<std::uint64_t> indices;
  for (const json& index : array_in(object, name)) {
    if (!index.is_number_unsigned()) refuse(fmt::format("{}: expected an array of indices", name));
    indices.push_back(index.get<std::uint64_t>());
    if (indices.back() >= nodes_.size())
      refuse(fmt::format("{}: node {}: there are {}", name, indices.back(), nodes_.size()));
  }
  return indices;
}

std::vector<std::uint64_t> Nodes::shown() const {
  const auto scene = find_whole(document_.root(), "scene");
  std::vector<std::uint64_t> shown = trees_of(scene ? roots_of_scene(*scene) : roots());
  std::erase_if(shown, [&](std::uint64_t index) { return !nodes_[index].is_visible; });
  return shown;
}

std::vector<std::uint64_t> Nodes::roots() const {
  std::vector<std::uint64_t> roots;
  for (std::uint64_t i = 0; i < nodes_.size(); ++i) {
    if (!nodes_[i].has_parent) roots.push_back(i);
  }
  return roots;
}

std::vector<std::uint64_t> Nodes::roots_of_scene(std::uint64_t scene) const {
  const json& item = document_.item(kScenes, scene);
  return at([&] { return document_.label(kScenes, scene); },
            [&] {
              std::vector<std::uint64_t> roots = listed_in(item, "nodes");
              std::vector<bool> is_listed(nodes_.size());
              for (const std::uint64_t root : roots) {
                if (nodes_[root].has_parent) refuse(fmt::format("nodes: node {} has a parent", root));
                if (is_listed[root]) refuse(fmt::format("nodes: node {} is listed twice", root));
                is_listed[root] = true;
              }
              return roots;
            });
}

std::vector<std::uint64_t> Nodes::trees_of(const std::vector<std::uint64_t>& roots) const {
  // An explicit stack: the file decides how deep the trees are.
  std::vector<std::uint64_t> stack(roots.rbegin(), roots.rend()), order;
  while (!stack.empty()) {
    const std::uint64_t index = stack.back();
    stack.pop_back();
    order.push_back(index);
    std::ranges::reverse_copy(nodes_[index].children, std::back_inserter(stack));
  }
  return order;
}

}  // namespace occlude::render::gltf
