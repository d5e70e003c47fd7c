// Why an agent takes its move: how its policy rates each one, term by term where it is a sum.

import type { ProgramPolicy, RatedMoves, RatingPolicy } from "../engine/types.ts";
import { INPUTS } from "../engine/tables.ts";
import { html } from "../page/dom.ts";
import { ACTIONS } from "../page/names.ts";

const ARROWS = ["•", "↑", "→", "↓", "←", "↗", "↘", "↙", "↖"];

/** Return a number of a policy as a reader takes it in. */
const shown = (number: number): string => {
  const size = Math.abs(number);
  const text = size >= 1e5 ? size.toExponential(0) : size.toFixed(size < 10 ? 2 : size < 100 ? 1 : 0);
  return number < 0 && Number(text) ? `−${text}` : text;
};

/**
 * Return a table with a column for each move, and the sentence that says how to read it. A weighted sum shows its
 * terms, weight times input, the largest weights first; other policies show the inputs that they read.
 */
export function whyTable(policy: RatingPolicy | ProgramPolicy, rated: RatedMoves, taken: number | null, text: string): HTMLElement[] {
  const weights = policy.kind === "rating" && !policy.hidden.length ? policy.genome : null;
  const reads = (name: string, input: number): boolean =>
    weights ? weights[input] !== 0 : policy.kind === "rating" || new RegExp(`\\b${name}\\b`).test(text);
  const read = policy.inputs.map((name, input) => ({ name, input })).filter(({ name, input }) => reads(name, input));
  if (weights) read.sort((a, b) => Math.abs(weights[b.input]!) - Math.abs(weights[a.input]!));
  const state = (move: number): string => [move === taken ? "taken" : "", rated.refused[move] ? "refused" : ""].join(" ").trim();
  const row = (head: readonly HTMLElement[], numbers: Float32Array): HTMLElement =>
    html("tr", {}, ...head, ...Array.from(numbers, (number, move) => html("td", { class: state(move) }, shown(number))));
  const wide = weights ? 2 : 1;
  const name = (name: keyof typeof INPUTS): HTMLElement => html("th", { scope: "row", title: INPUTS[name] }, name.replaceAll("_", " "));
  const table = html("table", { class: "why numbers" },
    html("thead", {}, html("tr", {}, html("th", {}, weights ? "term" : "input"), weights && html("th", {}, "weight"),
      ...Array.from(rated.ratings, (_, move) => html("th", { scope: "col", class: state(move), title: ACTIONS[move] + (rated.refused[move] ? ", which the mask forbids" : "") },
        html("span", { "aria-hidden": "true" }, ARROWS[move]), html("span", { class: "heard" }, ACTIONS[move]))))),
    html("tbody", {}, ...read.map(({ name: each, input }) => row(
      [name(each), ...(weights ? [html("td", { class: "muted" }, shown(weights[input]!))] : [])],
      weights ? rated.inputs[input]!.map((number) => number * weights[input]!) : rated.inputs[input]!))),
    html("tfoot", {}, row([html("th", { scope: "row", colspan: wide }, weights ? "sum" : "rating")], rated.ratings)));
  return [
    ...(text ? [html("p", { class: "program" }, html("code", {}, text))] : []),
    html("div", { class: "wide-table", tabindex: 0, role: "group", "aria-label": "Ratings of the moves" }, table),
  ];
}
