// SPDX-License-Identifier: MIT
#include "gltf_buffers.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <charconv>
#include <system_error>

#include "gltf_meshopt.h"
#include "occlude/render/input_file.h"

namespace occlude::render::gltf {
namespace fs = std::filesystem;
namespace {

constexpr std::string_view kData = "data:";

/// The value of a digit of base64, or -1.
int base64_digit(char c) {
  if (c >= 'A' && c <= 'Z') return c - 'A';
  if (c >= 'a' && c <= 'z') return c - 'a' + 26;
  if (c >= '0' && c <= '9') return c - '0' + 52;
  return c == '+' ? 62 : c == '/' ? 63 : -1;
}

std::string content_of_data_uri(std::string_view uri) {
  const std::size_t comma = uri.find(',');
  if (comma == std::string_view::npos || !uri.substr(0, comma).ends_with(";base64")) refuse("uri: its data is not base64");
  return from_base64(uri.substr(comma + 1));
}

/// With %20 as a blank, and so on.
std::string without_escapes(std::string_view uri) {
  std::string text;
  for (std::size_t i = 0; i < uri.size(); ++i) {
    unsigned byte = 0;
    if (uri[i] == '%' && i + 2 < uri.size() &&
        std::from_chars(uri.data() + i + 1, uri.data() + i + 3, byte, 16).ptr == uri.data() + i + 3) {
      text += static_cast<char>(byte);
      i += 2;
    } else {
      text += uri[i];
    }
  }
  return text;
}

/// Whether a URI begins with the name of a scheme, such as `http:`.
bool has_scheme(std::string_view uri) {
  const auto is_part = [](unsigned char c) { return std::isalnum(c) != 0 || c == '+' || c == '-' || c == '.'; };
  const auto end = std::ranges::find_if_not(uri, is_part);
  return end != uri.begin() && end != uri.end() && *end == ':';
}

/// The file that a URI names, by a path without links. Refuses what is not in the folder, or not there.
fs::path file_in(const fs::path& folder, const std::string& uri) {
  if (has_scheme(uri)) refuse("only files are read");
  const fs::path name = without_escapes(uri);
  if (name.native().find('\0') != std::string::npos) refuse("no name of a file");
  std::error_code error;
  const fs::path file = fs::canonical(folder / name, error);
  if (error) refuse("cannot read: " + error.message());
  const fs::path home = fs::canonical(folder);
  const bool leads_out = name.is_absolute() || std::ranges::find(name, fs::path("..")) != name.end() ||
                         std::ranges::mismatch(home, file).in1 != home.end();
  if (leads_out) refuse("it is not in the folder of the model");
  return file;
}

}  // namespace

std::string from_base64(std::string_view text) {
  while (text.ends_with('=')) text.remove_suffix(1);
  std::string bytes;
  bytes.reserve(text.size() / 4 * 3 + 2);
  unsigned bits = 0;
  int count = 0;
  for (const char c : text) {
    const int digit = base64_digit(c);
    if (digit < 0) refuse("uri: its data is not base64");
    bits = bits << 6U | static_cast<unsigned>(digit);
    count += 6;
    if (count < 8) continue;
    count -= 8;
    bytes += static_cast<char>(bits >> static_cast<unsigned>(count) & 0xFFU);
  }
  return bytes;
}

std::string to_base64(std::string_view bytes) {
  constexpr std::string_view kDigits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    unsigned bits = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      bits = bits << 8U | (i + k < bytes.size() ? static_cast<unsigned char>(bytes[i + k]) : 0U);
    }
    for (unsigned k = 0; k < 4; ++k) text += i + k > bytes.size() ? '=' : kDigits[bits >> (18U - 6U * k) & 63U];
  }
  return text;
}

Buffers::View Buffers::view(std::uint64_t index) {
  const json& view = document_.item(kBufferViews, index);
  return at([&] { return document_.label(kBufferViews, index); },
            [&]() -> View {
              const std::uint64_t stride = find_whole(view, "byteStride").value_or(0);
              const json* const compressed = find_extension(view, "EXT_meshopt_compression");
              if (compressed == nullptr) return {part(view), stride};
              auto decoded = decoded_views_.find(index);
              if (decoded == decoded_views_.end())
                decoded = decoded_views_.emplace(index, decode_meshopt(*compressed, part(*compressed))).first;
              return {decoded->second, stride};
            });
}

std::string Buffers::image(std::uint64_t index) {
  const json& image = document_.item(kImages, index);
  if (const auto index_of_view = find_whole(image, "bufferView")) {
    const std::span<const std::byte> bytes = view(*index_of_view).bytes;
    return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
  }
  const std::string uri = text_in(image, "uri", "");
  if (uri.starts_with(kData)) return content_of_data_uri(uri);
  const fs::path path = file_in(folder_, uri);
  files_.count(path);
  return read_input(path);
}

std::span<const std::byte> Buffers::part(const json& range) {
  const std::span<const std::byte> bytes = buffer(whole_in(range, "buffer"));
  const std::uint64_t offset = find_whole(range, "byteOffset").value_or(0), length = whole_in(range, "byteLength");
  if (offset > bytes.size() || length > bytes.size() - offset)
    refuse(fmt::format("bytes {} to {} + {} of a buffer of {}", offset, offset, length, bytes.size()));
  return bytes.subspan(static_cast<std::size_t>(offset), static_cast<std::size_t>(length));
}

std::span<const std::byte> Buffers::buffer(std::uint64_t index) {
  if (const auto known = buffers_.find(index); known != buffers_.end()) return known->second;
  const json& buffer = document_.item(kBuffers, index);
  return buffers_[index] = at([&] { return document_.label(kBuffers, index); },
                              [&] {
                                const std::uint64_t length = whole_in(buffer, "byteLength");
                                const std::span<const std::byte> bytes = load(index);
                                if (length > bytes.size())
                                  refuse(fmt::format("{} bytes instead of {}", bytes.size(), length));
                                return bytes.first(static_cast<std::size_t>(length));
                              });
}

std::span<const std::byte> Buffers::load(std::uint64_t index) {
  const json& buffer = document_.item(kBuffers, index);
  if (find(buffer, "uri") == nullptr) {
    if (index == 0 && document_.binary()) return *document_.binary();
    refuse("uri: missing");
  }
  const std::string uri = text_in(buffer, "uri", "");
  if (uri.starts_with(kData)) return std::as_bytes(std::span(embedded_[index] = content_of_data_uri(uri)));
  return at([&] { return fmt::format("\"{}\"", uri); }, [&] { return file(uri); });
}

std::span<const std::byte> Buffers::file(const std::string& uri) {
  const fs::path path = file_in(folder_, uri);
  auto content = in_files_.find(path);
  if (content == in_files_.end()) {
    files_.count(path);
    content = in_files_.emplace(path, read_input(path)).first;
  }
  return std::as_bytes(std::span(content->second));
}

}  // namespace occlude::render::gltf
