// SPDX-License-Identifier: MIT
// The page in which one walks while the culler culls each frame.

const byId = id => document.getElementById(id);
const kTimes = 60;  // frames of the median
const kSettling = 10;  // frames: occluders are chosen by what they hid in the frames before
const kLongestStep = 0.1;  // seconds: after a pause nobody jumps
const kLongestWay = 100000;  // frames, half an hour

/** What the sliders mean. */
const budgetOf = value => value === 28 ? Infinity : 0.1 * 10 ** (value / 14);
const pixelsOf = value => value === 0 ? 0 : 2 ** (value - 8);

const grouped = number => Math.round(number).toLocaleString('en-US');

class LivePage {
  constructor(start, culler) {
    Object.assign(this, {start, culler, times: [], steps: 0, frameOfPath: 0, way: []});
    this.viewer = new Viewer(byId('picture'), culler.model, start.lens, [start.lens.aspect * start.height, start.height]);
    this.viewer.isOutside = false;
    this.viewer.layers.occluders = false;
    byId('viewer').classList.add('ready');
    this.orbit = new OrbitControl(this.viewer, () => {});
    this.walk = new WalkControl(this.viewer, start.speed, () => this.wake());
    this.walk.place(...this.placeOfAddress() ?? this.placeOfPath(0));
    this.listen();
    this.setOptions();
  }

  /** The eye and target of a frame of the path. */
  placeOfPath(frame) {
    return [this.start.eyes[frame], this.start.targets[frame]];
  }

  /** Something has changed. */
  wake() {
    this.still = 0;
    this.schedule();
  }
  /** Does all that is to be done in the next frame of the browser, once. */
  schedule() {
    this.request ??= requestAnimationFrame(now => this.step(now));
  }

  step(now) {
    this.request = null;
    const seconds = Math.min(kLongestStep, (now - (this.last ?? now)) / 1000);
    if (this.viewer.isOutside) return;
    const isMoving = this.walk.advance(seconds) || this.fly();
    this.cull();
    this.last = isMoving ? now : undefined;
    this.still = isMoving ? 0 : this.still + 1;
    if (this.still < kSettling) this.schedule();
    else this.nameInAddress();
  }

  /** Culls for where one stands, and shows it. */
  cull() {
    const {eye, target} = this.walk;
    this.remember(eye, target);
    this.times.push(this.culler.cull(eye, target, this.start.lens.aspect, this.options));
    if (this.times.length > kTimes) this.times.shift();
    this.frame = this.culler.frame();
    this.viewer.setFrame(this.frame, eye, target);
    ++this.steps;
    this.tell();
  }

  /** The way that one has gone, a keyframe for each place. */
  remember(eye, target) {
    const isAt = place => place && [...place[0], ...place[1]].every((x, i) => x === [...eye, ...target][i]);
    if (!isAt(this.way.at(-1))) this.way.push([eye, target]);
    if (this.way.length > kLongestWay) this.way.shift();
  }
  /** Stands somewhere else, where the way begins anew. */
  jump(eye, target) {
    this.way = [];
    this.walk.place(eye, target);
  }

  tell() {
    const {drawn, culled, outOfView} = this.frame.counts;
    const sorted = [...this.times].sort((a, b) => a - b);
    byId('ms').textContent = sorted[sorted.length >> 1].toFixed(2);
    byId('share').textContent = drawn + culled > 0 ? `${(100 * culled / (drawn + culled)).toFixed(1)} %` : '–';
    for (const [id, count] of Object.entries({drawn, culled, outOfView})) byId(id).textContent = grouped(count);
  }

  /** A frame further on the path, if it is being played. */
  fly() {
    if (!this.isFlying) return false;
    this.frameOfPath = (this.frameOfPath + 1) % this.start.eyes.length;
    this.walk.place(...this.placeOfPath(this.frameOfPath));
    return true;
  }

  setFlying(isFlying) {
    this.isFlying = isFlying;
    byId('play').setAttribute('aria-pressed', isFlying);
    if (isFlying) this.setOutside(false);
    this.wake();
  }

  setOutside(isOutside) {
    byId('eye').setAttribute('aria-pressed', !isOutside);
    byId('outside').setAttribute('aria-pressed', isOutside);
    byId('viewer').classList.toggle('outside', isOutside);
    if (isOutside) this.setFlying(false);
    this.viewer.isOutside = isOutside;
    this.viewer.see();
    this.viewer.invalidate();
    this.wake();
  }

  setOptions() {
    const value = id => Number(byId(id).value);
    const method = document.querySelector('input[name=method]:checked').value;
    const budget = budgetOf(value('budget')), pixels = pixelsOf(value('margin'));
    this.options = {method, occluders: value('occluders'), budget, margin: pixels / this.start.height};
    byId('occludersValue').textContent = this.options.occluders;
    byId('budgetValue').textContent = budget === Infinity ? 'none' : budget.toPrecision(2);
    byId('marginValue').textContent = pixels === 0 || pixels >= 1 ? pixels : `1/${1 / pixels}`;
    byId('viewer').classList.toggle('cover', method === 'cover');
    byId('viewer').classList.toggle('frusta', method === 'frusta');
    this.times = [];
    if (this.viewer.isOutside) this.cull();
    else this.wake();
  }

  /** The address names the place, so that it can be passed on: #eye=X,Y,Z&target=X,Y,Z. */
  nameInAddress() {
    clearTimeout(this.naming);
    const place = ['eye', 'target'].map(name => `${name}=${this.walk[name].map(x => Number(x.toPrecision(9))).join(',')}`);
    this.naming = setTimeout(() => history.replaceState(null, '', `#${place.join('&')}`), 300);
  }

  /** The place that the address names, or a frame of the path (#frame=N). */
  placeOfAddress() {
    const named = new URLSearchParams(location.hash.slice(1));
    const frame = Number(named.get('frame') ?? NaN);
    if (Number.isInteger(frame) && this.start.eyes[frame]) return this.placeOfPath(frame);
    const [eye, target] = ['eye', 'target'].map(name => (named.get(name) ?? '').split(',').map(Number));
    const isPlace = [eye, target].every(p => p.length === 3 && p.every(Number.isFinite)) && distance(eye, target) > 0;
    return isPlace ? [eye, target] : undefined;
  }

  listen() {
    byId('eye').addEventListener('click', () => this.setOutside(false));
    byId('outside').addEventListener('click', () => this.setOutside(true));
    byId('behind').addEventListener('click', () => {
      this.viewer.isFollowing = true;
      this.viewer.orbit = this.viewer.behind();
      this.viewer.invalidate();
    });
    byId('start').addEventListener('click', () => {
      this.frameOfPath = 0;
      this.jump(...this.placeOfPath(0));
      this.setFlying(false);
      this.setOutside(false);
    });
    byId('save').addEventListener('click', () => saveFile('path.json', pathText(this.start.model, this.start.lens, this.way)));
    byId('play').hidden = this.start.eyes.length < 2;
    byId('play').addEventListener('click', () => this.setFlying(!this.isFlying));
    for (const input of document.querySelectorAll('input[name=method], input[type=range]')) input.addEventListener('input', () => this.setOptions());
    for (const box of document.querySelectorAll('input[data-layer]')) {
      box.addEventListener('change', () => {
        this.viewer.layers[box.dataset.layer] = box.checked;
        this.viewer.see();
        this.viewer.invalidate();
      });
    }
    addEventListener('hashchange', () => {
      const place = this.placeOfAddress();
      if (place) this.jump(...place);
      this.wake();
    });
    matchMedia('(prefers-color-scheme: dark)').addEventListener('change', () => this.viewer.invalidate());
    byId('picture').addEventListener('webglcontextlost', () => giveUp('the browser has given up the drawing; load the page again.'));
  }
}

function giveUp(reason) {
  byId('viewer').classList.remove('ready');
  byId('reason').textContent = `The model cannot be drawn here: ${reason}`;
}

async function open() {
  const start = await jsonOfPart('start');
  const [code, model] = await Promise.all([bytesOfPart('module'), bytesOfPart('model')]);
  const culler = await LiveCuller.open(code, model, start.lens, start.leaf);
  return new LivePage(start, culler);
}

window.livePage = open();
window.livePage.catch(error => giveUp(error.message));
