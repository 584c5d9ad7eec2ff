// SPDX-License-Identifier: MIT
#include "ply_header.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "occlude/render/errors.h"
#include "text_number.h"
#include "words.h"

namespace occlude::render::ply {
namespace {

struct ScalarName {
  std::string_view name, alias;
  Scalar type;
  std::size_t bytes;
};
constexpr std::array<ScalarName, 8> kScalars = {{{"char", "int8", Scalar::int8, 1},
                                                 {"uchar", "uint8", Scalar::uint8, 1},
                                                 {"short", "int16", Scalar::int16, 2},
                                                 {"ushort", "uint16", Scalar::uint16, 2},
                                                 {"int", "int32", Scalar::int32, 4},
                                                 {"uint", "uint32", Scalar::uint32, 4},
                                                 {"float", "float32", Scalar::float32, 4},
                                                 {"double", "float64", Scalar::float64, 8}}};

// Most elements in a file, and properties in an element. Real files have a dozen. Bounds the search for repeated names.
constexpr std::size_t kMostDeclarations = 1000;

/// Reads the header line by line.
class HeaderParser {
 public:
  HeaderParser(const std::filesystem::path& file, std::string_view bytes) : file_(file), bytes_(bytes) {}

  Header parse() {
    if (bytes_.empty()) throw InputError(file_.string() + ": the file is empty");
    if (next_line() != "ply") throw InputError(file_.string() + ": not a PLY file");
    read_format();
    while (read_statement()) {
    }
    return std::move(header_);
  }

 private:
  [[noreturn]] void fail(const std::string& reason) const {
    throw InputError(fmt::format("{}:{}: {}", file_.string(), header_.lines, reason));
  }

  std::string_view next_line() {
    ++header_.lines;
    const std::size_t end = bytes_.find('\n', header_.bytes);
    if (end == bytes_.npos) {
      if (header_.lines == 1) return {};
      fail("the header ends without end_header");
    }
    std::string_view line = bytes_.substr(header_.bytes, end - header_.bytes);
    header_.bytes = end + 1;
    if (line.ends_with('\r')) line.remove_suffix(1);
    return line;
  }

  void read_format() {
    auto words = words_of(next_line());
    while (!words.empty() && words[0] == "comment") words = words_of(next_line());
    if (words.size() != 3 || words[0] != "format" || words[2] != "1.0") fail("expected \"format ... 1.0\"");
    if (words[1] == "ascii") {
      header_.encoding = Encoding::ascii;
    } else if (words[1] == "binary_little_endian") {
      header_.encoding = Encoding::binary_little_endian;
    } else if (words[1] == "binary_big_endian") {
      header_.encoding = Encoding::binary_big_endian;
    } else {
      fail("unknown format (known: ascii, binary_little_endian, binary_big_endian)");
    }
  }

  /// False at end_header.
  bool read_statement() {
    const auto words = words_of(next_line());
    if (words.empty() || words[0] == "comment" || words[0] == "obj_info") return true;
    if (words[0] == "end_header") return false;
    if (words[0] == "element") {
      add_element(words);
    } else if (words[0] == "property") {
      add_property(words);
    } else {
      fail("expected element, property, comment or end_header");
    }
    return true;
  }

  void add_element(const std::vector<std::string_view>& words) {
    if (words.size() != 3) fail("expected \"element NAME COUNT\"");
    const auto count = parse_number<std::size_t>(words[2]);
    if (!count) fail("expected the number of elements, an integer of at most 64 bits");
    if (header_.find(words[1])) fail("the element was declared before");
    if (header_.elements.size() == kMostDeclarations) fail("too many elements");
    header_.elements.push_back({std::string(words[1]), *count, {}});
  }

  void add_property(const std::vector<std::string_view>& words) {
    if (header_.elements.empty()) fail("a property before the first element");
    const bool list = words.size() == 5 && words[1] == "list";
    if (!list && words.size() != 3) fail("expected \"property TYPE NAME\" or \"property list TYPE TYPE NAME\"");
    Element& element = header_.elements.back();
    Property property{std::string(words.back()), scalar(words[words.size() - 2]), std::nullopt};
    if (list) property.count = scalar(words[2]);
    if (list && !is_integer(*property.count)) fail("the length of a list must be of an integer type");
    if (element.find(property.name)) fail("the property was declared before");
    if (element.properties.size() == kMostDeclarations) fail("too many properties");
    element.properties.push_back(std::move(property));
  }

  Scalar scalar(std::string_view name) const {
    for (const ScalarName& scalar : kScalars) {
      if (name == scalar.name || name == scalar.alias) return scalar.type;
    }
    fail("unknown type (known: char uchar short ushort int uint float double)");
  }

  const std::filesystem::path& file_;
  std::string_view bytes_;
  Header header_;
};

}  // namespace

std::size_t size_of(Scalar type) { return kScalars[static_cast<std::size_t>(type)].bytes; }

bool is_integer(Scalar type) { return type != Scalar::float32 && type != Scalar::float64; }

const Property* Element::find(std::string_view property) const {
  const auto found = std::ranges::find(properties, property, &Property::name);
  return found == properties.end() ? nullptr : &*found;
}

const Property* Element::loop() const {
  const Property* const plural = find("vertex_indices");
  return plural != nullptr ? plural : find("vertex_index");
}

const Element* Header::find(std::string_view element) const {
  const auto found = std::ranges::find(elements, element, &Element::name);
  return found == elements.end() ? nullptr : &*found;
}

Header read_header(const std::filesystem::path& file, std::string_view bytes) { return HeaderParser(file, bytes).parse(); }

}  // namespace occlude::render::ply
