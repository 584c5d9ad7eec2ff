// SPDX-License-Identifier: MIT
// Draws a model: pictures for readers, and pictures of triangles' numbers for judges.
import type {Camera} from "./camera.mjs";
import {haze, hiddenColour, pale, type Rgb} from "./colours.mjs";
import type {Frame} from "./frame.mjs";
import {Lines, type ColouredLine} from "./lines.mjs";
import {triangleCount, type Model} from "./model.mjs";
import type {Picture} from "./picture.mjs";
import {subtract, type Point} from "./points.mjs";
import {link, type Program} from "./programs.mjs";
import {projectionOf} from "./projection.mjs";
import {readNumbers, Screen, setFilter, Targets, type Target} from "./screen.mjs";
import * as shaders from "./shaders.mjs";

/** A part of the canvas, in its pixels from the lower left. */
export interface Viewport {
  readonly x: number;
  readonly y: number;
  readonly width: number;
  readonly height: number;
}

export interface Look {
  /** What the frame draws; undefined: all. */
  readonly frame?: Frame | undefined;
  readonly showsFates: boolean;
  readonly showsClay: boolean;
  readonly showsHidden: boolean;
  readonly showsOutOfView: boolean;
  /** What is that much above the origin along `up` is cut off. */
  readonly ceiling: number;
  readonly marked?: {readonly first: number; readonly end: number; readonly colour: Rgb} | undefined;
  /** Seen through what is in front. */
  readonly lines: readonly ColouredLine[];
  readonly isDark: boolean;
  /** Corners are dark that far out of them. */
  readonly shadeRadius: number;
}

export class Painter {
  readonly #gl: WebGL2RenderingContext;
  readonly #colour: Program;
  readonly #number: Program;
  readonly #targets: Targets;
  readonly #screen: Screen;
  readonly #lines: Lines;
  readonly #fates: WebGLTexture;
  #model: Model | undefined;
  #array: WebGLVertexArrayObject | null = null;
  #buffers: WebGLBuffer[] = [];
  #index: Uint32Array<ArrayBuffer> = new Uint32Array();
  #indexed: {frame: Frame; count: number} | undefined;

  constructor(canvas: HTMLCanvasElement) {
    const how: WebGLContextAttributes = {antialias: false, depth: false, alpha: false, preserveDrawingBuffer: true};
    const gl = canvas.getContext("webgl2", {...how, powerPreference: "high-performance"}) as WebGL2RenderingContext | null;
    if (!gl) throw new Error("this browser draws nothing by WebGL 2");
    this.#gl = gl;
    this.#colour = link(gl, shaders.colourVertices, shaders.colourFragments);
    this.#number = link(gl, shaders.numberVertices, shaders.numberFragments);
    this.#targets = new Targets(gl);
    this.#screen = new Screen(gl);
    this.#lines = new Lines(gl);
    this.#fates = gl.createTexture();
  }

  setModel(model: Model): void {
    const gl = this.#gl;
    for (const buffer of this.#buffers) gl.deleteBuffer(buffer);
    gl.deleteVertexArray(this.#array);
    this.#model = model;
    this.#indexed = undefined;
    this.#array = gl.createVertexArray();
    gl.bindVertexArray(this.#array);
    const count = triangleCount(model);
    this.#buffers = [model.corners, model.colours].map((data, i) => {
      const buffer = gl.createBuffer();
      gl.bindBuffer(gl.ARRAY_BUFFER, buffer);
      gl.bufferData(gl.ARRAY_BUFFER, data, gl.STATIC_DRAW);
      gl.enableVertexAttribArray(i);
      if (i === 0) gl.vertexAttribPointer(0, 3, gl.FLOAT, false, 0, 0);
      else gl.vertexAttribPointer(1, 4, gl.UNSIGNED_BYTE, true, 0, 0);
      return buffer;
    });
    this.#index = new Uint32Array(3 * count);
    const index = gl.createBuffer();
    gl.bindBuffer(gl.ELEMENT_ARRAY_BUFFER, index);
    gl.bufferData(gl.ELEMENT_ARRAY_BUFFER, 12 * count, gl.DYNAMIC_DRAW);
    this.#buffers.push(index);
    this.setFates(new Uint8Array(count));
  }

  setFates(fates: Uint8Array): void {
    const gl = this.#gl, wide = shaders.kFatesWide, rows = Math.ceil(fates.length / wide);
    const padded = new Uint8Array(wide * rows);
    padded.set(fates);
    gl.bindTexture(gl.TEXTURE_2D, this.#fates);
    gl.pixelStorei(gl.UNPACK_ALIGNMENT, 1);
    gl.texImage2D(gl.TEXTURE_2D, 0, gl.R8UI, wide, rows, 0, gl.RED_INTEGER, gl.UNSIGNED_BYTE, padded);
    setFilter(gl, gl.NEAREST);
  }

  /** Paints a part of the canvas. */
  paint(viewport: Viewport, camera: Camera, look: Look): void {
    const gl = this.#gl, {width, height} = viewport;
    const target = this.#targets.of("colours", width, height);
    // Edges against the sky are mixed with that.
    this.#targets.begin(target, look.isDark ? haze.dark : haze.light);
    const {uniforms} = this.#use(this.#colour, camera, look.ceiling);
    gl.uniform1i(uniforms.showsFates!, Number(look.showsFates));
    gl.uniform1i(uniforms.showsClay!, Number(look.showsClay));
    gl.uniform1i(uniforms.showsHidden!, Number(look.showsHidden));
    gl.uniform1i(uniforms.showsOutOfView!, Number(look.showsOutOfView));
    gl.uniform3fv(uniforms.hidden!, hiddenColour);
    gl.uniform3fv(uniforms.outOfView!, look.isDark ? pale.dark : pale.light);
    gl.uniform3fv(uniforms.marked!, look.marked?.colour ?? hiddenColour);
    gl.uniform1f(uniforms.hatching!, 9 * Math.max(1, devicePixelRatio));
    gl.uniform2ui(uniforms.markedRange!, look.marked?.first ?? 0, look.marked?.end ?? 0);
    gl.activeTexture(gl.TEXTURE0);
    gl.bindTexture(gl.TEXTURE_2D, this.#fates);
    gl.uniform1i(uniforms.fates!, 0);
    this.#draw(look.frame);
    gl.disable(gl.DEPTH_TEST);
    const seen = {...camera, projection: projectionOf(camera)};
    this.#lines.draw(look.lines, seen, [width, height], 2 * Math.max(1, devicePixelRatio));
    this.#screen.show(target, [viewport.x, viewport.y], {...look, near: camera.near});
  }

  /** The colours of a picture before it is shaded by its depths: four bytes of each pixel. */
  picture(camera: Camera, look: Look, width: number, height: number): Uint8Array {
    const gl = this.#gl;
    this.paint({x: 0, y: 0, width, height}, camera, look);
    const pixels = new Uint8Array(4 * width * height);
    gl.bindFramebuffer(gl.FRAMEBUFFER, this.#targets.of("colours", width, height).buffer);
    gl.readPixels(0, 0, width, height, gl.RGBA, gl.UNSIGNED_BYTE, pixels);
    return pixels;
  }

  /** Which triangle each pixel shows, of a frame or of all. */
  numbers(camera: Camera, width: number, height: number, frame?: Frame): Picture {
    const target = this.#drawNumbers(camera, width, height, Infinity, true, frame);
    return {triangles: readNumbers(this.#gl, 0, 0, target.width, target.height), width, height, camera};
  }

  /** The triangle at a pixel from the lower left, if any. */
  triangleAt(camera: Camera, [x, y]: readonly [number, number], {width, height}: Viewport, ceiling: number): number | undefined {
    this.#drawNumbers(camera, width, height, ceiling, false);
    const [number] = readNumbers(this.#gl, Math.floor(x), Math.floor(y), 1, 1);
    return number! > 0 ? number! - 1 : undefined;
  }

  #drawNumbers(camera: Camera, width: number, height: number, ceiling: number, isOpaqueOnly: boolean, frame?: Frame): Target {
    const gl = this.#gl, target = this.#targets.of("numbers", width, height);
    this.#targets.begin(target);
    const {uniforms} = this.#use(this.#number, camera, ceiling);
    gl.uniform1i(uniforms.isOpaqueOnly!, Number(isOpaqueOnly));
    this.#draw(frame);
    return target;
  }

  #use(program: Program, camera: Camera, ceiling: number): Program {
    const gl = this.#gl, {uniforms} = program, high = camera.eye.map(Math.fround) as unknown as Point;
    gl.useProgram(program.program);
    gl.uniformMatrix4fv(uniforms.projection!, false, projectionOf(camera));
    gl.uniform3fv(uniforms.eye!, high);
    gl.uniform3fv(uniforms.eyeRest!, subtract(camera.eye, high));
    gl.uniform1f(uniforms.near!, camera.near);
    gl.uniform3fv(uniforms.up!, camera.up);
    gl.uniform1f(uniforms.ceiling!, Math.min(ceiling, 3e38));
    return program;
  }

  #draw(frame: Frame | undefined): void {
    const gl = this.#gl;
    gl.bindVertexArray(this.#array);
    if (frame === undefined) gl.drawArrays(gl.TRIANGLES, 0, 3 * triangleCount(this.#model!));
    else gl.drawElements(gl.TRIANGLES, this.#indexOf(frame), gl.UNSIGNED_INT, 0);
  }

  /** How many indices a frame draws, of the buffer that is bound. */
  #indexOf(frame: Frame): number {
    if (this.#indexed?.frame === frame) return this.#indexed.count;
    let count = 0;
    for (let i = 0; i < frame.drawn.length; i += 2) {
      const first = 3 * frame.drawn[i]!, end = first + 3 * frame.drawn[i + 1]!;
      this.#index.set(frame.index.subarray(first, end), count);
      count += end - first;
    }
    const gl = this.#gl;
    gl.bufferSubData(gl.ELEMENT_ARRAY_BUFFER, 0, this.#index, 0, count);
    this.#indexed = {frame, count};
    return count;
  }
}
