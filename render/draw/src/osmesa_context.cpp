// SPDX-License-Identifier: MIT
#include <GL/osmesa.h>
#include <stdlib.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <latch>
#include <new>
#include <stdexcept>
#include <system_error>
#include <thread>
#include <vector>

#include "gl.h"
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
    context_ = OSMesaCreateContextAttribs(kAttributes.data(), nullptr);
    if (context_ == nullptr) throw std::runtime_error("OSMesa offers no OpenGL 4.5 core context");
    if (OSMesaMakeCurrent(context_, pixel_.data(), GL_UNSIGNED_BYTE, 1, 1) == GL_FALSE) {
      OSMesaDestroyContext(context_);
      throw std::runtime_error("OSMesa cannot make its context current");
    }
  }
  ~OsMesaContext() override {
    OSMesaMakeCurrent(nullptr, nullptr, GL_UNSIGNED_BYTE, 0, 0);
    OSMesaDestroyContext(context_);
  }
  OsMesaContext(const OsMesaContext&) = delete;
  OsMesaContext& operator=(const OsMesaContext&) = delete;

  [[nodiscard]] std::string description() const override { return reinterpret_cast<const char*>(glGetString(GL_RENDERER)); }

 private:
  OSMesaContext context_;
  std::array<std::uint8_t, 4> pixel_{};  ///< required by OSMesa; we draw into framebuffer objects
};

}  // namespace

GlFunction gl_function(const char* name) { return OSMesaGetProcAddress(name); }

std::unique_ptr<OffscreenContext> make_offscreen_context() { return std::make_unique<OsMesaContext>(); }

}  // namespace occlude::render
