// SPDX-License-Identifier: MIT
// The page in which one flies through a model while each frame is culled.
import {load} from "occlude";

import {parse} from "./address.mjs";
import {App, type Source} from "./app.mjs";
import {moved, type Place} from "./camera.mjs";
import {Court} from "./court.mjs";
import {byId, grouped, tell} from "./elements.mjs";
import {sceneInside} from "./inside.mjs";
import {triangleCount, type Model} from "./model.mjs";
import {Panel} from "./panel.mjs";
import {listen} from "./pointers.mjs";
import {read} from "./read.mjs";
import {scenes as builtIn} from "./scenes.mjs";

/** Triangles of a model whose culler is there in less than a second or two. */
const kQuick = 150000;

async function start(): Promise<{app: App; court: Court}> {
  const address = parse(location.hash), inside = await sceneInside();
  const scenes = inside ? [inside, ...builtIn] : builtIn;
  const app = new App(load(bytesOf(byId("module").textContent!)), byId<HTMLCanvasElement>("picture"), address.settings, {
    onFrame() {
      panel.tellFrame();
      court.onFrame();
    },
    onCatch: (_, caught) => court.onCatch(caught),
    onFlight: () => panel.tellFlight(),
  });
  const court = new Court(app, scene => open(scene.make(), {scene: scene.key}));
  const panel = new Panel(app, scenes, {
    openScene: scene => open(scene.make(), {scene: scene.key}),
    openFiles: files => said(async () => openFiles([...files])),
  });

  async function open(model: Model, source: Source, place?: Place): Promise<void> {
    const isLarge = triangleCount(model) > kQuick;
    if (isLarge) tell(`Preparing the culler of ${grouped(triangleCount(model))} triangles …`, 600);
    await app.open(model, source, place);
    panel.tellModel();
    court.restart();
    if (isLarge) tell(`${model.name} is open.`, 3);
  }
  async function openFiles(files: readonly File[]): Promise<void> {
    tell("Reading …", 600);
    await new Promise(resolve => setTimeout(resolve));
    await open(await read(new Map(files.map(file => [file.name, file]))), {});
    tell(`${app.model.name} is open. It has not left this computer.`);
  }
  async function openAddress(): Promise<void> {
    const {scene, model, place, frame, before, settings} = parse(location.hash);
    Object.assign(app.settings, settings);
    if (model !== undefined) {
      tell(`Reading ${model} …`, 600);
      const answer = await fetch(model);
      if (!answer.ok) throw new Error(`${model}: ${answer.status} ${answer.statusText}`);
      await open(await read(new Map([[model.split("/").at(-1)!, await answer.blob()]])), {model}, place);
      tell(`${app.model.name} is open.`, 3);
    } else {
      const found = scenes.find(({key}) => key === scene) ?? scenes[0]!;
      const made = found.make();
      await open(made, {scene: found.key}, place ?? placeAt(made, frame));
    }
    panel.tellSettings();
    if (settings.isCatching) court.setOpen(true);
    if (settings.isCatching && place !== undefined) court.confront(place, before);
  }
  /** Errors are told, and nothing changes. */
  async function said(action: () => Promise<void>): Promise<void> {
    await action().catch((error: unknown) => tell(error instanceof Error ? error.message : String(error), 30));
  }

  listen(app, (x, y) => {
    app.setFlying(false);
    const answer = app.ask(x, y);
    tell(answer?.text ?? "There is nothing.", 20);
  });
  app.canvas.addEventListener("webglcontextlost", () => tell("The browser has given up the drawing; load the page again.", 1e6));
  addEventListener("hashchange", () => void said(openAddress));
  addEventListener("resize", () => app.wake());
  matchMedia("(prefers-color-scheme: light)").addEventListener("change", () => app.wake());
  await openAddress();
  return {app, court};
}

/** A place of the flight, in the coordinates of the file. */
function placeAt({flight, origin}: Model, frame: number | undefined): Place | undefined {
  const place = frame === undefined ? undefined : flight.places[frame];
  return place && moved(place, origin);
}

function bytesOf(base64: string): Uint8Array<ArrayBuffer> {
  const text = atob(base64), bytes = new Uint8Array(text.length);
  for (let i = 0; i < text.length; ++i) bytes[i] = text.charCodeAt(i);
  return bytes;
}

declare global {
  interface Window {
    page: Promise<{app: App; court: Court}>;
  }
}
window.page = start();
window.page.catch((error: unknown) => tell(`This cannot be shown here: ${error instanceof Error ? error.message : String(error)}`, 1e6));
