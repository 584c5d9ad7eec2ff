// SPDX-License-Identifier: MIT
#include "gltf_document.h"

#include <fmt/format.h>

#include <bit>
#include <cstring>
#include <limits>
#include <utility>

namespace occlude::render::gltf {
namespace {

// The numbers of a .glb file and of buffers are little-endian, and are read as they lie.
static_assert(std::endian::native == std::endian::little);

constexpr std::string_view kMagic = "glTF";
constexpr std::size_t kHeader = 12, kChunkHeader = 8;
constexpr std::uint32_t kJsonChunk = 0x4E4F534A, kBinaryChunk = 0x004E4942;

std::uint32_t number_at(std::string_view bytes, std::size_t place) {
  std::uint32_t number = 0;
  std::memcpy(&number, bytes.data() + place, sizeof(number));
  return number;
}

/// Takes a chunk off the front of the chunks.
std::pair<std::uint32_t, std::string_view> take_chunk(std::string_view& chunks) {
  if (chunks.size() < kChunkHeader) refuse("the file ends within a chunk");
  const std::uint32_t length = number_at(chunks, 0), type = number_at(chunks, 4);
  if (length > chunks.size() - kChunkHeader)
    refuse(fmt::format("a chunk of {} bytes has only {}", length, chunks.size() - kChunkHeader));
  const std::string_view content = chunks.substr(kChunkHeader, length);
  chunks.remove_prefix(kChunkHeader + length);
  return {type, content};
}

/// A number without fraction, however it is written.
std::optional<std::uint64_t> whole(const json& value) {
  if (value.is_number_unsigned()) return value.get<std::uint64_t>();
  if (!value.is_number_float()) return std::nullopt;
  const auto number = value.get<double>();
  if (!(number >= 0 && number < 0x1p53) || number != static_cast<double>(static_cast<std::uint64_t>(number)))
    return std::nullopt;
  return static_cast<std::uint64_t>(number);
}

[[noreturn]] void refuse_kind(const char* name, const char* kind) { refuse(fmt::format("{}: expected {}", name, kind)); }

}  // namespace

void refuse(const std::string& reason) { throw InputError(reason); }

const json* find(const json& object, const char* name) {
  const auto found = object.find(name);
  return found == object.end() ? nullptr : &*found;
}

const json& object_in(const json& object, const char* name) {
  const json* const value = find(object, name);
  if (value == nullptr) refuse(fmt::format("{}: missing", name));
  if (!value->is_object()) refuse_kind(name, "an object");
  return *value;
}

const json& array_in(const json& object, const char* name) {
  static const json none = json::array();
  const json* const value = find(object, name);
  if (value == nullptr) return none;
  if (!value->is_array()) refuse_kind(name, "an array");
  return *value;
}

std::optional<std::uint64_t> find_whole(const json& object, const char* name) {
  const json* const value = find(object, name);
  if (value == nullptr) return std::nullopt;
  if (const auto number = whole(*value)) return number;
  refuse_kind(name, "a whole number that is not negative");
}

std::uint64_t whole_in(const json& object, const char* name) {
  if (const auto number = find_whole(object, name)) return *number;
  refuse(fmt::format("{}: missing", name));
}

bool flag_in(const json& object, const char* name, bool otherwise) {
  const json* const value = find(object, name);
  if (value == nullptr) return otherwise;
  if (!value->is_boolean()) refuse_kind(name, "true or false");
  return value->get<bool>();
}

double number_in(const json& object, const char* name, double otherwise) {
  const json* const value = find(object, name);
  if (value == nullptr) return otherwise;
  if (!value->is_number()) refuse_kind(name, "a number");
  return value->get<double>();
}

std::string text_in(const json& object, const char* name, const char* otherwise) {
  const json* const value = find(object, name);
  if (value == nullptr) return otherwise;
  if (!value->is_string()) refuse_kind(name, "a string");
  return value->get<std::string>();
}

std::optional<std::vector<double>> find_numbers(const json& object, const char* name) {
  const json* const value = find(object, name);
  if (value == nullptr) return std::nullopt;
  if (!value->is_array()) refuse_kind(name, "an array of numbers");
  std::vector<double> numbers;
  for (const json& number : *value) {
    if (!number.is_number()) refuse_kind(name, "an array of numbers");
    numbers.push_back(number.get<double>());
  }
  return numbers;
}

std::optional<std::vector<double>> find_numbers(const json& object, const char* name, std::size_t count) {
  auto numbers = find_numbers(object, name);
  if (numbers && numbers->size() != count) refuse(fmt::format("{}: {} numbers instead of {}", name, numbers->size(), count));
  return numbers;
}

const json* find_extension(const json& object, const char* name) {
  if (find(object, "extensions") == nullptr) return nullptr;
  const json& extensions = object_in(object, "extensions");
  return find(extensions, name) == nullptr ? nullptr : &object_in(extensions, name);
}

std::string container_of(std::string text, std::string binary) {
  constexpr std::size_t kAligned = 4;
  text.resize((text.size() + kAligned - 1) / kAligned * kAligned, ' ');
  binary.resize((binary.size() + kAligned - 1) / kAligned * kAligned);
  const std::size_t length = kHeader + 2 * kChunkHeader + text.size() + binary.size();
  if (length > std::numeric_limits<std::uint32_t>::max()) refuse("what is left does not fit in a container");
  std::string bytes(kMagic);
  const auto append = [&](std::size_t number) {
    const auto value = static_cast<std::uint32_t>(number);
    bytes.append(reinterpret_cast<const char*>(&value), sizeof(value));
  };
  append(2);
  append(length);
  append(text.size());
  append(kJsonChunk);
  bytes += text;
  append(binary.size());
  append(kBinaryChunk);
  return bytes + binary;
}

Document::Document(std::string bytes) : bytes_(std::move(bytes)) {
  if (bytes_.starts_with(kMagic)) {
    open_container();
  } else {
    parse(bytes_);
  }
  if (!root_.is_object()) refuse("the JSON is not an object");
  check_version();
}

void Document::check_version() const {
  const json& asset = object_in(root_, "asset");
  const json* const version = find(asset, "version");
  // Files of version 1 have it as a string or as a number.
  if (version != nullptr && (*version == "1.0" || *version == 1.0)) throw OldVersion();
  for (const char* const member : {"version", "minVersion"}) {
    const std::string text = text_in(asset, member, "2.0");
    const bool is_read = member == std::string_view("version") ? text.starts_with("2.") : text == "2.0";
    if (!is_read) refuse(fmt::format("asset: {}: glTF {} is not supported, but 2.0", member, text));
  }
}

const json& Document::item(const List& list, std::uint64_t index) const {
  const json& items = array_in(root_, list.name);
  if (index >= items.size()) refuse(fmt::format("{} {}: there are {}", list.one, index, items.size()));
  const json& item = items[static_cast<std::size_t>(index)];
  if (!item.is_object()) refuse(fmt::format("{} {}: expected an object", list.one, index));
  return item;
}

std::string Document::label(const List& list, std::uint64_t index) const {
  const json* const name = find(item(list, index), "name");
  return name == nullptr || !name->is_string()
             ? fmt::format("{} {}", list.one, index)
             : fmt::format("{} {} \"{}\"", list.one, index, name->get_ref<const std::string&>());
}

void Document::open_container() {
  if (bytes_.size() < kHeader) refuse("the file ends within its header");
  const std::uint32_t version = number_at(bytes_, 4), length = number_at(bytes_, 8);
  if (version != 2) refuse(fmt::format("version {} of the container is not supported, but 2", version));
  if (length < kHeader || length > bytes_.size())
    refuse(fmt::format("the file has {} bytes, its header says {}", bytes_.size(), length));
  std::string_view chunks = std::string_view(bytes_).substr(kHeader, length - kHeader);
  const auto [type, text] = take_chunk(chunks);
  if (type != kJsonChunk) refuse("the first chunk is not JSON");
  parse(text);
  if (chunks.empty()) return;
  const auto [next_type, content] = take_chunk(chunks);
  if (next_type == kBinaryChunk) binary_ = std::as_bytes(std::span(content));
}

void Document::parse(std::string_view text) {
  while (text.ends_with('\0')) text.remove_suffix(1);  // some writers fill the chunk so
  try {
    root_ = json::parse(text);
  } catch (const json::exception& error) {
    const std::string_view what = error.what();
    refuse("no JSON that can be read: " + std::string(what.substr(what.find("] ") + 2)));
  }
}

}  // namespace occlude::render::gltf
