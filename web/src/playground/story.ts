// What happened in the step that is shown, in words, for each set of rules.

import { html } from "../page/dom.ts";
import { rulesName } from "./arena.ts";
import type { Store } from "./store.ts";
import { linesOf, unbroken } from "./words.ts";
import type { Line } from "./words.ts";

const LABELS: Record<Line["kind"], string> = {
  obstacle: "obstacle",
  teammate: "teammates",
  adversary: "adversaries",
  capture: "capture",
  end: "end",
  calm: "",
};

/** Return the card with the words; what is new is also told to readers who hear the page. */
export function story(store: Store): HTMLElement {
  const title = html("h2");
  const body = html("div", {
    class: "story-body",
    tabindex: 0,
    role: "region",
    "aria-label": "What happened",
  });
  const heard = html("div", { class: "heard", role: "status" });
  const element = html("section", { class: "card story" }, title, body, heard);
  let shown = "";
  store.shownBy(() => {
    const step = Math.min(store.player.step, store.game.length);
    const parts = store.games.map((game, place) => {
      // Where the episode has ended earlier, nothing happens any more.
      const lines = linesOf(store.scene, game, step);
      return {
        name: store.games.length > 1 ? rulesName(store, place) : "",
        lines,
        ended: step > game.length,
      };
    });
    const key = JSON.stringify([step, parts]);
    if (key === shown) return;
    shown = key;
    title.textContent = step ? `Step ${step}` : "Start";
    body.replaceChildren(...parts.map((part) => section(part, step)));
    heard.textContent = step ? `Step ${step}. ${parts.map(spoken).join(" ")}` : "";
  });
  return element;
}

interface Part {
  readonly name: string;
  readonly lines: readonly Line[];
  readonly ended: boolean;
}

function section({ name, lines, ended }: Part, step: number): HTMLElement {
  const hint = ended ? "The episode had ended." : "Give agents their moves, then play a step.";
  const told =
    ended || !step ? html("p", { class: "muted" }, hint) : html("ul", { class: "lines" }, ...lines.map(item));
  return html("div", { class: "story-part" }, name && html("h3", {}, name), told);
}

function item({ kind, text, turn, blame, cost }: Line): HTMLElement {
  const label = turn ? `${LABELS[kind]}, turn ${turn}` : LABELS[kind];
  return html(
    "li",
    { class: `line line-${kind}` },
    label && html("span", { class: "tag" }, label),
    html("span", { class: "line-text" }, ...unbroken(text)),
    blame && html("span", { class: "line-blame muted" }, blame),
    cost && html("strong", {}, cost),
  );
}

const spoken = ({ name, lines, ended }: Part): string =>
  [
    name,
    ...(ended
      ? ["The episode had ended."]
      : lines.map(({ text, blame, cost }) => [text, blame, cost].filter(Boolean).join(" "))),
  ]
    .filter(Boolean)
    .join(" ");
