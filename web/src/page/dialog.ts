// Dialogs with a head, keys in a list, fields to copy from, and files to save.

import { html } from "./dom.ts";
import type { Child } from "./dom.ts";

/** Return a dialog with a title and a button that closes it; so does a press on the ground around it. */
export function dialog(title: string, style: string, ...children: Child[]): HTMLDialogElement {
  const made = html(
    "dialog",
    {
      class: style,
      "aria-label": title,
      onclick: ({ target }: MouseEvent) => target === made && made.close(),
    },
    html(
      "div",
      { class: "dialog-head" },
      html("h2", {}, title),
      html(
        "button",
        { type: "button", class: "close", "aria-label": "Close", onclick: () => made.close() },
        "✕",
      ),
    ),
    ...children,
  );
  return made;
}

/** Keys and what they do. */
export type Keys = readonly (readonly [keys: readonly string[], text: string])[];

export const keyList = (keys: Keys): HTMLElement =>
  html(
    "dl",
    { class: "keys" },
    ...keys.flatMap(([names, text]) => [
      html("dt", {}, ...names.map((name) => html("kbd", {}, name))),
      html("dd", {}, text),
    ]),
  );

export const readOnly = (label: string): HTMLInputElement =>
  html("input", { type: "text", readonly: true, "aria-label": label });

/** Show a link in a field, and copy it where the browser allows it. */
export function copyLink(field: HTMLInputElement, link: string): void {
  field.value = link;
  field.hidden = false;
  field.select();
  void navigator.clipboard?.writeText(link).catch(() => {}); // it is selected: Ctrl+C copies it
}

/** Let the browser save a file. */
export function saveFile(name: string, content: BlobPart): void {
  const place = URL.createObjectURL(new Blob([content], { type: "application/octet-stream" }));
  html("a", { href: place, download: name }).click();
  setTimeout(() => URL.revokeObjectURL(place), 60_000); // the browser has read it by then
}
