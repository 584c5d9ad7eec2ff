// SPDX-License-Identifier: MIT
// A program that node runs has the variables of the environment, if it asks for any. Without fetch(), Emscripten does not take
// node for a browser.
Module['preRun'] = () => typeof ENV === 'undefined' || Object.assign(ENV, process.env);
globalThis.fetch = undefined;
