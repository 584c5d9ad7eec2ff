// SPDX-License-Identifier: MIT
// A reported seed must always give the same case. A change of the generator shows here.
#include <gtest/gtest.h>

#include <cstdint>
#include <map>
#include <string_view>

#include "case_hash.h"
#include "occlude/fuzz/cases.h"

namespace occlude::fuzz {
namespace golden_test {

/// Hashes of the first 1000 cases of each family.
const std::map<std::string_view, std::uint64_t> kHashes{
    {"random", 0xbf03f1fa03abc1e2},
    {"lattice", 0x5db77f7d18761948},
    {"face_touch", 0xa2512fb1166b13d3},
    {"ray_touch", 0x248de281a07e4a7b},
    {"near_touch", 0x36b9f75756d47040},
    {"corner_touch", 0xb106379da23fd818},
    {"ulp_lattice", 0x9258785ac2341021},
    {"ulp_random", 0xdd950c15fa8dd14e},
    {"flat_box", 0x8ce13b52d829811b},
    {"needle_box", 0xc7334bdd2ab855b2},
    {"point_box", 0x8d340c5051a97f1e},
    {"eye_in_box", 0x5f9f61be67b378b9},
    {"sliver", 0xe84bc8bf437c6b00},
    {"sliver_lattice", 0xefa8eb667c32fd64},
    {"many_sided", 0xe28ed277d4af01ff},
    {"collinear", 0xf4b1e0ca99cd8940},
    {"equal_farthest", 0x46dd994738a1ff11},
    {"far_offset", 0xb9f565e72abbb4aa},
    {"tiny_scale", 0x66a01becfe70ebeb},
    {"huge_scale", 0x8a550b34d9661686},
    {"decimal", 0xce16eff2a26d6fd4},
    {"non_coplanar", 0x1d3d333805b3c80d},
    {"orthographic", 0x8827e9e35fed59d5},
    {"orthographic_touch", 0x9f85f8a9013b9638},
    {"orthographic_ulp", 0xeadb5a3f0113ffb9},
    {"wide_frustum", 0xc9efccc26b89c2c8},
    {"wide_frustum_ulp", 0x30f7b83186302afc},
    {"axis_aligned_faces", 0x173e2a65553b95a6},
    {"shared_vertex", 0x6ec5291c10069c8f},
    {"edge_crossing", 0x73bf23da831984b8},
    {"edge_crossing_ulp", 0xc5befb2240b45432},
    {"edge_crossing_random", 0xb528c53d2fc5d1ea},
    {"orthographic_axis_aligned", 0xacdea4f7d6fa2113},
    {"orthographic_edge_crossing", 0x66c4244d19653b86},
    {"obb_random", 0x292adb749e6993c2},
    {"obb_lattice", 0xf1cb610cabeb23aa},
    {"obb_flat", 0x5407091a9834335e},
    {"obb_needle", 0x34abcfdfa4a838d5},
    {"obb_point", 0x246419389a984573},
    {"obb_dependent", 0x24491a50428603f0},
    {"obb_axis", 0xfdf5c90ab557579f},
    {"obb_ulp", 0xef969907128de1e9},
    {"obb_parallel", 0x0e238d6eee6575d0},
    {"obb_parallel_ulp", 0xf95b0bdc99de2f97},
    {"obb_about_eye", 0xb1dd8f4ede6c7370},
    {"obb_shared_vertex", 0x76ee75ba47ca79fb},
    {"obb_edge_crossing", 0xfc9a911980b5bde4},
    {"obb_edge_crossing_ulp", 0x42d1efa87fcfdabf},
    {"obb_wide_frustum", 0x7a4f67a684e0a25b},
    {"obb_sliver", 0x9cbb7998fea98fc8},
    {"obb_many_sided", 0xada68064b0a4f6b7},
    {"obb_decimal", 0xd831170869ebd36d},
    {"obb_far_offset", 0x5b4c0efc7c286f91},
    {"obb_tiny_scale", 0xddef1c734ce273f8},
    {"obb_huge_scale", 0x7c58ed207bda9402},
    {"obb_orthographic", 0x48c546c07657b7bf},
    {"obb_orthographic_touch", 0x97400a6f1819939a},
    {"obb_orthographic_parallel", 0x05a09fa9b5d23bf4},
    {"obb_orthographic_ulp", 0x9a2c533512494966},
    {"polytope_random", 0x7ab154ab7abb2b37},
    {"polytope_box", 0xf0b370aabf3107c8},
    {"polytope_hull", 0xd401e4cd3f949bd4},
    {"polytope_near", 0x75290c98570298fb},
    {"polytope_edge_on", 0x069297fe2db1cd74},
    {"polytope_ulp", 0xfe7fb167917a6447},
    {"polytope_many", 0xd1318af11dcd19c9},
    {"polytope_equal_farthest", 0xcb25a308ed681d01},
    {"polytope_wide_frustum", 0x6cb8737aef41a12b},
    {"polytope_edge_crossing", 0x5671fadc8e02020f},
    {"polytope_shared_vertex", 0x0ca77eeb6c83e435},
    {"polytope_decimal", 0xd419940ce0848237},
    {"polytope_far_offset", 0xba00447a8a93a4a8},
    {"polytope_tiny_scale", 0x0900847cf3b94b0f},
    {"polytope_huge_scale", 0x642d1fee1a5e6956},
    {"polytope_orthographic", 0x34dcd19d8578a4d5},
    {"polytope_orthographic_touch", 0xb451ab89b3c50bf5},
    {"polytope_orthographic_edge_on", 0x9cd7635e4b48aeac},
    {"polytope_orthographic_ulp", 0x7a3ea9af0e9379a5},
    {"obb_polytope", 0x564da3fa6bfa02f1},
    {"obb_polytope_random", 0x52cd03be2d48af11},
    {"obb_polytope_near", 0xe495b86a1c0ed46b},
    {"obb_polytope_edge_on", 0x791be0b62eea7873},
    {"obb_polytope_edge_crossing", 0x8abae4779277b36b},
    {"obb_polytope_ulp", 0xd99d26e4364567e6},
    {"obb_polytope_orthographic", 0x1b3d91fe0138a113},
    {"hair", 0xad375656b7de4998},
    {"obb_hair", 0xa14dea385098420c},
    {"polytope_hair", 0x0e5356a111918993},
    {"edge_on", 0x19a9662ac7e91fc3},
    {"cospherical", 0x5e7139f9e542d23f},
    {"any_scale", 0xbf4102ad75f973c2},
    {"obb_any_scale", 0x76f1fbcf302f3cec},
    {"polytope_any_scale", 0xf69a1ffcb8c4d0fb},
    {"long_box", 0xded35a32490dea2a},
    {"obb_long_box", 0x2bf5a75ad4b887bd},
    {"polytope_long_box", 0x1ea250dbf222c73e},
    {"edge_at_eye", 0x89778db2e213d302},
    {"obb_edge_at_eye", 0xdb35e94f23390a0e},
    {"obb_orthographic_long", 0x5d33a73bf3504dd8},
};

std::uint64_t hash_of(Family family) {
  CaseHash hash;
  for (std::uint64_t seed = 0; seed < 1000; ++seed) hash.add(make_case(family, seed));
  return hash.value();
}

TEST(Golden, CasesAreWhatTheyWere) {
  for (const Family family : families()) {
    const auto golden = kHashes.find(name(family));
    ASSERT_NE(golden, kHashes.end()) << name(family) << " has no hash yet: " << std::hex << hash_of(family);
    EXPECT_EQ(golden->second, hash_of(family)) << name(family);
  }
  EXPECT_EQ(kHashes.size(), families().size());
}

}  // namespace golden_test
}  // namespace occlude::fuzz
