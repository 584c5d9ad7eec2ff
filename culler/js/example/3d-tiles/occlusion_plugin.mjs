// SPDX-License-Identifier: MIT
// A plug-in of 3d-tiles-renderer: tiles that are hidden are loaded after those that show.
import {Box3} from "three";

export class OcclusionPlugin {
  name = "OCCLUSION_PLUGIN";
  #tiles;
  #queues;
  /** Of the frame that is named, by tile. */
  #known = {frame: -1, answers: new Map()};

  constructor(occlusion, camera) {
    this.occlusion = occlusion;
    this.camera = camera;
  }

  init(tiles) {
    this.#tiles = tiles;
    this.#queues = [tiles.downloadQueue, tiles.parseQueue].map(queue => ({queue, priority: queue.priorityCallback}));
    for (const {queue, priority} of this.#queues) {
      queue.priorityCallback = (a, b) => Number(this.isHidden(b)) - Number(this.isHidden(a)) || priority(a, b);
    }
  }

  dispose() {
    for (const {queue, priority} of this.#queues) queue.priorityCallback = priority;
  }

  /** In the last update of the camera. Queues may be shared with other tilesets. */
  isHidden(tile) {
    if (tile.internal?.renderer !== this.#tiles) return false;
    const {frameCount, group} = this.#tiles;
    if (this.#known.frame !== frameCount) this.#known = {frame: frameCount, answers: new Map()};
    const {answers} = this.#known;
    if (!answers.has(tile)) {
      const box = new Box3();
      tile.engineData.boundingVolume.getAABB(box);
      answers.set(tile, this.occlusion.isHidden(box.applyMatrix4(group.matrixWorld), this.camera));
    }
    return answers.get(tile);
  }
}
