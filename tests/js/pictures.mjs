// SPDX-License-Identifier: MIT
// What pages of tests share that compare pictures of three.js.
import * as THREE from "three";

/** The end of the page. */
export const tell = what => fetch("/result", {method: "POST", body: JSON.stringify(what)});

const options = {
  webgl: {},
  reversed: {reversedDepthBuffer: true},
  logarithmic: {logarithmicDepthBuffer: true},
  webgpu: {},
  webgpu_reversed: {reversedDepthBuffer: true},
  webgpu_by_webgl: {forceWebGL: true},
};

/** A renderer, and how to draw with it into numbers. */
export async function rendererOf(name, width, height) {
  const how = {canvas: new OffscreenCanvas(width, height), ...options[name]};
  const isOfNodes = name.startsWith("webgpu");
  const renderer = isOfNodes ? new (await import("three/webgpu")).WebGPURenderer(how) : new THREE.WebGLRenderer(how);
  if (isOfNodes) await renderer.init();
  renderer.shadowMap.enabled = true;
  renderer.info.autoReset = false;
  const target = isOfNodes ? new THREE.RenderTarget(width, height) : new THREE.WebGLRenderTarget(width, height);
  const {isWebGPUBackend, isWebGLBackend} = renderer.backend ?? {};
  const kind = isWebGPUBackend ? "WebGPU" : isWebGLBackend ? "WebGL by WebGPURenderer" : "WebGL";
  const isReversed = renderer.reversedDepthBuffer ?? renderer.capabilities.reversedDepthBuffer;
  return {kind, isReversed, picture};

  /** Four bytes for each pixel, and how much was drawn. */
  async function picture(scene, camera) {
    await new Promise(requestAnimationFrame); // maps of shadows are drawn once in a frame of the browser
    renderer.setRenderTarget(target);
    renderer.info.reset();
    renderer.render(scene, camera);
    const {triangles} = renderer.info.render;
    const into = isOfNodes ? [] : [new Uint8Array(4 * width * height)];
    return {pixels: await renderer.readRenderTargetPixelsAsync(target, 0, 0, width, height, ...into), triangles};
  }
}

/** Draws frames with and without culling. `move` is called before each. */
export async function compare({kind, isReversed, picture}, scene, camera, occlusion, frames, move) {
  const result = {kind, isReversed, frames: 0, different: 0, triangles: 0, allTriangles: 0, colours: 0};
  await picture(scene, camera); // the first one of WebGPURenderer 0.185 lacks some shadows
  for (let f = 0; f < frames; ++f) {
    await move(f);
    occlusion.update(camera);
    const culled = await picture(scene, camera), all = await picture(scene, camera.clone());
    const colours = new Set();
    for (let i = 0; i < all.pixels.length; i += 4) {
      result.different += Number([0, 1, 2].some(k => culled.pixels[i + k] !== all.pixels[i + k]));
      colours.add(all.pixels[i] + 256 * all.pixels[i + 1]);
    }
    result.frames += 1;
    result.triangles += culled.triangles;
    result.allTriangles += all.triangles;
    result.colours = Math.max(result.colours, colours.size);
  }
  return result;
}
