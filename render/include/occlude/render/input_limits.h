// SPDX-License-Identifier: MIT
// How much of an input is read. What is larger is refused, with the limit named.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>

namespace occlude::render {

/// Bytes of a JSON file, and of a line of JSON Lines: 200,000 vertices with all their digits. In memory it takes up to 40
/// times as much.
inline constexpr std::uint64_t kMostJson = std::uint64_t{16} << 20U;

/// Bytes of any other file: 50 million polygons and more.
inline constexpr std::uint64_t kMostBytes = std::uint64_t{4} << 30U;

/// Vertices of a cover's polygons together. The oracle cuts a box into pieces: so many vertices, all of whose polygons run
/// through the box, take it a minute or so, as many of a mesh before it two seconds.
inline constexpr std::size_t kMostCoverVertices = 2048;

/// "16 MiB"; what is no whole number of them is rounded.
[[nodiscard]] std::string in_mebibytes(std::uint64_t bytes);

/// What `--help` says of these limits, and of those of memory and of the import library.
[[nodiscard]] std::string limits_help();

}  // namespace occlude::render
