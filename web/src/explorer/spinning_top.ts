// The spinning top of a race: the intransitivity of each generation at its strength.

import { html, svg } from "../page/dom.ts";
import { listenToArrows } from "./arrow_keys.ts";
import { chart, frame, legend } from "./chart.ts";
import type { Frame } from "./chart.ts";
import { TEAMS } from "./data.ts";
import type { Run, Team } from "./data.ts";
import { card } from "./panel.ts";
import type { Panel } from "./panel.ts";
import type { Store } from "./store.ts";

/** Pursuers are on the left. */
const SIDES: Readonly<Record<Team, -1 | 1>> = { pursuer: -1, evader: 1 };

export function spinningTopPanel(run: Run, store: Store): Panel | null {
  const tops = run.findings?.spinning_top;
  if (!tops) return null;
  const most = 1.05 * Math.max(0.05, ...tops.pursuers.high, ...tops.evaders.high);
  const dots = TEAMS.flatMap((team) => {
    const { generations, strength, intransitivity, low, high } = tops[`${team}s`];
    const side = SIDES[team];
    return generations.map((generation, i) =>
      ({ team, generation, y: strength[i]!, x: side * intransitivity[i]!, low: side * low[i]!, high: side * high[i]! }));
  });
  const dot = (into: Frame, { team, x, y }: (typeof dots)[number], r: number, style: string): SVGElement =>
    svg("circle", { cx: into.x(x), cy: into.y(y), r, class: `${style} of-${team}s` });
  const made = chart("Intransitivity of each generation at its strength. Arrow keys choose generations.", (width, height) => {
    const into = frame(width, height, { low: -most, high: most, label: "intransitivity", mirrored: true }, { low: 0, high: 1, label: "strength" });
    into.root.insertBefore(svg("line", { x1: into.x(0), x2: into.x(0), y1: into.top, y2: into.bottom, class: "axis" }), into.marks);
    for (const each of dots) {
      const ends = { x1: into.x(each.low), x2: into.x(each.high), y1: into.y(each.y), y2: into.y(each.y) };
      into.root.insertBefore(svg("line", { ...ends, class: `line raw of-${each.team}s` }), into.marks);
      into.root.insertBefore(dot(into, each, 4.5, "dot"), into.marks);
    }
    return into;
  }, (into) => {
    const chosen = dots.filter(({ team, generation }) => generation === (store.hover[team] ?? store.selected[team]));
    into.marks.append(...chosen.map((each) => dot(into, each, 7, "dot")));
  }, (_, into, event) => {
    const box = into.root.getBoundingClientRect();
    const away = ({ x, y }: (typeof dots)[number]): number =>
      Math.hypot(into.x(x) - (event.clientX - box.left), into.y(y) - (event.clientY - box.top));
    const { team, generation } = dots.reduce((one, other) => (away(other) < away(one) ? other : one));
    store.select({ [team]: generation });
  });
  listenToArrows(made.element, store, () => run.payoff.shape);
  const element = card("Strength and cycles",
    "A dot is a generation: the higher, the stronger; the farther out, the more its results deviate from every order of strength. Lines: 95 % intervals, without episode noise.",
    legend(["pursuers, left", "of-pursuers"], ["evaders, right", "of-evaders"]), made.element,
    html("p", { class: "small numbers" }, (run.findings?.game ?? []).join(" · ")));
  element.classList.add("spinning-top");
  return { element, update: made.update };
}
