// SPDX-License-Identifier: MIT
// A model on its way from the child process that has read it.
#pragma once

#include <cstdio>
#include <string>

#include "occlude/render/model.h"

namespace occlude::render {

/// Writes the message of the InputError that the import ended with, empty if there was none, and the model. Throws
/// std::runtime_error if the file cannot be written.
void hand_over(const std::string& failure, const Model& model, std::FILE* out);

/// Reads what hand_over() wrote in a child that may have corrupted its own memory: the soup is well formed and its vertices
/// are legal. Throws the InputError, or ChildFailure if the data is damaged.
[[nodiscard]] Model take_over(std::FILE* in);

}  // namespace occlude::render
