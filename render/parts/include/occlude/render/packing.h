// SPDX-License-Identifier: MIT
// Values as a string of bytes, for another process with the same program.
#pragma once

#include <cstdint>
#include <cstring>
#include <stdexcept>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

namespace occlude::render {

template <class T>
concept Packable = std::is_trivially_copyable_v<T> && !std::is_pointer_v<T>;

/// Appends values to bytes.
class Packer {
 public:
  template <Packable T>
  Packer& put(const T& value) {
    bytes_.append(reinterpret_cast<const char*>(&value), sizeof value);
    return *this;
  }
  Packer& put(const std::string& text) {
    put(std::uint64_t{text.size()});
    bytes_ += text;
    return *this;
  }
  template <Packable T>
  Packer& put(const std::vector<T>& values) {
    return put(std::string(reinterpret_cast<const char*>(values.data()), values.size() * sizeof(T)));
  }
  Packer& put(const std::vector<bool>& bits) {
    std::string bytes((bits.size() + 7) / 8, '\0');
    for (std::size_t i = 0; i < bits.size(); ++i) {
      if (bits[i]) bytes[i / 8] = static_cast<char>(bytes[i / 8] | 1 << i % 8);
    }
    return put(std::uint64_t{bits.size()}).put(bytes);
  }

  [[nodiscard]] const std::string& bytes() const { return bytes_; }

 private:
  std::string bytes_;
};

/// Reads them back in the same order. Throws std::logic_error where the bytes end too early.
class Unpacker {
 public:
  /// REQUIRES: `bytes` outlive the object.
  explicit Unpacker(std::string_view bytes) : rest_(bytes) {}

  template <Packable T>
  [[nodiscard]] T get() {
    T value;
    std::memcpy(&value, next(sizeof value).data(), sizeof value);
    return value;
  }
  [[nodiscard]] std::string text() { return std::string(next(get<std::uint64_t>())); }
  template <Packable T>
  [[nodiscard]] std::vector<T> list() {
    const std::string_view bytes = next(get<std::uint64_t>());
    std::vector<T> values(bytes.size() / sizeof(T));
    if (!values.empty()) std::memcpy(values.data(), bytes.data(), values.size() * sizeof(T));
    return values;
  }
  [[nodiscard]] std::vector<bool> bits() {
    std::vector<bool> bits(get<std::uint64_t>());
    const std::string_view bytes = next(get<std::uint64_t>());
    for (std::size_t i = 0; i < bits.size(); ++i) bits[i] = (bytes.at(i / 8) >> i % 8 & 1) != 0;
    return bits;
  }
  [[nodiscard]] bool is_empty() const { return rest_.empty(); }

 private:
  std::string_view next(std::size_t bytes) {
    if (bytes > rest_.size()) throw std::logic_error("a part ends too early");
    const std::string_view taken = rest_.substr(0, bytes);
    rest_.remove_prefix(bytes);
    return taken;
  }

  std::string_view rest_;
};

}  // namespace occlude::render
