// SPDX-License-Identifier: MIT
// The address names scene, place and settings, so that they can be passed on.
import type {Place} from "./camera.mjs";
import type {MethodKey} from "./culling.mjs";
import type {Point} from "./points.mjs";

export interface Settings {
  method: MethodKey;
  isCulling: boolean;
  /** Milliseconds; undefined: none. */
  budget: number | undefined;
  /** Seconds for which a cull is held. */
  hold: number;
  isClay: boolean;
  isCatching: boolean;
}

export const defaults: Settings = {method: "polygons", isCulling: true, budget: undefined, hold: 0, isClay: false, isCatching: false};

export interface Address {
  readonly scene?: string | undefined;
  /** Where a model lies. */
  readonly model?: string | undefined;
  readonly place?: Place | undefined;
  /** The number of a place of the flight. */
  readonly frame?: number | undefined;
  /** Of the frame before. */
  readonly before?: Place | undefined;
  readonly settings: Settings;
}

export function parse(hash: string): Address {
  const named = new URLSearchParams(hash.replace(/^#/, ""));
  const number = (name: string) => (named.has(name) && Number(named.get(name)) > 0 ? Number(named.get(name)) : undefined);
  return {
    scene: named.get("scene") ?? undefined,
    model: named.get("model") ?? undefined,
    place: placeOf(named.get("eye"), named.get("target")),
    frame: named.has("frame") ? Number(named.get("frame")) : undefined,
    before: placeOf(named.get("eye0"), named.get("target0")),
    settings: {
      method: named.get("method") === "objects" ? "objects" : defaults.method,
      isCulling: named.get("culling") !== "off",
      budget: number("budget"),
      hold: number("hold") ?? 0,
      isClay: named.has("clay"),
      isCatching: named.has("catch"),
    },
  };
}

export function format({scene, model, place, before, settings}: Address): string {
  const named: [string, string | undefined][] = [
    ["scene", scene],
    ["model", model],
    ["eye", place && textOf(place.eye)],
    ["target", place && textOf(place.target)],
    ["eye0", before && textOf(before.eye)],
    ["target0", before && textOf(before.target)],
    ["method", settings.method === defaults.method ? undefined : settings.method],
    ["culling", settings.isCulling ? undefined : "off"],
    ["budget", settings.budget?.toPrecision(2)],
    ["hold", settings.hold > 0 ? String(settings.hold) : undefined],
    ["clay", settings.isClay ? "1" : undefined],
    ["catch", settings.isCatching ? "1" : undefined],
  ];
  const encoded = (value: string) => encodeURIComponent(value).replaceAll("%2C", ",");
  const said = named.flatMap(([name, value]) => (value === undefined ? [] : [`${name}=${encoded(value)}`]));
  return `#${said.join("&")}`;
}

/** All digits: what a place shows may hang on the last. */
const textOf = (point: Point): string => point.join(",");

function placeOf(eye: string | null, target: string | null): Place | undefined {
  const [from, to] = [eye, target].map(text => (text ?? "").split(",").map(Number));
  const isPlace = [from, to].every(point => point!.length === 3 && point!.every(Number.isFinite)) && from!.some((x, i) => x !== to![i]);
  return isPlace ? {eye: from as unknown as Point, target: to as unknown as Point} : undefined;
}
