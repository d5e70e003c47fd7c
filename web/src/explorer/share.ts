// What is shown, for others: a link to the match and its step, and a GIF of it.

import { gifOf } from "../board/gif.ts";
import { copyField, dialog, readOnly, saveFile } from "../page/dialog.ts";
import { hasAddress, html } from "../page/dom.ts";
import type { MatchPanel } from "./match.ts";
import type { Store } from "./store.ts";

/** Return the button and the dialog that it opens. */
export function share(match: MatchPanel, store: Store): { button: HTMLElement; dialog: HTMLDialogElement } {
  const link = readOnly("Link to this step");
  const told = html("p", { class: "muted small", role: "status" });
  const save = async (): Promise<void> => {
    if (!match.recording) return;
    const { pursuer, evader } = store.selected;
    gif.disabled = true;
    const file = await gifOf(match.recording, (percent) => (told.textContent = `Drawing: ${percent} %`));
    saveFile(`pursuers-${pursuer}-evaders-${evader}.gif`, file);
    told.textContent = `Saved, ${(file.size / 1e6).toFixed(1)} MB.`;
    gif.disabled = false;
  };
  const gif = html("button", { type: "button", class: "save-gif", onclick: save }, "Save the match as a GIF of 10 s");
  const made = dialog("Share this match", "share", gif,
    hasAddress() && copyField("The link leads to this step in the same file. Nothing is sent anywhere.", link, told), told);
  const open = (): void => {
    store.dispatchEvent(new Event("rest"));
    link.value = location.href;
    told.textContent = "";
    made.showModal();
  };
  return { button: html("button", { type: "button", class: "to-share", onclick: open }, "Share"), dialog: made };
}
