// SPDX-License-Identifier: MIT
#include "offscreen.h"

#include <EGL/egl.h>
#include <EGL/eglext.h>

#include <array>
#include <cstdio>
#include <osg/State>

namespace occlude::example {
namespace {

class Offscreen : public osg::GraphicsContext {
 public:
  explicit Offscreen(Traits* traits) {
    _traits = traits;
    setState(new osg::State);
    getState()->setGraphicsContext(this);
    getState()->setContextID(createNewContextID());
  }

  [[nodiscard]] bool valid() const override { return true; }
  [[nodiscard]] bool isRealizedImplementation() const override { return context_ != EGL_NO_CONTEXT; }
  bool realizeImplementation() override {
    display_ = eglGetPlatformDisplay(EGL_PLATFORM_SURFACELESS_MESA, nullptr, nullptr);
    if (display_ == EGL_NO_DISPLAY || eglInitialize(display_, nullptr, nullptr) == 0 || eglBindAPI(EGL_OPENGL_API) == 0) {
      return false;
    }
    constexpr std::array<EGLint, 13> kWanted = {EGL_SURFACE_TYPE,
                                                EGL_PBUFFER_BIT,
                                                EGL_RENDERABLE_TYPE,
                                                EGL_OPENGL_BIT,
                                                EGL_RED_SIZE,
                                                8,
                                                EGL_GREEN_SIZE,
                                                8,
                                                EGL_BLUE_SIZE,
                                                8,
                                                EGL_DEPTH_SIZE,
                                                24,
                                                EGL_NONE};
    EGLConfig config = nullptr;
    EGLint found = 0;
    if (eglChooseConfig(display_, kWanted.data(), &config, 1, &found) == 0 || found == 0) return false;
    const std::array<EGLint, 5> size = {EGL_WIDTH, _traits->width, EGL_HEIGHT, _traits->height, EGL_NONE};
    surface_ = eglCreatePbufferSurface(display_, config, size.data());
    context_ = eglCreateContext(display_, config, EGL_NO_CONTEXT, nullptr);
    return surface_ != EGL_NO_SURFACE && context_ != EGL_NO_CONTEXT;
  }
  void closeImplementation() override {
    if (context_ == EGL_NO_CONTEXT) return;
    releaseContextImplementation();
    eglDestroyContext(display_, context_);
    eglDestroySurface(display_, surface_);
    eglTerminate(display_);
    context_ = EGL_NO_CONTEXT;
  }
  bool makeCurrentImplementation() override { return eglMakeCurrent(display_, surface_, surface_, context_) != 0; }
  bool makeContextCurrentImplementation(osg::GraphicsContext*) override { return makeCurrentImplementation(); }
  bool releaseContextImplementation() override {
    return eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT) != 0;
  }
  void bindPBufferToTextureImplementation(GLenum) override {}
  void swapBuffersImplementation() override {}

 protected:
  ~Offscreen() override { close(false); }

 private:
  EGLDisplay display_ = EGL_NO_DISPLAY;
  EGLSurface surface_ = EGL_NO_SURFACE;
  EGLContext context_ = EGL_NO_CONTEXT;
};

}  // namespace

osg::ref_ptr<osg::GraphicsContext> make_offscreen(int width, int height) {
  osg::ref_ptr<osg::GraphicsContext::Traits> traits = new osg::GraphicsContext::Traits;
  traits->width = width;
  traits->height = height;
  traits->pbuffer = true;
  traits->doubleBuffer = false;
  osg::ref_ptr<osg::GraphicsContext> context = new Offscreen(traits);
  if (context->realize() && context->makeCurrent()) return context;
  std::fputs("there is no OpenGL without a display (EGL_PLATFORM_SURFACELESS_MESA)\n", stderr);
  return nullptr;
}

}  // namespace occlude::example
