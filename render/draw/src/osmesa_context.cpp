// SPDX-License-Identifier: MIT
#include "gl.h"
// gl.h must come first.
#include <GL/osmesa.h>
#include <dlfcn.h>
#include <stdlib.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <latch>
#include <new>
#include <stdexcept>
#include <string>
#include <system_error>
#include <thread>
#include <vector>

#include "occlude/render/offscreen_context.h"
#include "occlude/render/resource_limits.h"

namespace occlude::render {
namespace {

constexpr int kKeepWhatTheUserSet = 0;

/// Whether this process can start `count` more threads.
bool can_have_threads(std::size_t count) {
  std::latch seen(1);
  std::vector<std::jthread> threads;
  try {
    while (threads.size() < count) threads.emplace_back([&] { seen.wait(); });
  } catch (const std::system_error&) {
    // Fewer than `count`.
  }
  seen.count_down();
  return threads.size() == count;
}

/// Memory that llvmpipe needs besides models and pictures; it crashes with less. A compiled shader takes a few MiB, its
/// compiler about 100.
constexpr std::uint64_t kForDrawing = std::uint64_t{256} << 20U;

/// Address space of a thread: a stack of 8 MiB and a heap of 64 MiB.
constexpr std::uint64_t kForThread = std::uint64_t{72} << 20U;

/// llvmpipe starts two threads per processor, for at most 16 processors, and hangs if it cannot start one. Without threads
/// it draws in the caller's thread.
void draw_alone_if_need_be() {
  const auto threads = 2 * static_cast<std::size_t>(std::clamp(sysconf(_SC_NPROCESSORS_ONLN), 1L, 16L));
  if (can_have_memory(kForDrawing + threads * kForThread) && can_have_threads(threads)) return;
  setenv("LP_NUM_THREADS", "0", kKeepWhatTheUserSet);
}

/// Loaded by name. Only the headers of the library are used to build.
constexpr const char* kLibrary = "libOSMesa.so.8";

/// Addresses that it takes with LLVM and all else that it needs.
constexpr std::uint64_t kForLibrary = std::uint64_t{256} << 20U;

/// The functions of OSMesa. Making one loads them, and those of OpenGL. The library stays loaded, because LLVM runs code
/// when the program ends.
struct OsMesa {
  decltype(&::OSMesaCreateContextAttribs) create_context = nullptr;
  decltype(&::OSMesaMakeCurrent) make_current = nullptr;
  decltype(&::OSMesaDestroyContext) destroy_context = nullptr;

  OsMesa() {
    if (!can_have_memory(kForLibrary)) throw std::bad_alloc();
    void* const library = dlopen(kLibrary, RTLD_NOW | RTLD_LOCAL);
    if (library == nullptr) throw std::runtime_error(std::string("drawing needs OSMesa: ") + dlerror());
    load(library, "OSMesaCreateContextAttribs", create_context);
    load(library, "OSMesaMakeCurrent", make_current);
    load(library, "OSMesaDestroyContext", destroy_context);
    decltype(&::OSMesaGetProcAddress) of_opengl = nullptr;
    load(library, "OSMesaGetProcAddress", of_opengl);
#define OCCLUDE_GL_LOAD(name) take("gl" #name, of_opengl("gl" #name), gl.name);
    OCCLUDE_GL_FUNCTIONS(OCCLUDE_GL_LOAD)
#undef OCCLUDE_GL_LOAD
  }

 private:
  template <class Function>
  static void load(void* library, const char* name, Function& function) {
    take(name, dlsym(library, name), function);
  }
  template <class Found, class Function>
  static void take(const char* name, Found found, Function& function) {
    if (found == nullptr) throw std::runtime_error(std::string(kLibrary) + " has no " + name);
    function = reinterpret_cast<Function>(found);
  }
};

class OsMesaContext : public OffscreenContext {
 public:
  OsMesaContext() {
    // Mesa would otherwise write compiled shaders to the user's cache folder.
    setenv("MESA_SHADER_CACHE_DISABLE", "true", kKeepWhatTheUserSet);
    draw_alone_if_need_be();
    if (!can_have_memory(kForDrawing)) throw std::bad_alloc();
    constexpr std::array<int, 9> kAttributes = {OSMESA_FORMAT,
                                                OSMESA_RGBA,
                                                OSMESA_PROFILE,
                                                OSMESA_CORE_PROFILE,
                                                OSMESA_CONTEXT_MAJOR_VERSION,
                                                4,
                                                OSMESA_CONTEXT_MINOR_VERSION,
                                                5,
                                                0};
    context_ = library_.create_context(kAttributes.data(), nullptr);
    if (context_ == nullptr) throw std::runtime_error("OSMesa offers no OpenGL 4.5 core context");
    if (library_.make_current(context_, pixel_.data(), GL_UNSIGNED_BYTE, 1, 1) == GL_FALSE) {
      library_.destroy_context(context_);
      throw std::runtime_error("OSMesa cannot make its context current");
    }
  }
  ~OsMesaContext() override {
    library_.make_current(nullptr, nullptr, GL_UNSIGNED_BYTE, 0, 0);
    library_.destroy_context(context_);
  }
  OsMesaContext(const OsMesaContext&) = delete;
  OsMesaContext& operator=(const OsMesaContext&) = delete;

  [[nodiscard]] std::string description() const override { return reinterpret_cast<const char*>(gl.GetString(GL_RENDERER)); }

 private:
  static const OsMesa& library() {
    static const OsMesa loaded;
    return loaded;
  }

  const OsMesa& library_ = library();
  OSMesaContext context_;
  std::array<std::uint8_t, 4> pixel_{};  ///< required by OSMesa; we draw into framebuffer objects
};

}  // namespace

std::unique_ptr<OffscreenContext> make_offscreen_context() { return std::make_unique<OsMesaContext>(); }

}  // namespace occlude::render
