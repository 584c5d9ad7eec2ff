// SPDX-License-Identifier: MIT
// Names of what is in a scene. Reading order: 13.
#pragma once

#include <compare>
#include <cstdint>

namespace occlude::culler {

/// What an id names.
enum class SceneKind : std::uint8_t { object, occluder };

/// Names one object or one occluder of one scene until it is removed; none by default. No two ids that a program ever gets
/// are equal, whatever scenes they are of and whatever they name. So the id of what was removed names nothing any more, and
/// an id names nothing in another scene. What it names, its generation and its scene are all in one number:
/// 28 bits slot, 20 bits generation, 1 bit SceneKind, 15 bits scene, of which none is 0.
template <SceneKind kOf>
class SceneId {
 public:
  static constexpr SceneKind kKind = kOf;
  static constexpr unsigned kSlotBits = 28, kGenerationBits = 20, kSceneBits = 15;

  SceneId() = default;
  /// For scenes. REQUIRES: each has no more than its bits; scene != 0.
  SceneId(std::uint32_t slot, std::uint32_t generation, std::uint32_t scene)
      : number_(std::uint64_t{scene} << kSceneAt | std::uint64_t{static_cast<std::uint8_t>(kKind)} << kKindAt |
                std::uint64_t{generation} << kGenerationAt | slot) {}

  /// For programs that keep numbers, and for other languages; 0 is none. Any other number than those of ids of this type
  /// names nothing.
  [[nodiscard]] static SceneId from_number(std::uint64_t number) {
    SceneId id;
    id.number_ = number;
    return id;
  }
  [[nodiscard]] std::uint64_t number() const { return number_; }

  [[nodiscard]] bool is_none() const { return number_ == 0; }
  /// A small number that what is in the scene has to itself, objects apart from occluders. What is added takes the slot of
  /// what was removed, so an array of a caller's own that is indexed by slots stays short.
  [[nodiscard]] std::uint32_t slot() const { return field(0, kSlotBits); }
  [[nodiscard]] std::uint32_t generation() const { return field(kGenerationAt, kGenerationBits); }
  [[nodiscard]] std::uint32_t scene() const { return field(kSceneAt, kSceneBits); }
  /// Of another kind than the type says is only what from_number() made of a number of that kind.
  [[nodiscard]] SceneKind kind() const { return static_cast<SceneKind>(field(kKindAt, 1)); }

  friend auto operator<=>(const SceneId&, const SceneId&) = default;

 private:
  static constexpr unsigned kGenerationAt = kSlotBits, kKindAt = kGenerationAt + kGenerationBits, kSceneAt = kKindAt + 1;
  static_assert(kSceneAt + kSceneBits == 64);

  [[nodiscard]] std::uint32_t field(unsigned at, unsigned bits) const {
    return static_cast<std::uint32_t>(number_ >> at & ((std::uint64_t{1} << bits) - 1));
  }

  std::uint64_t number_ = 0;
};

using ObjectId = SceneId<SceneKind::object>;
using OccluderId = SceneId<SceneKind::occluder>;

}  // namespace occlude::culler
