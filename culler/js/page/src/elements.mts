// SPDX-License-Identifier: MIT

export const byId = <Kind extends HTMLElement = HTMLElement>(id: string): Kind => document.getElementById(id) as Kind;
export const inputOf = (id: string): HTMLInputElement => byId<HTMLInputElement>(id);

export function onClick(id: string, action: () => void): void {
  byId(id).addEventListener("click", action);
}
export function press(id: string, isPressed: boolean): void {
  byId(id).setAttribute("aria-pressed", String(isPressed));
}
export const grouped = (number: number): string => Math.round(number).toLocaleString("en-US");

let fading: ReturnType<typeof setTimeout> | undefined;
/** Says something for a while, or until the next. */
export function tell(text: string, seconds = 8): void {
  const toast = byId("toast");
  toast.textContent = text;
  toast.hidden = false;
  clearTimeout(fading);
  fading = setTimeout(() => (toast.hidden = true), 1000 * seconds);
}
