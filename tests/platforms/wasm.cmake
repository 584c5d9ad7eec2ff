# WebAssembly by Emscripten, where pointers have 32 bits; run by node. CMAKE_PREFIX_PATH has what libraries.sh made.
set(CMAKE_FIND_ROOT_PATH_MODE_PACKAGE BOTH)
set(CMAKE_TRY_COMPILE_PLATFORM_VARIABLES CMAKE_PREFIX_PATH)
include(/usr/share/emscripten/cmake/Modules/Platform/Emscripten.cmake)
# Debian's Highway has no vectors of doubles on WebAssembly; its loops over two lanes become such vectors where the compiler
# sees it.
set(flags "-fwasm-exceptions -msimd128 -DHWY_COMPILE_ONLY_EMU128")
set(CMAKE_C_FLAGS_INIT "${flags}")
set(CMAKE_CXX_FLAGS_INIT "${flags} -nostdinc++ -isystem ${CMAKE_PREFIX_PATH}/include/c++/v1")
set(CMAKE_CXX_STANDARD_LIBRARIES "-lc++16 -lc++abi-except -lunwind-except")
set(CMAKE_EXE_LINKER_FLAGS_INIT "-nostdlib++ -L${CMAKE_PREFIX_PATH}/lib -sALLOW_MEMORY_GROWTH -sMAXIMUM_MEMORY=4GB")
set(CMAKE_CROSSCOMPILING_EMULATOR node)
