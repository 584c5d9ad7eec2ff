// SPDX-License-Identifier: MIT
// A tileset of 3D Tiles with three.js: tiles that come and go hide, and are hidden.
import {TilesRenderer} from "3d-tiles-renderer";
import {Occlusion} from "occlude/three";
import * as THREE from "three";

import {OcclusionPlugin} from "./occlusion_plugin.mjs";

/** The scene, and what is to be done before each frame. */
export async function open(url, camera, width, height) {
  const scene = new THREE.Scene(), sun = new THREE.DirectionalLight(0xffffff, 2), tiles = new TilesRenderer(url);
  scene.background = new THREE.Color(0x88aacc);
  sun.position.set(1, 2, 0.5);
  scene.add(sun, new THREE.AmbientLight(0xffffff, 0.5), tiles.group);
  tiles.group.rotation.x = -Math.PI / 2; // tiles have z upwards
  const occlusion = await Occlusion.of(scene, {rows: height});
  const plugin = new OcclusionPlugin(occlusion, camera);
  tiles.registerPlugin(plugin);
  tiles.setCamera(camera);
  tiles.setResolution(camera, width, height);
  const update = () => {
    camera.updateMatrixWorld();
    tiles.update(); // first, as tiles come and go
    occlusion.update(camera);
  };
  return {scene, tiles, occlusion, plugin, update};
}
