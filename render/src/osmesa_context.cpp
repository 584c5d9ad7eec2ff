// SPDX-License-Identifier: MIT
#include <GL/osmesa.h>
#include <stdlib.h>

#include <array>
#include <cstdint>
#include <stdexcept>

#include "gl.h"
#include "occlude/render/offscreen_context.h"

namespace occlude::render {
namespace {

class OsMesaContext : public OffscreenContext {
 public:
  OsMesaContext() {
    // Mesa would otherwise write compiled shaders to the user's cache folder.
    constexpr int kKeepWhatTheUserSet = 0;
    setenv("MESA_SHADER_CACHE_DISABLE", "true", kKeepWhatTheUserSet);
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
  std::array<std::uint8_t, 4> pixel_{};  ///< OSMesa wants a picture of its own; we draw into framebuffer objects
};

}  // namespace

GlFunction gl_function(const char* name) { return OSMesaGetProcAddress(name); }

std::unique_ptr<OffscreenContext> make_offscreen_context() { return std::make_unique<OsMesaContext>(); }

}  // namespace occlude::render
