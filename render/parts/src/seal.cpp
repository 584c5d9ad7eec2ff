// SPDX-License-Identifier: MIT
#include "seal.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <pwd.h>
#include <sodium.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdlib>
#include <optional>
#include <stdexcept>
#include <system_error>

#include "occlude/render/errors.h"
#include "occlude/render/input_file.h"
#include "occlude/render/interrupt.h"

namespace occlude::render {
namespace fs = std::filesystem;
namespace {

using Key = std::array<unsigned char, 32>;
static_assert(std::tuple_size_v<Key> == crypto_generichash_KEYBYTES);

constexpr const char* kOtherPlace = "; XDG_STATE_HOME may name another folder";

[[noreturn]] void fail(const fs::path& file, const std::string& reason) {
  throw InputError(fmt::format("{}: the key that seals parts: {}{}", file.string(), reason, kOtherPlace));
}

[[noreturn]] void fail_to_create(const fs::path& file, int error) {
  fail(file, "cannot create: " + std::generic_category().message(error));
}

/// The folder that a variable of the environment names; empty if that is no full path (XDG Base Directory Specification).
fs::path folder_in(const char* variable) {
  const char* const value = std::getenv(variable);
  return value != nullptr && *value == '/' ? fs::path(value) : fs::path();
}

fs::path home() {
  if (const fs::path folder = folder_in("HOME"); !folder.empty()) return folder;
  const passwd* const user = getpwuid(geteuid());
  return user != nullptr ? fs::path(user->pw_dir) : fs::path();
}

fs::path key_file() {
  const fs::path state = folder_in("XDG_STATE_HOME");
  return (state.empty() ? home() / ".local" / "state" : state) / "occlude" / "parts.key";
}

/// Makes a key unless another process has made it in the meantime. The file has its name once it is whole.
void make_key(const fs::path& file) {
  std::error_code error;
  fs::create_directories(file.parent_path(), error);
  if (error) fail_to_create(file, error.value());
  Key key;
  randombytes_buf(key.data(), key.size());
  const fs::path whole = file.parent_path() / fmt::format(".occlude.tmp-{}", getpid());
  int descriptor = -1;
  const std::optional<Leftover> temporary = Leftover::make(whole, [&] {
    descriptor = ::open(whole.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_NOFOLLOW | O_CLOEXEC, S_IRUSR | S_IWUSR);
    return descriptor >= 0;
  });
  if (!temporary) fail_to_create(file, errno);
  const bool is_written = ::write(descriptor, key.data(), key.size()) == static_cast<ssize_t>(key.size());
  if (const int failure = errno; ::close(descriptor) != 0 || !is_written) fail_to_create(file, is_written ? errno : failure);
  if (link(whole.c_str(), file.c_str()) != 0 && errno != EEXIST) fail_to_create(file, errno);
}

/// Throws InputError if others than the user can have read or written the file.
void require_private(const fs::path& file) {
  struct stat status {};
  if (stat(file.c_str(), &status) != 0) fail(file, "cannot read: " + std::generic_category().message(errno));
  if (status.st_uid != geteuid()) fail(file, "it belongs to another user");
  if ((status.st_mode & (S_IRWXG | S_IRWXO)) != 0) fail(file, "others can read or write it");
}

}  // namespace

Seal::Seal() {
  if (sodium_init() < 0) throw std::runtime_error("there are no random numbers for a key");
  const fs::path file = key_file();
  if (access(file.c_str(), F_OK) != 0) make_key(file);
  require_private(file);
  const std::string bytes = read_input(file);
  if (bytes.size() != key_.size()) fail(file, fmt::format("it has {} bytes, not {}", bytes.size(), key_.size()));
  std::ranges::copy(bytes, key_.begin());
}

std::string Seal::of(std::initializer_list<std::string_view> texts) const {
  crypto_generichash_state state;
  crypto_generichash_init(&state, key_.data(), key_.size(), crypto_generichash_BYTES);
  const auto add = [&](std::string_view bytes) {
    crypto_generichash_update(&state, reinterpret_cast<const unsigned char*>(bytes.data()), bytes.size());
  };
  for (const std::string_view text : texts) {
    add(fmt::format("{:016x}", text.size()));
    add(text);
  }
  std::array<unsigned char, crypto_generichash_BYTES> code{};
  crypto_generichash_final(&state, code.data(), code.size());
  return fmt::format("{:02x}", fmt::join(code, ""));
}

}  // namespace occlude::render
