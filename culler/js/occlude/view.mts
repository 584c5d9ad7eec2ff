// SPDX-License-Identifier: MIT
import {cameraOf, type Camera} from "./cameras.mjs";
import type {Library} from "./library.mjs";
import {boxesOf, type Boxes} from "./numbers.mjs";
import {Disposable} from "./resource.mjs";

/** Of a box in the last frame of a view. `visible`: neither of the other two could be proved. */
export type Visibility = "visible" | "occluded" | "out_of_view";
const visibilities: readonly Visibility[] = ["visible", "occluded", "out_of_view"];

/** Asks a function of C that writes whether something holds. */
export function asked(library: Library, ask: (holds: number) => number): boolean {
  return library.using(scratch => {
    const holds = scratch.room(4);
    library.check(ask(holds));
    return library.memory.getInt32(holds, true) !== 0;
  });
}

/** Asks a function of C whether the last frame of a view does for the camera, too. */
export function holdsFor(view: Disposable, ask: "occlude_view_holds_for" | "occlude_model_view_holds_for", camera: Camera): boolean {
  const {library, pointer} = view.resource;
  return library.using(scratch => {
    const {place, suffix} = cameraOf(scratch, camera);
    return asked(library, holds => library.c[`${ask}${suffix}`]!(pointer, place, holds));
  });
}

/** One camera of a scene, and its last frame. It may be used with any scene at any time. */
export class View extends Disposable {
  /** @internal */
  constructor(library: Library) {
    super(library, (_, place) => library.c.occlude_view_create!(place), "occlude_view_destroy");
  }

  /**
   * Whether the last frame does for this camera, too: it leaves out nothing that the camera shows from its eye and from all
   * of its `eyes`. Never true by rounding, and not before the first frame.
   */
  holdsFor(camera: Camera): boolean {
    return holdsFor(this, "occlude_view_holds_for", camera);
  }

  /** Whether boxes, such as those of objects about to be added, would be visible in the last frame; before it all are. */
  visibility(boxes: Boxes): Visibility[] {
    const {library, pointer} = this.resource;
    return library.using(scratch => {
      const {place, count} = boxesOf(scratch, boxes);
      const answers = scratch.room(4 * count);
      library.check(library.c.occlude_view_visibility!(pointer, place, answers));
      return Array.from(library.words(answers, count), answer => visibilities[answer]!);
    });
  }
}
