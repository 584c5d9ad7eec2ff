// SPDX-License-Identifier: MIT
// Flies through a town in OpenSceneGraph with several ways of culling, and prints a table of what each leaves out and how
// long it takes. Exits with 1 if the culler left out what shows, or changed a picture.
#include <cstdio>
#include <fstream>
#include <osg/ArgumentParser>
#include <osg/GL>
#include <osg/Version>
#include <string>

#include "comparison.h"
#include "offscreen.h"

using namespace occlude::example;

namespace {

std::string processor() {
  std::ifstream file("/proc/cpuinfo");
  for (std::string line; std::getline(file, line);) {
    if (line.starts_with("model name")) return line.substr(line.find(':') + 2);
  }
  return "an unknown processor";
}

double percent(std::size_t part, std::size_t whole) {
  return whole == 0 ? 0 : 100 * static_cast<double>(part) / static_cast<double>(whole);
}

void print(const Comparison& comparison, const ComparisonSize& size) {
  const auto a_frame = [&](std::size_t sum) { return static_cast<double>(sum) / size.frames; };
  std::printf(
      "%zu houses, %zu things. %d frames at %dx%d; of a frame, %.0f things show, %.0f pass the view frustum and do not\n",
      comparison.ours().town.houses(), comparison.ours().town.things().size(), size.frames, size.width, size.height,
      a_frame(comparison.visible()), a_frame(comparison.hidden()));
  std::printf("%s; medians of %d runs: milliseconds of a frame\n\n", processor().c_str(), size.rounds);
  std::printf(
      "| way | drawn a frame | of the hidden culled | false culls | wrong pixels | update, ms | cull, ms | frame, ms |\n");
  std::printf("|---|---|---|---|---|---|---|---|\n");
  for (const auto& way : comparison.ways()) {
    const FrameTimes times = median(way->runs);
    std::printf("| %s | %.0f | %.1f %% | %zu | %zu | %.2f | %.2f | %.1f |\n", way->name.c_str(), a_frame(way->drawn),
                percent(way->culled_hidden, comparison.hidden()), way->false_culls, way->wrong_pixels, times.update,
                times.cull, times.frame);
  }
}

}  // namespace

int main(int argc, char** argv) {
  osg::ArgumentParser arguments(&argc, argv);
  ComparisonSize size;
  std::string picture;
  int picture_frame = 0;
  double misplaced = 0;
  while (arguments.read("--side", size.side) || arguments.read("--frames", size.frames) ||
         arguments.read("--rounds", size.rounds) || arguments.read("--size", size.width, size.height) ||
         arguments.read("--picture", picture_frame, picture) || arguments.read("--misplaced", misplaced)) {
  }
  if (arguments.argc() > 1 || size.side < 2 || size.frames < 1 || size.rounds < 1 || size.width < 1 || size.height < 1) {
    std::fputs(
        "Usage: osg_example [--side BLOCKS] [--frames N] [--rounds N] [--size W H] [--picture FRAME FILE.png] "
        "[--misplaced METRES]\n",
        stderr);
    return 2;
  }
  const osg::ref_ptr<osg::GraphicsContext> context = make_offscreen(size.width, size.height);
  if (!context) return 77;  // skipped
  std::printf("OpenSceneGraph %s, %s\n", osgGetVersion(), reinterpret_cast<const char*>(glGetString(GL_RENDERER)));
  Comparison comparison(size, *context, misplaced);
  comparison.run();
  print(comparison, size);
  if (!picture.empty() && !comparison.write_picture(picture_frame, picture)) {
    std::fprintf(stderr, "%s: cannot be written\n", picture.c_str());
    return 2;
  }
  if (comparison.ours().false_culls != 0 || comparison.ours().wrong_pixels != 0) {
    std::fputs("the culler left out what shows, or changed a picture\n", stderr);
    return 1;
  }
  return 0;
}
