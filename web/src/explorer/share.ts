// What is shown, for others: a link to the match and its step, and a GIF of it.

import { gifOf } from "../board/gif.ts";
import { copy, hasAddress, html } from "../page/dom.ts";
import type { MatchPanel } from "./match.ts";
import type { Store } from "./store.ts";

/** Return the button and the dialog that it opens. */
export function share(match: MatchPanel, store: Store): { button: HTMLElement; dialog: HTMLDialogElement } {
  const link = html("input", { type: "text", readonly: true, "aria-label": "Link to this step" });
  const told = html("p", { class: "muted small", role: "status" });
  const save = async (): Promise<void> => {
    if (!match.recording) return;
    const { pursuer, evader } = store.selected;
    gif.disabled = true;
    const file = await gifOf(match.recording, (percent) => (told.textContent = `Drawing: ${percent} %`));
    const place = URL.createObjectURL(file);
    html("a", { href: place, download: `pursuers-${pursuer}-evaders-${evader}.gif` }).click();
    setTimeout(() => URL.revokeObjectURL(place), 60_000); // the browser has read it by then
    told.textContent = `Saved, ${(file.size / 1e6).toFixed(1)} MB.`;
    gif.disabled = false;
  };
  const gif = html("button", { type: "button", class: "save-gif", onclick: save }, "Save the match as a GIF of 10 s");
  const dialog = html("dialog", { class: "share", "aria-labelledby": "share-title" },
    html("h2", { id: "share-title" }, "Share this match"),
    gif,
    hasAddress() && html("p", {}, "The link leads to this step in the same file. Nothing is sent anywhere."),
    hasAddress() && html("div", { class: "link" }, link, html("button", { type: "button", onclick: () => copy(link, told) }, "Copy")),
    told, html("button", { type: "button", onclick: () => dialog.close() }, "Close"));
  dialog.addEventListener("click", (event) => event.target === dialog && dialog.close());
  const open = (): void => {
    store.dispatchEvent(new Event("rest"));
    link.value = location.href;
    told.textContent = "";
    dialog.showModal();
  };
  return { button: html("button", { type: "button", class: "to-share", onclick: open }, "Share"), dialog };
}
