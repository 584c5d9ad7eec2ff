// SPDX-License-Identifier: MIT
// The structs of layout.mts are those of the headers: the compiler of the module checks each offset, size and default.
import assert from "node:assert/strict";
import {spawnSync} from "node:child_process";
import {test} from "node:test";

import {need, project} from "./common.mjs";

const made = `${project}build/js/layout.mjs`;
const compiler = "/usr/bin/em++";

/** The numbers of a member in C++: one, or those of an array, which may have rows of three. */
function numbersOf(member, {initial}) {
  if (typeof initial !== "object") return [[member, initial]];
  return initial.map((value, i) => [initial.length === 9 ? `${member}[${Math.floor(i / 3)}][${i % 3}]` : `${member}[${i}]`, value]);
}

function checksOf(struct) {
  const {name, fields, offsets, bytes} = struct;
  const hasDefaults = !["points", "boxes", "hiding", "fate", "model_frame"].includes(name.slice("occlude_".length));
  const lines = [`static_assert(sizeof(${name}) == ${bytes});`];
  if (hasDefaults) lines.push(`constexpr ${name} k_${name} = ${name.toUpperCase()}_INIT;`);
  for (const [member, field] of Object.entries(fields)) {
    const count = typeof field.initial === "object" ? field.initial.length : 1;
    const each = {u32: 4, i32: 4, f32: 4, u64: 8, f64: 8}[field.kind];
    lines.push(`static_assert(offsetof(${name}, ${member}) == ${offsets.get(member)});`);
    lines.push(`static_assert(sizeof(((${name}*)nullptr)->${member}) == ${count * each});`);
    lines.push(`static_assert(is_${field.kind}<decltype(element(((${name}*)nullptr)->${member}))>);`);
    if (!hasDefaults) continue;
    for (const [place, value] of numbersOf(member, field)) {
      lines.push(`static_assert(same(k_${name}.${place}, ${member === "size" ? bytes : value}));`);
    }
  }
  return lines;
}

const head = `
#include <cstddef>
#include <type_traits>
#include "model.h"
template <class T> std::remove_all_extents_t<std::remove_reference_t<T>> element(T&&);
template <class T> constexpr bool is_u32 = std::is_pointer_v<T> || std::is_same_v<T, std::size_t> || std::is_same_v<T, std::uint32_t>;
template <class T> constexpr bool is_i32 = std::is_same_v<T, std::int32_t>;
template <class T> constexpr bool is_u64 = std::is_same_v<T, std::uint64_t>;
template <class T> constexpr bool is_f32 = std::is_same_v<T, float>;
template <class T> constexpr bool is_f64 = std::is_same_v<T, double>;
template <class T> constexpr bool same(T value, double wanted) {
  if constexpr (std::is_pointer_v<T>) return value == nullptr && wanted == 0;
  else return static_cast<double>(value) == wanted;
}
`;

test("the structs are those of the headers", need(compiler, "Emscripten"), async () => {
  const {structs} = await import(made);
  const code = [head, ...Object.values(structs).flatMap(checksOf)].join("\n");
  const options = ["-std=c++20", "-fsyntax-only", "-x", "c++", "-I", `${project}culler/c/include`, "-I", `${project}culler/js/src`];
  const run = spawnSync(compiler, [...options, "-"], {
    input: code, encoding: "utf8", env: {...process.env, NODE_PATH: "/usr/share/nodejs"},
  });
  assert.equal(run.status, 0, run.stderr);
});
