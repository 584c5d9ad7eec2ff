// SPDX-License-Identifier: MIT
#include "item_buffer.h"

#include <cstddef>
#include <osg/Group>
#include <osg/Image>
#include <osg/Program>
#include <osg/Shader>
#include <osg/StateSet>
#include <osg/Uniform>

namespace occlude::example {
namespace {

// Three bytes of the number of a thing, from 1 on. 0 is the background.
osg::Vec4 colour_of(std::size_t thing) {
  const std::size_t number = thing + 1;
  const auto byte = [&](unsigned int shift) { return static_cast<float>(number >> shift & 255U) / 255; };
  return {byte(0), byte(8), byte(16), 1};
}

osg::ref_ptr<osg::Group> coloured(std::span<const Thing> things, bool has_glass) {
  osg::ref_ptr<osg::Group> group = new osg::Group;
  osg::ref_ptr<osg::Program> program = new osg::Program;
  program->addShader(new osg::Shader(osg::Shader::VERTEX, "#version 120\nvoid main() { gl_Position = ftransform(); }"));
  program->addShader(
      new osg::Shader(osg::Shader::FRAGMENT, "#version 120\nuniform vec4 thing;\nvoid main() { gl_FragColor = thing; }"));
  constexpr auto kOverride = osg::StateAttribute::OVERRIDE;
  osg::StateSet& state = *group->getOrCreateStateSet();
  state.setAttributeAndModes(program, osg::StateAttribute::ON | kOverride);
  for (const int mode : {GL_BLEND, GL_DITHER, GL_LIGHTING}) {
    state.setMode(static_cast<osg::StateAttribute::GLMode>(mode), osg::StateAttribute::OFF | kOverride);
  }
  for (std::size_t i = 0; i < things.size(); ++i) {
    if (things[i].is_glass && !has_glass) continue;
    osg::ref_ptr<osg::Group> thing = new osg::Group;
    thing->getOrCreateStateSet()->addUniform(new osg::Uniform("thing", colour_of(i)));
    thing->addChild(things[i].node);
    group->addChild(thing);
  }
  return group;
}

std::unique_ptr<Renderer> item_renderer(osg::GraphicsContext& context, std::span<const Thing> things, bool has_glass) {
  auto renderer = std::make_unique<Renderer>(context, *coloured(things, has_glass), osg::CullSettings::NO_CULLING);
  renderer->scene_view().setClearColor({0, 0, 0, 0});
  return renderer;
}

}  // namespace

ItemBuffer::ItemBuffer(osg::GraphicsContext& context, std::span<const Thing> things)
    : things_(things.size()),
      opaque_(item_renderer(context, things, false)),
      with_glass_(item_renderer(context, things, true)) {}

std::vector<bool> ItemBuffer::visible(double time, const osg::Matrixd& view) {
  std::vector<bool> visible(things_);
  draw(*opaque_, time, view, visible);
  draw(*with_glass_, time, view, visible);
  return visible;
}

void ItemBuffer::draw(Renderer& renderer, double time, const osg::Matrixd& view, std::vector<bool>& visible) {
  renderer.draw(++frame_, time, view);
  const osg::ref_ptr<osg::Image> picture = renderer.picture();
  const auto* const bytes = picture->data();
  for (std::size_t p = 0; p < static_cast<std::size_t>(picture->s()) * static_cast<std::size_t>(picture->t()); ++p) {
    const unsigned char* const pixel = bytes + 3 * p;
    const std::size_t number =
        pixel[0] | static_cast<std::size_t>(pixel[1]) << 8U | static_cast<std::size_t>(pixel[2]) << 16U;
    if (number != 0 && number <= things_) visible[number - 1] = true;
  }
}

}  // namespace occlude::example
