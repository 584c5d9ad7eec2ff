// SPDX-License-Identifier: MIT
// A value that is made when it is first asked for. Culling by frusta alone then pays nothing for what covers need.
#pragma once

#include <mutex>

#include "cover_triangles.h"

namespace occlude::culler {

/// May be asked on several threads at once.
template <class T>
class Lazy {
 public:
  /// The value, which make() makes at the first call. If make() throws, so does get(), and the next call tries again.
  template <class Make>
  const T& get(const Make& make) {
    std::call_once(once_, [&] { value_ = make(); });
    return value_;
  }

 private:
  std::once_flag once_;
  T value_;
};

class LazyTriangles : public Lazy<CoverTriangles> {};

}  // namespace occlude::culler
