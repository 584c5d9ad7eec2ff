// SPDX-License-Identifier: MIT
// Held culls that several Python threads may use, and where they have regions culled.
#pragma once

#include <functional>
#include <future>
#include <memory>
#include <mutex>
#include <utility>

#include "numbers.h"
#include "occlude/culler/held_cull.h"

namespace occlude::python {

/// A HeldCull or a HeldSceneCull.
///
/// Regions are culled on threads of this module, or by a function of Python's. The function may do anything, so it is called
/// when no lock is held: what the cull asks for is kept until the frame is done.
template <class Cull>
class SharedHeld {
 public:
  template <class Of, class Options>
  SharedHeld(const Of& of, culler::HeldOptions options, const Options& cull, py::object later)
      : later_(checked(std::move(later))), cull_(std::make_unique<Cull>(of, with_later(std::move(options)), cull)) {}
  /// A task that is running may take some time.
  ~SharedHeld() {
    const py::gil_scoped_release others_run;
    cull_.reset();
  }
  SharedHeld(const SharedHeld&) = delete;
  SharedHeld& operator=(const SharedHeld&) = delete;

  /// Runs work with the cull, while other threads run.
  template <class Work>
  auto use(Work&& work) {
    const py::gil_scoped_release others_run;
    const std::scoped_lock lock(mutex_);
    return work(*cull_);
  }
  /// Gives Python's function the task that was asked for, if any. What it throws is thrown on, and the task is kept.
  void hand_on() {
    Task task = exchange({});
    if (task == nullptr) return;
    try {
      later_(py::cpp_function([task] {
        const py::gil_scoped_release others_run;
        task();
      }));
    } catch (...) {
      exchange(std::move(task));
      throw;
    }
  }

 private:
  using Task = std::function<void()>;

  static py::object checked(py::object later) {
    if (!later.is_none() && PyCallable_Check(later.ptr()) == 0) throw py::type_error("later is no function");
    return later;
  }
  culler::HeldOptions with_later(culler::HeldOptions options) {
    if (later_.is_none()) {
      // A thread for each task. The last one has ended when the next is asked for, and before the cull is gone.
      options.later = [last = std::make_shared<std::future<void>>()](Task task) {
        *last = std::async(std::launch::async, std::move(task));
      };
    } else {
      options.later = [this](Task task) { task_ = std::move(task); };
    }
    return options;
  }
  Task exchange(Task task) {
    const py::gil_scoped_release others_run;
    const std::scoped_lock lock(mutex_);
    return std::exchange(task_, std::move(task));
  }

  py::object later_;
  std::mutex mutex_;
  Task task_;  ///< asked for and not yet handed on
  std::unique_ptr<Cull> cull_;
};

}  // namespace occlude::python
