// SPDX-License-Identifier: MIT
// The word that was probably meant.
#pragma once

#include <string>
#include <vector>

namespace occlude::cli {

/// ": did you mean 'WORD'?" with the nearest of the words, if at most a third of the letters, or one, is wrong, missing, too
/// much or swapped with the next; otherwise empty.
[[nodiscard]] std::string did_you_mean(const std::string& word, const std::vector<std::string>& words);

}  // namespace occlude::cli
