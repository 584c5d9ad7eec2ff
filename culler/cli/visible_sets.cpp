// SPDX-License-Identifier: MIT
#include "visible_sets.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <iterator>
#include <limits>
#include <span>
#include <string>
#include <tuple>
#include <utility>

#include "occlude/render/digest.h"
#include "occlude/render/interrupt.h"

namespace occlude::cli {
namespace {

static_assert(std::endian::native == std::endian::little, "the file has numbers as they are in memory");

template <class T>
void put(std::string& bytes, const T& value) {
  bytes.append(reinterpret_cast<const char*>(&value), sizeof value);
}

/// Seven bits a byte, the lowest first; the last byte is below 128.
void put_short(std::string& bytes, std::uint32_t number) {
  for (; number >= 128; number >>= 7U) bytes += static_cast<char>(number % 128 + 128);
  bytes += static_cast<char>(number);
}

/// How far back the set is that it differs from, 0 for none, and the distances from each change to the next.
std::string packed(std::uint32_t back, const Changes& changes) {
  std::string bytes;
  put_short(bytes, back);
  std::uint32_t last = 0;
  for (const std::uint32_t at : changes) put_short(bytes, at - std::exchange(last, at));
  return bytes;
}

/// Packs sets one after another, each as it is or by how it differs from an earlier one, whichever is shorter.
class SetPacker {
 public:
  explicit SetPacker(std::span<const BakedCell> cells, Changes BakedCell::*set) : cells_(cells), set_(set) {}

  [[nodiscard]] std::string next() {
    const Changes& changes = cells_[depths_.size()].*set_;
    std::string best = packed(0, changes);
    std::uint32_t depth = 0;
    for (std::uint32_t back = 1; back <= std::min<std::size_t>(kFarthestBack, depths_.size()); ++back) {
      const std::size_t from = depths_.size() - back;
      if (depths_[from] == kMostDepth) continue;
      Changes difference;
      std::ranges::set_symmetric_difference(changes, cells_[from].*set_, std::back_inserter(difference));
      if (difference.size() >= best.size()) continue;  // a byte for each at least
      if (std::string bytes = packed(back, difference); bytes.size() < best.size()) {
        best = std::move(bytes);
        depth = depths_[from] + 1;
      }
    }
    depths_.push_back(depth);
    return best;
  }

 private:
  /// A reader takes so many sets for one at most.
  static constexpr std::uint32_t kMostDepth = 8;
  /// Neighbours in a column and, of narrow corridors, in the one before.
  static constexpr std::uint32_t kFarthestBack = 8;

  std::span<const BakedCell> cells_;
  Changes BakedCell::*set_;
  std::vector<std::uint32_t> depths_;  ///< of each set so far: how many others it takes to read it
};

constexpr std::size_t kHeaderBytes = 64;

/// Which of the 64 numbers from `first` on are in a set: a bit for each, the lowest for `first`.
std::uint64_t word_of(const Changes& set, std::uint32_t first) {
  auto change = std::ranges::upper_bound(set, first);
  std::uint64_t word = (change - set.begin()) % 2 == 1 ? ~std::uint64_t{0} : 0;
  for (; change != set.end() && *change - first < 64; ++change) word ^= ~std::uint64_t{0} << (*change - first);
  return word;
}

/// REQUIRES: the number is greater than all in the set.
void add(Changes& set, std::uint32_t number) {
  if (!set.empty() && set.back() == number) {
    ++set.back();
  } else {
    set.insert(set.end(), {number, number + 1});
  }
}

}  // namespace

Changes changes_of(const std::vector<bool>& set) {
  Changes changes;
  for (std::size_t i = 0; i <= set.size(); ++i) {
    const bool is_in = i < set.size() && set[i];
    if (is_in != (changes.size() % 2 == 1)) changes.push_back(static_cast<std::uint32_t>(i));
  }
  return changes;
}

std::size_t size_of(const Changes& set) {
  std::size_t size = 0;
  for (std::size_t i = 0; i + 1 < set.size(); i += 2) size += set[i + 1] - set[i];
  return size;
}

std::vector<bool> members_of(const Changes& set, std::size_t count) {
  std::vector<bool> is_in(count);
  for (std::size_t i = 0; i < set.size(); i += 2) {
    const std::size_t end = i + 1 < set.size() ? set[i + 1] : count;
    std::fill(is_in.begin() + set[i], is_in.begin() + static_cast<std::ptrdiff_t>(end), true);
  }
  return is_in;
}

bool is_before(const kernel::Aabb& a, const kernel::Aabb& b) {
  const auto key = [](const kernel::Aabb& box) {
    return std::tuple(box.min.x, box.min.y, box.min.z, box.max.x, box.max.y, box.max.z);
  };
  return key(a) < key(b);
}

void make_mutual(std::vector<BakedCell>& cells) {
  // 64 cells at a time, so that whether they are in another's set is a word of it.
  std::vector<Changes> mutual(cells.size());
  std::vector<std::uint64_t> words(cells.size());
  for (std::uint32_t first = 0; first < cells.size(); first += 64) {
    render::check_interrupt();
    for (std::size_t b = 0; b < cells.size(); ++b) words[b] = word_of(cells[b].cells, first);
    for (std::uint32_t a = first; a < std::min<std::size_t>(first + 64, cells.size()); ++a) {
      const Changes& set = cells[a].cells;
      for (std::size_t i = 0; i < set.size(); i += 2) {
        for (std::uint32_t b = set[i]; b < set[i + 1]; ++b) {
          if (words[b] >> (a - first) & 1U) add(mutual[a], b);
        }
      }
    }
  }
  for (std::size_t a = 0; a < cells.size(); ++a) cells[a].cells = std::move(mutual[a]);
}

std::size_t write_visible_sets(render::OutputFile& file, const VisibleSets& sets) {
  const std::span cells = sets.cells;
  std::string body, packed_sets;
  double widest = 0;
  for (const BakedCell& cell : cells) {
    put(body, cell.box);
    widest = std::max(widest, cell.box.max.x - cell.box.min.x);
  }
  std::uint64_t at = kHeaderBytes + body.size() + (2 * cells.size() + 1) * sizeof(std::uint64_t);
  for (const auto set : {&BakedCell::items, &BakedCell::cells}) {
    SetPacker packer(cells, set);
    for (std::size_t i = 0; i < cells.size(); ++i) {
      render::check_interrupt();
      put(body, at + packed_sets.size());
      packed_sets += packer.next();
    }
  }
  put(body, at + packed_sets.size());
  std::string header = "OCCLPVS1";
  put(header, at + packed_sets.size());
  put(header, sets.model);
  put(header, static_cast<std::uint32_t>(cells.size()));
  put(header, sets.items);
  put(header, std::nextafter(widest, std::numeric_limits<double>::infinity()));
  const std::string reserved(kHeaderBytes - header.size() - sizeof(std::uint64_t), '\0');
  put(header, render::fnv1a(packed_sets, render::fnv1a(body, render::fnv1a(reserved, render::fnv1a(header)))));
  file.write(header + reserved);
  file.write(body);
  file.write(packed_sets);
  return at + packed_sets.size();
}

}  // namespace occlude::cli
