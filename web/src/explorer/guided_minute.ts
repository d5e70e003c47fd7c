// The guided minute: captions that drive the page. Python writes them from what the run shows.

import { stillMotion } from "../board/board.ts";
import { html } from "../page/dom.ts";
import type { Run } from "./data.ts";
import type { MatchPanel } from "./match.ts";
import type { Store } from "./store.ts";

/** Milliseconds of a caption, the time of a whole match; readers who want no motion go on by themselves. */
const REST = 12_000;

/** Return the button that begins, and the bar of the captions. */
export function guidedMinute(runs: readonly Run[], store: Store, match: MatchPanel): { button: HTMLElement; bar: HTMLElement } {
  const stops = () => runs[store.selected.run]!.findings?.guided_minute ?? [];
  const text = html("p", { "aria-live": "polite" });
  const back = html("button", { type: "button", onclick: () => show(at - 1, false) }, "Back");
  const next = html("button", { type: "button", onclick: () => show(at + 1, false) });
  const bar = html("section", { class: "guided card", "aria-label": "A guided minute" },
    text, html("div", {}, back, next, html("button", { type: "button", onclick: () => end() }, "Skip")));
  const button = html("button", { type: "button", class: "begin-minute", onclick: () => show(0, !stillMotion()) }, "A guided minute");
  let [at, due] = [-1, 0];

  function show(place: number, goesOn: boolean): void {
    clearTimeout(due);
    const stop = stops()[place];
    closeFour();
    if (!stop) return end();
    at = place;
    text.replaceChildren(html("span", { class: "muted numbers" }, `${place + 1} of ${stops().length} `), stop.text);
    back.disabled = place === 0;
    next.textContent = place === stops().length - 1 ? "End" : "Next";
    bar.hidden = false;
    store.select({ pursuer: stop.pursuer, evader: stop.evader, map: null });
    if (stop.shows === "judgement") document.querySelector(".diagnosis")?.scrollIntoView({ block: "nearest" });
    else if (stop.shows === "checkerboard") openFour();
    else {
      match.reveal();
      match.playSoon();
    }
    if (goesOn) due = setTimeout(() => show(place + 1, true), REST);
  }

  function end(): void {
    clearTimeout(due);
    at = -1;
    bar.hidden = true;
    button.focus();
  }

  // A dialog lets nothing else be pressed, so the bar goes into it.
  function openFour(): void {
    document.querySelector<HTMLButtonElement>(".miniature")?.click();
    const four = document.querySelector<HTMLDialogElement>("dialog.four[open]");
    four?.append(bar);
    four?.addEventListener("close", () => document.body.append(bar), { once: true });
  }

  const closeFour = (): void => document.querySelector<HTMLDialogElement>("dialog.four[open]")?.close();
  const update = (): void => {
    button.hidden = !stops().length;
    if (!bar.hidden) end();
  };
  store.on("run", update);
  bar.addEventListener("keydown", (event) => {
    if (event.key === "Escape") end();
  });
  bar.hidden = true;
  update();
  return { button, bar };
}
