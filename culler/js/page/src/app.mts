// SPDX-License-Identifier: MIT
// What the page shows, and how it goes on from frame to frame.
import type {Occlude} from "occlude";

import {format, type Settings} from "./address.mjs";
import {levelAxes} from "./axes.mjs";
import {moved, type Camera, type Place} from "./camera.mjs";
import {frustumColour, wrongColour, occluderColour} from "./colours.mjs";
import {Culling} from "./culling.mjs";
import {everythingIn, type Frame} from "./frame.mjs";
import {placeOf} from "./flight.mjs";
import {Judge, type Catch, type Scores} from "./judge.mjs";
import {viewsOf, type Views} from "./layout.mjs";
import type {ColouredLine} from "./lines.mjs";
import {metreOf} from "./metre.mjs";
import {cornerOf, isSeeThrough, objectCount, triangleCount, type Flight, type Model} from "./model.mjs";
import {Orbit} from "./orbit.mjs";
import {Painter, type Look, type Viewport} from "./painter.mjs";
import {kRate, Recorder} from "./path.mjs";
import {add, dot, scale} from "./points.mjs";
import {cornersOf} from "./projection.mjs";
import {Walker} from "./walker.mjs";
import {Asker, type Answer} from "./why.mjs";

/** What is open: a built-in scene, a model that lies somewhere, or a file of the reader's. */
export interface Source {
  readonly scene?: string;
  readonly model?: string;
}

/** Seconds: after a pause nobody jumps. */
const kLongestStep = 0.1;
/** The picture that judges look at is no wider. */
const kWidestJudged = 1280;
/** Frames that are still painted when nothing moves: the view from outside comes to rest. */
const kSettling = 20;
/** How many pixels of the picture are as high as the lens: what is caught, if it is a square, is a quarter of that. */
const lensPixelsOf = ({pixels}: Catch): number => Math.min(40, Math.max(8, 4 * Math.sqrt(pixels)));

/** Whoever wants to know. */
export interface Listener {
  /** A frame has been painted. */
  onFrame(app: App): void;
  /** Cullers were caught in the frame. */
  onCatch(app: App, caught: readonly Catch[]): void;
  /** The reader has taken over from the flight, or given it back. */
  onFlight(app: App): void;
}

export class App {
  readonly #loading: Promise<Occlude>;
  #occlude!: Occlude;
  readonly #listener: Listener;
  readonly canvas: HTMLCanvasElement;
  readonly painter: Painter;
  readonly walker = new Walker();
  readonly outside = new Orbit();
  readonly recorder = new Recorder();
  readonly shows = {outside: true, hidden: true, outOfView: true, cut: false};
  settings: Settings;
  source: Source = {};
  model!: Model;
  frame: Frame | undefined;
  views: Views;
  /** Times between the last frames, and of their culls, in milliseconds. */
  readonly between: number[] = [];
  readonly culls: number[] = [];
  /** By how much the flight and the walk are faster than they would be. */
  pace = 1;
  isFlying = true;
  share = 0;
  #caught: Catch | undefined;
  /** What the accused draws. */
  #lie: Frame | undefined;
  /** Of what the cullers are judged by, if they are. */
  scores: Scores | undefined;
  #culling: Culling | undefined;
  #judge!: Judge;
  #asker: Asker | undefined;
  #answer: {readonly triangle: number; readonly hiders: readonly number[]} | undefined;
  #fates = new Uint8Array();
  #told: Frame | undefined;
  #clock = 0;
  #recordedFrom = 0;
  #last: number | undefined;
  #still = 0;
  #request: number | undefined;

  constructor(loading: Promise<Occlude>, canvas: HTMLCanvasElement, settings: Settings, listener: Listener) {
    this.#loading = loading;
    this.canvas = canvas;
    this.painter = new Painter(canvas);
    this.settings = settings;
    this.#listener = listener;
    this.views = viewsOf(canvas, true);
  }

  /** Paints a model as it is, and prepares its culler after that. Begins where `place` is in the file, or flies. */
  async open(model: Model, source: Source, place?: Place): Promise<void> {
    this.#culling?.dispose();
    this.#asker?.dispose();
    this.#culling = this.#asker = undefined;
    this.model = model;
    this.source = source;
    this.painter.setModel(model);
    this.#fates = new Uint8Array(triangleCount(model));
    this.#judge = new Judge(this.painter, model);
    this.walker.up = model.up;
    this.walker.speed = 3 * this.unit * this.pace;
    this.share = 0;
    this.walker.place = place ? this.#placeIn(place) : placeOf(model.flight, 0);
    this.setFlying(place === undefined);
    this.outside.restart(Math.min(0.6 * model.box.size, 60 * this.unit + 0.12 * model.box.size));
    this.shows.cut = false;
    this.forget();
    this.#step(0);
    await new Promise(resolve => setTimeout(resolve));
    this.shows.cut = this.#isMostlyRoofed(place ? [this.walker.place] : samplesOf(model.flight));
    this.#occlude = await this.#loading;
    this.#prepare();
    this.wake();
  }

  get unit(): number {
    return metreOf(this.model.box.size);
  }

  setMethod(method: Settings["method"]): void {
    this.settings.method = method;
    this.#prepare();
    this.wake();
  }

  setFlying(isFlying: boolean): void {
    this.isFlying = isFlying;
    if (isFlying) this.forget();
    this.#listener.onFlight(this);
    this.wake();
  }

  /** Goes somewhere else, and stays there. */
  jump(place: Place): void {
    this.forget();
    this.walker.place = place;
    this.setFlying(false);
  }

  get caught(): Catch | undefined {
    return this.#caught;
  }

  /** Stands where somebody was caught, and shows it. */
  show(caught: Catch): void {
    this.jump(caught.camera);
    this.#caught = caught;
    this.#lie = caught.hidden && frameWithout(this.model, caught.hidden);
  }

  /** What was caught or picked is shown no longer. */
  forget(): void {
    this.#caught = this.#answer = this.#lie = undefined;
    this.wake();
  }

  get camera(): Camera {
    const {width, height} = this.views.eye;
    return {...this.walker.place, ...this.model.lens, up: this.model.up, aspect: width / height};
  }

  get margin(): number {
    return this.#occlude.marginFor(this.views.eye.height);
  }

  /** Something has changed: paints soon. */
  wake(): void {
    this.#still = 0;
    this.#request ??= requestAnimationFrame(now => this.#frame(now));
  }

  /** Starts to record the way, or ends; then it returns the file. */
  record(): string | undefined {
    if (!this.recorder.isOn) {
      this.#recordedFrom = this.#clock;
      this.recorder.start();
      this.wake();
      return undefined;
    }
    this.recorder.isOn = false;
    return this.recorder.text(this.model);
  }

  /** The address of what is shown. */
  address(): string {
    const place = this.isFlying ? undefined : this.#placeInFile(this.walker.place);
    return format({...this.source, place, settings: this.settings});
  }
  addressOf({camera, before}: Catch): string {
    const [place, placeBefore] = [camera, before].map(of => of && this.#placeInFile(of));
    return format({...this.source, place, before: placeBefore, settings: {...this.settings, isCatching: true}});
  }

  #placeIn(place: Place): Place {
    return moved(place, scale(this.model.origin, -1));
  }
  #placeInFile(place: Place): Place {
    return moved(place, this.model.origin);
  }

  /** Culls and judges the frames of two places of the file, the second after the first; what is caught in the second is shown. */
  confront(place: Place, before: Place | undefined, scores: Scores): readonly Catch[] {
    this.#judge.restart();
    for (const [of, isLast] of [[before, false], [place, true]] as const) {
      if (of === undefined) continue;
      this.#clock += 1 / kRate;
      this.walker.place = this.#placeIn(of);
      const caught = this.#cullAndJudge(scores);
      if (isLast) return caught;
    }
    return [];
  }

  /** Judges so many frames, a thirtieth of a second apart, from this share of the flight on. */
  async judgeFlight(from: number, frames: number, scores: Scores): Promise<void> {
    this.#judge.restart();
    for (let f = 0; f < frames; ++f) {
      this.#clock += 1 / kRate;
      this.walker.place = placeOf(this.model.flight, Math.min(1, from + f / (kRate * this.model.flight.seconds)));
      this.#cullAndJudge(scores);
      this.#paint();
      this.#listener.onFrame(this);
      await new Promise(resolve => requestAnimationFrame(resolve));
    }
  }

  /** Pixels of the camera's picture that differ with and without culling. */
  differences(place: Place): {pixels: number; different: number; colours: number; hidden: number} {
    this.walker.place = place;
    this.#cull();
    const {width, height} = this.views.eye, look = this.#lookOf(this.frame, false, []);
    const culled = this.painter.picture(this.camera, look, width, height);
    const all = this.painter.picture(this.camera, {...look, frame: this.#culling!.everything}, width, height);
    const a = new Uint32Array(culled.buffer), b = new Uint32Array(all.buffer);
    let different = 0;
    a.forEach((pixel, i) => (different += Number(pixel !== b[i])));
    return {pixels: a.length, different, colours: new Set(b).size, hidden: this.frame!.counts.hidden};
  }

  /** What is at a place of the page, and why it is drawn or not. */
  ask(x: number, y: number): Answer | undefined {
    const {view, camera, at} = this.viewAt(x, y);
    const triangle = this.painter.triangleAt(camera, at, view, this.#ceilingOf(camera, view === this.views.outside));
    return triangle === undefined ? undefined : this.why(triangle);
  }

  /** Why a triangle is drawn or not; what hides it is shown. */
  why(triangle: number): Answer {
    this.#asker ??= new Asker(this.#occlude, this.model);
    const answer = this.#asker.why(triangle, this.camera, this.margin);
    this.#answer = {triangle, hiders: answer.hiders};
    this.wake();
    return answer;
  }

  /** The view at a place of the page, and the pixel in it, from the lower left. */
  viewAt(x: number, y: number): {view: Viewport; camera: Camera; at: readonly [number, number]} {
    const {eye, outside, ratio} = this.views;
    const px = x * ratio, py = this.canvas.height - 1 - y * ratio;
    const isIn = (v: Viewport) => px >= v.x && py >= v.y && px < v.x + v.width && py < v.y + v.height;
    const view = outside && isIn(outside) ? outside : eye;
    const camera = view === outside ? this.#cameraOutside(outside) : this.camera;
    return {view, camera, at: [px - view.x, py - view.y]};
  }

  /** Whether so many of these places are under something opaque that the view from outside is best cut open. */
  #isMostlyRoofed(places: readonly Place[]): boolean {
    const {up} = this.model, {east} = levelAxes(up);
    const isRoofed = ({eye}: Place): boolean => {
      const above: Camera = {eye, target: add(eye, up), up: east, fovY: 1, aspect: 1, near: this.model.lens.near};
      const triangle = this.painter.triangleAt(above, [0, 0], {x: 0, y: 0, width: 1, height: 1}, Infinity);
      return triangle !== undefined && !isSeeThrough(this.model, triangle);
    };
    return places.filter(isRoofed).length > kShareOfRoofs * places.length;
  }

  #prepare(): void {
    this.#culling?.dispose();
    this.#culling = new Culling(this.#occlude, this.model, this.settings.method);
    this.#judge.restart();
    this.culls.length = 0;
  }

  #frame(now: number): void {
    this.#request = undefined;
    const elapsed = now - (this.#last ?? now), isFirst = this.#last === undefined;
    const isMoving = this.#step(Math.min(kLongestStep, elapsed / 1000));
    if (!isFirst && isMoving) keepLast(this.between, elapsed);
    this.#still = isMoving ? 0 : this.#still + 1;
    this.#last = this.#still < kSettling ? now : undefined;
    if (this.#still < kSettling) this.#request ??= requestAnimationFrame(next => this.#frame(next));
  }

  /** Goes on by so many seconds; returns whether anything moves. */
  #step(seconds: number): boolean {
    const isJudging = this.scores !== undefined && this.#culling !== undefined;
    const passed = isJudging && this.isFlying ? 1 / kRate : seconds;
    const isMoving = this.isFlying ? this.#fly(passed) : this.walker.advance(passed);
    this.#clock += passed;
    this.recorder.record(this.#placeInFile(this.walker.place), this.#clock - this.#recordedFrom);
    if (isJudging && isMoving) this.#listener.onCatch(this, this.#cullAndJudge(this.scores!));
    else this.#cull();
    this.outside.follow(this.camera, Math.min(1, 2.5 * seconds));
    this.#paint();
    this.#listener.onFrame(this);
    return isMoving || this.recorder.isOn;
  }

  #fly(seconds: number): boolean {
    this.share = (this.share + (seconds * this.pace) / this.model.flight.seconds) % 1;
    this.walker.place = placeOf(this.model.flight, this.share);
    return true;
  }

  #cull(): void {
    this.views = viewsOf(this.canvas, this.shows.outside);
    const {isCulling, budget, hold} = this.settings;
    this.frame = undefined;
    if (!isCulling || this.#culling === undefined) return;
    this.frame = this.#culling.cull(this.camera, {budget, margin: this.margin}, hold, this.#clock);
    keepLast(this.culls, this.#culling.milliseconds);
  }

  #cullAndJudge(scores: Scores): Catch[] {
    this.#cull();
    if (this.#culling === undefined) return [];
    const {width, height} = this.views.eye, smaller = Math.min(1, kWidestJudged / width);
    const size = [Math.round(width * smaller), Math.round(height * smaller)] as const;
    return this.#judge.judge(this.camera, this.frame ?? this.#culling.everything, this.#culling.milliseconds, size, scores);
  }

  #paint(): void {
    const {eye, outside} = this.views;
    const ray = this.#caught ? [{from: this.#caught.proof.from, to: this.#caught.proof.to, colour: wrongColour}] : [];
    this.painter.paint(eye, this.camera, this.#lookOf(this.frame, false, []));
    if (outside) {
      this.#tellFates();
      const camera = this.#cameraOutside(outside);
      const look = this.#lookOf(undefined, this.frame !== undefined, [...this.#frustum(), ...ray]);
      this.painter.paint(outside, camera, {...look, ceiling: this.#ceilingOf(camera, true)});
    }
    if (this.#caught) this.#paintLens(this.#caught);
  }

  /** What shows, and beside it what the accused draws. */
  #paintLens(caught: Catch): void {
    const {x, y, width, height} = this.lens, half = width / 2;
    const pixels = lensPixelsOf(caught) / this.views.eye.height;
    const camera = {...caught.camera, target: caught.proof.to, fovY: this.model.lens.fovY * pixels, aspect: half / height};
    const look = this.#lookOf(undefined, false, []);
    this.painter.paint({x, y, width: half, height}, camera, look);
    this.painter.paint({x: x + half, y, width: half, height}, camera, {...look, frame: this.#lie ?? this.frame});
  }

  /** Where what is caught is shown larger: in the lower right of the camera's view. */
  get lens(): Viewport {
    const {eye, ratio} = this.views;
    const height = Math.round(Math.min(180 * ratio, 0.22 * eye.width)), width = 2 * height;
    // The bar is below, but for a view that is above the other; a card is beside the lens where there is room for one.
    const above = (eye.y > 0 ? 30 : this.canvas.clientHeight < 480 ? 85 : 110) * ratio;
    return {x: eye.x + eye.width - width - 12 * ratio, y: eye.y + above, width, height};
  }

  #lookOf(frame: Frame | undefined, showsFates: boolean, lines: readonly ColouredLine[]): Look {
    const {hidden, outOfView} = this.shows;
    const isDark = !matchMedia("(prefers-color-scheme: light)").matches;
    const showsClay = this.settings.isClay || !this.model.isColoured;
    const rest = {ceiling: Infinity, shadeRadius: 0.6 * this.unit, marked: this.#marked()};
    return {frame, showsFates, showsClay, showsHidden: hidden, showsOutOfView: outOfView, lines, isDark, ...rest};
  }

  #marked(): Look["marked"] {
    if (this.#caught) {
      const {object} = this.#caught, {firsts} = this.model;
      return {first: firsts[object]!, end: firsts[object + 1]!, colour: wrongColour};
    }
    const picked = this.#answer?.triangle;
    return picked === undefined ? undefined : {first: picked, end: picked + 1, colour: occluderColour};
  }

  #tellFates(): void {
    if (this.frame === undefined || this.frame === this.#told) return;
    this.frame.tellFates(this.#fates);
    this.painter.setFates(this.#fates);
    this.#told = this.frame;
  }

  #cameraOutside({width, height}: Viewport): Camera {
    return this.outside.camera(this.camera, width / height);
  }

  /** Above the origin of what a camera draws. */
  #ceilingOf(camera: Camera, isOutside: boolean): number {
    if (!isOutside || !this.shows.cut) return Infinity;
    return dot(this.walker.place.eye, camera.up) + 0.4 * this.unit - dot(camera.eye, camera.up);
  }

  /** What the camera sees, and the edges of what hides what was picked. */
  #frustum(): ColouredLine[] {
    const {camera} = this, corners = cornersOf(camera, Math.min(0.25 * this.model.box.size, 35 * this.unit));
    const view = corners.flatMap((corner, i): ColouredLine[] => [
      {from: camera.eye, to: corner, colour: frustumColour},
      {from: corner, to: corners[(i + 1) % 4]!, colour: frustumColour},
    ]);
    const edges = (this.#answer?.hiders ?? []).slice(0, 400).flatMap(triangle => [0, 1, 2].map((i): ColouredLine => ({
      from: cornerOf(this.model, triangle, i), to: cornerOf(this.model, triangle, (i + 1) % 3), colour: occluderColour,
    })));
    return [...view, ...edges];
  }
}

const kMostKept = 40;
function keepLast(numbers: number[], number: number): void {
  numbers.push(number);
  if (numbers.length > kMostKept) numbers.shift();
}
export function median(numbers: readonly number[]): number {
  return [...numbers].sort((a, b) => a - b)[numbers.length >> 1] ?? NaN;
}

/** Trees and bridges are above few places of a way, roofs of a building that one walks through above many. */
const kShareOfRoofs = 0.25;
const kSamplesOfFlight = 16;
const samplesOf = (flight: Flight): Place[] => Array.from({length: kSamplesOfFlight}, (_, i) => placeOf(flight, i / kSamplesOfFlight));

/** What an accused culler draws, whatever is out of view. */
function frameWithout(model: Model, hidden: Uint8Array): Frame {
  const index = Uint32Array.from({length: 3 * triangleCount(model)}, (_, i) => i);
  const drawn: number[] = [];
  for (let o = 0; o < objectCount(model); ++o) {
    if (hidden[o] === 0) drawn.push(model.firsts[o]!, model.firsts[o + 1]! - model.firsts[o]!);
  }
  return {...everythingIn(index), drawn: Uint32Array.from(drawn)};
}

