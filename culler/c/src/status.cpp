// SPDX-License-Identifier: MIT
#include "status.h"

#include <array>
#include <cstring>
#include <new>

#include "occlude/kernel/validity.h"

namespace occlude::c {
namespace {

/// Messages are shorter: they name one place. Nothing is allocated, so that the end of memory can be reported too.
constexpr std::size_t kLongest = 255;

thread_local std::array<char, kLongest + 1> last_error{};

occlude_status failed(occlude_status status, const char* text) noexcept {
  std::strncpy(last_error.data(), text, kLongest);
  return status;
}

bool rounds_to_nearest() { return kernel::check_rounding() == kernel::Refusal::none; }

}  // namespace

occlude_status status_of_exception() noexcept {
  try {
    throw;
  } catch (const std::bad_alloc&) {
    return failed(OCCLUDE_OUT_OF_MEMORY, "out of memory");
  } catch (const UnknownId& e) {
    return failed(OCCLUDE_UNKNOWN_ID, e.what());
  } catch (const Stopped& e) {
    return failed(OCCLUDE_STOPPED, e.what());
  } catch (const std::logic_error& e) {
    return failed(OCCLUDE_INVALID_ARGUMENT, e.what());
  } catch (const std::exception& e) {
    return failed(rounds_to_nearest() ? OCCLUDE_FAILED : OCCLUDE_ROUNDING_MODE, e.what());
  } catch (...) {
    return failed(OCCLUDE_FAILED, "unknown failure");
  }
}

}  // namespace occlude::c

// Written so that a change of the project's version shows here.
static_assert(OCCLUDE_VERSION == 10000 * OCCLUDE_PROJECT_MAJOR + 100 * OCCLUDE_PROJECT_MINOR + OCCLUDE_PROJECT_PATCH);

uint32_t occlude_version() noexcept { return OCCLUDE_VERSION; }

const char* occlude_status_text(occlude_status status) noexcept {
  switch (status) {
    case OCCLUDE_OK:
      return "ok";
    case OCCLUDE_INVALID_ARGUMENT:
      return "invalid argument";
    case OCCLUDE_UNKNOWN_ID:
      return "unknown id";
    case OCCLUDE_OUT_OF_MEMORY:
      return "out of memory";
    case OCCLUDE_ROUNDING_MODE:
      return "processor does not round to nearest";
    case OCCLUDE_STOPPED:
      return "stopped by the caller";
    case OCCLUDE_FAILED:
      return "failed";
    default:
      return "unknown status";
  }
}

const char* occlude_last_error() noexcept { return occlude::c::last_error.data(); }
