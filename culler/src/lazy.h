// SPDX-License-Identifier: MIT
// What one method of culling needs of a model, made when it is first asked for. The other method then pays nothing for it.
#pragma once

#include <mutex>

namespace occlude::culler {

/// May be asked on several threads at once.
template <class T>
class Lazy {
 public:
  /// What make() makes at the first call. If make() throws, so does get(), and the next call tries again.
  template <class Make>
  const T& get(const Make& make) {
    std::call_once(once_, [&] { made_ = make(); });
    return made_;
  }

 private:
  std::once_flag once_;
  T made_;
};

}  // namespace occlude::culler
