// SPDX-License-Identifier: MIT
// Marks what runs of this user have kept, so that nobody else's bytes are taken for it.
#pragma once

#include <array>
#include <initializer_list>
#include <string>
#include <string_view>

namespace occlude::render {

/// A code that only who knows the user's key can make: keyed BLAKE2b (RFC 7693) of 256 bits. The key is random. It stands in
/// the file occlude/parts.key of $XDG_STATE_HOME, which is ~/.local/state unless it is set.
class Seal {
 public:
  /// Reads the key, or makes it if there is none. Throws InputError, naming the file, if that cannot be done, or if others
  /// than the user may know the key.
  Seal();

  /// The seal of these texts, in this order: 64 hexadecimal digits. Texts that are divided elsewhere have another seal.
  [[nodiscard]] std::string of(std::initializer_list<std::string_view> texts) const;

 private:
  std::array<unsigned char, 32> key_{};
};

}  // namespace occlude::render
