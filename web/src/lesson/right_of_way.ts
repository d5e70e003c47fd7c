// Who may enter a free cell: an arrow for a pursuer that may go, a bar for one that waits.

import { html, svg } from "../page/dom.ts";
import type { Crossing, WidgetPart } from "./data.ts";

const CELL = 32;

export const rightOfWay = ({ crossings = [] }: WidgetPart): HTMLElement =>
  html("div", { class: "widget crossings" }, ...crossings.map((each) => html("figure", {},
    html("figcaption", {}, each.title), picture(each), html("p", { class: "small muted" }, each.text))));

/** Return nine cells, with pursuers around the one in the middle. */
function picture({ title, text, ways }: Crossing): SVGElement {
  const lines = [0, 1, 2, 3].map((at) => `M${at * CELL} 0V${3 * CELL}M0 ${at * CELL}H${3 * CELL}`).join("");
  return svg("svg", { viewBox: `-1 -1 ${3 * CELL + 2} ${3 * CELL + 2}`, role: "img", "aria-label": `${title}: ${text}` },
    svg("path", { class: "grid", d: lines }),
    ...ways.map(([down, right, goes], agent) => svg("g", { transform: `translate(${1.5 * CELL} ${1.5 * CELL})` },
      svg("g", { transform: `translate(${-CELL * right} ${-CELL * down})` },
        svg("path", { class: "filled-pursuer", d: "M0 -12 12 9H-12z" }),
        svg("text", { y: 6.5, "text-anchor": "middle" }, `P${agent}`)),
      // Drawn for a move to the right, and turned.
      svg("path", { class: goes ? "goes" : "waits", d: goes ? "M-18 0H-5M-9 -4 -4 0 -9 4" : "M-16 -13V13",
        transform: `rotate(${(Math.atan2(down, right) * 180) / Math.PI})` }))));
}
