// SPDX-License-Identifier: MIT
// What covers need of a model, made when it is first asked for. Culling by frusta alone then pays nothing for it.
#pragma once

#include <mutex>

#include "cover_triangles.h"

namespace occlude::culler {

/// May be asked on several threads at once.
class LazyTriangles {
 public:
  /// The triangles, which make() makes at the first call. If make() throws, so does get(), and the next call tries again.
  template <class Make>
  const CoverTriangles& get(const Make& make) {
    std::call_once(once_, [&] { triangles_ = make(); });
    return triangles_;
  }

 private:
  std::once_flag once_;
  CoverTriangles triangles_;
};

}  // namespace occlude::culler
