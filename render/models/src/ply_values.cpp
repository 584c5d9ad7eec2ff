// SPDX-License-Identifier: MIT
#include "ply_values.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cstring>

#include "occlude/render/errors.h"
#include "text_number.h"

namespace occlude::render::ply {
namespace {

bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\r' || c == '\n'; }

/// The fewest bytes of one value; in text a digit and a blank.
std::size_t least_bytes(Encoding encoding, Scalar type) { return encoding == Encoding::ascii ? 2 : size_of(type); }

}  // namespace

ValueReader::ValueReader(const std::filesystem::path& file, const Header& header, std::string_view bytes)
    : file_(file), encoding_(header.encoding), rest_(bytes.substr(header.bytes)), line_(header.lines + 1) {}

std::string ValueReader::place() const {
  const std::string line = encoding_ == Encoding::ascii ? fmt::format(":{}", line_) : std::string();
  return fmt::format("{}{}: {} {}", file_.string(), line, element_->name, index_);
}

void ValueReader::fail(const std::string& reason) const { throw InputError(place() + ": " + reason); }

void ValueReader::expect_room_for(const Element& element) const {
  std::size_t least = 0;
  for (const Property& property : element.properties)
    least += least_bytes(encoding_, property.count.value_or(property.type));
  // In text no blank needs to follow the last value.
  const std::size_t room = rest_.size() + (encoding_ == Encoding::ascii ? 1 : 0);
  if (least != 0 && element.count > room / least) {
    throw InputError(fmt::format("{}: {} of element \"{}\" are declared, but the file is too short for them", file_.string(),
                                 element.count, element.name));
  }
}

void ValueReader::expect_end() {
  if (encoding_ == Encoding::ascii) skip_blanks();
  if (rest_.empty()) return;
  const std::string line = encoding_ == Encoding::ascii ? fmt::format(":{}", line_) : "";
  throw InputError(fmt::format("{}{}: {} bytes follow the last element", file_.string(), line, rest_.size()));
}

void ValueReader::skip_blanks() {
  std::size_t begin = 0;
  for (; begin < rest_.size() && is_blank(rest_[begin]); ++begin) line_ += rest_[begin] == '\n';
  rest_.remove_prefix(begin);
}

std::string_view ValueReader::token() {
  skip_blanks();
  std::size_t end = 0;
  while (end < rest_.size() && !is_blank(rest_[end])) ++end;
  const std::string_view word = rest_.substr(0, end);
  rest_.remove_prefix(end);
  if (word.empty()) fail("the file ends here");
  return word;
}

template <class T>
T ValueReader::take_text() {
  const auto number = parse_number<T>(token());
  const char* const what = std::is_integral_v<T> ? "an integer of at most 64 bits" : "a number";
  if (!number) throw InputError(fmt::format("{}:{}: expected {}", file_.string(), line_, what));
  return *number;
}

template <class T>
T ValueReader::take_binary() {
  if (rest_.size() < sizeof(T)) fail("the file ends here");
  std::array<char, sizeof(T)> bytes;
  std::memcpy(bytes.data(), rest_.data(), sizeof(T));
  rest_.remove_prefix(sizeof(T));
  const bool file_is_little = encoding_ == Encoding::binary_little_endian;
  if (file_is_little != (std::endian::native == std::endian::little)) std::ranges::reverse(bytes);
  return std::bit_cast<T>(bytes);
}

template <class T>
T ValueReader::take() {
  return encoding_ == Encoding::ascii ? take_text<T>() : take_binary<T>();
}

double ValueReader::real(Scalar type) {
  if (type == Scalar::float32) return static_cast<double>(take<float>());
  if (type == Scalar::float64) return take<double>();
  return static_cast<double>(integer(type));
}

/// What work(T()) returns for the type T of a binary integer.
template <class Work>
auto with_type(Scalar type, const Work& work) {
  switch (type) {
    case Scalar::int8:
      return work(std::int8_t());
    case Scalar::uint8:
      return work(std::uint8_t());
    case Scalar::int16:
      return work(std::int16_t());
    case Scalar::uint16:
      return work(std::uint16_t());
    case Scalar::int32:
      return work(std::int32_t());
    default:
      return work(std::uint32_t());
  }
}

std::int64_t ValueReader::integer(Scalar type) {
  if (encoding_ == Encoding::ascii) return take_text<std::int64_t>();
  return with_type(type, [&]<class T>(T) -> std::int64_t { return take_binary<T>(); });
}

void ValueReader::integers(Scalar type, std::int64_t count, std::vector<std::int64_t>& to) {
  to.clear();
  if (encoding_ == Encoding::ascii) {
    for (; count > 0; --count) to.push_back(take_text<std::int64_t>());
    return;
  }
  if (static_cast<std::uint64_t>(count) > rest_.size() / size_of(type)) fail("the file ends here");
  to.resize(static_cast<std::size_t>(count));
  with_type(type, [&]<class T>(T) {
    for (std::int64_t& item : to) item = take_binary<T>();
  });
}

void ValueReader::skip(const Property& property) {
  const std::int64_t items = property.count ? integer(*property.count) : 1;
  if (items < 0) fail("the list has a negative length");
  if (encoding_ == Encoding::ascii) {
    for (std::int64_t i = 0; i < items; ++i) static_cast<void>(token());
  } else {
    const std::size_t bytes = static_cast<std::size_t>(items) * size_of(property.type);
    if (bytes > rest_.size()) fail("the file ends here");
    rest_.remove_prefix(bytes);
  }
}

}  // namespace occlude::render::ply
