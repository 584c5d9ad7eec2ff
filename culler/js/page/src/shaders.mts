// SPDX-License-Identifier: MIT
// The programs of the page (OpenGL ES 3.0).

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

/** Depth is near / distance, in floating point: far away it is as fine as near by. */
const kDepth = "gl_FragDepth = near * gl_FragCoord.w;";

const kModelInputs = `#version 300 es
precision highp float;
precision highp int;
uniform float near;
uniform vec3 up;
uniform float ceiling;  // what is higher than that above the eye is cut off
flat in uint triangle;
flat in float opacity;
in vec3 place;
in vec3 tint;
/** Of what light comes through every second pixel is left out, as on a chessboard. */
bool isLeftOut() {
  return dot(place, up) > ceiling || opacity < 0.5 && ((int(gl_FragCoord.x) + int(gl_FragCoord.y)) & 1) == 0;
}`;

export const colourVertices = modelVertices("");

/** Lit by a sky and a sun. With fates, what is culled has its colour; what is marked has another. */
export const colourFragments = `${kModelInputs}
precision highp usampler2D;
uniform usampler2D fates;
uniform bool showsFates, showsClay, showsHidden, showsOutOfView;
uniform vec3 hidden, outOfView, marked;
uniform float hatching;  // pixels from stripe to stripe
uniform uvec2 markedRange;  // triangles: the first and the one after the last
out vec4 colour;

/** By the slope of the surface, as in the reports. */
vec3 clay(float slope) {
  return slope > 0.99 ? vec3(0.66, 0.66, 0.62) : slope > 0.82 ? vec3(0.58, 0.63, 0.50) : slope > 0.3 ? vec3(0.66, 0.50, 0.42)
                                                                                                : vec3(0.80, 0.71, 0.58);
}

void main() {
  uint fate = showsFates ? texelFetch(fates, ivec2(triangle % ${kFatesWide}u, triangle / ${kFatesWide}u), 0).r : 0u;
  if (isLeftOut() || fate == 1u && !showsHidden || fate == 2u && !showsOutOfView) discard;
  vec3 across = cross(dFdx(place), dFdy(place));
  float size = length(across);
  vec3 normal = size > 0.0 ? across / size : up;
  normal *= dot(normal, place) > 0.0 ? -1.0 : 1.0;
  bool isMarked = triangle >= markedRange.x && triangle < markedRange.y;
  vec3 base = showsClay ? clay(abs(dot(normal, up))) : tint;
  base = isMarked ? marked : fate == 1u ? hidden : fate == 2u ? outOfView : base;
  // For colour-blind readers what is hidden is striped as well.
  if (fate == 1u && fract((gl_FragCoord.x + gl_FragCoord.y) / hatching) < 0.3) base = mix(base, vec3(1), 0.28);
  vec3 helper = abs(up.x) < 0.9 ? vec3(1, 0, 0) : vec3(0, 1, 0), east = normalize(cross(up, helper));
  vec3 sun = normalize(0.75 * up + 0.35 * east + 0.5 * cross(up, east));
  float light = 0.55 + 0.17 * dot(normal, up) + 0.42 * max(0.0, dot(normal, sun));
  // Light adds up in its own measure, about the square of what the screen is told.
  colour = vec4(sqrt(base * base * (isMarked || fate == 1u ? 0.45 + 0.55 * light : light)), 1);
  ${kDepth}
}`;

/** The number of the triangle from 1, in four bytes. */
export const numberVertices = modelVertices("");
export const numberFragments = `${kModelInputs}
uniform bool isOpaqueOnly;
out vec4 number;
void main() {
  if (isLeftOut() || isOpaqueOnly && opacity < 0.5) discard;
  uint n = triangle + 1u;
  number = vec4(n & 255u, (n >> 8) & 255u, (n >> 16) & 255u, n >> 24) / 255.0;
  ${kDepth}
}`;

/** The whole picture as one triangle. */
export const screenVertices = `#version 300 es
out vec2 at;
void main() {
  at = vec2(gl_VertexID & 1, gl_VertexID >> 1) * 2.0;
  gl_Position = vec4(2.0 * at - 1.0, 0, 1);
}`;

/**
 * The picture, darker where surfaces meet. The inverse of the distance is linear on a plane in the picture: the mean of two opposite
 * pixels differs from the middle's only at a bend or an edge. Inwards it is nearer.
 */
export const screenFragments = `#version 300 es
precision highp float;
uniform sampler2D picture, depths;
uniform float near, radius;  // radius: of the shade, where the distance is 1, in heights of the picture
uniform vec3 sky, haze;
in vec2 at;
out vec4 colour;

/** The picture without steps along edges: a mean along each edge, as FXAA takes it. */
vec3 smoothed(vec2 at, vec2 pixel) {
  vec3 weights = vec3(0.299, 0.587, 0.114), middle = texture(picture, at).rgb;
  float a = dot(texture(picture, at + vec2(-1, -1) * pixel).rgb, weights), b = dot(texture(picture, at + vec2(1, -1) * pixel).rgb, weights);
  float c = dot(texture(picture, at + vec2(-1, 1) * pixel).rgb, weights), d = dot(texture(picture, at + vec2(1, 1) * pixel).rgb, weights);
  float here = dot(middle, weights), least = min(here, min(min(a, b), min(c, d))), most = max(here, max(max(a, b), max(c, d)));
  if (most - least < 0.06) return middle;
  vec2 along = vec2(c + d - a - b, a + c - b - d);
  along = clamp(along / (min(abs(along.x), abs(along.y)) + (a + b + c + d) / 32.0 + 0.008), -8.0, 8.0) * pixel;
  vec3 inner = 0.5 * (texture(picture, at - along / 6.0).rgb + texture(picture, at + along / 6.0).rgb);
  vec3 outer = 0.5 * inner + 0.25 * (texture(picture, at - along / 2.0).rgb + texture(picture, at + along / 2.0).rgb);
  float light = dot(outer, weights);
  return light < least || light > most ? inner : outer;
}

void main() {
  vec2 size = vec2(textureSize(depths, 0));
  float middle = texture(depths, at).r;
  if (middle == 0.0) {
    colour = vec4(mix(haze, sky, smoothstep(0.35, 1.0, at.y)), 1);
    return;
  }
  float reach = clamp(radius * middle / near, 5.0 / size.y, 0.05);
  float turn = 6.2832 * fract(52.9829189 * fract(dot(floor(gl_FragCoord.xy), vec2(0.06711056, 0.00583715))));
  float shade = 0.0;
  for (int i = 0; i < 8; ++i) {
    float angle = turn + float(i) * 2.39996, far = reach * sqrt((float(i) + 0.5) / 8.0);
    vec2 step = far * vec2(cos(angle) * size.y / size.x, sin(angle));
    if (any(greaterThan(abs(at - 0.5) + abs(step), vec2(0.5)))) continue;
    float bend = (texture(depths, at + step).r + texture(depths, at - step).r) * 0.5 / middle - 1.0;
    // By how much the two are nearer, in lengths of the step: in a corner about 1, at the edge of what stands in front more.
    float deep = 0.87 * bend / far;
    shade += clamp(deep, -0.2, 1.0) * (1.0 - smoothstep(0.9, 2.0, deep));
  }
  float light = 1.0 - 0.65 * shade / 8.0;
  colour = vec4(smoothed(at, 1.0 / size) * light, 1);
}`;

/** Straight lines some pixels wide. Each is a quad. */
export const lineVertices = `#version 300 es
precision highp float;
uniform mat4 projection;
uniform vec2 size;  // of the picture, in pixels
uniform float width;
layout(location = 0) in vec3 from;
layout(location = 1) in vec3 to;
layout(location = 2) in vec4 colour;
out vec4 tint;
void main() {
  vec4 a = projection * vec4(from, 1), b = projection * vec4(to, 1);
  // Cut off at the near plane, where z = -w.
  float da = a.z + a.w, db = b.z + b.w;
  if (da < 0.0 && db > 0.0) a = mix(a, b, da / (da - db));
  if (db < 0.0 && da > 0.0) b = mix(b, a, db / (db - da));
  vec2 along = (b.xy / b.w - a.xy / a.w) * size;
  vec2 across = length(along) > 0.0 ? normalize(vec2(-along.y, along.x)) * width / size : vec2(0);
  vec4 end = (gl_VertexID & 2) == 0 ? a : b;
  end.xy += ((gl_VertexID & 1) == 0 ? across : -across) * end.w;
  tint = colour;
  gl_Position = da < 0.0 && db < 0.0 ? vec4(0, 0, 2, 1) : end;
}`;
export const lineFragments = `#version 300 es
precision highp float;
uniform float near;
in vec4 tint;
out vec4 colour;
void main() {
  colour = tint;
  ${kDepth}
}`;
