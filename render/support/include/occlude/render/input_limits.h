// SPDX-License-Identifier: MIT
// The largest inputs that are read. A larger input is refused with a message that names the limit.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>

namespace occlude::render {

/// Bytes of a JSON file, and of a line of JSON Lines: 200,000 vertices with all their digits. The parsed values take up to
/// 40 times as much memory.
inline constexpr std::uint64_t kMostJson = std::uint64_t{16} << 20U;

/// Bytes of any other file: 50 million polygons and more.
inline constexpr std::uint64_t kMostBytes = std::uint64_t{4} << 30U;

/// Vertices of all polygons of a case's cover. This many, with every polygon running through the box, take the kernel and
/// the oracle about ten seconds.
inline constexpr std::size_t kMostCoverVertices = 1024;

/// The same for a witness. In a model of small parts ten thousand of them may hide one wall. The oracle's own limit of work
/// stops what takes longer.
inline constexpr std::size_t kMostWitnessVertices = 65536;

/// Windows of a witness for a region of eyes. To see whether so many cover a rectangle takes up to a second.
inline constexpr std::size_t kMostWitnessWindows = 16384;

/// For example "16 MiB"; rounded down to whole MiB.
[[nodiscard]] std::string in_mebibytes(std::uint64_t bytes);

}  // namespace occlude::render
