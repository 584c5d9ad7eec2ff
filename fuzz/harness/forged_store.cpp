// SPDX-License-Identifier: MIT
#include "forged_store.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <fstream>
#include <iterator>
#include <limits>
#include <numeric>
#include <span>
#include <utility>

#include "differential/small_scenes.h"
#include "frusta/convex_regions.h"
#include "frusta/partition.h"
#include "model/bounds.h"
#include "occlude/culler/culler.h"
#include "occlude/render/output_file.h"
#include "occlude/render/store.h"
#include "scratch_file.h"
#include "store_parts.h"

namespace occlude::harness {
namespace {

using culler::HierarchyNode;
using culler::Partition;
using culler::RegionKind;
using fuzz::Random;
using U32 = std::uint32_t;
using U64 = std::uint64_t;

std::vector<std::byte> written(const culler::Culler& culler) {
  const ScratchFile file({}, ".sound.store");
  render::OutputFile output(file.path());
  write_store(output, culler);
  output.commit();
  std::ifstream in(file.path(), std::ios::binary);
  const std::vector<char> bytes(std::istreambuf_iterator<char>(in), {});
  const auto as_bytes = std::as_bytes(std::span(bytes));
  return {as_bytes.begin(), as_bytes.end()};
}

culler::BuildConfig some_config(Random& random) {
  culler::BuildConfig config;
  config.hierarchy.leaf_size = static_cast<U32>(random.integer(1, 4));
  config.hierarchy.bounds = random.chance(0.1) ? culler::Bounds::obb : culler::Bounds::aabb;
  config.lists.kind = random.chance(0.5) ? RegionKind::grid : RegionKind::tree;
  config.lists.threshold = 0.05;
  config.lists.regions = 8;
  return config;
}

/// Sound, and many polygons for its size.
culler::PolygonSoup fine_soup(Random& random) {
  culler::PolygonSoup soup;
  for (int i = 0; i < 1000; ++i) {
    const glm::dvec3 at{random.integer(0, 50), random.integer(-20, 20), random.integer(-20, 20)};
    const std::array loop{soup.add_vertex(at), soup.add_vertex(at + glm::dvec3{0, 1, 0}),
                          soup.add_vertex(at + glm::dvec3{0, 0, 1})};
    soup.add_polygon(loop);
  }
  return soup;
}

template <class Values>
auto one_of(Random& random, const Values& values) {
  return values[random.index(values.size())];
}

// Numbers.

/// A number in the place of another; `others` are some that stand elsewhere.
template <class Float>
Float forged_float(Random& random, Float old, std::span<const Float> others) {
  constexpr Float kInfinity = std::numeric_limits<Float>::infinity();
  const std::array values{std::numeric_limits<Float>::quiet_NaN(),
                          kInfinity,
                          -kInfinity,
                          Float{0},
                          -Float{0},
                          -old,
                          2 * old,
                          std::nextafter(old, kInfinity),
                          std::nextafter(old, -kInfinity),
                          std::numeric_limits<Float>::max(),
                          std::numeric_limits<Float>::denorm_min(),
                          static_cast<Float>(0x1p100),
                          static_cast<Float>(0x1p-100),
                          static_cast<Float>(0x1p30),
                          one_of(random, others)};
  return one_of(random, values);
}

template <class Integer>
Integer forged_integer(Random& random, Integer old, std::span<const Integer> others) {
  constexpr auto kMost = std::numeric_limits<Integer>::max();
  const std::array values{Integer{0},
                          Integer{1},
                          Integer{2},
                          kMost,
                          static_cast<Integer>(kMost - 1),
                          static_cast<Integer>(kMost / 2),
                          static_cast<Integer>(kMost / 2 + 1),
                          static_cast<Integer>(old + 1),
                          static_cast<Integer>(old - 1),
                          static_cast<Integer>(2 * old),
                          static_cast<Integer>(old ^ (Integer{1} << random.index(8 * sizeof(Integer)))),
                          static_cast<Integer>(random.bits()),
                          static_cast<Integer>(random.index(256)),
                          one_of(random, others)};
  return one_of(random, values);
}

/// Another number of this type in a place of the part.
template <class Number>
void forge_number(Random& random, StorePart& part) {
  std::vector<Number> numbers = part.get<Number>();
  if (numbers.empty()) return;
  Number& number = numbers[random.index(numbers.size())];
  const std::span<const Number> others(numbers);
  if constexpr (std::numeric_limits<Number>::is_integer) {
    number = forged_integer(random, number, others);
  } else {
    number = forged_float(random, number, others);
  }
  std::memcpy(part.bytes.data(), numbers.data(), numbers.size() * sizeof(Number));
}

StorePart& some_part(Random& random, StoreParts& store) { return store.parts[random.index(store.parts.size())]; }

void number(Random& random, StoreParts& store) {
  constexpr std::array kForge{forge_number<double>,        forge_number<float>,        forge_number<U32>,
                              forge_number<std::uint16_t>, forge_number<std::uint8_t>, forge_number<U64>};
  one_of(random, kForge)(random, some_part(random, store));
}

/// A number of the settings, of those that are one.
void setting(Random& random, StoreParts& store) {
  (random.chance(0.5) ? forge_number<double> : forge_number<U32>)(random, store["config"]);
}

void regions(Random& random, StoreParts& store) {
  StorePart& config = store["config"];
  std::vector<double> numbers = config.get<double>();
  numbers[3] = random.real(1, 0x1p30);
  config.set(numbers);
  if (random.chance(0.5)) return;
  std::erase_if(store.parts,
                [](const StorePart& part) { return culler::Culler::method_of(part.name) == culler::Method::frusta; });
}

// Elements and sections.

/// An element in the place of another, or two of them exchanged.
void element(Random& random, StoreParts& store) {
  StorePart& part = some_part(random, store);
  if (part.size() < 2) return;
  const auto at = [&](std::size_t i) { return part.bytes.begin() + static_cast<std::ptrdiff_t>(i * part.element); };
  const auto a = at(random.index(part.size())), b = at(random.index(part.size()));
  if (random.chance(0.5)) {
    std::vector<std::byte> copy(a, a + part.element);
    std::ranges::copy(copy, b);
  } else if (a != b) {
    std::swap_ranges(a, a + part.element, b);
  }
}

/// More or fewer elements or bytes.
void count(Random& random, StoreParts& store) {
  StorePart& part = some_part(random, store);
  const std::size_t step = random.chance(0.8) ? part.element : 1, size = part.bytes.size();
  if (random.chance(0.1)) {
    part.bytes.clear();
  } else if (random.chance(0.5)) {
    part.bytes.resize(size - std::min(size, step * (1 + random.index(3))));
  } else {
    part.bytes.resize(size + step * (1 + random.index(3)));
    const std::size_t from = std::min(size, part.bytes.size() - size);
    if (random.chance(0.5)) std::copy_n(part.bytes.begin(), from, part.bytes.begin() + static_cast<std::ptrdiff_t>(size));
  }
}

void sections(Random& random, StoreParts& store) {
  StorePart& part = some_part(random, store);
  StorePart& other = some_part(random, store);
  switch (random.index(6)) {
    case 0:
      store.parts.erase(store.parts.begin() + (&part - store.parts.data()));
      break;
    case 1:
      store.parts.insert(store.parts.begin() + (&other - store.parts.data()), StorePart(part));
      break;
    case 2:
      std::swap(part, other);
      break;
    case 3:
      std::swap(part.name, other.name);
      break;
    case 4:
      part.name += random.chance(0.5) ? " " : std::string(40, 'x');
      break;
    default:
      part.bytes = StorePart(other).bytes;
      break;
  }
}

/// A number of the header or the table, which then has the right hash.
void table(Random& random, std::vector<std::byte>& store) {
  render::StoreHeader header;
  std::memcpy(&header, store.data(), sizeof header);
  const std::size_t size = sizeof header + header.sections * sizeof(render::StoreSection);
  StorePart head{"", 1, {store.begin(), store.begin() + static_cast<std::ptrdiff_t>(size)}};
  (random.chance(0.5) ? forge_number<U64> : forge_number<U32>)(random, head);
  std::ranges::copy(head.bytes, store.begin());
  if (random.chance(0.2)) store.resize(random.index(store.size() + 1));
  rehash(store);
}

// Whole structures.

/// The smallest box of polygons [first, first + count).
kernel::Aabb box_of(culler::SoupView soup, U32 first, U32 count) {
  kernel::Aabb box = soup.box(first);
  for (U32 p = first + 1; p < first + count; ++p) culler::grow(box, soup.box(p));
  return box;
}

/// Trees of any shape over polygons in their order.
class SomeTree {
 public:
  enum class Shape { any, of_left_leaves, of_right_leaves };

  SomeTree(Random& random, culler::SoupView soup, Shape shape, std::size_t levels)
      : random_(random), soup_(soup), shape_(shape) {
    append(0, static_cast<U32>(soup.size()), levels);
  }

  [[nodiscard]] const std::vector<HierarchyNode>& nodes() const { return nodes_; }

 private:
  void append(U32 first, U32 count, std::size_t levels) {
    const std::size_t self = nodes_.size();
    nodes_.push_back({.box = box_of(soup_, first, count), .first = first, .count = count});
    if (count == 1 || levels == 0 || (shape_ == Shape::any && random_.chance(0.05))) return;
    const U32 left = shape_ == Shape::of_left_leaves    ? 1
                     : shape_ == Shape::of_right_leaves ? count - 1
                                                        : 1 + static_cast<U32>(random_.index(count - 1));
    append(first, left, levels - 1);
    nodes_[self].right = static_cast<U32>(nodes_.size());
    append(first + left, count - left, levels - 1);
  }

  Random& random_;
  culler::SoupView soup_;
  Shape shape_;
  std::vector<HierarchyNode> nodes_;
};

/// A leaf that has no polygon, and a root above it and the root before.
void add_empty_leaf(std::vector<HierarchyNode>& nodes) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  const kernel::Aabb empty{{kInfinity, kInfinity, kInfinity}, {-kInfinity, -kInfinity, -kInfinity}};
  for (HierarchyNode& node : nodes) node.right += node.is_leaf() ? 0 : 2;
  const std::array above{HierarchyNode{nodes[0].box, 0, nodes[0].count, 2}, HierarchyNode{empty, 0, 0, 0}};
  nodes.insert(nodes.begin(), above.begin(), above.end());
}

/// Another tree, with the blocks that it has or those of the one before.
void tree(Random& random, StoreParts& store) {
  const std::vector<glm::dvec3> vertices = store["vertices"].get<glm::dvec3>();
  const std::vector<U32> indices = store["indices"].get<U32>(), first = store["first"].get<U32>();
  const auto shape = static_cast<SomeTree::Shape>(random.index(3));
  const std::array<std::size_t, 4> levels{1, culler::kMostLevels, culler::kMostLevels + 1, vertices.size()};
  std::vector<HierarchyNode> nodes =
      SomeTree(random, culler::SoupView{vertices, indices, first}, shape, one_of(random, levels)).nodes();
  HierarchyNode& node = nodes[random.index(nodes.size())];
  const HierarchyNode& other = nodes[random.index(nodes.size())];
  switch (random.index(10)) {
    case 0:
      node.right = static_cast<U32>(&node - nodes.data());
      break;  // its own child
    case 1:
      node.right = 0;
      break;  // a leaf that has nodes below it
    case 2:
      node.right = other.right;
      break;  // a child of two
    case 3:
      nodes.push_back(HierarchyNode(nodes[0]));
      break;  // two roots
    case 4:
      node.box = HierarchyNode(other).box;
      break;
    case 5:
      node.count = other.count;
      break;
    case 6:
      add_empty_leaf(nodes);
      break;
    default:
      break;
  }
  store["nodes"].set(nodes);
  if (store["oriented"].size() != 0) store["oriented"].set(std::vector<U32>(nodes.size(), 0xFFFFFFFFU));
  if (random.chance(0.8)) std::erase_if(store.parts, [](const StorePart& part) { return part.name == "node blocks"; });
}

/// Another division of space, deep or not, with lists for as many regions as there are.
void cells(Random& random, StoreParts& store) {
  const std::array<std::size_t, 5> sizes{0, 1, 8, culler::kMostLevels, culler::kMostLevels + 1};
  const std::size_t divided = one_of(random, sizes);
  std::vector<Partition::Cell> cells;
  const bool is_lower_region = random.chance(0.5);
  for (std::size_t i = 0; i < divided; ++i) {
    const double plane = random.chance(0.1) ? -0.0 : random.real(-20, 20);
    const auto axis = static_cast<U32>(random.index(3));
    const auto self = static_cast<U32>(cells.size());
    cells.push_back({plane, axis, is_lower_region ? self + 2 : static_cast<U32>(2 * divided - i)});
    if (is_lower_region) cells.emplace_back();
  }
  cells.resize(2 * divided + 1);
  if (random.chance(0.2)) cells[random.index(cells.size())].upper = static_cast<U32>(random.index(cells.size() + 1));
  store["cells"].set(cells);
  const std::size_t entries = store["listed"].size();
  std::vector<U64> first(divided + 2, entries);
  std::fill_n(first.begin(), first.size() - 1, 0);
  store["list first"].set(first);
  std::vector<U32> listed(entries);
  std::iota(listed.begin(), listed.end(), 0U);
  listed.resize(std::min(entries, store["known"].size()));
  first.back() = listed.size();
  store["list first"].set(first);
  store["listed"].set(listed);
  store["hidden"].bytes.clear();
}

/// Each region lists everything.
void lists(Random& random, StoreParts& store) {
  const std::size_t occluders = store["known"].size(), regions = store["list first"].size() - 1;
  std::vector<U64> first;
  std::vector<U32> listed;
  for (std::size_t r = 0; r <= regions; ++r) {
    first.push_back(listed.size());
    for (U32 i = 0; r < regions && i < occluders; ++i) {
      if (random.chance(0.9)) listed.push_back(i);
    }
  }
  store["list first"].set(first);
  store["listed"].set(listed);
  store["hidden"].bytes.clear();
}

/// What is known of occluders, which is heuristics, changed so that some are chosen first.
void known(Random& random, StoreParts& store) {
  std::vector<double> numbers = store["known"].get<double>();
  for (double& x : numbers) {
    if (random.chance(0.3)) x *= random.chance(0.5) ? 0x1p80 : -1;
  }
  store["known"].set(numbers);
  if (random.chance(0.5)) lists(random, store);
}

/// Sides along any edges in one ring, or rings that do not close.
void rings(Random& random, StoreParts& store) {
  constexpr U32 kOfTwo = 0x80000000U;
  std::vector<U32> next = store["cover next"].get<U32>();
  if (next.empty()) return;
  U32 &a = next[random.index(next.size())], &b = next[random.index(next.size())];
  switch (random.index(4)) {
    case 0:
      std::swap(a, b);
      break;
    case 1:
      a = static_cast<U32>(&a - next.data()) | kOfTwo;
      break;  // alone
    case 2:
      a = b;
      break;
    default:
      a ^= kOfTwo;
      break;
  }
  store["cover next"].set(next);
}

/// Vertices of triangles in one place or another, and of one triangle twice.
void corners(Random& random, StoreParts& store) {
  std::vector<glm::dvec3> vertices = store["cover vertices"].get<glm::dvec3>();
  std::vector<U32> corners = store["cover corners"].get<U32>();
  if (corners.empty()) return;
  U32& corner = corners[random.index(corners.size())];
  const U32 old = corner;
  vertices.push_back(vertices[old]);
  const auto copied = static_cast<U32>(vertices.size() - 1);
  if (random.chance(0.5)) {
    corner = copied;  // beside others that stand in the same place
  } else {
    std::ranges::replace(corners, old, copied);
  }
  store["cover vertices"].set(vertices);
  store["cover corners"].set(corners);
}

/// Appends an element to a part of a list of lists, and where it ends.
void append(StorePart& elements, StorePart& first, std::span<const U32> list) {
  std::vector<U32> all = elements.get<U32>(), ends = first.get<U32>();
  all.insert(all.end(), list.begin(), list.end());
  ends.push_back(static_cast<U32>(all.size()));
  elements.set(all);
  first.set(ends);
}

std::vector<U32> some_polygons(Random& random, std::size_t all, std::size_t most) {
  std::vector<U32> polygons;
  for (std::size_t i = 0; i < most; ++i) polygons.push_back(static_cast<U32>(random.index(all)));
  std::ranges::sort(polygons);
  polygons.erase(std::unique(polygons.begin(), polygons.end()), polygons.end());
  return polygons;
}

/// Makes place for an occluder of this number, which looks larger than all others and is listed everywhere.
void add_known(Random& random, StoreParts& store, std::size_t number) {
  constexpr std::array kLarge{0.0, 0.0, 0.0, 1e6, 1e6, 1e6, 1e6, 1.0};  // centre, area along each axis, round area, radius
  std::vector<double> known = store["known"].get<double>();
  known.insert(known.begin() + static_cast<std::ptrdiff_t>(kLarge.size() * number), kLarge.begin(), kLarge.end());
  store["known"].set(known);
  lists(random, store);
}

/// A part of a polygon of the last kind of region: pieces are last.
void piece(Random& random, StoreParts& store) {
  const std::vector<U32> indices = store["indices"].get<U32>(), starts = store["first"].get<U32>();
  const std::size_t p = random.index(starts.size() - 1);
  const std::span loop = std::span(indices).subspan(starts[p], starts[p + 1] - starts[p]);
  const auto first = static_cast<U32>(random.index(loop.size() - 2));
  const auto length = 1 + static_cast<U32>(random.index(loop.size() - 2 - first));
  std::vector<U32> corners{loop[0]};
  corners.insert(corners.end(), loop.begin() + first + 1, loop.begin() + first + 2 + length);
  append(store["region corners"], store["region first corner"], corners);
  append(store["region polygons"], store["region first polygon"], std::array{static_cast<U32>(p)});
  std::vector<culler::FanRun> runs = store["pieces"].get<culler::FanRun>();
  runs.push_back({first, length});
  store["pieces"].set(runs);
  add_known(random, store, store["region first corner"].size() - 2);
}

/// Two loops as one, without the side that they share; empty if they share none. The second may be turned over.
std::vector<U32> joined_loop(std::span<const glm::dvec3> vertices, std::span<const U32> a, std::span<const U32> b) {
  for (std::size_t i = 0; i < a.size(); ++i) {
    for (std::size_t k = 0; k < b.size(); ++k) {
      const auto is_at = [&](std::size_t of_a, std::size_t of_b) {
        return vertices[a[of_a % a.size()]] == vertices[b[of_b % b.size()]];
      };
      if (!is_at(i, k + 1) || !is_at(i + 1, k)) continue;
      std::vector<U32> loop(a.begin(), a.end());
      std::ranges::rotate(loop, loop.begin() + static_cast<std::ptrdiff_t>((i + 1) % a.size()));
      for (std::size_t n = 2; n < b.size(); ++n) loop.push_back(b[(k + n) % b.size()]);
      return loop;
    }
  }
  return {};
}

/// Two polygons that meet in a side at any angle, as a flat region.
void joined(Random& random, StoreParts& store) {
  const std::vector<glm::dvec3> vertices = store["vertices"].get<glm::dvec3>();
  const std::vector<U32> indices = store["indices"].get<U32>(), starts = store["first"].get<U32>();
  std::vector<U32> whole = store["whole"].get<U32>();
  if (store["pieces"].size() != 0) return;  // which come after joined regions
  const auto loop_of = [&](U32 p) { return std::span(indices).subspan(starts[p], starts[p + 1] - starts[p]); };
  const auto polygons = static_cast<U32>(starts.size() - 1);
  std::vector<std::array<U32, 2>> pairs;
  for (U32 a = 0; a < polygons; ++a) {
    for (U32 b = a + 1; b < polygons && polygons < 200; ++b) {
      const bool are_alone = whole[a] == a && whole[b] == b;
      if (are_alone && !joined_loop(vertices, loop_of(a), loop_of(b)).empty()) pairs.push_back({a, b});
    }
  }
  if (pairs.empty()) return;
  const std::array<U32, 2> pair = one_of(random, pairs);
  std::vector<U32> loop = joined_loop(vertices, loop_of(pair[0]), loop_of(pair[1]));
  if (random.chance(0.2)) std::swap(loop[0], loop[random.index(loop.size())]);
  const auto parts = std::span(pair).first(random.chance(0.3) ? 1 : 2);  // one: the region is larger than what is drawn
  for (const U32 p : parts) whole[p] = static_cast<U32>(store["region first corner"].size() - 1);
  append(store["region corners"], store["region first corner"], loop);
  append(store["region polygons"], store["region first polygon"], parts);
  store["whole"].set(whole);
  add_known(random, store, store["region first corner"].size() - 2);
}

/// Any polygons as a closed solid.
void shell(Random& random, StoreParts& store) {
  const std::size_t polygons = store["first"].size() - 1;
  std::vector<U32> of = store["shell of"].get<U32>(), first = store["shell first polygon"].get<U32>();
  if (of.empty()) of.assign(polygons, 0xFFFFFFFFU);
  if (first.empty()) first.push_back(0);
  std::vector<U32> parts = some_polygons(random, polygons, 8);
  std::erase_if(parts, [&](U32 p) { return of[p] != 0xFFFFFFFFU; });
  for (const U32 p : parts) of[p] = static_cast<U32>(first.size() - 1);
  store["shell of"].set(of);
  store["shell first polygon"].set(first);
  append(store["shell polygons"], store["shell first polygon"], parts);
  if (random.chance(0.2)) std::ranges::fill(store["shell limits"].bytes, std::byte{});
  add_known(random, store, store["known"].size());
}

/// Vertices in the place of others, or moved: another model, whose boxes may be wrong.
void vertices(Random& random, StoreParts& store) {
  for (const char* name : {"vertices", "cover vertices"}) {
    std::vector<glm::dvec3> all = store[name].get<glm::dvec3>();
    if (all.empty()) continue;
    all[random.index(all.size())] = random.chance(0.5) ? all[random.index(all.size())] : fuzz::lattice_point(random, 20);
    store[name].set(all);
    if (random.chance(0.5)) return;
  }
}

struct Kind {
  const char* name;
  void (*forge)(Random&, StoreParts&);
};
constexpr std::array kKinds{
    Kind{"number", number}, Kind{"setting", setting},   Kind{"regions", regions}, Kind{"element", element},
    Kind{"count", count},   Kind{"sections", sections}, Kind{"tree", tree},       Kind{"cells", cells},
    Kind{"lists", lists},   Kind{"known", known},       Kind{"rings", rings},     Kind{"corners", corners},
    Kind{"piece", piece},   Kind{"joined", joined},     Kind{"shell", shell},     Kind{"vertices", vertices}};

}  // namespace

ForgedStore sound_store(Random& random) {
  const culler::BuildConfig config = some_config(random);
  culler::PolygonSoup soup = random.chance(0.1) ? fine_soup(random) : fuzz::some_soup(random);
  return {"sound", config.hierarchy.bounds == culler::Bounds::obb, written(culler::Culler(std::move(soup), config))};
}

ForgedStore forged_store(Random& random) {
  ForgedStore forged = sound_store(random);
  if (random.chance(0.1)) {
    forged.what = "table";
    table(random, forged.bytes);
    return forged;
  }
  StoreParts parts(forged.bytes);
  const Kind kind = one_of(random, kKinds);
  kind.forge(random, parts);
  for (std::size_t more = random.chance(0.2) ? 1 + random.index(2) : 0; more > 0; --more) number(random, parts);
  forged.what = kind.name;
  forged.bytes = parts.store();
  return forged;
}

}  // namespace occlude::harness
