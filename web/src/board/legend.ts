// What the shapes on a board mean, to stand beside it.

import { html, svg } from "../page/dom.ts";

const STAR = Array.from({ length: 16 }, (_, corner) => {
  const reach = corner % 2 ? 6.5 : 11;
  const angle = (Math.PI * corner) / 8;
  return `${12 + reach * Math.sin(angle)} ${12 - reach * Math.cos(angle)}`;
}).join(" ");

/** Return the legend: each shape as the board draws it, and its meaning. */
export function legend(): HTMLElement {
  const shapes: readonly (readonly [meaning: string, shape: SVGElement])[] = [
    ["pursuer", svg("path", { d: "M12 3 22 20H2z", class: "filled-pursuer" })],
    ["evader", svg("circle", { cx: 12, cy: 12, r: 9, class: "filled-evader" })],
    ["capture", svg("polygon", { points: STAR, class: "filled-capture" })],
    ["captured evader", svg("circle", { cx: 12, cy: 12, r: 7.5, class: "ring-evader" })],
    ["conflict", svg("rect", { x: 3, y: 3, width: 18, height: 18, class: "dashed-conflict" })],
  ];
  return html(
    "ul",
    { class: "shapes small", "aria-label": "Shapes on the board" },
    ...shapes.map(([meaning, shape]) =>
      html("li", {}, svg("svg", { viewBox: "0 0 24 24", "aria-hidden": "true" }, shape), meaning),
    ),
  );
}
