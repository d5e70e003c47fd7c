// All runs of the page beside each other: a small matrix, the name, and what is present.

import { html } from "../page/dom.ts";
import type { Run } from "./data.ts";
import { gameWords } from "./game.ts";
import { drawCells } from "./heatmap.ts";
import type { Store } from "./store.ts";

const SIDE = 84;

/** Return the tabs of the runs. They show the selected cell in every matrix. */
export function raceTabs(runs: readonly Run[], store: Store): HTMLElement {
  const tabs = runs.map((run, number) => tab(run, number, store));
  const list = html("nav", { class: "races", "aria-label": "Runs" }, ...tabs.map((each) => each.button));
  const update = (): void => tabs.forEach((each, number) => each.update(number === store.selected.run));
  store.on("match hover", update);
  update();
  list.hidden = runs.length < 2;
  return list;
}

function tab(
  run: Run,
  number: number,
  store: Store,
): { button: HTMLButtonElement; update(selected: boolean): void } {
  const [rows, columns] = run.payoff.shape;
  // Directories of a job are named after what the tab says anyway.
  const named = !run.name.startsWith(run.schedule);
  const cell = SIDE / Math.max(rows, columns);
  const canvas = html("canvas", { "aria-hidden": "true" });
  drawCells(canvas, run.payoff, { left: 0, top: 0, width: columns * cell, height: rows * cell });
  const mark = html("span", { class: "place" });
  const button = html(
    "button",
    {
      type: "button",
      class: "race",
      title: `${run.name} (key ${number + 1})`,
      onclick: () => choose(run, number, store),
    },
    html("span", { class: "small-matrix" }, canvas, mark),
    html(
      "span",
      { class: "race-text" },
      html("strong", {}, named ? run.name : run.schedule),
      html(
        "span",
        { class: "small" },
        run.findings
          ? run.findings.sentence
          : `${run.learning.map((team) => gameWords(run).teams[team]).join(" and ")} against ${scriptOf(run)}`,
      ),
      html("span", { class: "small muted" }, `${named ? `${run.schedule}, ` : ""}seed ${run.seed}`),
    ),
  );
  const update = (selected: boolean): void => {
    button.setAttribute("aria-current", String(selected));
    const g = store.hover.pursuer ?? store.selected.pursuer;
    const h = store.hover.evader ?? store.selected.evader;
    mark.hidden = g >= rows || h >= columns;
    mark.style.left = `${(h + 0.5) * cell}px`;
    mark.style.top = `${(rows - g - 0.5) * cell}px`;
  };
  return { button, update };
}

const scriptOf = (run: Run): string => run.teams.pursuer.script ?? run.teams.evader.script ?? "another run";

/** Select a run; generations that it does not have become its last ones. */
export function choose(run: Run, number: number, store: Store): void {
  const [rows, columns] = run.payoff.shape;
  const { pursuer, evader } = store.selected;
  store.select({ run: number, pursuer: Math.min(pursuer, rows - 1), evader: Math.min(evader, columns - 1) });
}
