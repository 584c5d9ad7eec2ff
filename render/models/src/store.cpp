// SPDX-License-Identifier: MIT
#include "occlude/render/store.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cstring>
#include <fstream>
#include <memory>
#include <new>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "mapped_file.h"
#include "occlude/render/errors.h"
#include "occlude/render/input_file.h"
#include "occlude/render/progress.h"
#include "store_format.h"

namespace occlude::render {
namespace {

using Bytes = std::span<const std::byte>;

/// Throws InputError about a file.
[[noreturn]] void fail(const std::filesystem::path& file, const std::string& reason) {
  throw InputError(file.string() + ": " + reason);
}

void require_little_endian(const std::filesystem::path& file) {
  if constexpr (std::endian::native != std::endian::little) fail(file, "stores are for little-endian machines only");
}

std::string_view text_of(Bytes bytes) { return {reinterpret_cast<const char*>(bytes.data()), bytes.size()}; }

template <class T>
std::string_view text_of(const T& value) {
  return text_of(std::as_bytes(std::span(&value, 1)));
}

// Writing.

StoreSection section_of(const culler::Part& part, std::uint64_t offset) {
  StoreSection section;
  if (part.name.size() >= section.name.size()) throw std::logic_error("the name of a part is too long");
  std::ranges::copy(part.name, section.name.begin());
  section.element = static_cast<std::uint32_t>(part.element);
  section.offset = offset;
  section.bytes = part.bytes.size();
  return section;
}

/// What fills a section up.
Bytes filling(std::uint64_t bytes) {
  static constexpr std::array<std::byte, kStoreAlignment> kZeros{};
  return Bytes(kZeros).first(aligned(bytes) - bytes);
}

// Reading.

/// A store whose header and table are right.
class OpenStore {
 public:
  explicit OpenStore(const std::filesystem::path& file) : file_(file), mapped_(std::make_shared<const MappedFile>(file)) {
    require_little_endian(file);
    const StoreHeader header = read_header();
    table_.resize(header.sections);
    std::memcpy(table_.data(), bytes().data() + sizeof header, header.sections * sizeof(StoreSection));
    if (hash_of(header, table_) != header.hash) damaged("its table");
    hash_ = header.hash;
    check_places(header);
  }

  [[nodiscard]] std::uint64_t hash() const { return hash_; }

  /// The parts that frames by this method need. Throws InputError if one of them is damaged.
  [[nodiscard]] culler::Parts parts(culler::Method method) const {
    culler::Parts parts{{}, mapped_};
    std::vector<Bytes> sections;
    std::vector<std::uint64_t> hashes;
    for (const StoreSection& section : table_) {
      const std::string_view name(section.name.data());
      if (is_by_cover(culler::Culler::method_of(name).value_or(method)) != is_by_cover(method)) {
        parts.left_out += section.bytes;
        continue;
      }
      parts.parts.push_back({name, section.element, bytes().subspan(section.offset, section.bytes)});
      sections.push_back(parts.parts.back().bytes);
      hashes.push_back(section.hash);
    }
    const std::vector<std::uint64_t> found = hashes_of(sections, MappedFile::populate);
    const auto differs = std::ranges::mismatch(found, hashes).in1;
    if (differs != found.end()) {
      damaged(fmt::format("part \"{}\"", parts.parts[static_cast<std::size_t>(differs - found.begin())].name));
    }
    return parts;
  }

 private:
  [[nodiscard]] Bytes bytes() const { return mapped_->bytes(); }
  [[noreturn]] void damaged(const std::string& what) const { fail(file_, what + " is damaged: preprocess the model again"); }

  [[nodiscard]] StoreHeader read_header() const {
    if (!text_of(bytes()).starts_with(kStoreMagic)) fail(file_, "not a file of occlude preprocess");
    require(kStoreMagic.size() + sizeof(std::uint32_t));
    std::uint32_t version = 0;
    std::memcpy(&version, bytes().data() + kStoreMagic.size(), sizeof version);
    if (version != kStoreVersion) {
      fail(file_, fmt::format("format version {}, but this program reads version {}: preprocess the model again", version,
                              kStoreVersion));
    }
    require(sizeof(StoreHeader));
    StoreHeader header;
    std::memcpy(&header, bytes().data(), sizeof header);
    require(sizeof header + std::uint64_t{header.sections} * sizeof(StoreSection));
    return header;
  }

  void require(std::uint64_t size) const {
    if (size > bytes().size()) fail(file_, fmt::format("the file ends too early, at byte {}", bytes().size()));
  }

  /// Sections follow one another without gaps, to the end of the file.
  void check_places(const StoreHeader& header) const {
    std::uint64_t end = sizeof header + table_.size() * sizeof(StoreSection);
    require(header.bytes);
    if (header.bytes < end) damaged("its table");
    for (const StoreSection& section : table_) {
      if (section.name.back() != 0 || section.offset != end || section.bytes > header.bytes - end) damaged("its table");
      const std::uint64_t filled = end + aligned(section.bytes);
      if (filled > header.bytes) damaged("its table");
      const Bytes filling = bytes().subspan(end + section.bytes, filled - end - section.bytes);
      if (std::ranges::any_of(filling, [](std::byte b) { return b != std::byte{}; })) damaged("what fills a section");
      end = filled;
    }
    if (end != header.bytes) damaged("its table");
    if (end != bytes().size()) fail(file_, "there is data after the last section");
  }

  const std::filesystem::path& file_;
  std::shared_ptr<const MappedFile> mapped_;
  std::vector<StoreSection> table_;
  std::uint64_t hash_ = 0;
};

}  // namespace

void write_store(OutputFile& file, const culler::Culler& culler) {
  require_little_endian(file.path());
  const culler::Parts parts = culler.parts(check_interrupt);
  std::vector<StoreSection> table;
  std::uint64_t end = sizeof(StoreHeader) + parts.parts.size() * sizeof(StoreSection);
  for (const culler::Part& part : parts.parts) {
    table.push_back(section_of(part, end));
    end += aligned(part.bytes.size());
  }
  StoreHeader header;
  std::ranges::copy(kStoreMagic, header.magic.begin());
  std::memcpy(header.version.data(), &kStoreVersion, sizeof kStoreVersion);
  header.sections = static_cast<std::uint32_t>(table.size());
  header.bytes = end;
  std::vector<Bytes> sections;
  for (const culler::Part& part : parts.parts) sections.push_back(part.bytes);
  const std::vector<std::uint64_t> hashes = hashes_of(sections);
  for (std::size_t i = 0; i < table.size(); ++i) table[i].hash = hashes[i];
  header.hash = hash_of(header, table);

  file.write(text_of(header));
  file.write(text_of(std::as_bytes(std::span(table))));
  for (const culler::Part& part : parts.parts) {
    check_interrupt();
    file.write(text_of(part.bytes));
    file.write(text_of(filling(part.bytes.size())));
  }
}

bool is_store(const std::filesystem::path& file) {
  require_readable(file, UINT64_MAX);
  std::ifstream in(file, std::ios::binary);
  std::string start(kStoreMagic.size(), '\0');
  in.read(start.data(), static_cast<std::streamsize>(start.size()));
  return in && start == kStoreMagic;
}

culler::Culler read_store(const std::filesystem::path& file, culler::Method method) try {
  return culler::Culler(OpenStore(file).parts(method), check_interrupt);
} catch (const std::invalid_argument& error) {
  fail(file, error.what());
} catch (const std::bad_alloc&) {
  fail(file, "out of memory");
}

std::uint64_t hash_of_store(const std::filesystem::path& file) { return OpenStore(file).hash(); }

culler::PolygonSoup model_of(const culler::Culler& culler) {
  const culler::Hierarchy& hierarchy = culler.hierarchy();
  const culler::SoupView soup = hierarchy.soup();
  culler::PolygonSoup model;
  model.vertices.assign(soup.vertices.begin(), soup.vertices.end());
  model.faces.assign(hierarchy.faces().begin(), hierarchy.faces().end());
  model.see_through.resize(soup.see_through.size());
  model.first.resize(soup.first.size());
  for (std::size_t p = 0; p < soup.size(); ++p) {
    model.first[hierarchy.original(p) + std::size_t{1}] = static_cast<std::uint32_t>(soup.loop(p).size());
  }
  for (std::size_t p = 0; p < soup.size(); ++p) model.first[p + 1] += model.first[p];
  model.indices.resize(soup.indices.size());
  for (std::size_t p = 0; p < soup.size(); ++p) {
    const std::uint32_t original = hierarchy.original(p);
    std::ranges::copy(soup.loop(p), model.indices.begin() + model.first[original]);
    if (!soup.see_through.empty()) model.see_through[original] = soup.see_through[p];
  }
  return model;
}

bool is_model_of(culler::SoupView soup, const culler::Culler& culler) {
  const culler::Hierarchy& hierarchy = culler.hierarchy();
  const culler::SoupView own = hierarchy.soup();
  if (soup.vertices.size() != own.vertices.size() || soup.size() != own.size()) return false;
  if (std::memcmp(soup.vertices.data(), own.vertices.data(), soup.vertices.size() * sizeof(glm::dvec3)) != 0) return false;
  for (std::size_t p = 0; p < own.size(); ++p) {
    const std::uint32_t original = hierarchy.original(p);
    if (!std::ranges::equal(own.loop(p), soup.loop(original))) return false;
    if (own.is_opaque(p) != soup.is_opaque(original) || hierarchy.face(p) != soup.face(original)) return false;
  }
  return true;
}

}  // namespace occlude::render
