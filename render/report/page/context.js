// SPDX-License-Identifier: MIT
// WebGL for the picture. The browser takes up to two seconds to start it, beside everything else: the page asks for it as soon
// as there is a canvas.

const contextOf = canvas => canvas.getContext('webgl2', {antialias: false, depth: false, alpha: false});

contextOf(document.getElementById('picture'));
