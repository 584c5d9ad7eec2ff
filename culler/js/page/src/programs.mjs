// SPDX-License-Identifier: MIT
// Programs of WebGL 2, and what they share.

/** @typedef {{readonly program: WebGLProgram, readonly uniforms: Record<string, WebGLUniformLocation | null>}} Program */

/**
 * Depth is near / distance, in floating point: far away it is as fine as near by. With parallel rays, where `near` is 0, it falls evenly.
 */
export const kDepth = "gl_FragDepth = near > 0.0 ? near * gl_FragCoord.w : 1.0 - gl_FragCoord.z;";

/** Of what light comes through every second pixel is left out, as on a chessboard: whatever is drawn first, what is behind shows. */
const kSeeThrough = `
bool isBetween() { return ((int(gl_FragCoord.x) + int(gl_FragCoord.y)) & 1) == 0; }`;

/** What fragments of a model's triangles have in common. */
export const kModelInputs = `#version 300 es
precision highp float;
precision highp int;
precision highp usampler2D;
uniform vec3 up;
uniform float ceiling;  // what is higher than that above the eye is cut off
uniform float near;
flat in uint triangle;
in vec3 place;${kSeeThrough}
bool isLeftOut(bool isSeeThrough) { return dot(place, up) > ceiling || isSeeThrough && isBetween(); }
/** The number of the triangle from 1, in four bytes, as readNumbers() takes them. */
vec4 numberInBytes() {
  uint n = triangle + 1u;
  return vec4(n & 255u, (n >> 8) & 255u, (n >> 16) & 255u, n >> 24) / 255.0;
}`;

/** Surfaces under a sky and a sun. Slopes are the cosines to what is level. */
export const kLight = `
vec3 clay(float slope) {
  return slope > 0.99 ? vec3(0.66, 0.66, 0.62) : slope > 0.82 ? vec3(0.58, 0.63, 0.50) : slope > 0.3 ? vec3(0.66, 0.50, 0.42)
                                                                                                : vec3(0.80, 0.71, 0.58);
}

/** The side of the surface that is seen. */
vec3 normalAt(vec3 place, vec3 up) {
  vec3 across = cross(dFdx(place), dFdy(place));
  float size = length(across);
  vec3 normal = size > 0.0 ? across / size : up;
  return dot(normal, place) > 0.0 ? -normal : normal;
}

/** A colour in the light, or so much of it. */
vec3 lit(vec3 base, vec3 normal, vec3 up, float share) {
  vec3 helper = abs(up.x) < 0.9 ? vec3(1, 0, 0) : vec3(0, 1, 0), east = normalize(cross(up, helper));
  vec3 sun = normalize(0.75 * up + 0.35 * east + 0.5 * cross(up, east));
  float light = 0.55 + 0.17 * dot(normal, up) + 0.42 * max(0.0, dot(normal, sun));
  // Light adds up in its own measure, about the square of what the screen is told.
  return sqrt(base * base * mix(1.0, light, share));
}`;

/**
 * A program with its uniforms by name; that of a list is called as the list.
 * @param {WebGL2RenderingContext} gl
 * @param {string} vertices
 * @param {string} fragments
 * @returns {Program}
 */
export function link(gl, vertices, fragments) {
  const program = gl.createProgram();
  for (const [type, source] of /** @type {const} */ ([[gl.VERTEX_SHADER, vertices], [gl.FRAGMENT_SHADER, fragments]])) {
    const shader = /** @type {WebGLShader} */ (gl.createShader(type));
    gl.shaderSource(shader, source);
    gl.compileShader(shader);
    if (!gl.getShaderParameter(shader, gl.COMPILE_STATUS)) throw new Error(gl.getShaderInfoLog(shader) ?? "a shader was refused");
    gl.attachShader(program, shader);
  }
  gl.linkProgram(program);
  if (!gl.getProgramParameter(program, gl.LINK_STATUS)) throw new Error(gl.getProgramInfoLog(program) ?? "a program was refused");
  /** @type {Program["uniforms"]} */
  const uniforms = {};
  for (let i = 0; i < gl.getProgramParameter(program, gl.ACTIVE_UNIFORMS); ++i) {
    const {name} = /** @type {WebGLActiveInfo} */ (gl.getActiveUniform(program, i));
    uniforms[name.replace("[0]", "")] = gl.getUniformLocation(program, name);
  }
  return {program, uniforms};
}
