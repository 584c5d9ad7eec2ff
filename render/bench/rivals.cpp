// SPDX-License-Identifier: MIT
#include "rivals.h"

#include <dlfcn.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <system_error>

#include "occlude/render/console.h"
#include "occlude/render/printable.h"

namespace occlude::experiments {
namespace {

constexpr std::array kKnown{"Embree", "OpenSceneGraph"};

/// The module's function, or null where no module was built. Says so if there is one that cannot be loaded, for instance
/// because a library has been removed since. The module stays loaded: its libraries keep threads.
AppendRivals* load_module() {
  std::error_code error;
  const auto module = std::filesystem::read_symlink("/proc/self/exe", error).replace_filename("occlude_rivals.so");
  if (!std::filesystem::exists(module, error)) return nullptr;
  void* const library = dlopen(module.c_str(), RTLD_NOW | RTLD_LOCAL);
  void* const function = library == nullptr ? nullptr : dlsym(library, kAppendRivals);
  if (function == nullptr) render::say(render::printable(dlerror()) + ": other projects are not measured\n");
  return reinterpret_cast<AppendRivals*>(function);
}

}  // namespace

std::vector<Rival> rivals(const culler::Hierarchy& tree, const std::vector<RayPicture>& pictures) {
  std::vector<Rival> rivals;
  if (AppendRivals* const append = load_module()) append(tree, pictures, rivals);
  for (const char* const name : kKnown) {
    const auto is_it = [&](const Rival& rival) { return rival.project.name == name; };
    if (std::ranges::none_of(rivals, is_it)) rivals.push_back({{name, ""}, {}});
  }
  return rivals;
}

}  // namespace occlude::experiments
