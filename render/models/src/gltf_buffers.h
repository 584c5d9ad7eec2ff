// SPDX-License-Identifier: MIT
// The bytes of a glTF file and of the files that it names.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <map>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "counted_files.h"
#include "gltf_document.h"

namespace occlude::render::gltf {

/// The bytes of `text` in base64 (RFC 4648), with or without padding.
[[nodiscard]] std::string from_base64(std::string_view text);
[[nodiscard]] std::string to_base64(std::string_view bytes);

/// Buffers and views of them. They are read when they are first asked for: a buffer that only pictures are in, and one that
/// a compressed view stands for, need not exist. Spans are good as long as this is there.
class Buffers {
 public:
  /// `folder`: that of the document's file. Files in it are read, and no others.
  Buffers(const Document& document, std::filesystem::path folder, CountedFiles& files)
      : document_(document), folder_(std::move(folder)), files_(files) {}

  struct View {
    std::span<const std::byte> bytes;
    std::uint64_t stride = 0;  ///< 0: elements follow each other closely
  };
  /// Of a view with EXT_meshopt_compression, what is decoded.
  [[nodiscard]] View view(std::uint64_t index);
  /// The bytes of the file of a picture. They are not kept.
  [[nodiscard]] std::string image(std::uint64_t index);

 private:
  [[nodiscard]] std::span<const std::byte> buffer(std::uint64_t index);
  [[nodiscard]] std::span<const std::byte> load(std::uint64_t index);
  [[nodiscard]] std::span<const std::byte> file(const std::string& uri);
  /// Bytes [byteOffset, byteOffset + byteLength) of the buffer that `range` names.
  [[nodiscard]] std::span<const std::byte> part(const json& range);

  const Document& document_;
  const std::filesystem::path folder_;
  CountedFiles& files_;
  std::map<std::uint64_t, std::span<const std::byte>> buffers_;
  std::map<std::uint64_t, std::vector<std::byte>> decoded_views_;
  std::map<std::uint64_t, std::string> embedded_;          ///< the content of data URIs, by buffer
  std::map<std::filesystem::path, std::string> in_files_;  ///< the content of files, whatever names buffers have for them
};

}  // namespace occlude::render::gltf
