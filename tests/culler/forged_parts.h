// SPDX-License-Identifier: MIT
// Parts of a culler that a test changes.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "occlude/culler/culler.h"

namespace occlude::culler {

/// A copy of the parts of a culler, to be changed.
class ForgedParts {
 public:
  explicit ForgedParts(const Culler& culler) : ForgedParts(culler.parts()) {}
  explicit ForgedParts(const Parts& parts) {
    for (const Part& part : parts.parts) {
      names_.emplace_back(part.name);
      elements_.push_back(part.element);
      bytes_.emplace_back(part.bytes.begin(), part.bytes.end());
    }
  }

  [[nodiscard]] const std::vector<std::string>& names() const { return names_; }
  /// The elements of a part.
  template <class T>
  [[nodiscard]] std::vector<T> get(std::string_view name) const {
    const std::vector<std::byte>& bytes = bytes_[number(name)];
    std::vector<T> elements(bytes.size() / sizeof(T));
    if (!bytes.empty()) std::memcpy(elements.data(), bytes.data(), bytes.size());
    return elements;
  }
  template <class T>
  void set(std::string_view name, const std::vector<T>& elements) {
    const auto bytes = std::as_bytes(std::span(elements));
    bytes_[number(name)].assign(bytes.begin(), bytes.end());
  }
  /// Changes the elements by change(elements).
  template <class T, class Change>
  void edit(std::string_view name, Change&& change) {
    std::vector<T> elements = get<T>(name);
    change(elements);
    set(name, elements);
  }
  void erase(std::string_view name) {
    const auto i = static_cast<std::ptrdiff_t>(number(name));
    names_.erase(names_.begin() + i);
    elements_.erase(elements_.begin() + i);
    bytes_.erase(bytes_.begin() + i);
  }
  std::uint64_t left_out = 0;  ///< Parts::left_out

  [[nodiscard]] std::vector<std::byte>& bytes(std::string_view name) { return bytes_[number(name)]; }
  [[nodiscard]] std::size_t element(std::string_view name) const { return elements_[number(name)]; }

  /// The culler with these parts, which it keeps.
  [[nodiscard]] Culler culler() const { return Culler(parts()); }
  /// Why there is none; empty if there is.
  [[nodiscard]] std::string refusal() const {
    try {
      static_cast<void>(culler());
    } catch (const std::invalid_argument& error) {
      return error.what();
    }
    return "";
  }

 private:
  struct alignas(kPartAlignment) Line {
    std::array<std::byte, kPartAlignment> bytes;
  };
  struct Kept {
    std::vector<std::string> names;
    std::vector<std::vector<Line>> lines;
  };

  [[nodiscard]] std::size_t number(std::string_view name) const {
    const auto found = std::ranges::find(names_, name);
    if (found == names_.end()) throw std::logic_error("no part " + std::string(name));
    return static_cast<std::size_t>(found - names_.begin());
  }

  [[nodiscard]] Parts parts() const {
    auto kept = std::make_shared<Kept>();
    kept->names = names_;
    for (const std::vector<std::byte>& bytes : bytes_) {
      std::vector<Line>& lines = kept->lines.emplace_back(bytes.size() / sizeof(Line) + 1);
      if (!bytes.empty()) std::memcpy(lines.data(), bytes.data(), bytes.size());
    }
    Parts parts{{}, kept, left_out};
    for (std::size_t i = 0; i < names_.size(); ++i) {
      const auto bytes = std::as_bytes(std::span(kept->lines[i])).first(bytes_[i].size());
      parts.parts.push_back({kept->names[i], elements_[i], bytes});
    }
    return parts;
  }

  std::vector<std::string> names_;
  std::vector<std::size_t> elements_;
  std::vector<std::vector<std::byte>> bytes_;
};

}  // namespace occlude::culler
