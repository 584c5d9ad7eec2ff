// SPDX-License-Identifier: MIT
// The programs of the page (OpenGL ES 3.0).
import {kDepth, kLight, kModelInputs} from "./programs.mjs";

/** Triangles in a row of the texture of fates. */
export const kFatesWide = 4096;

/** The eye comes in two parts, so that what is near to it keeps all its digits. */
const modelVertices = (body: string) => `#version 300 es
precision highp float;
precision highp usampler2D;
uniform mat4 projection;
uniform vec3 eye, eyeRest;
layout(location = 0) in vec3 corner;
layout(location = 1) in vec4 colour;
flat out uint triangle;
flat out float opacity;
out vec3 place;
out vec3 tint;
invariant gl_Position;
void main() {
  place = (corner - eye) - eyeRest;
  triangle = uint(gl_VertexID) / 3u;
  opacity = colour.a;
  tint = colour.rgb;
  gl_Position = projection * vec4(place, 1);
  ${body}
}`;

const kInputs = `${kModelInputs}
flat in float opacity;
in vec3 tint;
bool isSeeThrough() { return opacity < 0.5; }`;

export const colourVertices = modelVertices("");

/** Lit by a sky and a sun. With fates, what is culled has its colour; what is marked has another. */
export const colourFragments = `${kInputs}${kLight}
uniform usampler2D fates;
uniform bool showsFates, showsClay, showsHidden, showsOutOfView;
uniform vec3 hidden, outOfView, marked;
uniform float hatching;  // pixels from stripe to stripe
uniform uvec2 markedRange;  // triangles: the first and the one after the last
out vec4 colour;

void main() {
  uint fate = showsFates ? texelFetch(fates, ivec2(triangle % ${kFatesWide}u, triangle / ${kFatesWide}u), 0).r : 0u;
  if (isLeftOut(isSeeThrough()) || fate == 1u && !showsHidden || fate == 2u && !showsOutOfView) discard;
  vec3 normal = normalAt(place, up);
  bool isMarked = triangle >= markedRange.x && triangle < markedRange.y;
  vec3 base = showsClay ? clay(abs(dot(normal, up))) : tint;
  base = isMarked ? marked : fate == 1u ? hidden : fate == 2u ? outOfView : base;
  // For colour-blind readers what is hidden is striped as well.
  if (fate == 1u && fract((gl_FragCoord.x + gl_FragCoord.y) / hatching) < 0.3) base = mix(base, vec3(1), 0.28);
  colour = vec4(lit(base, normal, up, isMarked || fate == 1u ? 0.55 : 1.0), 1);
  ${kDepth}
}`;

export const numberVertices = modelVertices("");
export const numberFragments = `${kInputs}
uniform bool isOpaqueOnly;
out vec4 number;
void main() {
  if (isLeftOut(isSeeThrough()) || isOpaqueOnly && isSeeThrough()) discard;
  number = numberInBytes();
  ${kDepth}
}`;
