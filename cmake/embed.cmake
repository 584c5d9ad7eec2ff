# Writes the C++ file OUT, which holds the FILES (a list with commas) and returns their bytes by name: it defines FUNCTION of
# the header HEADER. Run by `cmake -P`. Of modules of JavaScript (*.mjs) it holds what a page has in one script: they neither
# import nor export.
string(REPLACE "," ";" files "${FILES}")
set(arrays "")
set(cases "")
foreach(file IN LISTS files)
  cmake_path(GET file FILENAME name)
  string(MAKE_C_IDENTIFIER "${name}" identifier)
  file(READ ${file} bytes HEX)
  if(name MATCHES "\\.mjs$")
    file(READ ${file} text)
    string(REGEX REPLACE "(^|\n)import [^\n]*" "\\1" text "${text}")
    string(REGEX REPLACE "(^|\n)export " "\\1" text "${text}")
    string(HEX "${text}" bytes)
  endif()
  # The last line of a library may name a source map ("//# sourceMappingURL="), which a page does not have.
  string(REGEX REPLACE "2f2[fa]2320736f757263654d617070696e6755524c.*$" "" bytes "${bytes}")
  string(REGEX REPLACE "(..)" "0x\\1," bytes "${bytes}")
  string(APPEND arrays "constexpr unsigned char ${identifier}[] = {${bytes}};\n")
  string(APPEND cases "  if (name == \"${name}\") return text(${identifier}, sizeof ${identifier});\n")
endforeach()
file(WRITE ${OUT} "// Made by embed.cmake.
#include \"${HEADER}\"

namespace occlude::render {
namespace {

${arrays}
std::string_view text(const unsigned char* bytes, std::size_t size) { return {reinterpret_cast<const char*>(bytes), size}; }

}  // namespace

std::string_view ${FUNCTION}(std::string_view name) {
${cases}  return {};
}

}  // namespace occlude::render
")
