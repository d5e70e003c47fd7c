// Scores of the last generations against opponents that no run has met.

import { html } from "../page/dom.ts";
import type { HeldOut, Interval, Run } from "./data.ts";
import { interval } from "./format.ts";
import { card } from "./panel.ts";
import type { Panel } from "./panel.ts";

export function heldOutPanel(run: Run): Panel | null {
  const scores = [run.held_out?.pursuers, run.held_out?.evaders].filter((each) => each !== null && each !== undefined);
  if (!scores.length) return null;
  return {
    element: card("Held-out opponents", `The last generations against opponents that no run has met; 95 % intervals over ${scores[0]!.episodes} episodes.`,
      ...scores.map(tableOf)),
  };
}

function tableOf(scores: HeldOut): HTMLElement {
  const last = (intervals: readonly Interval[]): Interval => intervals.at(-1)!;
  const rows = [["mean", last(scores.mean)] as const, ...Object.entries(scores.against).map(([name, each]) => [name, last(each)] as const)];
  return html("table", { class: "scores numbers" },
    html("caption", {}, html("span", { class: scores.team }, `${scores.team}s`), ` of generation ${scores.generations.at(-1)}, ${scores.score}`),
    ...rows.map(([name, each], place) => html("tr", { class: place ? "" : "mean" },
      html("th", { scope: "row" }, name), html("td", { class: "range" }, rangeOf(each, scores.team)),
      html("td", {}, interval(each.value, each.low, each.high)))));
}

function rangeOf({ value, low, high }: Interval, team: string): HTMLElement {
  const bar = html("span", { class: `between ${team}` });
  bar.style.left = `${100 * (low ?? value)}%`;
  bar.style.width = `${100 * ((high ?? value) - (low ?? value))}%`;
  const dot = html("span", { class: `value ${team}` });
  dot.style.left = `${100 * value}%`;
  return html("span", { class: "scale", "aria-hidden": "true" }, bar, dot);
}
