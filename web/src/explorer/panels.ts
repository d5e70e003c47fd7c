// What belongs to a run below its matrix: diagnosis, curves, checkerboards, settings.

import { html } from "../page/dom.ts";
import { checkerboardPanel } from "./checkerboards.ts";
import { ciaoPanel } from "./ciao.ts";
import { jointPanel, ratingPanel, trainingPanel } from "./curves.ts";
import type { Run } from "./data.ts";
import { evolvedPanel } from "./evolved.ts";
import { diagnosisPanel, settingsPanel } from "./panel.ts";
import type { Panel } from "./panel.ts";
import type { Store } from "./store.ts";

/** Return the panels of the selected run; those of the others are made when they are first shown. */
export function panels(runs: readonly Run[], store: Store, play: () => void): HTMLElement {
  const made = new Map<Run, readonly Panel[]>();
  const place = html("div", { class: "panels" });
  let shown: readonly Panel[] = [];
  const update = (): void => shown.forEach((panel) => panel.update?.());
  const change = (): void => {
    const run = runs[store.selected.run]!;
    shown = made.get(run) ?? panelsOf(run, store, play);
    made.set(run, shown);
    place.replaceChildren(...shown.map((panel) => panel.element));
    update();
  };
  store.on("run", change);
  store.on("match hover", update);
  change();
  return place;
}

function panelsOf(run: Run, store: Store, play: () => void): Panel[] {
  const all = [
    jointPanel(run),
    diagnosisPanel(run),
    evolvedPanel(run, store),
    trainingPanel(run, store),
    checkerboardPanel(run, store, play),
    ratingPanel(run, store),
    ciaoPanel(run, store),
    settingsPanel(run),
  ];
  return all.filter((panel) => panel !== null);
}
