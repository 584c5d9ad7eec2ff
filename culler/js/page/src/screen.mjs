// SPDX-License-Identifier: MIT
// Pictures with depths, and how they come to the screen.
import {haze, sky} from "./colours.mjs";
import {link} from "./programs.mjs";

/** @import {Rgb} from "./colours.mjs" */

/**
 * @typedef {object} Target A picture that is drawn into.
 * @property {WebGLFramebuffer} buffer
 * @property {WebGLTexture} colours
 * @property {WebGLTexture} depths
 * @property {number} width
 * @property {number} height
 */

/** Two views and a lens, and the pictures of their numbers, coarse and fine. */
const kMostTargets = 8;

/** Pictures, kept by name and size; those that have not been asked for are forgotten. */
export class Targets {
  /** @param {WebGL2RenderingContext} gl */
  constructor(gl) {
    this.gl = gl;
    /** @type {Map<string, Target>} */
    this.targets = new Map();
  }

  /**
   * @param {string} kind
   * @param {number} width
   * @param {number} height
   * @returns {Target}
   */
  of(kind, width, height) {
    const name = `${kind} ${width} ${height}`, found = this.targets.get(name);
    if (found) return found;
    if (this.targets.size >= kMostTargets) this.forgetOldest();
    const {gl} = this, buffer = gl.createFramebuffer();
    const [colours, depths] = [gl.RGBA8, gl.DEPTH_COMPONENT32F].map(format => this.texture(format, width, height));
    const target = /** @type {Target} */ ({buffer, colours, depths, width, height});
    gl.bindFramebuffer(gl.FRAMEBUFFER, buffer);
    gl.framebufferTexture2D(gl.FRAMEBUFFER, gl.COLOR_ATTACHMENT0, gl.TEXTURE_2D, target.colours, 0);
    gl.framebufferTexture2D(gl.FRAMEBUFFER, gl.DEPTH_ATTACHMENT, gl.TEXTURE_2D, target.depths, 0);
    this.targets.set(name, target);
    return target;
  }

  /**
   * Draws into a target from now on, in front of nothing.
   * @param {Target} target
   * @param {Rgb} [background]
   */
  begin({buffer, width, height}, background = [0, 0, 0]) {
    const {gl} = this;
    gl.bindFramebuffer(gl.FRAMEBUFFER, buffer);
    gl.viewport(0, 0, width, height);
    gl.depthMask(true);
    gl.clearColor(...background, 0);
    gl.clearDepth(0);
    gl.clear(gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT);
    gl.enable(gl.DEPTH_TEST);
    gl.depthFunc(gl.GREATER);
  }

  /**
   * @param {number} format
   * @param {number} width
   * @param {number} height
   */
  texture(format, width, height) {
    const {gl} = this, made = gl.createTexture();
    gl.activeTexture(gl.TEXTURE0);
    gl.bindTexture(gl.TEXTURE_2D, made);
    gl.texStorage2D(gl.TEXTURE_2D, 1, format, width, height);
    setFilter(gl, format === gl.RGBA8 ? gl.LINEAR : gl.NEAREST);
    return made;
  }

  forgetOldest() {
    const {gl} = this;
    for (const [oldest, {buffer, colours, depths}] of this.targets) {
      gl.deleteFramebuffer(buffer);
      gl.deleteTexture(colours);
      gl.deleteTexture(depths);
      this.targets.delete(oldest);
      return;
    }
  }
}

/**
 * Of the texture that is bound.
 * @param {WebGL2RenderingContext} gl
 * @param {number} filter
 */
export function setFilter(gl, filter) {
  gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_MIN_FILTER, filter);
  gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_MAG_FILTER, filter);
  gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_WRAP_S, gl.CLAMP_TO_EDGE);
  gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_WRAP_T, gl.CLAMP_TO_EDGE);
}

/**
 * The numbers of triangles in a part of the target that is drawn into, as numberInBytes() of programs.mjs wrote them.
 * @param {WebGL2RenderingContext} gl
 * @param {number} x
 * @param {number} y
 * @param {number} width
 * @param {number} height
 */
export function readNumbers(gl, x, y, width, height) {
  const bytes = new Uint8Array(4 * width * height);
  gl.readPixels(x, y, width, height, gl.RGBA, gl.UNSIGNED_BYTE, bytes);
  return new Uint32Array(bytes.buffer);
}

/** The whole picture as one triangle. */
const kScreenVertices = `#version 300 es
out vec2 at;
void main() {
  at = vec2(gl_VertexID & 1, gl_VertexID >> 1) * 2.0;
  gl_Position = vec4(2.0 * at - 1.0, 0, 1);
}`;

/**
 * The picture, darker where surfaces meet. The inverse of the distance is linear on a plane in the picture: the mean of two opposite
 * pixels differs from the middle's only at a bend or an edge. Inwards it is nearer. With parallel rays nothing is darker.
 */
const kScreenFragments = `#version 300 es
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
    vec4 painted = texture(picture, at);  // lines: they have no depth
    colour = vec4(mix(mix(haze, sky, smoothstep(0.35, 1.0, at.y)), painted.rgb, painted.a), 1);
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
  float light = near > 0.0 ? 1.0 - 0.65 * shade / 8.0 : 1.0;
  colour = vec4(smoothed(at, 1.0 / size) * light, 1);
}`;

export class Screen {
  /** @param {WebGL2RenderingContext} gl */
  constructor(gl) {
    this.gl = gl;
    this.screen = link(gl, kScreenVertices, kScreenFragments);
  }

  /**
   * Shows a picture in a part of the canvas, before a sky. Corners are dark that far out of them.
   * @param {Target} target
   * @param {readonly [number, number]} at
   * @param {{readonly near: number, readonly shadeRadius: number, readonly isDark: boolean}} look
   */
  show({colours, depths, width, height}, [x, y], {near, shadeRadius, isDark}) {
    const {gl} = this, {program, uniforms} = this.screen;
    gl.bindFramebuffer(gl.FRAMEBUFFER, null);
    gl.viewport(x, y, width, height);
    gl.disable(gl.DEPTH_TEST);
    gl.useProgram(program);
    [colours, depths].forEach((texture, i) => {
      gl.activeTexture(gl.TEXTURE0 + i);
      gl.bindTexture(gl.TEXTURE_2D, texture);
    });
    gl.uniform1i(uniforms.picture ?? null, 0);
    gl.uniform1i(uniforms.depths ?? null, 1);
    gl.uniform1f(uniforms.near ?? null, near);
    gl.uniform1f(uniforms.radius ?? null, shadeRadius);
    gl.uniform3fv(uniforms.haze ?? null, isDark ? haze.dark : haze.light);
    gl.uniform3fv(uniforms.sky ?? null, isDark ? sky.dark : sky.light);
    gl.bindVertexArray(null);
    gl.drawArrays(gl.TRIANGLES, 0, 3);
  }
}
