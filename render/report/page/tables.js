// SPDX-License-Identifier: MIT
// The tables that the page computes from the figures of its frames.

const grouped = number => Math.round(number).toLocaleString('en');
const inMs = number => number.toFixed(2);
const inPercent = share => `${(100 * share).toFixed(1)} %`;

/** An element with children: texts and elements. */
function element(name, attributes, ...children) {
  const result = document.createElement(name);
  for (const [key, value] of Object.entries(attributes)) result.setAttribute(key, value);
  result.append(...children);
  return result;
}

function table(heads, rows) {
  const row = (cells, kind) => element('tr', {}, ...cells.map(cell => element(kind, {}, cell)));
  return element('div', {class: 'wide'},
                 element('table', {}, element('thead', {}, row(heads, 'th')), element('tbody', {}, ...rows.map(cells => row(cells, 'td')))));
}

/** A link that moves the cursor to a frame. */
const frameLink = frame => element('a', {href: `#frame=${frame}`}, String(frame));

/** The columns of a frame's reasons, those of most polygons first. */
const reasonsOf = (walk, columns, i) => Object.keys(walk.reasons).sort((a, b) => columns[b][i] - columns[a][i]);

/** The frames that took longest, and what they drew. */
function worstTable(walk, columns) {
  const kListed = 10;
  const times = walk.rendered ? columns.frame_ms : columns.cull_ms;
  const worst = [...times.keys()].sort((a, b) => times[b] - times[a]).slice(0, kListed);
  if (!walk.rendered) {
    return table(['Frame', 'culling, ms', 'drawn', 'culled'],
                 worst.map(i => [frameLink(columns.frame[i]), inMs(columns.cull_ms[i]), grouped(columns.drawn[i]), grouped(columns.culled[i])]));
  }
  return table(['Frame', 'ms', 'culling, ms', 'without culling, ms', 'only visible, ms', 'drawn', 'of it hidden', 'chiefly because'], worst.map(i => {
    const hidden = columns.drawn[i] - columns.visible[i], [chief] = reasonsOf(walk, columns, i);
    return [frameLink(columns.frame[i]), inMs(columns.frame_ms[i]), inMs(columns.cull_ms[i]), inMs(columns.view_frustum_frame_ms[i]),
            inMs(columns.visible_frame_ms[i]), grouped(columns.drawn[i]), inPercent(columns.drawn[i] ? hidden / columns.drawn[i] : 0),
            element('span', {class: 'said'}, hidden > 0 ? `${walk.reasons[chief]} (${inPercent(columns[chief][i] / hidden)})` : '')];
  }));
}

/** Of the polygons in view. */
const shareCulled = (columns, i) => columns.in_view[i] ? 1 - columns.drawn[i] / columns.in_view[i] : 0;

/** What each region hid in the frames that it held for. */
function regionTables(walk, columns) {
  const kListed = 15;
  const framesOf = walk.regions.map(() => []);
  columns.region.forEach((number, i) => framesOf[number - 1]?.push(i));
  const rows = walk.regions.map((region, number) => {
    const held = framesOf[number];
    const mean = value => held.reduce((sum, i) => sum + value(i), 0) / held.length;
    return {region, frames: held.length, link: columns.frame[held[0]], culled: mean(i => columns.culled[i]), share: mean(i => shareCulled(columns, i))};
  }).filter(row => row.frames > 0);
  const heads = ['From frame', 'frames', 'culling it, ms', 'hid a frame', 'of what is in view'];
  const cells = row => [frameLink(row.link), grouped(row.frames), inMs(row.region.ms), grouped(row.culled), inPercent(row.share)];
  const least = [...rows].sort((a, b) => a.share - b.share).slice(0, kListed);
  return [element('p', {}, `${grouped(walk.regions.length)} regions were culled on the path. Each is a box of eyes: a frame whose eye is in it draws ` +
                           'what the region does not hide, as far as it is in its own view. Those that hid least:'),
          table(heads, least.map(cells)),
          element('details', {}, element('summary', {}, `All ${grouped(rows.length)} regions with frames that are counted`), table(heads, rows.map(cells)))];
}

/** "polygon 12", or several, by their numbers in the model file. */
function nameOfOccluder(occluder, model) {
  const kNamed = 3, count = occluder.polygons.length;
  const named = occluder.polygons.slice(0, kNamed).map(p => model.numbers[p]).join(', ');
  const kind = occluder.shell ? ', a closed shell' : '';
  if (count === 0) return `too small for this page${kind}`;
  return `${count === 1 ? 'polygon' : 'polygons'} ${named}${count > kNamed ? ` and ${count - kNamed} more` : ''}${kind}`;
}

/** Whether a hider hid nothing in most frames that used it. */
const isUseless = hider => 2 * hider.useless > hider.frames;

/** Two tables of hiders by what they hid: the best, and the useless ones. `nameOf` names one; `heads` are those of its columns. */
function hiderTables(heads, best, useless, nameOf, frames) {
  const row = o => [nameOf(o), grouped(o.frames), grouped(o.hidden / o.frames), inPercent(o.useless / o.frames),
                    o.best_hidden ? frameLink(frames[o.best_frame]) : '–', isUseless(o) ? element('span', {class: 'flag'}, '⚠ useless') : ''];
  const tables = [table(heads, best.map(row))];
  if (useless.length > 0) {
    tables.push(element('details', {}, element('summary', {}, `The ${useless.length} useless ones used most often`), table(heads, useless.map(row))));
  }
  return tables;
}

/** What each occluder hid over the path. */
function occluderTables(occluders, model, frames) {
  const kListed = 15;
  if (occluders.length === 0) return [];
  const best = [...occluders].sort((a, b) => b.hidden - a.hidden).slice(0, kListed);
  const useless = occluders.filter(isUseless).sort((a, b) => b.useless - a.useless);
  const spent = occluders.reduce((sum, o) => sum + o.useless, 0), all = occluders.reduce((sum, o) => sum + o.frames, 0);
  return [element('p', {}, `${grouped(occluders.length)} occluders were chosen on the path, ${grouped(useless.length)} of them useless: ` +
                           `they hid nothing in more than half of the frames that chose them. ${inPercent(spent / all)} of all choices hid nothing.`),
          ...hiderTables(['Occluder', 'frames', 'hid a frame', 'hid nothing in', 'most in frame', ''], best, useless.slice(0, kListed),
                         o => nameOfOccluder(o, model), frames)];
}

/** What each piece of the covers helped to hide over the path. */
function pieceTables(pieces, model, frames) {
  return [element('p', {}, `A piece is a leaf of the tree: its polygons are drawn into the coarse picture together. ${grouped(pieces.used)} pieces ` +
                           `were used on the path, ${grouped(pieces.useless)} of them useless: they helped to hide nothing in more than half of the frames ` +
                           `that drew them. ${inPercent(pieces.idle / pieces.uses)} of all uses hid nothing. What several hide together counts for each.`),
          ...hiderTables(['Piece', 'frames', 'helped to hide a frame', 'hid nothing in', 'most in frame', ''], pieces.best, pieces.worst,
                         o => nameOfOccluder({polygons: model.polygonsIn(o.leaf)}, model), frames)];
}
