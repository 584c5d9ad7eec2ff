// SPDX-License-Identifier: MIT
// Draws one culled frame of a model: as its camera sees it, or from outside with the culling as it is.

/** Colours of hiders, by their number modulo 8: neighbours differ in lightness. */
const kHiderColours = ['#5b2a86', '#f0a58f', '#0b5d57', '#b9a6e8', '#7a3b12', '#79c6ee', '#a3195b', '#b5d8a0'];
const kPickedColour = '#e600c8', kRegionColour = '#d81b60';

/** The colour of a hider. */
const hiderColour = number => kHiderColours[number % kHiderColours.length];

/** Of boxes. */
const kDrawnBoxColour = '#8a5a2b', kOutOfViewColour = '#9aa3af';
const colourOfFate = fate =>
    fate === Fate.covered ? hiddenColour : rgb(fate === Fate.outOfView ? kOutOfViewColour : hiderColour(fate - Fate.hidden));

/** What was drawn in vain, from rarely to often: the more, the darker. */
const kHeat = ['#fde8a9', '#f9a85d', '#e0533d', '#992766', '#3b0f70'];
const shareOfVain = (frames, most) => most > 1 ? Math.log(frames) / Math.log(most) : 1;

/** For a click: rasterisers round corners to 1/16 of a pixel, some of them. */
const kMagnified = 16;

/** How far shadows are drawn beyond their occluders, in depths of the interesting part of the frame. */
const kShadowReach = 1.5;

/** From outside the model is cut off so much above the camera at most, in the same depths: rooms open. */
const kCut = 0.25;
/** Milliseconds after which what takes time is found out of a frame that stays. */
const kRest = 150;

/** The twelve edges of a box that is given by its centre and half-edges. */
function edgesOf({centre, halfEdges}) {
  const corner = signs => halfEdges.reduce((point, edge, i) => add(point, scale(edge, signs[i])), centre);
  return [0, 1, 2].flatMap(axis => [[1, 1], [1, -1], [-1, -1], [-1, 1]].map(others =>
      [1, -1].map(sign => corner([...others.slice(0, axis), sign, ...others.slice(axis)]))));
}

class Viewer {
  /** Throws where there is no WebGL2. `lens` has what all cameras of a path share, `size` the pixels of their pictures. */
  constructor(canvas, lens, size) {
    this.pixels = size;
    this.canvas = canvas;
    this.lens = lens;
    this.gl = contextOf(canvas);
    if (!this.gl) throw new Error('this browser has no WebGL2.');
    this.models = new ModelPainter(this.gl);
    this.targets = new Targets(this.gl);
    this.screen = new Screen(this.gl);
    this.lines = new Lines(this.gl);
    this.faces = new FacePainter(this.gl);
    this.boxes = new BoxPainter(this.gl);
    this.layers = {drawn: true, hidden: true, missed: true, outOfView: true, occluders: true, shadows: true, frustum: true, region: true, cut: true, boxes: false, vain: false};
    this.isOutside = true;
    canvas.style.setProperty('--aspect', lens.aspect);
    this.orbit = new Orbit();
    new ResizeObserver(() => this.invalidate()).observe(canvas);
  }

  /** In place of the one before. A frame comes before the next picture. */
  setModel(model) {
    this.model = model;
    this.models.setModel(model);
    this.high = model.point(model.steps);
    this.size = distance(model.low, this.high);
    this.picked = null;
  }

  /** A frame of Frames, its eye and target, the region that holds for it, if any does, and its up, if that is not the one of the path. */
  setFrame(frame, eye, target, region, up = this.lens.up) {
    this.frame = frame;
    this.region = region;
    const before = this.camera;
    this.camera = {...this.lens, eye, target, up};
    if (isParallel(this.lens)) this.camera.far ??= this.farthest(eye);
    const depth = this.depthOfScene();
    const isNear = before && distance(before.eye, eye) < 0.1 * this.depth;
    this.depth = isNear ? this.depth + 0.15 * (depth - this.depth) : depth;  // no jumps from frame to frame
    this.models.fates.set(frame.fates);
    if (this.orbit.isFollowing) this.goBehind();
    this.isSeenKnown = false;
    if (!before) this.openAbove();
    this.seeSoon();
    this.invalidate();
  }

  /** Once frame and camera stay. */
  seeSoon() {
    clearTimeout(this.seeing);
    this.seeing = setTimeout(() => this.see(), kRest);
  }

  /** Finds where to open the model, and which of the drawn polygons the camera sees, in a picture of the walk's size. */
  see() {
    if (!this.isOutside) return;
    this.openAbove();
    if (!this.layers.missed || this.isSeenKnown) return;
    const [width, height] = this.pixels, {firstTriangle} = this.model;
    const numbers = this.numbersIn(this.camera, {drawn: true}, width, height);
    const seen = new Uint8Array(this.model.triangles);
    let last = 0;
    for (const number of numbers) {
      if (number === last || number === 0) continue;
      last = number;
      if (seen[last - 1]) continue;
      const polygon = this.model.polygonOf(last - 1);
      seen.fill(1, firstTriangle[polygon], firstTriangle[polygon + 1]);
    }
    this.models.setSeen(seen);
    this.isSeenKnown = true;
    this.invalidate();
  }

  /** Draws soon, once for all changes. */
  invalidate() {
    this.request ??= requestAnimationFrame(() => this.draw());
  }

  draw() {
    cancelAnimationFrame(this.request);
    this.request = null;
    if (!this.frame) return;
    this.fit();
    this.paint(this.isOutside ? this.outside() : this.camera);
  }

  /** The whole model from straight above, a rectangle of this `size` around `middle`, in so many pixels: for a map. */
  drawMap(middle, size, pixels, background) {
    const gl = this.gl, target = this.targets.of('map', ...pixels);
    [this.canvas.width, this.canvas.height] = pixels;
    const {up, north} = levelAxes(this.lens.up);
    const eye = add(middle, scale(up, this.size));
    this.models.fates.set(new Uint16Array(this.model.leaves));
    this.targets.begin(target, background);
    this.paintModel({height: size[1], aspect: size[0] / size[1], near: this.size / 100, far: 3 * this.size,
                     eye, target: middle, up: north}, {drawn: true});
    gl.bindFramebuffer(gl.DRAW_FRAMEBUFFER, null);
    gl.blitFramebuffer(0, 0, ...pixels, 0, 0, ...pixels, gl.COLOR_BUFFER_BIT, gl.NEAREST);
    this.models.fates.set(this.frame.fates);
    this.invalidate();
  }

  /** What is exactly at a point of the canvas, in its CSS pixels: the polygon's place in the model, or null. */
  pick(x, y) {
    const {clientWidth, clientHeight} = this.canvas;
    const window = {x: 2 * x / clientWidth - 1, y: 1 - 2 * y / clientHeight, across: kMagnified * clientWidth, up: kMagnified * clientHeight};
    const [number] = this.numbersIn({...(this.isOutside ? this.outside() : this.camera), window}, this.shown(), 1, 1);
    return number === 0 ? null : this.model.polygonOf(number - 1);
  }

  /** The camera outside is behind and above that of the frame, until somebody moves it. */
  goBehind() {
    this.orbit.restart(1.5 * this.depth);
    this.orbit.follow({...this.camera, up: this.lens.up}, 1);
  }

  // The rest is how.

  /** The camera outside. */
  outside() {
    return this.orbit.camera({...this.camera, up: this.lens.up}, this.lens.aspect);
  }

  farthest(point) {
    return 1.01 * length(point.map((x, i) => Math.max(Math.abs(x - this.model.low[i]), Math.abs(x - this.high[i])))) + 1e-9;
  }

  /** The depth of the interesting part: two fifths of the leaves in view are nearer, most others are far and small. */
  depthOfScene() {
    const {fates} = this.frame, kMost = 4096, distances = [];
    const stride = Math.max(1, Math.floor(fates.length / kMost));
    for (let leaf = 0; leaf < fates.length; leaf += stride) {
      const polygon = this.model.firstPolygon[leaf];
      if (fates[leaf] !== Fate.outOfView && polygon < this.model.polygons) distances.push(distance(this.model.cornerOf(polygon), this.camera.eye));
    }
    distances.sort((a, b) => a - b);
    return Math.max(distances[Math.floor(distances.length * 2 / 5)] ?? 0, 100 * this.camera.near, this.size / 1000);
  }

  fit() {
    const {canvas} = this, ratio = Math.min(window.devicePixelRatio || 1, 2);
    const width = Math.max(1, Math.round(canvas.clientWidth * ratio)), height = Math.max(1, Math.round(canvas.clientHeight * ratio));
    if (canvas.width !== width || canvas.height !== height) [canvas.width, canvas.height] = [width, height];
  }

  /** The camera of the frame draws what was drawn, and nothing else. */
  shown() {
    return this.isOutside ? this.layers : {drawn: this.layers.drawn, vain: this.layers.vain};
  }

  /** The height above the eye of `camera` at which the model is cut off. */
  ceiling(camera, shown) {
    const above = dot(unit(this.lens.up), subtract(this.camera.eye, camera.eye)) + Math.min(this.opening, kCut * this.depth);
    return {up: unit(this.lens.up), height: shown.cut ? above : 1e30};
  }

  /** So that one sees the camera from outside, the model is cut off below what stands between: at half its height above the camera. */
  openAbove() {
    const before = this.opening, {eye, near} = this.camera, outside = this.outside().eye, way = subtract(outside, eye);
    const there = {fovY: 1, aspect: 1, near, eye, target: outside, up: this.lens.up};
    const [number] = this.numbersIn(there, {...this.layers, cut: false}, 1, 1);
    this.opening = number === 0 ? Infinity : this.shareOf(eye, way, number - 1) * dot(unit(this.lens.up), way) / 2;
    if (!(this.opening > 0)) this.opening = Infinity;
    if (this.opening !== before) this.invalidate();
  }

  /** Where a way meets the plane of a triangle: 1 at its end. */
  shareOf(from, way, triangle) {
    const [a, b, c] = [0, 3, 6].map(at => this.model.point(this.model.corners.subarray(9 * triangle + at, 9 * triangle + at + 3)));
    const normal = cross(subtract(b, a), subtract(c, a)), share = dot(normal, subtract(a, from)) / dot(normal, way);
    return share < 1 ? share : Infinity;
  }

  paintModel(camera, shown) {
    const gl = this.gl, isDark = matchMedia('(prefers-color-scheme: dark)').matches;
    this.models.use(this.models.colours, camera, shown, this.ceiling(camera, shown));
    const {uniforms} = this.models.colours;
    gl.uniform3fv(uniforms.pale, isDark ? pale.dark : pale.light);
    gl.uniform3fv(uniforms.cover, hiddenColour);
    gl.uniform3fv(uniforms.hiders, kHiderColours.flatMap(rgb));
    gl.uniform3fv(uniforms.missed, wrongColour);
    gl.uniform3fv(uniforms.heat, kHeat.flatMap(rgb));
    gl.uniform1i(uniforms.showsVain, Boolean(shown.vain));
    gl.uniform1i(uniforms.marksMissed, Boolean(shown.missed && this.isSeenKnown));
    gl.uniform4f(uniforms.tint, 0, 0, 0, 0);
    gl.uniform1f(uniforms.unitOfHatching, this.canvas.width / this.canvas.clientWidth);
    this.models.drawAll();
  }

  paint(camera) {
    const gl = this.gl, isDark = matchMedia('(prefers-color-scheme: dark)').matches, {width, height} = this.canvas;
    const target = this.targets.of('colours', width, height);
    this.targets.begin(target, isDark ? haze.dark : haze.light);  // edges before the sky are mixed with that
    this.paintModel(camera, this.shown());
    gl.depthFunc(gl.GEQUAL);
    if (this.layers.occluders) {
      for (const {outline} of this.frame.occluders) this.models.drawPolygons(outline.polygons, occluderColour, 0.6);
    }
    if (this.picked !== null) this.models.drawPolygons([this.picked], rgb(kPickedColour), 0.85);
    gl.enable(gl.BLEND);
    gl.blendFunc(gl.ONE, gl.ONE_MINUS_SRC_ALPHA);
    gl.depthMask(false);
    if (this.isOutside && this.layers.shadows) this.faces.draw(this.shadowFaces(), camera);
    const ratio = this.canvas.width / this.canvas.clientWidth;
    const near = nearOf(camera);
    this.lines.draw(this.outlines(), {eye: camera.eye, near, projection: projectionOf(camera)}, [width, height], 1.6 * ratio);
    if (this.isOutside && this.layers.boxes) this.boxes.draw(this.treeBoxes(), camera);
    gl.depthMask(true);
    gl.disable(gl.BLEND);
    this.screen.show(target, [0, 0], {near, shadeRadius: 0.6 * metreOf(this.size), isDark});
  }

  /** Where an edge of a shadow ends. */
  beyond(corner) {
    const along = isParallel(this.lens) ? axesOf(this.camera).forward : unit(subtract(corner, this.camera.eye));
    return add(corner, scale(along, kShadowReach * this.depth));
  }

  /** The colour of what an occluder hides, alone or else in a pair; none if it hides nothing. */
  colourOf(occluder) {
    const hiders = [...this.frame.hiders].filter(([, both]) => both.includes(occluder)).sort(([, a], [, b]) => a.length - b.length);
    return hiders.length > 0 ? hiderColour(hiders[0][0]) : null;
  }

  shadowFaces() {
    return this.frame.occluders.filter(occluder => this.colourOf(occluder)).flatMap(occluder => {
      const near = occluder.outline.points, far = near.map(corner => this.beyond(corner));
      const colour = [...rgb(this.colourOf(occluder)), 0.16];
      return near.flatMap((corner, i) => {
        const next = (i + 1) % near.length;
        return [{corners: [corner, near[next], far[next]], colour}, {corners: [corner, far[next], far[i]], colour}];
      });
    });
  }

  outlines() {
    const lines = [];
    const add = (from, to, colour, alpha) => lines.push({from, to, colour, alpha});
    if (this.isOutside && this.layers.frustum) {
      const near = cornersOf(this.camera, nearOf(this.camera));
      const far = cornersOf(this.camera, this.depth);
      near.forEach((corner, i) => {
        add(corner, far[i], frustumColour);
        add(far[i], far[(i + 1) % 4], frustumColour);
      });
    }
    if (this.isOutside && this.layers.region && this.region) {
      for (const [from, to] of edgesOf(this.region)) add(from, to, rgb(kRegionColour));
    }
    for (const occluder of this.frame.occluders) {
      const {points} = occluder.outline;
      if (this.layers.occluders) points.forEach((corner, i) => add(corner, points[(i + 1) % points.length], occluderColour));
      if (!this.isOutside || !this.layers.shadows) continue;
      const colour = this.colourOf(occluder);
      for (const corner of points) add(corner, this.beyond(corner), rgb(colour ?? '#808080'), colour ? 0.9 : 0.4);
    }
    return lines;
  }

  /** The boxes of the tree at which the descent of this frame ended: culled subtrees and drawn leaves, as the layers show. */
  treeBoxes() {
    const boxes = [], {fates, culled} = this.frame;
    const add = (first, end, colour) => {
      const box = this.model.boxOf(first, end);
      if (box) boxes.push({low: box[0], high: box[1], colour: [...colour, 0.8]});
    };
    for (const {fate, first, end} of culled) {
      if (fate === Fate.outOfView ? this.layers.outOfView : this.layers.hidden) add(first, end, colourOfFate(fate));
    }
    if (this.layers.drawn) fates.forEach((fate, leaf) => fate === Fate.drawn && add(leaf, leaf + 1, rgb(kDrawnBoxColour)));
    return boxes;
  }

  /** The numbers of the triangles in a picture, from 1. */
  numbersIn(camera, shown, width, height) {
    this.targets.begin(this.targets.of('numbers', width, height));
    this.models.use(this.models.numbers, camera, shown, this.ceiling(camera, shown));
    this.models.drawAll();
    return readNumbers(this.gl, 0, 0, width, height);
  }
}
