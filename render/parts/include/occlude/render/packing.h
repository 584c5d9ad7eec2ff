// SPDX-License-Identifier: MIT
// Values as a string of bytes, for another process with the same program. Bytes that come back are not believed.
#pragma once

#include <cstdint>
#include <cstring>
#include <stdexcept>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

namespace occlude::render {

/// Bytes that cannot be what was asked for. The message is the reason; who knows where the bytes are from adds the place.
struct PartError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// Throws PartError unless it `holds`.
inline void require_part(bool holds, const char* otherwise) {
  if (!holds) throw PartError(otherwise);
}

/// Values of which every pattern of bits is one; so not bool.
template <class T>
concept Packable = std::is_trivially_copyable_v<T> && !std::is_pointer_v<T> && !std::is_same_v<T, bool>;

/// Appends values to bytes.
class Packer {
 public:
  template <Packable T>
  Packer& put(const T& value) {
    bytes_.append(reinterpret_cast<const char*>(&value), sizeof value);
    return *this;
  }
  Packer& put(bool flag) { return put(std::uint8_t{flag}); }
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

/// Reads them back in the same order. Throws PartError where the bytes cannot be such values. Nothing takes more memory than
/// the bytes do, or eight times as much for lists of flags.
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
  [[nodiscard]] bool flag() {
    const auto byte = get<std::uint8_t>();
    require_part(byte <= 1, "a flag is neither 0 nor 1");
    return byte != 0;
  }
  [[nodiscard]] std::string text() { return std::string(next(get<std::uint64_t>())); }
  template <Packable T>
  [[nodiscard]] std::vector<T> list() {
    const std::string_view bytes = next(get<std::uint64_t>());
    require_part(bytes.size() % sizeof(T) == 0, "a list ends within a value");
    std::vector<T> values(bytes.size() / sizeof(T));
    if (!values.empty()) std::memcpy(values.data(), bytes.data(), values.size() * sizeof(T));
    return values;
  }
  [[nodiscard]] std::vector<bool> bits() {
    const auto size = get<std::uint64_t>();
    const std::string_view bytes = next(get<std::uint64_t>());
    require_part(bytes.size() == size / 8 + (size % 8 == 0 ? 0 : 1), "flags are not as many as it says");
    std::vector<bool> bits(size);
    for (std::size_t i = 0; i < size; ++i) bits[i] = (bytes[i / 8] >> i % 8 & 1) != 0;
    return bits;
  }
  [[nodiscard]] bool is_empty() const { return rest_.empty(); }
  /// Throws PartError if something is left.
  void finish() const { require_part(is_empty(), "it goes on where it should end"); }

 private:
  std::string_view next(std::size_t bytes) {
    require_part(bytes <= rest_.size(), "it ends too early");
    const std::string_view taken = rest_.substr(0, bytes);
    rest_.remove_prefix(bytes);
    return taken;
  }

  std::string_view rest_;
};

}  // namespace occlude::render
