// SPDX-License-Identifier: MIT
// The programs of the viewer (OpenGL ES 3.0).

const kFatesWide = 1024;      // leaves in a row of the texture of fates
const kTrianglesWide = 4096;  // triangles in a row of the texture of what is seen

/** Of what is see-through every second pixel is left out, as on a chessboard: whatever is drawn first, what is behind shows. */
const kSeeThrough = `
flat in uint seeThrough;
bool isLeftOut() { return seeThrough == 1u && ((int(gl_FragCoord.x) + int(gl_FragCoord.y)) & 1) == 0; }`;

/** Corners of the model, and of each twice its leaf, and 1 more if it is see-through. Triangles of leaves that no layer shows become nothing. */
const kModelVertices = `#version 300 es
precision highp float;
precision highp usampler2D;
uniform mat4 picture;
uniform ivec3 eyeCell;  // the eye on the grid, and its place in that cell: near corners keep all their digits
uniform vec3 eyeRest;
uniform float step;
uniform usampler2D fates;
uniform bool showsDrawn, showsOutOfView, showsHidden, showsAll;
in ivec3 corner;
in uint leaf;
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
  gl_Position = isShown ? picture * vec4(place, 1) : vec4(0, 0, 2, 1);
}`;

/**
 * Colours: of what is drawn by the slope of the surface, plain, and dotted if it is hidden; of what is culled by its hider,
 * hatched; of what is out of view pale. Fates and hiders differ in lightness and pattern as well, for colour-blind readers.
 */
const kModelColours = `#version 300 es
precision highp float;
precision highp int;
precision highp usampler2D;
uniform vec3 up, pale, cover;
uniform vec3 hiders[8];
uniform vec3 missed;  // drawn, but hidden
uniform float ceiling;  // what is higher is cut off
uniform vec4 tint;  // mixed into all that, by its alpha
uniform bool marksMissed, showsVain;
uniform usampler2D marks;  // of each triangle: 1 if the view of the camera shows it, and 2 times how often it was drawn in vain
uniform vec3 heat[5];
uniform float unitOfHatching;
flat in uint fate;
flat in uint triangle;${kSeeThrough}
in vec3 place;
out vec4 colour;

/** Darker than what is out of view, and never patterned. */
vec3 drawn(float slope) {
  return slope > 0.99 ? vec3(0.58, 0.58, 0.54) : slope > 0.82 ? vec3(0.50, 0.55, 0.42) : slope > 0.3 ? vec3(0.55, 0.40, 0.33)
                                                                                                  : vec3(0.74, 0.64, 0.50);
}

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
  if (dot(place, up) > ceiling || isLeftOut()) discard;
  vec3 normal = cross(dFdx(place), dFdy(place));
  float size = length(normal);
  normal = size > 0.0 ? normal / size : up;
  float light = 0.62 + 0.38 * abs(dot(normal, normalize(vec3(-0.57, -0.42, 0.71))));
  vec3 base;
  uint marked = mark();
  if (showsVain) base = marked < 2u ? pale : colourOfHeat(float(marked >> 1) / 127.0);
  else if (fate == 0u && marksMissed && (marked & 1u) == 0u) base = isDotted() ? patterned(missed) : missed;
  else if (fate == 0u) base = drawn(abs(dot(normal, up)));
  else if (fate == 1u) base = pale;
  else {
    uint hider = fate - 3u;
    base = fate == 2u ? cover : hiders[hider % 8u];
    if (isHatched(fate == 2u ? 0u : hider % 4u)) base = patterned(base);
  }
  colour = vec4(mix(base, tint.rgb, tint.a) * light, 1);
}`;

/**
 * The number of the triangle at each pixel, from 1. Depths are near / distance, or fall evenly if the picture is orthographic,
 * and are kept as floating-point numbers: far away they tell walls from what hangs on them.
 */
const kModelNumbers = `#version 300 es
precision highp float;
precision highp int;
uniform vec3 up, forward;
uniform float ceiling, near, far;
uniform bool isPerspective;
flat in uint fate;
flat in uint triangle;${kSeeThrough}
in vec3 place;
out uint number;
void main() {
  if (dot(place, up) > ceiling || isLeftOut()) discard;
  float away = dot(place, forward);
  gl_FragDepth = isPerspective ? near / away : (far - away) / (far - near);
  number = triangle + 1u;
}`;

/** A line as a strip of some pixels: two corners at each end. */
const kLineVertices = `#version 300 es
precision highp float;
uniform mat4 picture;
uniform vec2 pixels;  // size of the picture
uniform float wide;
in vec3 from, to;  // relative to the eye
in vec4 paint;
out vec4 paints;
void main() {
  vec4 a = picture * vec4(from, 1), b = picture * vec4(to, 1);
  float nearest = 1e-6;  // what is behind the eye is cut off
  if (a.w < nearest && b.w < nearest) { gl_Position = vec4(0, 0, 2, 1); return; }
  if (a.w < nearest) a = mix(a, b, (nearest - a.w) / (b.w - a.w));
  if (b.w < nearest) b = mix(b, a, (nearest - b.w) / (a.w - b.w));
  vec2 along = (b.xy / b.w - a.xy / a.w) * pixels;
  float size = length(along);
  vec2 across = size > 0.0 ? vec2(-along.y, along.x) / size : vec2(0, 1);
  vec4 end = gl_VertexID < 2 ? a : b;
  end.xy += (gl_VertexID % 2 == 0 ? 1.0 : -1.0) * across * wide / pixels * end.w;
  paints = paint;
  gl_Position = end;
}`;

/** The twelve edges of a box, one pixel wide: along each axis from the four corners at its low side. */
const kBoxVertices = `#version 300 es
precision highp float;
uniform mat4 picture;
in vec3 low, high;  // relative to the eye
in vec4 paint;
out vec4 paints;
void main() {
  int edge = gl_VertexID / 2, axis = edge / 4;
  bvec3 isHigh;
  isHigh[axis] = gl_VertexID % 2 == 1;
  isHigh[(axis + 1) % 3] = edge % 2 == 1;
  isHigh[(axis + 2) % 3] = edge / 2 % 2 == 1;
  paints = paint;
  gl_Position = picture * vec4(mix(low, high, isHigh), 1);
}`;

/** Triangles of one colour each. */
const kFaceVertices = `#version 300 es
precision highp float;
uniform mat4 picture;
in vec3 corner;  // relative to the eye
in vec4 paint;
out vec4 paints;
void main() {
  paints = paint;
  gl_Position = picture * vec4(corner, 1);
}`;

const kPaint = `#version 300 es
precision highp float;
in vec4 paints;
out vec4 colour;
void main() { colour = vec4(paints.rgb * paints.a, paints.a); }`;

/** A program with its attributes at the places 0, 1, ..., and its uniforms by name. */
function linkProgram(gl, vertices, fragments, attributes) {
  const program = gl.createProgram();
  for (const [type, text] of [[gl.VERTEX_SHADER, vertices], [gl.FRAGMENT_SHADER, fragments]]) {
    const shader = gl.createShader(type);
    gl.shaderSource(shader, text);
    gl.compileShader(shader);
    if (!gl.getShaderParameter(shader, gl.COMPILE_STATUS)) throw new Error(gl.getShaderInfoLog(shader));
    gl.attachShader(program, shader);
  }
  attributes.forEach((name, place) => gl.bindAttribLocation(program, place, name));
  gl.linkProgram(program);
  if (!gl.getProgramParameter(program, gl.LINK_STATUS)) throw new Error(gl.getProgramInfoLog(program));
  const uniforms = {};
  for (let i = gl.getProgramParameter(program, gl.ACTIVE_UNIFORMS) - 1; i >= 0; --i) {
    const name = gl.getActiveUniform(program, i).name;
    uniforms[name.replace('[0]', '')] = gl.getUniformLocation(program, name);
  }
  return {program, uniforms};
}
