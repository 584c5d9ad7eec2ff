// SPDX-License-Identifier: MIT
#include "occlude/render/job.h"

#include <fmt/format.h>

#include <cstddef>

#include "dealer.h"
#include "helpers.h"
#include "kept_parts.h"
#include "occlude/render/console.h"
#include "occlude/render/digest.h"
#include "occlude/render/errors.h"
#include "occlude/render/input_file.h"
#include "occlude/render/printable.h"
#include "occlude/render/ranks.h"

namespace occlude::render {
namespace {

/// Another build of the program may give other results.
std::uint64_t with_program(std::uint64_t key) {
  return Digest().add(std::to_string(key)).add(read_input("/proc/self/exe")).value();
}

}  // namespace

Job::Job(const Keeping& keeping, const std::function<std::uint64_t()>& key) {
  if (ranks() > 1 || !keeping.folder.empty()) key_ = with_program(key());
  if (is_first_rank() && !keeping.folder.empty()) {
    kept_ = std::make_unique<KeptParts>(keeping.folder, key_, keeping.resume);
  }
}

Job::~Job() = default;

void Job::run(const Stage& stage) {
  const unsigned number = stages_++;
  if (!is_first_rank()) return help({key_, number}, stage.work);
  try {
    run_first(stage, number);
  } catch (const Interrupted&) {
    const std::size_t parts = kept_ ? kept_->count() : 0;
    if (parts > 0) {
      say(printable(fmt::format("occlude: {} finished parts are in {}: --resume goes on", parts, kept_->folder().string())) +
          "\n");
    }
    throw;
  }
}

void Job::run_first(const Stage& stage, unsigned number) {
  Dealer dealer(stage, number, kept_.get());
  {
    const Helpers helpers(dealer, {key_, number});
    while (const std::optional<Dealer::Part> part = dealer.next()) {
      try {
        dealer.accept(part->number, stage.work(part->input), 0);
      } catch (...) {
        dealer.fail(std::current_exception());
      }
    }
  }
  dealer.finish();
}

void Job::finish() {
  if (kept_) kept_->remove();
}

}  // namespace occlude::render
