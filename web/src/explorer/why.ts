// Why an agent takes its move: how its policy rates each one, term by term where the rating is a sum.

import { INPUTS } from "../engine/tables.ts";
import type { InputName, RatedMoves } from "../engine/types.ts";
import { html } from "../page/dom.ts";
import { ACTIONS } from "../page/names.ts";
import { weightsOf } from "./data.ts";
import type { ProgramText, RatesMoves } from "./data.ts";
import { signed } from "./format.ts";

/** Stand for the actions where there is little room. */
const ARROWS = ["stay", "↑", "→", "↓", "←", "↗", "↘", "↙", "↖"];

/** Return the inputs that a policy reads, those of weighted sums by the size of their weights. */
export function inputsRead(policy: RatesMoves, program: ProgramText | null): InputName[] {
  const weights = weightsOf(policy, program);
  if (weights) {
    const size = (input: InputName): number => Math.abs(weights[input] ?? 0);
    return policy.inputs.filter(size).sort((a, b) => size(b) - size(a));
  }
  return policy.inputs.filter((input) => !program || new RegExp(`\\b${input}\\b`).test(program.expression));
}

/**
 * Return a table with a column for each move: the rating, and below it of a weighted sum the terms,
 * weight times input, the largest weights first, of other policies the inputs that they read. What
 * is the same for all moves decides nothing. The move that is `asked` is on the board.
 */
export function whyTable(
  policy: RatesMoves,
  { inputs, ratings, refused }: RatedMoves,
  taken: number | null,
  asked: number | null,
  program: ProgramText | null,
): HTMLElement[] {
  const weights = weightsOf(policy, program);
  const style = (move: number): string =>
    `${move === taken ? "taken" : ""} ${refused[move] ? "refused" : ""} ${move === asked ? "asked" : ""}`;
  const row = (head: HTMLElement, numbers: Float32Array): HTMLElement =>
    html(
      "tr",
      { class: numbers.every((number) => number === numbers[0]) ? "same" : "" },
      head,
      ...Array.from(numbers, (number, move) => html("td", { class: style(move) }, signed(number))),
    );
  const name = (input: InputName): HTMLElement => {
    const weight = weights ? `weight ${signed(weights[input]!)} x ` : "";
    const title = `${weight}${INPUTS[input]}`;
    return html("th", { scope: "row", title }, input.replaceAll("_", " "));
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
      ...inputsRead(policy, program).map((input) => {
        const weight = weights ? weights[input]! : 1;
        const values = inputs[policy.inputs.indexOf(input)]!;
        return row(
          name(input),
          values.map((value) => weight * value),
        );
      }),
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
