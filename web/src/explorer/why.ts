// Why an agent takes its move: how its policy rates each one, term by term where the rating is a sum.

import { INPUTS } from "../engine/tables.ts";
import type { RatedMoves } from "../engine/types.ts";
import { html } from "../page/dom.ts";
import { ACTIONS } from "../page/names.ts";
import { weightsOf } from "./data.ts";
import type { ProgramText, RatesMoves } from "./data.ts";
import { signed } from "./format.ts";

/** Stand for the actions where there is little room. */
const ARROWS = ["stay", "↑", "→", "↓", "←", "↗", "↘", "↙", "↖"];

/**
 * Return a table with a column for each move: the rating, and below it of a weighted sum the terms,
 * weight times input, the largest weights first, of other policies the inputs that they read. What
 * is the same for all moves decides nothing.
 */
export function whyTable(
  policy: RatesMoves,
  { inputs, ratings, refused }: RatedMoves,
  taken: number | null,
  program: ProgramText | null,
): HTMLElement[] {
  const weights = weightsOf(policy, program);
  const weightOf = (input: number): number => (weights ? (weights[policy.inputs[input]!] ?? 0) : 1);
  const reads = (input: number): boolean =>
    weights || !program
      ? weightOf(input) !== 0
      : new RegExp(`\\b${policy.inputs[input]}\\b`).test(program.expression);
  const read = [...policy.inputs.keys()]
    .filter(reads)
    .sort((a, b) => Math.abs(weightOf(b)) - Math.abs(weightOf(a)));
  const style = (move: number): string =>
    `${move === taken ? "taken" : ""} ${refused[move] ? "refused" : ""}`;
  const row = (head: HTMLElement, numbers: Float32Array): HTMLElement =>
    html(
      "tr",
      { class: numbers.every((number) => number === numbers[0]) ? "same" : "" },
      head,
      ...Array.from(numbers, (number, move) => html("td", { class: style(move) }, signed(number))),
    );
  const name = (input: number): HTMLElement => {
    const each = policy.inputs[input]!;
    return html(
      "th",
      { scope: "row", title: `${weights ? `weight ${signed(weightOf(input))} x ` : ""}${INPUTS[each]}` },
      each.replaceAll("_", " "),
    );
  };
  const table = html(
    "table",
    { class: "why numbers" },
    html(
      "thead",
      {},
      html(
        "tr",
        {},
        html("th", {}, weights ? "term" : "input"),
        ...Array.from(ratings, (_, move) =>
          html(
            "th",
            { scope: "col", class: style(move), title: ACTIONS[move], "aria-label": ACTIONS[move] },
            ARROWS[move],
          ),
        ),
      ),
      row(html("th", { scope: "row" }, weights ? "sum" : "rating"), ratings),
    ),
    html(
      "tbody",
      {},
      ...read.map((input) =>
        row(
          name(input),
          inputs[input]!.map((number) => weightOf(input) * number),
        ),
      ),
    ),
  );
  return [
    ...(program ? [html("p", { class: "expression" }, html("code", {}, program.expression))] : []),
    html(
      "div",
      { class: "wide-table", tabindex: 0, role: "group", "aria-label": "How the moves are rated" },
      table,
    ),
  ];
}
