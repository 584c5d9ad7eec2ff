# The flags with which every target of the project is compiled. Included once, from the top.
#
# occlude_options carries the flags privately: nothing of it reaches a project that links our libraries.
add_library(occlude_options INTERFACE)
target_compile_features(occlude_options INTERFACE cxx_std_20)
# A contracted a*b+c rounds once instead of twice. The error-free operations (kernel/src/error_free.h) compute what each
# rounding loses. If the compiler left one out, their results would no longer be exact, and the exact stage would be wrong.
# The filter's bounds would still hold, but `plain` and every figure in the files would differ between machines.
# A project that embeds us may compile with -ffast-math; the kernel's arithmetic must not be rearranged.
if(MSVC)  # /fp:precise does both with cl of Visual Studio 2022; clang-cl would contract
  target_compile_options(occlude_options INTERFACE /utf-8 /fp:precise $<$<CXX_COMPILER_ID:Clang>:/clang:-ffp-contract=off>)
else()
  target_compile_options(occlude_options INTERFACE -ffp-contract=off -fno-fast-math)
endif()
if(PROJECT_IS_TOP_LEVEL AND NOT MSVC)
  target_compile_options(occlude_options INTERFACE -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Werror)
  if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU" AND CMAKE_CXX_COMPILER_VERSION VERSION_LESS 13)
    # False positives on std::string concatenation (GCC bug 105651, fixed in 13).
    target_compile_options(occlude_options INTERFACE -Wno-restrict)
  endif()
  if(CMAKE_SIZEOF_VOID_P EQUAL 4)
    # Of what is in memory there are fewer than 2^31, also where a number has 64 bits, or 32 without a sign.
    target_compile_options(occlude_options INTERFACE -Wno-shorten-64-to-32 -Wno-sign-conversion)
  endif()
endif()

if(CMAKE_SYSTEM_PROCESSOR MATCHES "^(aarch64|arm64|ARM64)$")
  # SVE vectors have no size known to the compiler, so they cannot be members, as ours are. NEON is used instead.
  target_compile_definitions(occlude_options INTERFACE
    "HWY_DISABLED_TARGETS=(HWY_SVE|HWY_SVE2|HWY_SVE_256|HWY_SVE2_128)")
endif()

if(MINGW AND CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
  # GCC stores vectors of 32 bytes on a stack that Windows aligns to 16, with moves that need an alignment of 32 (GCC bug
  # 54412). The assembler replaces these moves by ones that need no alignment and cost the same.
  target_compile_options(occlude_options INTERFACE -Wa,-muse-unaligned-vector-move)
  # Every object file has a copy of an inline function, and the linker keeps one of them. On Windows GCC 12 assumes that the
  # copy it sees is the one that runs, and keeps values in registers that this copy does not use but another does: exact signs
  # came out wrong.
  target_compile_options(occlude_options INTERFACE -fno-ipa-ra)
endif()

set(OCCLUDE_SANITIZE "" CACHE STRING "Sanitizer to build with: address, undefined, thread or several with commas")
if(OCCLUDE_SANITIZE)
  if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
    # The checks that are compiled in mislead the compiler's own flow analysis.
    target_compile_options(occlude_options INTERFACE -Wno-error)
  endif()
  target_compile_options(occlude_options INTERFACE
    -fsanitize=${OCCLUDE_SANITIZE} -fno-sanitize-recover=all -fno-omit-frame-pointer)
  target_link_options(occlude_options INTERFACE -fsanitize=${OCCLUDE_SANITIZE})
endif()

option(OCCLUDE_FUZZERS "Build everything for a coverage-guided fuzzer, the harnesses as such (clang or afl-clang-fast)" OFF)
if(OCCLUDE_FUZZERS)
  target_compile_options(occlude_options INTERFACE -fsanitize=fuzzer-no-link)
endif()

# What is installed. These libraries are shared or static as BUILD_SHARED_LIBS says, all others are static.
set(occlude_installed kernel culler)

# occlude_module(NAME ROOMS...): makes the library occlude::NAME from the sources in the folder src, with its public headers in the
# folder include; or from those in these folders, each with its own public headers in a folder include.
function(occlude_module name)
  if(ARGN)
    list(TRANSFORM ARGN PREPEND ${CMAKE_CURRENT_SOURCE_DIR}/ OUTPUT_VARIABLE folders)
    set(private ${CMAKE_CURRENT_SOURCE_DIR})
    list(TRANSFORM folders APPEND /include OUTPUT_VARIABLE includes)
    file(GLOB public ${includes})  # those that there are
  else()
    set(private ${CMAKE_CURRENT_SOURCE_DIR}/src)
    set(folders ${private} ${private}/*)
    set(public ${CMAKE_CURRENT_SOURCE_DIR}/include)
  endif()
  list(TRANSFORM folders APPEND /*.cpp)
  file(GLOB sources CONFIGURE_DEPENDS ${folders})
  set(kind STATIC)
  if(name IN_LIST occlude_installed)
    set(kind)
  endif()
  add_library(occlude_${name} ${kind} ${sources})
  # In a unity build, too, Highway compiles these files once per instruction set, each by itself.
  foreach(source IN LISTS sources)
    file(STRINGS ${source} is_per_target REGEX "^#include <hwy/foreach_target\\.h>")
    if(is_per_target)
      set_source_files_properties(${source} PROPERTIES SKIP_UNITY_BUILD_INCLUSION ON)
    endif()
  endforeach()
  add_library(occlude::${name} ALIAS occlude_${name})
  target_include_directories(occlude_${name} PUBLIC "$<BUILD_INTERFACE:${public}>" PRIVATE ${private})
  set_target_properties(occlude_${name} PROPERTIES OCCLUDE_PUBLIC "${public}")  # for install.cmake
  target_compile_features(occlude_${name} PUBLIC cxx_std_20)
  target_link_libraries(occlude_${name} PRIVATE $<BUILD_INTERFACE:occlude_options>)
  get_target_property(type occlude_${name} TYPE)
  if(type STREQUAL "SHARED_LIBRARY")
    # It exports all that it has. Before 1.0 a new minor version may change the interface.
    set_target_properties(occlude_${name} PROPERTIES WINDOWS_EXPORT_ALL_SYMBOLS ON INSTALL_RPATH "$ORIGIN"
      VERSION ${PROJECT_VERSION} SOVERSION ${PROJECT_VERSION_MAJOR}.${PROJECT_VERSION_MINOR})
    if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
      # No program replaces a function of it, so that calls within it are inlined.
      target_compile_options(occlude_${name} PRIVATE -fno-semantic-interposition)
    endif()
  else()
    # For shared libraries and modules that are made of it. What is hidden is called directly there, too.
    set_target_properties(occlude_${name} PROPERTIES POSITION_INDEPENDENT_CODE ON CXX_VISIBILITY_PRESET hidden
      VISIBILITY_INLINES_HIDDEN ON)
  endif()
endfunction()

# occlude_embed(MODULE NAME HEADER FUNCTION FILES...): makes the files part of the library occlude::MODULE, in NAME.cpp. FUNCTION
# of its private header HEADER returns their bytes.
function(occlude_embed module name header function)
  list(JOIN ARGN "," files)
  set(embedded ${CMAKE_CURRENT_BINARY_DIR}/${name}.cpp)
  add_custom_command(OUTPUT ${embedded}
    COMMAND ${CMAKE_COMMAND} -DOUT=${embedded} -DHEADER=${header} -DFUNCTION=${function} -DFILES=${files}
      -P ${PROJECT_SOURCE_DIR}/cmake/embed.cmake
    DEPENDS ${PROJECT_SOURCE_DIR}/cmake/embed.cmake ${ARGN} VERBATIM)
  target_sources(occlude_${module} PRIVATE ${embedded})
  set_source_files_properties(${embedded} PROPERTIES SKIP_UNITY_BUILD_INCLUSION ON)
endfunction()
