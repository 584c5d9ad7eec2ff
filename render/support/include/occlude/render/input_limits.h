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

/// Vertices of the polygons of a case's cover together: so many, all of whose polygons run through the box, take kernel and
/// oracle ten seconds or so.
inline constexpr std::size_t kMostCoverVertices = 1024;

/// The same of a witness. What hides a wall in a model of small parts may be ten thousand of them; the oracle's own limit of
/// work holds for what takes longer.
inline constexpr std::size_t kMostWitnessVertices = 65536;

/// "16 MiB"; what is no whole number of them is rounded.
[[nodiscard]] std::string in_mebibytes(std::uint64_t bytes);

}  // namespace occlude::render
