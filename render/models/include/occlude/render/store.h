// SPDX-License-Identifier: MIT
// The file of `occlude preprocess`: a model with all that culling it needs. It is mapped, checked and used where it lies.
#pragma once

#include <cstdint>
#include <filesystem>

#include "occlude/culler/culler.h"
#include "occlude/culler/polygon_soup.h"
#include "occlude/render/output_file.h"

namespace occlude::render {

/// The layout of the file. All numbers are little-endian; a machine of another byte order refuses to read or write it.
/// 1. The header, 64 bytes: "occlude preprocess\n"; the version, u32; 1 byte 0; the number of sections, u32; 4 bytes 0; the
///    size of the file, u64; 16 bytes 0; the hash of the header before it and of the table, u64.
/// 2. The table, 64 bytes for each section: its name, filled with 0 to 32 bytes; the size of an element, u32; 4 bytes 0;
///    where it begins in the file, its size, and its hash, u64 each.
/// 3. The sections, in the order of the table, each filled with 0 to the next multiple of 64 bytes, where the next one
///    begins. They are the parts of a culler (occlude/culler/parts.h), in their layout in memory.
/// A hash is XXH3 with 64 bits. That of a section is the hash of the hashes of its pieces of 1 MiB; what fills it up must
/// be 0. So no bit of the file can change unnoticed.
inline constexpr std::uint32_t kStoreVersion = 7;

/// Writes the culler, after making what frames by either method need. The caller commits the file. The same culler gives the
/// same bytes.
void write_store(OutputFile& file, const culler::Culler& culler);

/// Whether the file begins as a store does, of any version. Throws InputError if it cannot be read.
[[nodiscard]] bool is_store(const std::filesystem::path& file);

/// The culler in the file, which keeps the file mapped: nothing is copied. What only frames by the other method
/// than this need is not read, and is made anew if it is asked for: occluders without what samples have found. Throws
/// InputError, naming the file, if it is not a store, has another version, is too short or too long, or is damaged, and
/// where the constructor of Culler throws. Allocates no more than some times the size of the file. A file that anyone has
/// made, with right hashes, gives a culler that is in bounds and culls nothing visible of the model in it, with the
/// exception that the constructor of Culler names: oriented boxes.
[[nodiscard]] culler::Culler read_store(const std::filesystem::path& file, culler::Method method);

/// A number that differs for stores that differ. Throws as read_store() does about the header.
[[nodiscard]] std::uint64_t hash_of_store(const std::filesystem::path& file);

/// The model of a culler, as it was before it was prepared.
[[nodiscard]] culler::PolygonSoup model_of(const culler::Culler& culler);

/// Whether this is the model of the culler, bit by bit.
[[nodiscard]] bool is_model_of(culler::SoupView soup, const culler::Culler& culler);

}  // namespace occlude::render
