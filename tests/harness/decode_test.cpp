// SPDX-License-Identifier: MIT
// The same bytes give the same scene with every compiler, so that every build can replay what a harness found.
#include "decode.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <vector>

#include "cases/case_line.h"
#include "occlude/fuzz/random.h"

namespace occlude::harness {
namespace decode_test {

/// FNV-1a.
std::uint64_t hash_of(const std::string& text, std::uint64_t hash) {
  for (const char c : text) hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001b3U;
  return hash;
}

TEST(Decode, SameBytesSameScene) {
  fuzz::Random random(1);
  std::uint64_t hash = 0xcbf29ce484222325U;
  for (int i = 0; i < 2000; ++i) {
    std::vector<std::uint8_t> bytes(random.index(300));
    for (std::uint8_t& byte : bytes) byte = static_cast<std::uint8_t>(random.bits());
    Decoder decoder(bytes);
    fuzz::Case made = decoder.question();
    made.box = decoder.box();
    hash = hash_of(cases::write_case("", made, ""), hash);
  }
  EXPECT_EQ(hash, 0xc3f23e4672dc823U) << std::hex << hash;
}

}  // namespace decode_test
}  // namespace occlude::harness
