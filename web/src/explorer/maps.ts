// The maps of a race on which they evolve with the teams: those after a generation, in the order of their worth.

import { listenToArrows } from "./arrow_keys.ts";
import { chart, frame, legend, line, mark } from "./chart.ts";
import type { Run } from "./data.ts";
import { rate } from "./format.ts";
import { card } from "./panel.ts";
import type { Panel } from "./panel.ts";
import type { Store } from "./store.ts";
import { html, svg } from "../page/dom.ts";

/** What a map's walls look like. */
function picture(rows: readonly string[]): SVGSVGElement {
  const walls = rows.flatMap((row, y) => Array.from(row, (cell, x) => (cell === "#" ? `M${x} ${y}h1v1h-1z` : "")));
  const [height, width] = [rows.length, rows[0]!.length];
  return svg("svg", { viewBox: `0 0 ${width} ${height}`, "aria-hidden": "true" },
    svg("rect", { width, height, class: "free" }), svg("path", { d: walls.join(""), class: "walls" }));
}

/** The maps after the newer of the generations that are selected or under the pointer; a click plays the match on one. */
export function mapsPanel(run: Run, store: Store, play: () => void): Panel | null {
  if (!run.maps) return null;
  const { fitness, count, walls, scores } = run.maps;
  const generations = walls.length / count;
  const isScored = (generation: number): boolean => fitness !== "none" && generation > 0;
  const title = html("h3");
  const room = html("div", { class: "maps", role: "group", "aria-label": "Maps" });
  const choose = (number: number): void => {
    store.select({ map: store.selected.map === number ? null : number });
    play();
  };
  const button = (number: number): HTMLElement => {
    const [place, worth] = [(number % count) + 1, isScored(Math.floor(number / count)) ? rate(scores[number]!, 3) : "-"];
    return html("button", { type: "button", "data-map": number, title: "Play the match here; once more: as in the evaluation", "aria-label": `Map ${place}, ${fitness} ${worth}`, onclick: () => choose(number) },
      picture(walls[number]!), html("span", { class: "small numbers" }, worth));
  };
  const newest = (): number => Math.min(generations - 1,
    Math.max(store.hover.pursuer ?? store.selected.pursuer, store.hover.evader ?? store.selected.evader));
  const of = (generation: number): readonly number[] => scores.slice(generation * count, (generation + 1) * count);
  const all = Array.from({ length: generations }, (_, generation) => generation);
  const curve = (value: (all: readonly number[]) => number) => all.map((generation) => (isScored(generation) ? value(of(generation)) : null));
  const [best, mean] = [curve((each) => each[0]!), curve((each) => each.reduce((a, b) => a + b) / count)];
  const [low, high] = [Math.min(...mean.filter((each) => each !== null)), Math.max(...scores)];
  const margin = 0.06 * (high - low || 1);
  const made = chart(`Worth of the maps by generation: ${fitness}. Arrow keys choose generations.`, (width, height) => {
    const into = frame(width, height, { low: 0, high: generations - 1, label: "generation", whole: true }, { low: low - margin, high: high + margin, label: fitness });
    line(into, all, best, "of-both");
    line(into, all, mean, "of-both dashed");
    return into;
  }, (into) => mark(into, newest(), "of-both"), (value) => {
    const generation = Math.min(generations - 1, Math.max(0, Math.round(value)));
    store.select({ pursuer: generation, evader: generation });
  });
  listenToArrows(made.element, store, () => run.payoff.shape);
  let shown = -1;
  const element = card("Maps",
    "Both teams learned on these maps, which evolve with them. Click one: the match is played there.",
    title, room, ...(fitness === "none" ? [] : [legend([`${fitness}: the best map`, "of-both"], ["mean of all", "of-both dashed"]), made.element]));
  element.classList.add("maps-panel");
  return {
    element,
    update: () => {
      made.update();
      const generation = newest();
      if (shown !== generation) {
        title.textContent = `After generation ${generation}${generation ? "" : ", drawn at random"}`;
        room.replaceChildren(...of(generation).map((_, place) => button(generation * count + place)));
        shown = generation;
      }
      for (const each of room.children) each.ariaPressed = String(Number((each as HTMLElement).dataset["map"]) === store.selected.map);
    },
  };
}
