// SPDX-License-Identifier: MIT
// What tells the ids of one scene from those of all others.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <mutex>
#include <stdexcept>
#include <string>
#include <vector>

#include "occlude/culler/scene.h"

namespace occlude::culler {

/// A number that no other scene has while this one lives. A later scene may have it again; its ids begin with generations
/// that this one has not used. So no id is given twice.
class SceneNumber {
 public:
  /// Throws std::runtime_error if more scenes live than there are numbers.
  SceneNumber() : SceneNumber(numbers().take()) {}
  ~SceneNumber() { numbers().give_back({number_, next_generation_}); }
  SceneNumber(const SceneNumber&) = delete;
  SceneNumber& operator=(const SceneNumber&) = delete;

  [[nodiscard]] std::uint32_t number() const { return number_; }
  /// With which the ids of a slot begin.
  [[nodiscard]] std::uint32_t first_generation() const { return first_generation_; }
  /// Says that an id has this generation.
  void use(std::uint32_t generation) { next_generation_ = std::max(next_generation_, generation + 1); }

 private:
  static constexpr std::uint32_t kGenerations = 1U << ObjectId::kGenerationBits;

  struct Unused {
    std::uint32_t number, first_generation;
  };

  /// Those of the program.
  class Numbers {
   public:
    Unused take() {
      const std::scoped_lock lock(mutex_);
      if (unused_.empty()) {
        if (next_ >> ObjectId::kSceneBits != 0) {
          throw std::runtime_error("there are already " + std::to_string(next_ - 1) + " scenes");
        }
        if (unused_.capacity() < next_) unused_.reserve(2 * std::size_t{next_});  // so that giving back cannot fail
        unused_.push_back({next_++, 0});
      }
      const Unused taken = unused_.back();
      unused_.pop_back();
      return taken;
    }
    /// A number whose generations have all been used is not used again.
    void give_back(const Unused& unused) {
      const std::scoped_lock lock(mutex_);
      if (unused.first_generation < kGenerations) unused_.push_back(unused);
    }

   private:
    std::mutex mutex_;
    std::vector<Unused> unused_;
    std::uint32_t next_ = 1;
  };

  static Numbers& numbers() {
    static Numbers all;
    return all;
  }

  explicit SceneNumber(const Unused& taken)
      : number_(taken.number), first_generation_(taken.first_generation), next_generation_(taken.first_generation) {}

  std::uint32_t number_, first_generation_, next_generation_;
};

}  // namespace occlude::culler
