// SPDX-License-Identifier: MIT
#include "frame_buffer.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <stdexcept>

namespace occlude::render {
namespace {

constexpr GLenum kColour = GL_COLOR_ATTACHMENT0;
constexpr GLenum kItems = GL_COLOR_ATTACHMENT1;

void clear_items() {
  constexpr std::array<GLuint, 4> kNoItem = {kNothing, 0, 0, 0};
  gl.ClearBufferuiv(GL_COLOR, 0, kNoItem.data());
}

float unit(std::uint8_t channel) { return static_cast<float>(channel) / 255; }

/// OpenGL's rows run from the bottom to the top.
template <class Pixel>
void flip(Raster<Pixel>& raster) {
  for (int y = 0; y < raster.height / 2; ++y) {
    const auto row = [&](int index) { return raster.pixels.begin() + std::ptrdiff_t{index} * raster.width; };
    std::swap_ranges(row(y), row(y + 1), row(raster.height - 1 - y));
  }
}

}  // namespace

FrameBuffer::FrameBuffer(int width, int height) : width_(width), height_(height) {
  GLint largest = 0;
  gl.GetIntegerv(GL_MAX_RENDERBUFFER_SIZE, &largest);
  if (width < 1 || height < 1 || width > largest || height > largest)
    throw std::runtime_error(
        fmt::format("cannot draw a picture of {}x{} pixels (1x1 to {}x{} are possible)", width, height, largest, largest));
  gl.BindFramebuffer(GL_FRAMEBUFFER, frame_.name());
  attach(colour_, GL_RGBA8, kColour);
  attach(items_, GL_R32UI, kItems);
  attach(depth_, GL_DEPTH_COMPONENT32F, GL_DEPTH_ATTACHMENT);
  if (gl.CheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE)
    throw std::runtime_error(fmt::format("OpenGL offers no buffers for a picture of {}x{} pixels", width, height));
}

void FrameBuffer::attach(const GlRenderbuffer& buffer, GLenum format, GLenum attachment) {
  gl.BindRenderbuffer(GL_RENDERBUFFER, buffer.name());
  gl.RenderbufferStorage(GL_RENDERBUFFER, format, width_, height_);
  gl.FramebufferRenderbuffer(GL_FRAMEBUFFER, attachment, GL_RENDERBUFFER, buffer.name());
}

void FrameBuffer::begin(GLenum attachment) const {
  constexpr float kFarthest = 0;
  gl.BindFramebuffer(GL_FRAMEBUFFER, frame_.name());
  gl.Viewport(0, 0, width_, height_);
  gl.DrawBuffers(1, &attachment);
  gl.ClearBufferfv(GL_DEPTH, 0, &kFarthest);
}

void FrameBuffer::begin_picture(const Rgba& sky) {
  const std::array<float, 4> colour = {unit(sky.r), unit(sky.g), unit(sky.b), 1};
  begin(kColour);
  gl.ClearBufferfv(GL_COLOR, 0, colour.data());
}

void FrameBuffer::begin_items() {
  begin(kItems);
  clear_items();
}

void FrameBuffer::begin_nothing() {
  constexpr GLenum kNone = GL_NONE;
  gl.DrawBuffers(1, &kNone);
}

void FrameBuffer::begin_items_before() {
  gl.DrawBuffers(1, &kItems);
  clear_items();
}

template <class Pixel>
Raster<Pixel> FrameBuffer::read(GLenum attachment, GLenum format, GLenum type) const {
  Raster<Pixel> raster{width_, height_, {}};
  raster.pixels.resize(static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_));
  gl.BindFramebuffer(GL_FRAMEBUFFER, frame_.name());
  gl.ReadBuffer(attachment);
  gl.ReadPixels(0, 0, width_, height_, format, type, raster.pixels.data());
  flip(raster);
  return raster;
}

Image FrameBuffer::image() const { return read<Rgba>(kColour, GL_RGBA, GL_UNSIGNED_BYTE); }

Items FrameBuffer::items() const { return read<std::uint32_t>(kItems, GL_RED_INTEGER, GL_UNSIGNED_INT); }

}  // namespace occlude::render
