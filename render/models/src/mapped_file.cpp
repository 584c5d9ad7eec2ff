// SPDX-License-Identifier: MIT
#include "mapped_file.h"

#include <fcntl.h>
#include <sys/mman.h>
#include <unistd.h>

#include <bit>
#include <cerrno>
#include <cstdint>
#include <system_error>

#include "occlude/render/errors.h"
#include "occlude/render/input_file.h"

namespace occlude::render {
namespace {

/// A file that is open for reading.
class Descriptor {
 public:
  explicit Descriptor(const std::filesystem::path& file) : number_(::open(file.c_str(), O_RDONLY | O_CLOEXEC)) {}
  ~Descriptor() {
    if (number_ >= 0) ::close(number_);
  }
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  [[nodiscard]] int number() const { return number_; }

 private:
  int number_;
};

}  // namespace

MappedFile::MappedFile(const std::filesystem::path& file) {
  require_readable(file, UINT64_MAX);
  const auto fail = [&] { throw InputError(file.string() + ": cannot read: " + std::generic_category().message(errno)); };
  const Descriptor descriptor(file);
  if (descriptor.number() < 0) fail();
  const off_t size = ::lseek(descriptor.number(), 0, SEEK_END);
  if (size < 0) fail();
  if (size == 0) return;  // cannot be mapped
  void* const begin = ::mmap(nullptr, static_cast<std::size_t>(size), PROT_READ, MAP_PRIVATE, descriptor.number(), 0);
  if (begin == MAP_FAILED) fail();
  bytes_ = {static_cast<const std::byte*>(begin), static_cast<std::size_t>(size)};
}

MappedFile::~MappedFile() {
  if (!bytes_.empty()) ::munmap(const_cast<std::byte*>(bytes_.data()), bytes_.size());
}

void MappedFile::populate(std::span<const std::byte> range) {
#ifdef MADV_POPULATE_READ
  const auto page = static_cast<std::uintptr_t>(::sysconf(_SC_PAGESIZE));
  const auto begin = std::bit_cast<std::uintptr_t>(range.data()) / page * page;
  const auto end = std::bit_cast<std::uintptr_t>(range.data() + range.size());
  static_cast<void>(::madvise(std::bit_cast<void*>(begin), end - begin, MADV_POPULATE_READ));
#else
  static_cast<void>(range);
#endif
}

}  // namespace occlude::render
