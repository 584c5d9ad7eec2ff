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

/** A renderer, and how to draw pictures with it into numbers. */
export async function rendererOf(name, width, height) {
  const how = {canvas: new OffscreenCanvas(width, height), ...options[name]};
  const isOfNodes = name.startsWith("webgpu");
  const renderer = isOfNodes ? new (await import("three/webgpu")).WebGPURenderer(how) : new THREE.WebGLRenderer(how);
  if (isOfNodes) await renderer.init();
  renderer.shadowMap.enabled = true;
  renderer.info.autoReset = false;
  const Target = isOfNodes ? THREE.RenderTarget : THREE.WebGLRenderTarget;
  const targets = [0, 1].map(() => new Target(width, height));
  const {isWebGPUBackend, isWebGLBackend} = renderer.backend ?? {};
  const kind = isWebGPUBackend ? "WebGPU" : isWebGLBackend ? "WebGL by WebGPURenderer" : "WebGL";
  const isReversed = renderer.reversedDepthBuffer ?? renderer.capabilities.reversedDepthBuffer;
  return {kind, isReversed, pictures};

  function draw(scene, camera, target) {
    renderer.setRenderTarget(target);
    renderer.info.reset();
    renderer.render(scene, camera);
    return renderer.info.render.triangles;
  }
  function read(target) {
    const into = isOfNodes ? [] : [new Uint8Array(4 * width * height)];
    return renderer.readRenderTargetPixelsAsync(target, 0, 0, width, height, ...into);
  }

  /** By two cameras, of the scene as it is now: four bytes for each pixel, and how much was drawn. */
  async function pictures(scene, cameras) {
    const triangles = cameras.map((camera, i) => draw(scene, camera, targets[i]));
    const pixels = [await read(targets[0]), await read(targets[1])];
    return pixels.map((pixels, i) => ({pixels, triangles: triangles[i]}));
  }
}

/** Draws frames with and without culling. `move` is called before each. */
export async function compare({kind, isReversed, pictures}, scene, camera, occlusion, frames, move) {
  const result = {kind, isReversed, frames: 0, different: 0, hidden: 0, triangles: 0, allTriangles: 0, colours: 0};
  await pictures(scene, [camera, camera.clone()]); // the first ones of WebGPURenderer 0.185 lack some shadows
  for (let f = 0; f < frames; ++f) {
    await new Promise(requestAnimationFrame); // WebGPURenderer draws maps of shadows once in a frame of the browser
    await move(f);
    occlusion.update(camera);
    const [culled, all] = await pictures(scene, [camera, camera.clone()]), colours = new Set();
    for (let i = 0; i < all.pixels.length; i += 4) {
      result.different += Number([0, 1, 2].some(k => culled.pixels[i + k] !== all.pixels[i + k]));
      colours.add(all.pixels[i] + 256 * all.pixels[i + 1]);
    }
    result.frames += 1;
    result.hidden += occlusion.hiddenFrom(camera);
    result.triangles += culled.triangles;
    result.allTriangles += all.triangles;
    result.colours = Math.max(result.colours, colours.size);
  }
  return result;
}
