// SPDX-License-Identifier: MIT
// The camera that looks from outside: it goes round the eye of another one, and follows it.
import {axesOf, levelAxes} from "./axes.mjs";
import {add, dot, scale} from "./points.mjs";

/** @import {Point} from "./points.mjs" */
/** @typedef {{readonly eye: Point, readonly target: Point, readonly up: Point}} Watched */

/** Radians: straight from above or below there is no right and left. */
const kSteepest = 1.5;

export class Orbit {
  yaw = NaN;
  pitch = 0.75;
  distance = 1;
  /** @type {Point} What it goes round, from there where it would be. */
  shifted = [0, 0, 0];
  /** Whether it turns with the camera: until somebody turns it. */
  isFollowing = true;

  /**
   * Behind the other camera and above it, that far away.
   * @param {number} distance
   */
  restart(distance) {
    Object.assign(this, {yaw: NaN, pitch: 0.75, distance, shifted: [0, 0, 0], isFollowing: true});
  }

  /**
   * Turns after the camera, by a share of what is missing.
   * @param {Watched} camera
   * @param {number} share
   */
  follow(camera, share) {
    if (!this.isFollowing) return;
    const {east, north} = levelAxes(camera.up), {forward} = axesOf(camera);
    const heading = Math.atan2(dot(forward, north), dot(forward, east));
    const missing = Math.atan2(Math.sin(heading - this.yaw), Math.cos(heading - this.yaw));
    this.yaw = Number.isNaN(this.yaw) ? heading : this.yaw + share * missing;
  }

  /**
   * @param {number} yaw
   * @param {number} pitch
   */
  turn(yaw, pitch) {
    this.isFollowing = false;
    this.yaw += yaw;
    this.pitch = Math.min(kSteepest, Math.max(-kSteepest, this.pitch + pitch));
  }
  /** @param {number} factor */
  zoom(factor) {
    this.distance *= factor;
  }
  /**
   * Moves what is seen by shares of the height of the picture.
   * @param {Watched} camera
   * @param {number} right
   * @param {number} up
   */
  shift(camera, right, up) {
    const axes = axesOf(this.camera(camera, 1));
    this.shifted = add(this.shifted, add(scale(axes.right, -right * this.distance), scale(axes.up, -up * this.distance)));
  }

  /**
   * @param {Watched} of
   * @param {number} aspect
   */
  camera(of, aspect) {
    const {east, north, up} = levelAxes(of.up);
    const ahead = add(scale(east, Math.cos(this.yaw)), scale(north, Math.sin(this.yaw)));
    const target = add(add(of.eye, scale(ahead, 0.25 * this.distance)), this.shifted);
    const back = add(scale(ahead, -Math.cos(this.pitch)), scale(up, Math.sin(this.pitch)));
    return {eye: add(target, scale(back, this.distance)), target, up: of.up, fovY: 45, aspect, near: this.distance / 100};
  }
}
