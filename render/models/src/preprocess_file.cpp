// SPDX-License-Identifier: MIT
#include "occlude/render/preprocess_file.h"

#include <fmt/format.h>
#include <zlib.h>

#include <array>
#include <bit>
#include <cstring>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>

#include "occlude/render/errors.h"
#include "occlude/render/input_file.h"
#include "occlude/render/progress.h"

namespace occlude::render {
namespace {

static_assert(std::endian::native == std::endian::little, "numbers are written in their memory layout");

constexpr std::string_view kMagic = "occlude preprocess\n";

std::uint32_t crc(const void* data, std::size_t bytes) {
  return static_cast<std::uint32_t>(crc32_z(0, static_cast<const Bytef*>(data), bytes));
}

template <class T>
std::uint32_t crc_of(const std::vector<T>& values) {
  return crc(values.data(), values.size() * sizeof(T));
}

/// Identifies a model.
using Fingerprint = std::array<std::uint32_t, 3>;

Fingerprint fingerprint(const culler::PolygonSoup& soup) {
  return {crc_of(soup.vertices), crc_of(soup.indices), crc_of(soup.first)};
}

class Writer {
 public:
  template <class T>
  void put(const T& value) {
    bytes_.append(reinterpret_cast<const char*>(&value), sizeof value);
  }
  template <class T>
  void put(const std::vector<T>& values) {
    put(static_cast<std::uint64_t>(values.size()));
    bytes_.append(reinterpret_cast<const char*>(values.data()), values.size() * sizeof(T));
  }
  void put(std::string_view text) { bytes_ += text; }

  [[nodiscard]] const std::string& bytes() const { return bytes_; }

 private:
  std::string bytes_;
};

class Reader {
 public:
  Reader(const std::filesystem::path& file, std::string_view bytes) : file_(file), bytes_(bytes), rest_(bytes) {}

  [[noreturn]] void fail(const std::string& reason) const { throw InputError(file_.string() + ": " + reason); }

  [[nodiscard]] std::string_view take(std::size_t bytes) {
    if (bytes > rest_.size()) fail(fmt::format("the file ends too early, at byte {}", bytes_.size()));
    const std::string_view taken = rest_.substr(0, bytes);
    rest_.remove_prefix(bytes);
    return taken;
  }
  template <class T>
  T get() {
    T value;
    std::memcpy(&value, take(sizeof value).data(), sizeof value);
    return value;
  }
  template <class T>
  std::vector<T> get_all() {
    const auto count = get<std::uint64_t>();
    if (count > rest_.size() / sizeof(T)) fail(fmt::format("the file ends too early, at byte {}", bytes_.size()));
    std::vector<T> values(count);
    const std::string_view taken = take(count * sizeof(T));
    if (count != 0) std::memcpy(values.data(), taken.data(), taken.size());
    return values;
  }
  /// Reads the checksum and checks that nothing follows.
  void end() {
    const std::uint32_t found = crc(bytes_.data(), bytes_.size() - rest_.size());
    if (get<std::uint32_t>() != found) fail("the checksum is wrong: the file is damaged");
    if (!rest_.empty()) fail("there is data after the checksum");
  }

 private:
  const std::filesystem::path& file_;
  std::string_view bytes_, rest_;
};

}  // namespace

void write_preprocess(OutputFile& file, const culler::PolygonSoup& soup, const culler::Preprocess& preprocess) {
  const auto& [config, layout, lists] = preprocess;
  Writer writer;
  writer.put(kMagic);
  writer.put(kPreprocessVersion);
  writer.put(fingerprint(soup));
  writer.put(config.hierarchy.leaf_size);
  writer.put(std::uint32_t{config.hierarchy.bounds == culler::Bounds::obb});
  writer.put(std::uint32_t{config.occluders.shells});
  writer.put(std::uint32_t{config.lists.kind == culler::Partition::Kind::tree});
  writer.put(config.lists.threshold);
  writer.put(config.lists.regions);
  writer.put(layout.order);
  writer.put(layout.left);
  writer.put(lists.first);
  writer.put(lists.occluders);
  writer.put(lists.hidden);
  writer.put(crc(writer.bytes().data(), writer.bytes().size()));
  file.write(writer.bytes());
}

culler::Preprocess read_preprocess(const std::filesystem::path& file, const culler::PolygonSoup& soup) {
  const std::string bytes = read_input(file);
  Reader reader(file, bytes);
  if (!bytes.starts_with(kMagic)) reader.fail("not a file of occlude preprocess");
  static_cast<void>(reader.take(kMagic.size()));
  if (const auto version = reader.get<std::uint32_t>(); version != kPreprocessVersion) {
    reader.fail(fmt::format("format version {}, but this program reads version {}: preprocess the model again", version,
                            kPreprocessVersion));
  }
  const auto model = reader.get<Fingerprint>();
  culler::Preprocess result;
  auto& [config, layout, lists] = result;
  config.hierarchy.leaf_size = reader.get<std::uint32_t>();
  const auto bounds = reader.get<std::uint32_t>(), shells = reader.get<std::uint32_t>(), kind = reader.get<std::uint32_t>();
  config.hierarchy.bounds = bounds == 0 ? culler::Bounds::aabb : culler::Bounds::obb;
  config.occluders.shells = shells != 0;
  config.lists.kind = kind == 0 ? culler::Partition::Kind::grid : culler::Partition::Kind::tree;
  config.lists.threshold = reader.get<double>();
  config.lists.regions = reader.get<double>();
  layout.order = reader.get_all<std::uint32_t>();
  layout.left = reader.get_all<std::uint32_t>();
  lists.first = reader.get_all<std::uint64_t>();
  lists.occluders = reader.get_all<std::uint32_t>();
  lists.hidden = reader.get_all<float>();
  reader.end();
  if (model != fingerprint(soup)) reader.fail("made from another model: preprocess this one");
  if (bounds > 1 || shells > 1 || kind > 1) reader.fail("invalid setting");
  return result;
}

}  // namespace occlude::render
