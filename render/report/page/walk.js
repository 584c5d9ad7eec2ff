// SPDX-License-Identifier: MIT
// The page of a walk: one frame cursor, which the charts, the map, the tables and the viewer share.

const byId = id => document.getElementById(id);
const kColours = {before: '#8a94a3', visible: '#0f8291', culled: '#6f57b5', outOfView: '#c5ccd6'};
/** Of the frames of each method, and of its culls alone. */
const kMethodColours = [['#2f7fe0', '#d9822b'], ['#b3261e', '#e79a96'], ['#5b2a86', '#b9a6e8']];
/** Options of a walk by several methods that only the first of them takes. */
const kOfFirst = / --(hold|occluders|probes|weight-[a-z-]+|near|solid-angle|test)[ =]\S+| --unions(?= |$)/g;
/** Of times of the processor. */
const kDots = [2, 4];
/** What the page calls the culls of a kind, and what did them. */
const kWords = {frusta: {hidden: 'culled by shadow', hiders: 'What each occluder hid'},
                cover: {hidden: 'culled by cover', hiders: 'What each piece of the covers hid'}};

const kFramesASecond = 30;

/** Of what was drawn in vain, by the reason: neighbours in the stack differ in lightness. */
const kReasonColours = ['#f9cbb0', '#b8461a', '#f2a177', '#7d2b0c', '#e8743b', '#4a1a08', '#c9bfb9'];

const line = (name, colour, values) => ({name, colour, values});

/** Points from one list of coordinates. */
const points = list => Array.from({length: list.length / 3}, (_, i) => list.slice(3 * i, 3 * i + 3));

class WalkPage {
  /** Walks of the same frames, each by its own method. */
  constructor(walks) {
    this.walks = walks;
    this.method = 0;
    this.count = this.columns.frame.length;
    this.index = 0;
    this.charts = new Charts(index => this.setIndex(index));
    this.fillMethods();
    this.fillTables();
    this.listen();
    this.first = this.indexOfHidingMost();
    this.setIndex(this.indexOfAddress() ?? this.first);
  }

  /** Of the method that is shown. */
  get walk() {
    return this.walks[this.method].walk;
  }
  get columns() {
    return this.walks[this.method].columns;
  }

  /** Shows the walk by another method. */
  async setMethod(method) {
    this.wanted = method;
    const scene = await sceneOf(method);
    if (this.wanted !== method) return;  // another one was chosen meanwhile
    this.method = method;
    this.fillTables();
    this.showScene(scene);
    this.fillFates();
    this.setIndex(this.index);
    this.colourMap();
  }

  /** One chooses a method among the figures that all have in the frame. */
  fillMethods() {
    byId('methodOfView').hidden = this.walks.length === 1;
    this.counts = this.walks.map(({walk}, method) => {
      const choice = element('input', {type: 'radio', name: 'method'}), count = element('b', {}), swatch = element('i', {class: 'swatch'});
      choice.checked = method === 0;
      choice.addEventListener('change', () => this.setMethod(method));
      swatch.style.setProperty('--swatch', kMethodColours[method][0]);
      byId('methodOfView').append(element('label', {}, choice, swatch, walk.name, count));
      return count;
    });
  }
  tellMethods(i) {
    this.walks.forEach(({columns}, method) => this.counts[method].textContent = `${grouped(columns.drawn[i])} · ${inMs(columns.cull_ms[i])} ms`);
  }

  /** Takes as long as unpacking the model, and comes after the first picture. */
  fillCharts() {
    const c = this.columns, isOne = this.walks.length === 1;
    const timed = (name, colour, of, member) => [line(name, colour, of[`${member}_ms`]),
                                                 {...line(`${name}, processor time`, colour, of[`${member}_processor_ms`]), pattern: kDots}];
    const nameOf = walk => isOne ? 'with occlusion culling' : walk.name;
    const times = this.walks.flatMap(({walk, columns}, method) => {
      const [ofFrames, ofCulls] = kMethodColours[method];
      return [...walk.rendered ? timed(nameOf(walk), ofFrames, columns, 'frame') : [],
              ...timed(isOne ? 'culling alone' : `${walk.name}: culling alone`, ofCulls, columns, 'cull')];
    });
    if (this.walk.rendered) times.unshift(...timed('view-frustum culling', kColours.before, c, 'view_frustum_frame'));
    this.charts.add(byId('times'), c.frame, times, {unit: 'ms', hiddenAtFirst: ['processor time']});
    const polygons = [line('view-frustum culling', kColours.before, c.in_view),
                      ...this.walks.map(({walk, columns}, method) => line(nameOf(walk), kMethodColours[method][0], columns.drawn))];
    if (this.walk.rendered) polygons.push(line('visible', kColours.visible, c.visible));
    this.charts.add(byId('polygons'), c.frame, polygons, {unit: 'polygons'});
    this.fillFates();
  }

  /** What became of all polygons, by the method that is shown. */
  fillFates() {
    const c = this.columns;
    const missed = Object.entries(this.walk.reasons).map(([name, text], i) => line(`hidden, but drawn: ${text}`, kReasonColours[i], c[name]));
    const drawn = this.walk.rendered ? [...missed, line('visible', kColours.visible, c.visible)] : [line('drawn', kColours.visible, c.drawn)];
    const outOfView = c.out_of_view.reduce((sum, n) => sum + n, 0) / (this.count * this.walk.polygons);
    this.charts.add(byId('fates'), c.frame, [line('out of view', kColours.outOfView, c.out_of_view), line('culled by shadow or cover', kColours.culled, c.culled), ...drawn],
                    {unit: 'polygons', stacked: true, hiddenAtFirst: outOfView > 2 / 3 ? ['out of view'] : []});
    this.charts.setCursor(this.index);
  }

  fillTables() {
    const {regions, kind} = this.walk;
    byId('worst').replaceChildren(worstTable(this.walk, this.columns));
    byId('regionTables').replaceChildren(...regions.length > 0 ? regionTables(this.walk, this.columns) : []);
    for (const id of ['region', 'marks']) byId(id).hidden = regions.length === 0;
    byId('hiddenBy').textContent = kWords[kind].hidden;
    byId('whatHid').textContent = kWords[kind].hiders;
    byId('viewer').classList.toggle('cover', kind === 'cover');
  }

  /** Once the model of the first method is unpacked. */
  addScene(path, scene) {
    this.eyes = points(path.eyes);
    this.targets = points(path.targets);
    this.ups = path.ups && points(path.ups);
    try {
      this.viewer = new Viewer(byId('picture'), scene.scene.camera, this.walk.size);
    } catch (error) {
      showPictures(error.message);
    }
    this.showScene(scene);
    if (!this.viewer) return;
    byId('picture').addEventListener('webglcontextlost', () => showPictures('the browser has given up the drawing; load the page again.'));
    byId('viewer').classList.add('ready');
    this.orbit = new OrbitControl(this.viewer, (x, y) => this.pick(x, y));
    this.setIndex(this.index);
  }

  /** The model and the frames of a method. */
  showScene({scene, model, frames, details}) {
    Object.assign(this, {scene, model, frames, details});
    for (const outline of scene.outlines) {
      outline.points = outline.corners.map(corner => model.point(corner));
      outline.polygons = scene.occluders[outline.occluder].polygons;
    }
    byId('occluderTables').replaceChildren(...(scene.pieces ? pieceTables(scene.pieces, model, this.columns.frame)
                                                            : occluderTables(scene.occluders, model, this.columns.frame)));
    byId('vain').hidden = scene.drawn_frames === 0;
    byId('mostVain').textContent = grouped(model.mostVain);
    this.viewer?.setModel(model);
  }

  /** Draws the whole model once, so that the first picture comes before it. */
  addMap() {
    if (!this.viewer) return;
    this.map = new PathMap(byId('map'), this.viewer, this.eyes, this.targets, index => this.setIndex(index));
    this.colourMap();
  }
  colourMap() {
    this.map?.show(this.viewer, [...this.columns.frame.keys()].map(i => this.shareCulled(i)), this.walk.regions);
    this.map?.setCursor(this.index, this.regionOf(this.index));
  }

  setIndex(index) {
    this.index = Math.min(this.count - 1, Math.max(0, index));
    this.nameInAddress();
    const frame = this.columns.frame[this.index];
    byId('slider').value = this.index;
    byId('slider').setAttribute('aria-valuetext', `frame ${frame}`);
    byId('number').textContent = frame;
    this.charts.setCursor(this.index);
    byId('told').textContent = this.account(this.index);
    this.tellCounts(this.index);
    this.tellMethods(this.index);
    this.showFrame();
  }

  showFrame() {
    if (!this.viewer) return;
    const shown = Math.floor(this.index / this.scene.every);
    this.frame = this.frames.at(shown);
    const at = this.shown = shown * this.scene.every;
    this.viewer.setFrame(this.frame, this.eyes[at], this.targets[at], this.regionOf(at), this.ups?.[at]);
    this.map?.setCursor(this.index, this.regionOf(this.index));
    this.tellPicked();
    this.fillHiders();
    byId('picture').setAttribute('aria-label', `${this.viewer.isOutside ? 'From outside' : 'View of the camera'}: ${this.account(at)}`);
  }

  /** The frame on which the page opens: that with the most polygons in view which it did not draw. */
  indexOfHidingMost() {
    const {in_view: inView, drawn} = this.columns, hidden = inView.map((n, i) => n - drawn[i]);
    return hidden.indexOf(Math.max(...hidden));
  }

  /** The legend of a frame. */
  tellCounts(i) {
    const c = this.columns, wrong = this.walk.rendered ? c.drawn[i] - c.visible[i] : undefined;
    for (const [name, count] of Object.entries({drawn: c.drawn[i], hidden: c.culled[i], away: c.out_of_view[i], wrong})) {
      byId(`count-${name}`).textContent = count === undefined ? '' : grouped(count);
    }
  }

  /** Of the polygons in view. */
  shareCulled(i) {
    return shareCulled(this.columns, i);
  }

  /** The region that holds for a frame; none where it was culled for itself. */
  regionOf(i) {
    return this.walk.regions[this.columns.region?.[i] - 1];
  }

  /** In words. */
  heldBy(i) {
    const region = this.regionOf(i);
    if (!this.columns.region) return '';
    if (!region) return ' It was culled for itself: no region holds for it.';
    const number = this.columns.region[i], isNew = region.first === this.columns.frame[i];
    return ` It is held by region ${number} of ${grouped(this.walk.regions.length)}, ` +
           (isNew ? 'which was culled in it.' : `culled in frame ${region.first} in ${inMs(region.ms)} ms.`);
  }

  /** A frame in words. */
  account(i) {
    const c = this.columns;
    const visible = this.walk.rendered ? ` (${grouped(c.visible[i])} visible)` : '';
    const time = this.walk.rendered
        ? `${inMs(c.frame_ms[i])} ms, of it culling ${inMs(c.cull_ms[i])} (without occlusion culling ${inMs(c.view_frustum_frame_ms[i])}, ` +
              `the visible polygons alone ${inMs(c.visible_frame_ms[i])})`
        : `culling ${inMs(c.cull_ms[i])} ms`;
    return `Frame ${c.frame[i]}: ${time}; ${grouped(c.drawn[i])} polygons drawn${visible}, ${grouped(c.culled[i])} culled, ` +
           `${grouped(c.out_of_view[i])} out of view. Of the ${grouped(c.in_view[i])} in view ${inPercent(this.shareCulled(i))} were culled.` + this.heldBy(i) +
           (this.walk.rendered ? this.chiefReason(i) : '');
  }

  /** Why a frame drew what is hidden: the chief reason in words. */
  chiefReason(i) {
    const hidden = this.columns.drawn[i] - this.columns.visible[i];
    if (hidden <= 0) return '';
    const [chief] = reasonsOf(this.walk, this.columns, i);
    return ` ${grouped(hidden)} were drawn though they are hidden, ${inPercent(this.columns[chief][i] / hidden)} of these because: ${this.walk.reasons[chief]}.`;
  }

  /** The hiders of the frame with their colours. */
  fillHiders() {
    const items = [...this.frame.hiders].sort(([a], [b]) => a - b).map(([number, both]) => {
      const item = element('li', {}, both.map(o => nameOfOccluder(this.occluder(o), this.model)).join(' and '));
      if (both.length === 1) item.append(`: ${grouped(both[0].hidden)}`);
      item.style.setProperty('--swatch', hiderColour(number));
      item.dataset.pattern = number % 4;
      return item;
    });
    const idle = this.frame.occluders.filter(o => o.hidden === 0);
    for (const occluder of idle) items.push(element('li', {class: 'idle'}, `⚠ ${nameOfOccluder(this.occluder(occluder), this.model)}: hides nothing`));
    byId('hiders').replaceChildren(...items);
  }
  occluder(shown) {
    return this.scene.occluders[shown.outline.occluder];
  }

  setOutside(isOutside) {
    byId('eye').setAttribute('aria-pressed', !isOutside);
    byId('outside').setAttribute('aria-pressed', isOutside);
    byId('viewer').classList.toggle('outside', isOutside);
    this.viewer.isOutside = isOutside;
    this.viewer.see();
    this.viewer.invalidate();
  }

  pick(x, y) {
    this.viewer.picked = this.viewer.pick(x, y);
    this.viewer.invalidate();
    this.tellPicked();
  }

  tellPicked() {
    const polygon = this.viewer.picked;
    byId('picked').textContent = polygon === null ? 'Click a polygon to see what became of it.' : this.accountOf(polygon);
    if (polygon === null) return;
    if (!this.details.starts.has(this.shown)) {
      byId('picked').append(' Distances and reasons: this page has those of frame ', frameLink(this.columns.frame[this.details.nearest(this.shown)]), '; the command tells those of this one.');
    }
    byId('picked').append(element('br', {}), element('code', {}, this.commandFor(polygon)));
  }

  /** The command that tells more of a polygon: that of the walk without its outputs. */
  commandFor(polygon) {
    const options = byId('command').textContent.replace(/^occlude walk/, '')
        .replace(/ --(out|witness|cases)[ =](\\'|'[^']*'|[^\s'])+/g, '').replace(/ --(no-render|json)(?= |$)/g, '');
    const byMethod = this.method === 0 ? options : `${options.replace(kOfFirst, '')} --method ${this.walk.method}`;
    return `occlude why${byMethod} --frame ${this.columns.frame[this.index]} --polygon ${this.model.numbers[polygon]}`;
  }

  /** What became of a polygon in this frame. */
  accountOf(polygon) {
    const name = `Polygon ${this.model.numbers[polygon]}`;
    return `${name}: ${this.fateOf(polygon)} ${this.vainOf(polygon)}`;
  }
  fateOf(polygon) {
    const leaf = this.model.leafOf(polygon), fate = this.frame.fates[leaf], details = this.details.at(this.shown);
    if (fate === Fate.drawn) return `drawn, with its leaf of ${this.countIn(leaf, leaf + 1)}${this.reasonFor(polygon, details)}.`;
    const i = this.frame.culled.findIndex(node => leaf < node.end), {first, end} = this.frame.culled[i];
    const node = `with a node of ${this.countIn(first, end)}`;
    if (fate === Fate.covered) return `culled, hidden by several polygons in front of it together, ${node}.`;
    const both = this.hidersOf(fate), [plane, ...planes] = this.planesThatCulled(i, details);
    if (fate === Fate.outOfView) {
      return `culled, out of view, ${node}${plane ? `, which is beyond the ${this.scene.planes[plane.number]} plane by ${plane.distance}` : ''}.`;
    }
    const names = both.map(o => nameOfOccluder(this.occluder(o), this.model)).join(' and of ');
    return `culled, in the shadow of ${names}, ${node}${plane ? [plane, ...planes].map((p, k) => this.clearance(both[k], p)).join('') : ''}.`;
  }
  /** One or two occluders, none of what is not hidden by a shadow. */
  hidersOf(fate) {
    return fate >= Fate.hidden ? this.frame.hiders.get(fate - Fate.hidden) : [];
  }
  /** The planes that culled subtree i, with the distances from them; none where the page has no details. */
  planesThatCulled(i, details) {
    if (!details) return [];
    const planesOf = ({fate}) => fate === Fate.outOfView ? 1 : this.hidersOf(fate).length;
    const first = this.frame.culled.slice(0, i).reduce((sum, node) => sum + planesOf(node), 0);
    return Array.from({length: planesOf(this.frame.culled[i])}, (_, k) => ({
      number: details.planes[first + k], distance: this.inUnits(details.distances[first + k]), isOutside: details.distances[first + k] < 0}));
  }
  /** Model units; single precision has so many digits. */
  inUnits(distance) {
    return String(Number(Math.abs(distance).toPrecision(6)));
  }
  clearance({outline}, {number, distance, isOutside}) {
    const corner = i => `(${outline.points[i % outline.points.length].map(c => Number(c.toPrecision(6))).join(', ')})`;
    const side = number === 0 ? 'its near side' : `the side through its edge ${corner(number - 1)} – ${corner(number)}`;
    return isOutside ? `; the node sticks out of its shadow by ${distance}, at ${side}` : `; the node is inside its shadow by ${distance}, nearest to ${side}`;
  }
  reasonFor(polygon, details) {
    const answer = details?.missed.get(polygon);
    if (!answer) return '';
    const alone = answer.occluder < 0 ? '' : ` (${nameOfOccluder(this.scene.alone[answer.occluder], this.model)})`;
    return `, though it is hidden: ${this.scene.reasons[answer.reason]}${alone}`;
  }
  countIn(firstLeaf, endLeaf) {
    const count = this.model.firstPolygon[endLeaf] - this.model.firstPolygon[firstLeaf];
    return `${grouped(count)} ${count === 1 ? 'polygon' : 'polygons'}`;
  }
  vainOf(polygon) {
    const frames = this.scene.drawn_frames;
    return frames > 0 ? `In ${grouped(this.model.vain[polygon])} of the ${grouped(frames)} frames it was drawn though it is hidden.` : '';
  }

  play(isPlaying) {
    this.isPlaying = isPlaying;
    if (isPlaying) this.playFrom(this.columns.frame[this.index], performance.now());
    byId('told').setAttribute('aria-live', isPlaying ? 'off' : 'polite');
    byId('play').textContent = isPlaying ? '❚❚' : '▶';
    byId('play').setAttribute('aria-label', isPlaying ? 'Pause' : 'Play');
  }

  /** In the path's own time, whichever of its frames are here: from `start`, a time of the browser's, on. */
  playFrom(frame, start) {
    if (!this.isPlaying) return;
    const {frame: frames} = this.columns, first = frames[0], span = frames.at(-1) - first + 1;
    const now = first + (frame - first + kFramesASecond * (performance.now() - start) / 1000) % span;
    const index = nearestIndex(frames, now);
    if (index !== this.index) this.setIndex(index);
    requestAnimationFrame(() => this.playFrom(frame, start));
  }

  /** The address names the frame at which the cursor rests, so that it can be passed on. */
  nameInAddress() {
    clearTimeout(this.naming);
    if (this.index === this.indexOfAddress() || (this.index === this.first && !location.hash)) return;
    this.naming = setTimeout(() => this.nameNow(), 300);
  }

  nameNow() {
    clearTimeout(this.naming);
    history.replaceState(null, '', `#frame=${this.columns.frame[this.index]}`);
  }

  indexOfAddress() {
    const frame = Number(location.hash.match(/^#frame=(\d+)$/)?.[1] ?? NaN);
    return Number.isNaN(frame) ? undefined : nearestIndex(this.columns.frame, frame);
  }

  listen() {
    byId('slider').max = this.count - 1;
    byId('slider').addEventListener('input', event => this.setIndex(Number(event.target.value)));
    byId('play').addEventListener('click', () => this.play(!this.isPlaying));
    byId('eye').addEventListener('click', () => this.setOutside(false));
    byId('outside').addEventListener('click', () => this.setOutside(true));
    byId('behind').addEventListener('click', () => {
      this.viewer.goBehind();
      this.viewer.see();
      this.viewer.invalidate();
    });
    byId('save').addEventListener('click', async () => save('path.json', new TextDecoder().decode(await bytesOfPart('way'))));
    for (const box of document.querySelectorAll('input[data-layer]')) {
      box.addEventListener('change', () => {
        this.viewer.layers[box.dataset.layer] = box.checked;
        this.viewer.see();
        this.viewer.invalidate();
      });
    }
    addEventListener('click', event => {
      const link = event.target.closest('a[href^="#frame="]');
      if (!link) return;
      this.nameNow();  // a name still to come would undo the link's, or be the same, and the link would lead nowhere
      byId('viewer').scrollIntoView();
    });
    addEventListener('hashchange', () => this.setIndex(this.indexOfAddress() ?? this.index));
    addEventListener('keydown', event => this.key(event));
    matchMedia('(prefers-color-scheme: dark)').addEventListener('change', () => this.viewer?.invalidate());
  }

  key(event) {
    if (event.ctrlKey || event.metaKey || event.altKey) return;
    const step = event.shiftKey ? 10 : 1;
    const actions = {ArrowLeft: () => this.setIndex(this.index - step), ArrowRight: () => this.setIndex(this.index + step),
                     Home: () => this.setIndex(0), End: () => this.setIndex(this.count - 1), ' ': () => this.play(!this.isPlaying)};
    const action = actions[event.key];
    const ownsKey = event.key === ' ' ? event.target.closest('button, summary, a, input[type=checkbox]') : event.target.closest('input');
    if (!action || ownsKey || (['Home', 'End'].includes(event.key) && event.target === document.body)) return;
    event.preventDefault();
    action();
  }
}

/** Where the model cannot be drawn, pictures of one frame are shown. */
function showPictures(reason) {
  byId('viewer').classList.remove('ready');
  byId('viewer').classList.add('without');
  byId('reason').textContent = reason;
}

/** Once the browser has drawn. */
const picture = () => new Promise(done => requestAnimationFrame(() => setTimeout(done)));

/** The model and the frames of a method. What they have in common with those of the first one is in the page once. */
async function sceneOf(method) {
  const partOf = name => hasPart(`${name}-${method}`) ? `${name}-${method}` : name;
  const scene = await jsonOfPart(partOf('scene'));
  const names = ['vertices', 'leaves', 'sides', 'corners', 'numbers', 'vain', 'frames', 'details'];
  const parts = Object.fromEntries(await Promise.all(names.map(async name => [name, await bytesOfPart(partOf(name))])));
  const model = new Model(scene, parts);
  return {scene, model, frames: new Frames(scene, parts.frames, model.leaves), details: new Details(parts.details)};
}

async function open() {
  const page = new WalkPage(await jsonOfPart('figures'));
  page.addScene(await jsonOfPart('path'), await sceneOf(0));
  await picture();
  page.fillCharts();
  page.addMap();
  return page;
}

window.walkPage = open();
window.walkPage.catch(error => showPictures(error.message));
