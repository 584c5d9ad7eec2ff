// SPDX-License-Identifier: MIT
// A store (render/store.h) section by section, to be changed and put together again.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "rehashed.h"
#include "store_format.h"

namespace occlude::harness {

struct StorePart {
  std::string name;
  std::uint32_t element = 0;
  std::vector<std::byte> bytes;

  [[nodiscard]] std::size_t size() const { return element == 0 ? 0 : bytes.size() / element; }

  template <class T>
  [[nodiscard]] std::vector<T> get() const {
    std::vector<T> elements(bytes.size() / sizeof(T));
    if (!elements.empty()) std::memcpy(elements.data(), bytes.data(), elements.size() * sizeof(T));
    return elements;
  }
  template <class T>
  void set(const std::vector<T>& elements) {
    const auto as_bytes = std::as_bytes(std::span(elements));
    bytes.assign(as_bytes.begin(), as_bytes.end());
  }
};

class StoreParts {
 public:
  /// REQUIRES: a sound store.
  explicit StoreParts(std::span<const std::byte> store) {
    std::memcpy(&header_, store.data(), sizeof header_);
    for (std::size_t i = 0; i < header_.sections; ++i) {
      render::StoreSection section;
      std::memcpy(&section, store.data() + sizeof header_ + i * sizeof section, sizeof section);
      const std::span<const std::byte> bytes = store.subspan(section.offset, section.bytes);
      parts.push_back({section.name.data(), section.element, {bytes.begin(), bytes.end()}});
    }
  }

  /// REQUIRES: there is one of this name.
  [[nodiscard]] StorePart& operator[](std::string_view name) { return *std::ranges::find(parts, name, &StorePart::name); }

  /// The store with these parts and the right hashes.
  [[nodiscard]] std::vector<std::byte> store() const {
    std::vector<render::StoreSection> table;
    std::uint64_t end = sizeof header_ + parts.size() * sizeof(render::StoreSection);
    for (const StorePart& part : parts) {
      render::StoreSection& section = table.emplace_back();
      std::ranges::copy(std::string_view(part.name).substr(0, section.name.size()), section.name.begin());
      section.element = part.element;
      section.offset = end;
      section.bytes = part.bytes.size();
      end += render::aligned(part.bytes.size());
    }
    render::StoreHeader header = header_;
    header.sections = static_cast<std::uint32_t>(parts.size());
    header.bytes = end;
    std::vector<std::byte> store(end);
    std::memcpy(store.data(), &header, sizeof header);
    for (std::size_t i = 0; i < parts.size(); ++i) {
      std::memcpy(store.data() + sizeof header + i * sizeof table[i], &table[i], sizeof table[i]);
      std::ranges::copy(parts[i].bytes, store.begin() + static_cast<std::ptrdiff_t>(table[i].offset));
    }
    rehash(store);
    return store;
  }

  std::vector<StorePart> parts;

 private:
  render::StoreHeader header_;
};

}  // namespace occlude::harness
