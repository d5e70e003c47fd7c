// CIAO: current individuals against ancestral opponents, a triangle for each team.

import { otherOf } from "../engine/teams.ts";
import type { Team } from "../engine/teams.ts";
import { html, svg } from "../page/dom.ts";
import { listenToArrows } from "./arrow_keys.ts";
import type { Run } from "./data.ts";
import { rate } from "./format.ts";
import { gameWords, sidesOf } from "./game.ts";
import { cellsOf, scaleOfRates } from "./heatmap.ts";
import { card } from "./panel.ts";
import type { Panel } from "./panel.ts";
import type { Store } from "./store.ts";

export function ciaoPanel(run: Run, store: Store): Panel | null {
  const both = run.findings?.ciao;
  if (!both) return null;
  const triangles = sidesOf(run).map((team) => {
    const { fading, stripes, period } = both[`${team}s`];
    const numbers = `fading ${rate(fading)}, stripes ${rate(stripes)}${period === null ? "" : ` every ${period} generations`}`;
    return triangle(run, team, numbers, store);
  });
  return {
    element: card(
      "CIAO: current individuals against ancestral opponents",
      "The team's own score. Stripes: intransitive, since wins and losses alternate with the age of the opponent; whether a team returns to earlier strategies is recurrence, under What happened. Darker away from the diagonal: forgetting.",
      html("div", { class: "triangles" }, ...triangles.map((each) => each.element)),
      run.payoff.others ? scaleOfRates(...gameWords(run).ends) : scaleOfRates("0 loses", "1 wins"),
    ),
    update: () => triangles.forEach((each) => each.update()),
  };
}

function triangle(
  run: Run,
  team: Team,
  numbers: string,
  store: Store,
): { element: HTMLElement; update(): void } {
  const own = team === "pursuer" ? 0 : 1;
  const words = gameWords(run);
  const rows = run.payoff.shape[own];
  const columns = run.payoff.shape[1 - own]!;
  const rates = run.payoff.capture_rate;
  const others = run.payoff.others;
  const scores = Array.from({ length: rows }, (_, row) =>
    Array.from({ length: Math.min(row + 1, columns) }, (_none, column) =>
      team === "pursuer" ? rates[row]![column]! : (others?.[column]![row] ?? 1 - rates[column]![row]!),
    ),
  );
  const canvas = cellsOf({ shape: [rows, columns], first: [0, 0], capture_rate: scores });
  const place = svg("rect", { class: "chosen", width: 1, height: 1 });
  const under = svg("rect", { class: "chosen under", width: 1, height: 1 });
  const overlay = svg(
    "svg",
    { viewBox: `0 0 ${columns} ${rows}`, preserveAspectRatio: "none", "aria-hidden": "true" },
    under,
    place,
  );
  const frame = html(
    "div",
    {
      class: "triangle",
      "aria-label": `CIAO of the ${words.teams[team]}: ${numbers}. Arrow keys choose a match.`,
      onpointermove: (event: PointerEvent) => store.point(at(event) ?? {}),
      onpointerleave: () => store.point({}),
      onclick: (event: MouseEvent) => at(event) && store.select(at(event)!),
    },
    canvas,
    overlay,
  );
  listenToArrows(frame, store, () => run.payoff.shape, team);
  frame.style.aspectRatio = `${columns} / ${rows}`;
  const at = (event: MouseEvent): { [name in Team]: number } | null => {
    const box = frame.getBoundingClientRect();
    const column = Math.floor(((event.clientX - box.left) / box.width) * columns);
    const row = rows - 1 - Math.floor(((event.clientY - box.top) / box.height) * rows);
    return column >= 0 && row < rows && column <= row
      ? ({ [team]: row, [otherOf(team)]: column } as { [name in Team]: number })
      : null;
  };
  const update = (): void => {
    const row = store.hover[team] ?? store.selected[team];
    const column = store.hover[otherOf(team)] ?? store.selected[otherOf(team)];
    for (const each of [place, under]) {
      each.setAttribute("x", String(column));
      each.setAttribute("y", String(rows - 1 - row));
      each.style.display = column <= row ? "" : "none";
    }
  };
  const element = html(
    "figure",
    {},
    html("figcaption", { class: "small" }, html("span", { class: team }, words.teams[team])),
    frame,
    html(
      "p",
      { class: "small muted" },
      `horizontal: ${words.generation[otherOf(team)]}; vertical: ${words.generation[team]}`,
    ),
    html("p", { class: "small numbers" }, numbers),
  );
  return { element, update };
}
