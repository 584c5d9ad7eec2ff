// SPDX-License-Identifier: MIT
#include "page_vain.h"

#include "bytes.h"

namespace occlude::render {

void PageVain::add(const culler::CullResult& frame, std::span<const std::uint32_t> visible) {
  auto next = visible.begin();
  for (const culler::PolygonRange& range : frame.drawn) {
    for (std::uint32_t p = range.first; p < range.first + range.count; ++p) {
      while (next != visible.end() && *next < p) ++next;
      const bool shows = next != visible.end() && *next == p;
      if (!shows && model_.place(p) != PageModel::kNone) ++frames_[model_.place(p)];
    }
  }
}

std::string PageVain::packed() const {
  Bytes bytes;
  for (const std::uint32_t count : frames_) bytes.number(count);
  return bytes.text();
}

}  // namespace occlude::render
