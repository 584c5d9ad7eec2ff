// SPDX-License-Identifier: MIT
// Charts over the frames. They zoom together; a click moves the cursor, which all of them show.

const styleOf = name => getComputedStyle(document.documentElement).getPropertyValue(name).trim();

/** Beside a finger one scrolls the page; two fingers zoom. */
function touches() {
  const usual = Dygraph.defaultInteractionModel;
  const forTwo = handler => (event, chart, context) => {
    if (event.touches.length > 1 || context.initialTouches?.length > 1) handler(event, chart, context);
  };
  return {...usual, touchstart: forTwo(usual.touchstart), touchmove: forTwo(usual.touchmove), touchend: forTwo(usual.touchend)};
}

/** Whether a chart from 0 on would have a whole series in its lowest twentieth, where no one reads a figure. */
function spansDecades(series) {
  const most = Math.max(...series.flatMap(s => s.values));
  const medians = series.map(({values}) => [...values].sort((a, b) => a - b)[values.length >> 1]);
  return series.every(({values}) => Math.min(...values) > 0) && Math.min(...medians) < most / 20;
}

class Charts {
  /** Calls onFrame with the index of a frame that is clicked. */
  constructor(onFrame) {
    this.onFrame = onFrame;
    this.charts = [];
    this.cursor = 0;
    matchMedia('(prefers-color-scheme: dark)').addEventListener('change', () => this.recolour());
  }

  /**
   * A chart in `place`, an element, in place of the one before. `series` has {name, colour, pattern, values} each; a pattern is one of
   * dashes, if there is one; values are of the frames whose numbers `frames`
   * has. `stacked`: areas, the last one lowest. `hiddenAtFirst`, and a box with `data-series`, has how names end.
   */
  add(place, frames, series, {unit, stacked = false, hiddenAtFirst = []}) {
    const legend = place.querySelector('.legend'), drawing = place.querySelector('.drawing');
    this.remove(drawing);
    const rows = frames.map((frame, i) => [frame, ...series.map(s => s.values[i])]);
    const line = document.createElement('div');
    line.className = 'cursor';
    const isLog = !stacked && spansDecades(series);
    const chart = new Dygraph(drawing, rows, {
      logscale: isLog,
      labels: ['frame', ...series.map(s => s.name)],
      colors: series.map(s => s.colour),
      series: Object.fromEntries(series.map(s => [s.name, {strokePattern: s.pattern ?? null}])),
      visibility: series.map(s => !hiddenAtFirst.some(end => s.name.endsWith(end))),
      stackedGraph: stacked,
      fillAlpha: 0.85,
      strokeWidth: stacked ? 0.5 : 1.3,
      includeZero: !isLog,
      legend: 'never',
      axes: {y: {labelsKMB: unit !== 'ms'}},
      ylabel: isLog ? `${unit}, log scale` : unit,
      xlabel: 'frame',
      yLabelWidth: 16,
      xLabelHeight: 18,
      axisLabelFontSize: 13,
      highlightCircleSize: 3,
      interactionModel: touches(),
      ...this.inks(),
      drawCallback: (self, isFirst) => {
        if (isFirst) self.graphDiv.append(line);
        this.placeCursor(self, line);
        if (!isFirst) this.follow(self);
      },
      highlightCallback: (event, x, points, row) => this.write(chart, row),
      unhighlightCallback: () => this.write(chart, this.cursor),
      clickCallback: (event, x) => this.onFrame(nearestIndex(frames, x)),
    });
    place.querySelectorAll('input[data-series]').forEach(box => {
      const indices = [...series.keys()].filter(i => series[i].name.endsWith(box.dataset.series));
      box.checked = !hiddenAtFirst.includes(box.dataset.series);
      box.onchange = () => {
        chart.setVisibility(Object.fromEntries(indices.map(i => [i, box.checked])));
        this.setCursor(this.cursor);
      };
    });
    place.querySelector('.unzoom').onclick = () => chart.resetZoom();
    this.charts.push({chart, line, legend, series, unit, frames, drawing});
  }

  remove(drawing) {
    const at = this.charts.findIndex(e => e.drawing === drawing);
    if (at >= 0) this.charts.splice(at, 1)[0].chart.destroy();
  }

  setCursor(index) {
    this.cursor = index;
    for (const {chart, line} of this.charts) {
      this.placeCursor(chart, line);
      this.write(chart, index);
    }
  }

  entryOf(chart) {
    return this.charts.find(e => e.chart === chart);
  }

  placeCursor(chart, line) {
    const entry = this.entryOf(chart);
    if (!entry) return;
    const x = chart.toDomXCoord(entry.frames[this.cursor]), area = chart.getArea();
    line.hidden = x < area.x || x > area.x + area.w;
    line.style.cssText = `left:${x}px;top:${area.y}px;height:${area.h}px`;
  }

  /** The values of a row of what the chart shows. */
  write(chart, row) {
    const {legend, series, unit} = this.entryOf(chart);
    legend.replaceChildren(...series.filter((_, i) => chart.visibility()[i]).map(s => {
      const item = document.createElement('span');
      item.className = 'item';
      item.style.setProperty('--swatch', s.colour);
      item.textContent = `${s.name} `;
      const value = document.createElement('b');
      value.textContent = unit === 'ms' ? `${s.values[row].toFixed(2)} ms` : s.values[row].toLocaleString('en');
      item.append(value);
      return item;
    }));
  }

  /** The other charts show the frames that this one does. */
  follow(chart) {
    if (this.isFollowing) return;
    this.isFollowing = true;
    const [from, to] = chart.xAxisRange();
    for (const {chart: other} of this.charts) {
      const [otherFrom, otherTo] = other.xAxisRange();
      if (other !== chart && (otherFrom !== from || otherTo !== to)) other.updateOptions({dateWindow: [from, to]});
    }
    this.isFollowing = false;
  }

  inks() {
    return {axisLineColor: styleOf('--soft'), gridLineColor: styleOf('--line')};
  }
  recolour() {
    for (const {chart} of this.charts) chart.updateOptions(this.inks());
  }
}

/** The index of the number nearest to x among ascending ones. */
function nearestIndex(numbers, x) {
  let best = 0;
  numbers.forEach((number, i) => {
    if (Math.abs(number - x) < Math.abs(numbers[best] - x)) best = i;
  });
  return best;
}
