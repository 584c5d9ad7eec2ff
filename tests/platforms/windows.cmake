# Windows on x86-64 by MinGW, where long has 32 bits; run by Wine.
set(CMAKE_SYSTEM_NAME Windows)
set(CMAKE_SYSTEM_PROCESSOR x86_64)
set(CMAKE_CXX_COMPILER x86_64-w64-mingw32-g++-posix)
set(CMAKE_C_COMPILER x86_64-w64-mingw32-gcc-posix)
# A Windows of its own, which keeps its diagnostics to itself.
set(CMAKE_CROSSCOMPILING_EMULATOR env;WINEDEBUG=-all;WINEPREFIX=${CMAKE_BINARY_DIR}/wine;wine)
# Wine does not have the compiler's libraries.
set(CMAKE_EXE_LINKER_FLAGS_INIT -static)
