// SPDX-License-Identifier: MIT
// Settings, buttons and counts.
import {median, type App} from "./app.mjs";
import {copyLink, sizeOf} from "./court.mjs";
import {byId, grouped, inputOf, onClick, press, tell} from "./elements.mjs";
import {showSplit} from "./layout.mjs";
import {triangleCount} from "./model.mjs";
import {turned} from "./read.mjs";
import {save} from "./save.mjs";
import type {Scene} from "./scenes.mjs";

const recordLabel = byId("record").innerHTML;

/** What the sliders mean. */
const kNoBudget = 24;
const budgetOf = (value: number): number | undefined => (value === kNoBudget ? undefined : 0.1 * 10 ** (value / 12));
const sliderOf = (budget: number | undefined): number => (budget === undefined ? kNoBudget : Math.round(12 * Math.log10(budget / 0.1)));
const holdOf = (value: number): number => value / 4;
const paceOf = (value: number): number => 10 ** (value / 20);

export interface Doors {
  openScene(scene: Scene): Promise<void>;
  openFiles(files: Iterable<File>): Promise<void>;
}

export class Panel {
  readonly #app: App;

  constructor(app: App, scenes: readonly Scene[], doors: Doors) {
    this.#app = app;
    const select = byId<HTMLSelectElement>("scene");
    select.append(...scenes.map(({key, title}) => new Option(title, key)));
    select.addEventListener("change", () => {
      const scene = scenes.find(({key}) => key === select.value);
      if (scene) void doors.openScene(scene);
    });
    this.#listenToButtons();
    this.#listenToSettings();
    onClick("open", () => byId("files").click());
    const input = inputOf("files");
    input.addEventListener("change", () => {
      void doors.openFiles([...(input.files ?? [])]);
      input.value = ""; // the same file may be opened again
    });
    listenToDrops(doors);
  }

  /** Another model is open: whatever hangs on it. */
  tellModel(): void {
    const {model, shows, source} = this.#app;
    byId("scene-name").textContent = model.name;
    document.title = `occlude: ${model.name}`;
    byId("about").textContent = `${model.name}: ${sizeOf(this.#app)}. W A S D or the arrows walk, Q and E go down and up, ` +
      "Shift is faster; drag looks around, the wheel changes the speed. One finger looks, two walk. A click asks why. " +
      "From outside drag turns, Shift and drag or two fingers move, the wheel or a pinch zooms.";
    inputOf("cut").checked = shows.cut;
    const select = byId<HTMLSelectElement>("scene"), isOwn = source.scene === undefined;
    select.querySelector("option[value=own]")?.remove();
    if (isOwn) select.append(new Option(model.name, "own"));
    select.value = source.scene ?? "own";
    byId("model-settings").hidden = !isOwn && !model.isColoured;
    byId("clay-row").hidden = !model.isColoured;
    byId("up-row").hidden = !isOwn;
    inputOf("up").checked = model.up[1] === 1;
    byId("cameras-row").hidden = model.cameras.length === 0;
    const names = ["", ...model.cameras.map(({name}) => name)];
    byId("cameras").replaceChildren(...names.map((name, i) => new Option(name, String(i - 1))));
  }

  /** All inputs as the settings are. */
  tellSettings(): void {
    const {settings, pace} = this.#app;
    document.querySelector<HTMLInputElement>(`input[name=method][value=${settings.method}]`)!.checked = true;
    inputOf("budget").value = String(sliderOf(settings.budget));
    inputOf("hold").value = String(settings.hold * 4);
    inputOf("clay").checked = settings.isClay;
    press("culling", settings.isCulling);
    byId("budget-value").textContent = settings.budget === undefined ? "none" : `${settings.budget.toPrecision(2)} ms`;
    byId("hold-value").textContent = settings.hold === 0 ? "one frame" : `${settings.hold} s`;
    byId("speed-value").textContent = `× ${pace.toPrecision(2)}`;
  }

  tellFlight(): void {
    press("fly", this.#app.isFlying);
    byId("fly").innerHTML = `<span aria-hidden="true">${this.#app.isFlying ? "❚❚" : "▶"}</span><span class="long"> Fly</span>`;
  }

  tellFrame(): void {
    const {frame, between, culls, model, views, canvas, recorder} = this.#app;
    const counts = frame?.counts ?? {drawn: triangleCount(model), hidden: 0, outOfView: 0};
    const put = (id: string, text: string) => (byId(id).textContent = text);
    put("fps", between.length > 5 ? (1000 / median(between)).toFixed(0) : "–");
    put("ms", frame && culls.length > 0 ? median(culls).toFixed(2) : "–");
    put("drawn", grouped(counts.drawn));
    put("hidden", frame ? grouped(counts.hidden) : "–");
    put("away", frame ? grouped(counts.outOfView) : "–");
    showSplit(views, canvas);
    if (recorder.isOn) byId("record").textContent = `■ ${recorder.seconds.toFixed(0)} s`;
  }

  #listenToButtons(): void {
    const app = this.#app;
    onClick("fly", () => app.setFlying(!app.isFlying));
    onClick("culling", () => {
      app.settings.isCulling = !app.settings.isCulling;
      this.tellSettings();
      app.wake();
    });
    onClick("link", () => {
      const {scene, model} = app.source, isOwn = scene === undefined && model === undefined;
      copyLink(app.address(), isOwn ? " Your file is not in it: who opens it must have it, too." : "");
    });
    onClick("record", () => {
      const text = app.record();
      press("record", app.recorder.isOn);
      if (text === undefined) return tell("Recording: walk or fly, then save. The file is what `occlude walk MODEL --path` takes.");
      save("path.json", text);
      byId("record").innerHTML = recordLabel;
    });
    const toggle = () => {
      byId("settings").hidden = !byId("settings").hidden;
      press("more", !byId("settings").hidden);
    };
    onClick("more", toggle);
    onClick("settings-close", toggle);
  }

  #listenToSettings(): void {
    const app = this.#app, {settings, shows} = app;
    const listen = (id: string, change: (input: HTMLInputElement) => void) => {
      inputOf(id).addEventListener("input", () => {
        change(inputOf(id));
        this.tellSettings();
        app.wake();
      });
    };
    for (const radio of document.querySelectorAll<HTMLInputElement>("input[name=method]")) {
      radio.addEventListener("change", () => app.setMethod(radio.value === "objects" ? "objects" : "polygons"));
    }
    listen("budget", input => (settings.budget = budgetOf(Number(input.value))));
    listen("hold", input => (settings.hold = holdOf(Number(input.value))));
    listen("speed", input => {
      app.pace = paceOf(Number(input.value));
      app.walker.speed = 3 * app.unit * app.pace;
    });
    listen("clay", input => (settings.isClay = input.checked));
    listen("show-outside", input => (shows.outside = input.checked));
    listen("show-hidden", input => (shows.hidden = input.checked));
    listen("show-away", input => (shows.outOfView = input.checked));
    listen("cut", input => (shows.cut = input.checked));
    listen("up", input => {
      const model = turned(app.model, input.checked ? [0, 1, 0] : [0, 0, 1]);
      void app.open(model, app.source).then(() => this.tellModel());
    });
    byId<HTMLSelectElement>("cameras").addEventListener("change", event => {
      const place = app.model.cameras[Number((event.target as HTMLSelectElement).value)];
      if (place) app.jump(place);
    });
  }
}

function listenToDrops(doors: Doors): void {
  let depth = 0;
  const show = (by: number) => {
    depth = Math.max(0, depth + by);
    byId("drop").hidden = depth === 0;
  };
  addEventListener("dragenter", () => show(1));
  addEventListener("dragleave", () => show(-1));
  addEventListener("dragover", event => event.preventDefault());
  addEventListener("drop", event => {
    event.preventDefault();
    show(-depth);
    void doors.openFiles(event.dataTransfer?.files ?? []);
  });
}
