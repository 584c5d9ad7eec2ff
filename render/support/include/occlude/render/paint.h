// SPDX-License-Identifier: MIT
// Colours of text on a terminal.
#pragma once

#include <string>

namespace occlude::render {

enum class Colour { red, green, yellow };

/// Colours text, or leaves it as it is.
class Paint {
 public:
  /// Leaves text as it is.
  Paint() = default;
  /// Colours text for this descriptor if it is a terminal that has colours (TERM is not "dumb") and NO_COLOR is not set, or
  /// empty (no-color.org).
  explicit Paint(int descriptor);

  [[nodiscard]] std::string operator()(Colour colour, const std::string& text) const;

 private:
  bool is_on_ = false;
};

}  // namespace occlude::render
