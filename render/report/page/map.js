// SPDX-License-Identifier: MIT
// The path from above, coloured by the share of the polygons in view that is culled.

/** Dark for little, bright for much; the steps differ in lightness. */
const kShares = [[0, [53, 25, 98]], [0.25, [35, 89, 150]], [0.5, [20, 146, 150]], [0.75, [106, 196, 97]], [1, [253, 231, 37]]];

function colourOfShare(share) {
  const above = Math.max(1, kShares.findIndex(([s]) => s >= share));
  const [[a, from], [b, to]] = [kShares[above - 1], kShares[above]];
  return `rgb(${from.map((c, i) => Math.round(c + (to[i] - c) * (share - a) / (b - a))).join(' ')})`;
}

/** Regions begin at marks on the path where these are so many pixels apart. */
const kMarksApart = 7;

class PathMap {
  /** `eyes` and `targets` are points. Calls onFrame with the index of the frame that is clicked. */
  constructor(canvas, viewer, eyes, targets, onFrame) {
    this.canvas = canvas;
    this.axes = levelAxes(viewer.lens.up);
    this.eyes = eyes;
    this.targets = targets;
    const flat = eyes.map(eye => this.flat(eye));
    const low = [0, 1].map(i => Math.min(...flat.map(p => p[i]))), high = [0, 1].map(i => Math.max(...flat.map(p => p[i])));
    this.middle = [0, 1].map(i => (low[i] + high[i]) / 2);
    const spans = [0, 1].map(i => Math.max(high[i] - low[i], viewer.size / 200));
    this.scale = 512 / (1.25 * Math.max(...spans));  // pixels of the map a unit; no higher than wide
    this.pixels = [512, Math.round(1.25 * this.scale * Math.max(spans[1], 0.6 * spans[0]))];
    canvas.addEventListener('click', event => {
      const box = canvas.getBoundingClientRect();
      const at = [event.clientX - box.left, event.clientY - box.top].map(c => c * this.pixels[0] / box.width);
      const places = eyes.map(eye => this.place(eye));
      const away = places.map(p => Math.hypot(p[0] - at[0], p[1] - at[1]));
      onFrame(away.indexOf(Math.min(...away)));
    });
  }

  flat(point) {
    return [dot(point, this.axes.east), dot(point, this.axes.north)];
  }
  place(point) {
    const [x, y] = this.flat(point);
    return [this.pixels[0] / 2 + (x - this.middle[0]) * this.scale, this.pixels[1] / 2 - (y - this.middle[1]) * this.scale];
  }

  /** `shares` are numbers from 0 to 1, `regions` have centre and halfEdges. */
  show(viewer, shares, regions) {
    this.regions = regions;
    this.ground = this.drawGround(viewer, shares);
  }

  drawGround(viewer, shares) {
    const ground = document.createElement('canvas');
    [ground.width, ground.height] = this.pixels;
    const context = ground.getContext('2d');
    const height = dot(this.eyes[0], this.axes.up);
    const middle = add(add(scale(this.axes.east, this.middle[0]), scale(this.axes.north, this.middle[1])), scale(this.axes.up, height));
    const kPaper = '#f3f5f8';
    viewer.drawMap(middle, this.pixels.map(p => p / this.scale), this.pixels, rgb(kPaper));
    context.drawImage(viewer.canvas, 0, 0);
    context.fillStyle = `${kPaper}8c`;  // pale
    context.fillRect(0, 0, ...this.pixels);
    context.lineCap = 'round';
    for (const [width, colour] of [[9, () => '#10151c'], [6, i => colourOfShare(shares[i])]]) {
      context.lineWidth = width;
      for (let i = 0; i < this.eyes.length; ++i) {
        context.strokeStyle = colour(i);
        context.beginPath();
        context.moveTo(...this.place(this.eyes[i]));
        context.lineTo(...this.place(this.eyes[Math.min(i + 1, this.eyes.length - 1)]));
        context.stroke();
      }
    }
    this.markRegions(context);
    return ground;
  }

  /** A mark across the path where each region begins; none where they would hide the path. */
  markRegions(context) {
    const starts = this.regions.map(({centre, halfEdges: [along]}) => [this.place(subtract(centre, along)), this.place(add(centre, along))]);
    const long = starts.reduce((sum, [from, to]) => sum + Math.hypot(to[0] - from[0], to[1] - from[1]), 0);
    if (long < kMarksApart * starts.length) return;
    context.lineCap = 'butt';
    context.lineWidth = 2;
    context.strokeStyle = '#10151c';
    for (const [[x, y], to] of starts) {
      const away = Math.hypot(to[0] - x, to[1] - y), [dx, dy] = [(to[1] - y) / away * 6, (x - to[0]) / away * 6];
      if (away === 0) continue;
      context.beginPath();
      context.moveTo(x - dx, y - dy);
      context.lineTo(x + dx, y + dy);
      context.stroke();
    }
  }

  /** Where the eye may be while a region holds, seen from above: at least as wide as a line. */
  drawRegion(context, {centre, halfEdges: [along, side]}) {
    const corners = [[1, 1], [1, -1], [-1, -1], [-1, 1]].map(([a, b]) => this.place(add(centre, add(scale(along, a), scale(side, b)))));
    context.beginPath();
    for (const corner of corners) context.lineTo(...corner);
    context.closePath();
    context.lineJoin = 'round';
    for (const [width, colour] of [[7, '#fff'], [3, kRegionColour]]) {
      context.lineWidth = width;
      context.strokeStyle = colour;
      context.stroke();
    }
  }

  /** `region` holds for the frame, if any does. */
  setCursor(index, region) {
    const context = this.canvas.getContext('2d');
    [this.canvas.width, this.canvas.height] = this.pixels;
    context.drawImage(this.ground, 0, 0);
    if (region) this.drawRegion(context, region);
    const [x, y] = this.place(this.eyes[index]), [tx, ty] = this.place(this.targets[index]);
    const heading = Math.atan2(ty - y, tx - x);
    context.beginPath();
    context.moveTo(x, y);
    context.arc(x, y, 60, heading - 0.5, heading + 0.5);
    context.closePath();
    context.fillStyle = 'rgb(91 140 255 / 35%)';
    context.fill();
    context.beginPath();
    context.arc(x, y, 9, 0, 7);
    context.fillStyle = '#5b8cff';
    context.fill();
    context.lineWidth = 3;
    context.strokeStyle = '#fff';
    context.stroke();
  }
}
