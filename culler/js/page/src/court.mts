// SPDX-License-Identifier: MIT
// "Catch it lying": who was caught, and the scores.
import {median, type App} from "./app.mjs";
import {byId, grouped, onClick, press, tell} from "./elements.mjs";
import {newScores, type AccusedKey, type Catch, type Score, type Scores} from "./judge.mjs";
import {cover} from "./layout.mjs";
import {facetOf, triangleCount} from "./model.mjs";
import {rivals} from "./rivals.mjs";
import {scenes, type Scene} from "./scenes.mjs";

const accused: readonly {key: AccusedKey; title: string; says: string}[] = [
  {key: "occlude", title: "occlude", says: "This package, by the method that is chosen in the settings."},
  ...rivals,
];

/** A tour judges that many stretches of a flight, each of that many frames. */
const kStretches = 6, kFramesOfStretch = 20;

export class Court {
  readonly #app: App;
  readonly #open: (scene: Scene) => Promise<void>;
  /** By the title of the scene. */
  readonly scores = new Map<string, Scores>();
  /** Who has stopped the flight once stops it no more. */
  readonly #stopped = new Set<AccusedKey>();
  #isTouring = false;

  constructor(app: App, open: (scene: Scene) => Promise<void>) {
    this.#app = app;
    this.#open = open;
    onClick("catch", () => this.setOpen(app.scores === undefined));
    onClick("court-close", () => this.setOpen(false));
    onClick("tour", () => void (this.#isTouring ? (this.#isTouring = false) : this.tour()));
    onClick("card-on", () => app.setFlying(true));
    onClick("card-link", () => {
      if (app.caught) copyLink(app.addressOf(app.caught));
    });
    byId("court-note").append(...accused.flatMap(({title, says}) => [elementOf("dt", title), elementOf("dd", says)]));
  }

  setOpen(isOpen: boolean): void {
    this.#app.settings.isCatching = isOpen;
    this.#stopped.clear();
    this.#app.scores = isOpen ? this.scoresOf(this.#app.model.name) : undefined;
    byId("court").hidden = !isOpen;
    press("catch", isOpen);
    if (isOpen && !this.#app.caught) this.#app.setFlying(true);
    if (!isOpen) this.#app.forget();
    this.#tellScores();
    this.#app.wake();
  }

  /** Another model is open. */
  restart(): void {
    this.#stopped.clear();
    if (this.#app.scores) this.#app.scores = this.scoresOf(this.#app.model.name);
    this.#tellScores();
  }

  scoresOf(name: string): Scores {
    const found = this.scores.get(name) ?? newScores();
    this.scores.set(name, found);
    return found;
  }

  /** Stops for the first that is caught for the first time. */
  onCatch(caught: readonly Catch[]): void {
    this.#tellScores();
    const first = caught.find(({accused: key}) => !this.#stopped.has(key));
    if (first === undefined) return;
    this.#stopped.add(first.accused);
    this.#app.show(first);
  }

  /** What is caught, or nothing: card, mark and lens. */
  onFrame(): void {
    const {caught, views, canvas, lens} = this.#app;
    for (const id of ["card", "mark", "lens"]) byId(id).hidden = caught === undefined;
    document.body.classList.toggle("caught", caught !== undefined);
    if (caught === undefined) return;
    const {ratio, eye} = views, [x, y] = caught.at;
    Object.assign(byId("mark").style, {
      left: `${(eye.x + x * eye.width) / ratio}px`, top: `${(canvas.height - eye.y - y * eye.height) / ratio}px`,
    });
    cover(byId("lens"), lens, views, canvas);
    const {title} = accused.find(({key}) => key === caught.accused)!, {model} = this.#app;
    byId("card-title").textContent = `Caught: ${title}`;
    byId("card-text").textContent =
      `It leaves out “${model.names[caught.object]!}”, which shows at ${pixelsOf(caught)} of this picture. The ray from the eye ` +
      `through the marked one reaches ${facetOf(model, caught.proof.triangle)} and misses all ${grouped(caught.proof.missed)} others ` +
      "that could hide it.";
  }

  /** Judges stretches of the flights of all scenes, without a stop. */
  async tour(): Promise<void> {
    const before = byId("tour").textContent;
    this.#isTouring = true;
    byId("tour").textContent = "Stop";
    for (const scene of scenes) {
      if (!this.#isTouring) break;
      await this.#open(scene);
      this.#app.setFlying(false);
      const scores = Object.assign(this.scoresOf(scene.title), newScores());
      for (let s = 0; s < kStretches && this.#isTouring; ++s) {
        await this.#app.judgeFlight((s + 0.3) / kStretches, kFramesOfStretch, scores);
        this.#tellScores();
      }
    }
    this.#isTouring = false;
    byId("tour").textContent = before;
  }

  /** Opens a link to a catch: says if it is none here. */
  confront(place: Parameters<App["confront"]>[0], before: Parameters<App["confront"]>[1]): void {
    const caught = this.#app.confront(place, before, this.scoresOf(this.#app.model.name));
    for (const {accused: key} of caught) this.#stopped.add(key);
    if (caught.length > 0) this.#app.show(caught[0]!);
    else tell("Nobody hides what shows here, in a window of this size.");
    this.#tellScores();
  }

  #tellScores(): void {
    const named = [...this.scores].filter(([, scores]) => scores.occlude.frames > 0);
    const table = byId<HTMLTableElement>("scores");
    table.replaceChildren();
    const head = table.createTHead().insertRow();
    for (const text of ["wrong frames", ...named.map(([name]) => name), "ms"]) head.append(elementOf("th", text));
    const body = table.createTBody();
    for (const {key, title, says} of accused) {
      const row = body.insertRow(), of = named.map(([, scores]) => scores[key]);
      const name = elementOf("th", title);
      name.title = says;
      row.append(name, ...of.map((score, i) => this.#cellOf(score, named[i]![0])));
      const times = of.flatMap(score => score.times);
      row.append(elementOf("td", times.length > 0 ? median(times).toFixed(1) : "–"));
    }
  }

  #cellOf({frames, wrongFrames, first}: Score, scene: string): HTMLElement {
    const cell = elementOf("td", `${wrongFrames} / ${frames}`);
    cell.className = wrongFrames > 0 ? "wrong" : "right";
    if (first === undefined || scene !== this.#app.model.name) return cell;
    const button = document.createElement("button");
    button.textContent = cell.textContent;
    button.title = "Show the first";
    button.addEventListener("click", () => this.#app.show(first));
    cell.replaceChildren(button);
    return cell;
  }
}

const pixelsOf = ({pixels}: Catch): string => (pixels === 1 ? "1 pixel" : `${grouped(pixels)} pixels`);

/** Copies the address, and says so. */
export function copyLink(address: string, more = ""): void {
  history.replaceState(null, "", address);
  const copied = navigator.clipboard?.writeText(location.href) ?? Promise.reject(new Error("no clipboard"));
  copied.then(() => tell(`The link is copied.${more}`), () => tell(`The link is in the address bar.${more}`));
}

function elementOf(kind: "td" | "th" | "dt" | "dd", text: string): HTMLElement {
  const element = document.createElement(kind);
  element.textContent = text;
  return element;
}

/** What the settings say of a model. */
export const sizeOf = (app: App): string => `${grouped(triangleCount(app.model))} triangles in ${grouped(app.model.names.length)} objects`;
