// SPDX-License-Identifier: MIT

/** What went wrong. `disposed`: the object was disposed of. The others are those of `occlude_status` in occlude.h. */
export type ErrorCode =
  | "invalid_argument"
  | "unknown_id"
  | "out_of_memory"
  | "rounding_mode"
  | "stopped"
  | "failed"
  | "disposed";

/** What every refused call throws, with the text of the library: `box 3: box has min > max`. What throws changes nothing. */
export class OccludeError extends Error {
  override readonly name = "OccludeError";

  constructor(readonly code: ErrorCode, text: string) {
    super(text);
  }
}

const codes: readonly ErrorCode[] = ["invalid_argument", "unknown_id", "out_of_memory", "rounding_mode", "stopped", "failed"];

/** The error of a status that is not 0. */
export const errorOf = (status: number, text: string) => new OccludeError(codes[status - 1] ?? "failed", text);

export function refuse(text: string): never {
  throw new OccludeError("invalid_argument", text);
}
