// SPDX-License-Identifier: MIT
// The camera that looks from outside: it goes round the eye, and follows it.
import {axesOf, levelAxes} from "./axes.mjs";
import type {Camera, Place} from "./camera.mjs";
import {add, dot, scale, type Point} from "./points.mjs";

export class Outside {
  #yaw = 0;
  #pitch = 0;
  #distance = 1;
  /** Whether it turns with the camera: until somebody turns it. */
  isFollowing = true;

  /** Behind and above somebody who walks through a model of this size. */
  restart(distance: number): void {
    this.#distance = distance;
    this.#pitch = 0.75;
    this.isFollowing = true;
    this.#yaw = NaN;
  }

  /** Turns after the camera, by a share of what is missing. */
  follow(camera: Camera, share: number): void {
    if (!this.isFollowing) return;
    const {east, north} = levelAxes(camera.up), {forward} = axesOf(camera);
    const heading = Math.atan2(dot(forward, north), dot(forward, east));
    const missing = Math.atan2(Math.sin(heading - this.#yaw), Math.cos(heading - this.#yaw));
    this.#yaw = Number.isNaN(this.#yaw) ? heading : this.#yaw + share * missing;
  }

  turn(yaw: number, pitch: number): void {
    this.isFollowing = false;
    this.#yaw += yaw;
    this.#pitch = Math.min(1.5, Math.max(-0.3, this.#pitch + pitch));
  }
  zoom(factor: number): void {
    this.#distance *= factor;
  }

  camera(of: Camera, aspect: number): Camera {
    const {east, north, up} = levelAxes(of.up), out = this.#ahead(east, north);
    const target = add(of.eye, scale(out, 0.25 * this.#distance));
    const back = add(scale(out, -Math.cos(this.#pitch)), scale(up, Math.sin(this.#pitch)));
    const place: Place = {eye: add(target, scale(back, this.#distance)), target};
    return {...place, up: of.up, fovY: 45, aspect, near: this.#distance / 100};
  }

  #ahead(east: Point, north: Point): Point {
    return add(scale(east, Math.cos(this.#yaw)), scale(north, Math.sin(this.#yaw)));
  }
}
