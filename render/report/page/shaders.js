// SPDX-License-Identifier: MIT
// The programs of the viewer (OpenGL ES 3.0).

const kFatesWide = 1024;      // leaves in a row of the texture of fates
const kTrianglesWide = 4096;  // triangles in a row of the texture of what is seen

/** Corners of the model, and of each twice its leaf, and 1 more if it is see-through. Triangles of leaves that no layer shows become nothing. */
const kModelVertices = `#version 300 es
precision highp float;
precision highp usampler2D;
uniform mat4 projection;
uniform ivec3 eyeCell;  // the eye on the grid, and its place in that cell: near corners keep all their digits
uniform vec3 eyeRest;
uniform float step;
uniform usampler2D fates;
uniform bool showsDrawn, showsOutOfView, showsHidden, showsAll;
layout(location = 0) in ivec3 corner;
layout(location = 1) in uint leaf;
flat out uint fate;
flat out uint triangle;
flat out uint seeThrough;
out vec3 place;
invariant gl_Position;
void main() {
  uint number = leaf >> 1;
  fate = texelFetch(fates, ivec2(number % ${kFatesWide}u, number / ${kFatesWide}u), 0).r;
  seeThrough = leaf & 1u;
  triangle = uint(gl_VertexID) / 3u;
  place = step * (vec3(corner - eyeCell) - eyeRest);
  bool isShown = showsAll || (fate == 0u ? showsDrawn : fate == 1u ? showsOutOfView : showsHidden);
  gl_Position = isShown ? projection * vec4(place, 1) : vec4(0, 0, 2, 1);
}`;

const kInputs = `${kModelInputs}
flat in uint fate;
flat in uint seeThrough;`;

/**
 * Colours: of what is drawn by the slope of the surface, plain, and dotted if it is hidden; of what is culled by its hider,
 * hatched; of what is out of view pale. Fates and hiders differ in lightness and pattern as well, for colour-blind readers.
 */
const kModelColours = `${kInputs}${kLight}
uniform vec3 pale, cover;
uniform vec3 hiders[8];
uniform vec3 missed;  // drawn, but hidden
uniform vec4 tint;  // mixed into all that, by its alpha
uniform bool marksMissed, showsVain;
uniform usampler2D marks;  // of each triangle: 1 if the view of the camera shows it, and 2 times how often it was drawn in vain
uniform vec3 heat[5];
uniform float unitOfHatching;
out vec4 colour;

uint mark() { return texelFetch(marks, ivec2(triangle % ${kTrianglesWide}u, triangle / ${kTrianglesWide}u), 0).r; }

/** From 0 to 1: the more, the darker. */
vec3 colourOfHeat(float share) {
  float at = share * 4.0;
  int below = min(int(at), 3);
  return mix(heat[below], heat[below + 1], at - float(below));
}

vec2 pixel() { return gl_FragCoord.xy / unitOfHatching; }

/** Whether this pixel is in a stripe of the pattern. */
bool isHatched(uint pattern) {
  vec2 at = pixel();
  float across = pattern == 0u ? at.x + at.y : pattern == 1u ? at.x - at.y : pattern == 2u ? at.y * 1.4 : at.x * 1.4;
  return fract(across / 9.0) < 0.3;
}

/** Whether this pixel is in a dot: every second row of dots is shifted. */
bool isDotted() {
  vec2 at = pixel() / vec2(6.0, 5.0);
  at.x += 0.5 * mod(floor(at.y), 2.0);
  return distance(fract(at), vec2(0.5)) < 0.3;
}

/** A pattern in white or black, whichever is farther from the colour. */
vec3 patterned(vec3 base) { return mix(base, vec3(dot(base, vec3(0.3, 0.6, 0.1)) < 0.5 ? 1 : 0), 0.45); }

void main() {
  if (isLeftOut(seeThrough == 1u)) discard;
  vec3 normal = normalAt(place, up), base;
  uint marked = mark();
  bool isPlain = false;  // so plain that light may change it much
  if (showsVain) base = marked < 2u ? pale : colourOfHeat(float(marked >> 1) / 127.0);
  else if (fate == 0u && marksMissed && (marked & 1u) == 0u) base = isDotted() ? patterned(missed) : missed;
  else if (fate == 0u) {
    base = clay(abs(dot(normal, up)));
    isPlain = tint.a == 0.0;
  }
  else if (fate == 1u) base = pale;
  else {
    uint hider = fate - 3u;
    base = fate == 2u ? cover : hiders[hider % 8u];
    if (isHatched(fate == 2u ? 0u : hider % 4u)) base = patterned(base);
  }
  colour = vec4(lit(mix(base, tint.rgb, tint.a), normal, up, isPlain ? 1.0 : 0.55), 1);
  ${kDepth}
}`;

const kModelNumbers = `${kInputs}
out vec4 number;
void main() {
  if (isLeftOut(seeThrough == 1u)) discard;
  number = numberInBytes();
  ${kDepth}
}`;

/** The twelve edges of a box, one pixel wide: along each axis from the four corners at its low side. */
const kBoxVertices = `#version 300 es
precision highp float;
uniform mat4 projection;
layout(location = 0) in vec3 low;  // relative to the eye
layout(location = 1) in vec3 high;
layout(location = 2) in vec4 paint;
out vec4 tint;
void main() {
  int edge = gl_VertexID / 2, axis = edge / 4;
  bvec3 isHigh;
  isHigh[axis] = gl_VertexID % 2 == 1;
  isHigh[(axis + 1) % 3] = edge % 2 == 1;
  isHigh[(axis + 2) % 3] = edge / 2 % 2 == 1;
  tint = paint;
  gl_Position = projection * vec4(mix(low, high, isHigh), 1);
}`;

/** Triangles of one colour each. */
const kFaceVertices = `#version 300 es
precision highp float;
uniform mat4 projection;
layout(location = 0) in vec3 corner;  // relative to the eye
layout(location = 1) in vec4 paint;
out vec4 tint;
void main() {
  tint = paint;
  gl_Position = projection * vec4(corner, 1);
}`;
