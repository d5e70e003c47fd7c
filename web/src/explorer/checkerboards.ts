// Checkerboards: two pursuer and two evader generations, each better against one opponent.

import { html } from "../page/dom.ts";
import type { Checkerboard, Run } from "./data.ts";
import { gameWords, generationName, sidesOf } from "./game.ts";
import { showRate } from "./heatmap.ts";
import { card } from "./panel.ts";
import type { Panel } from "./panel.ts";
import type { Store } from "./store.ts";

/** The strongest ones; `play` plays the match of a cell that is pressed. */
export function checkerboardPanel(run: Run, store: Store, play: () => void): Panel | null {
  const { findings } = run;
  const { teams, click } = gameWords(run);
  if (!findings?.table.length || !findings.checkerboards) return null; // beside the judgement
  const boards = findings.checkerboards.map((board) =>
    miniature(run, board, (pursuer, evader) => {
      store.select({ pursuer, evader });
      play();
    }),
  );
  return {
    element: card(
      "Checkerboards",
      `${sidesOf(run).length > 1 ? "Two generations of each team" : "Two generations against two others"}: each generation of the ${teams.pursuer} is better against another one of the ${teams.evader}. Click a cell to ${click}.`,
      boards.length
        ? html("div", { class: "boards" }, ...boards)
        : html("p", {}, `No four cells differ by more than ${findings.margin} in this way.`),
      boards.length && !run.game?.exact
        ? html(
            "p",
            { class: "small muted" },
            "The strongest of all pairs, so noise makes them look stronger than they are. The diagnosis says whether there are more than noise makes.",
          )
        : null,
    ),
  };
}

function miniature(
  run: Run,
  { pursuers, evaders }: Checkerboard,
  choose: (pursuer: number, evader: number) => void,
): HTMLElement {
  const cell = (g: number, h: number): HTMLElement => {
    const made = html("button", { type: "button", class: "cell", onclick: () => choose(g, h) });
    showRate(
      made,
      run.payoff.capture_rate[g]![h]!,
      `${generationName(run, "pursuer", g)} against ${generationName(run, "evader", h)}`,
    );
    return made;
  };
  return html(
    "div",
    { class: "miniature numbers" },
    html("span"),
    ...evaders.map((h) => html("span", { class: "evader" }, h)),
    ...pursuers.flatMap((g) => [html("span", { class: "pursuer" }, g), ...evaders.map((h) => cell(g, h))]),
  );
}
