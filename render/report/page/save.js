// SPDX-License-Identifier: MIT
// Hands camera paths to the reader, as files that every --path takes.

function saveFile(name, text) {
  const link = document.createElement('a');
  link.href = URL.createObjectURL(new Blob([text], {type: 'application/json'}));
  link.download = name;
  link.click();
  setTimeout(() => URL.revokeObjectURL(link.href));
}

/** The file of a path with a keyframe, an eye and a target, for each frame. A single one stays for two frames. */
function pathText(model, lens, keyframes) {
  const {projection, fov_y_deg, height, near, far, up} = lens;
  const shown = projection === 'orthographic' ? {height} : {fov_y_deg};
  const frames = keyframes.length > 1 ? keyframes : [...keyframes, ...keyframes];
  const path = {model, frames: frames.length, projection, ...shown, near, ...(far ? {far} : {}), up,
                keyframes: frames.map(([eye, target]) => ({eye, target}))};
  return `${JSON.stringify(path)}\n`;
}
