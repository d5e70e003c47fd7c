// A small picture of what a player does: agents of its team, those of the other, and their ways.

import { svg } from "../page/dom.ts";
import type { Team } from "../explorer/data.ts";

type Points = readonly (readonly [x: number, y: number])[];

interface Scene {
  readonly own: Points;
  readonly others: Points;
  /** Lines with a head at their end; those of a network have none. */
  readonly ways: readonly Points[];
}

/** On 7 x 5 units, by the name of a script without "careful". */
const SCENES: Readonly<Record<string, Scene>> = {
  random: { own: [[3.5, 2.5]], others: [], ways: [[[4.3, 2.5], [6, 2.5]], [[2.7, 2.5], [1, 2.5]], [[3.5, 1.7], [3.5, 0.4]], [[3.5, 3.3], [3.5, 4.6]]] },
  still: { own: [[3.5, 2.5]], others: [], ways: [] },
  chaser: { own: [[1, 2.5]], others: [[6, 2.5]], ways: [[[1.9, 2.5], [4.9, 2.5]]] },
  "clumsy chaser": { own: [[1, 2.5]], others: [[6, 2.5]], ways: [[[1.9, 2.5], [2.5, 1.2], [3.2, 3.8], [4, 2.5], [4.9, 2.5]]] },
  hunter: { own: [[1, 1.1], [1, 3.9]], others: [[6, 1.1], [6, 3.9]], ways: [[[1.9, 1.1], [4.9, 1.1]], [[1.9, 3.9], [4.9, 3.9]]] },
  surrounder: { own: [[3.5, 0.8], [6, 4.2]], others: [[3.5, 2.5]], ways: [[[6, 3.3], [6, 2.5], [4.8, 2.5]]] },
  "team surrounder": { own: [[1, 0.8], [6, 0.8], [1, 4.2], [6, 4.2]], others: [[3.5, 2.5]], ways: [[[1.8, 0.8], [3.5, 0.8], [3.5, 1.4]], [[6, 1.6], [6, 2.5], [4.7, 2.5]], [[1, 3.4], [1, 2.5], [2.3, 2.5]], [[5.2, 4.2], [3.5, 4.2], [3.5, 3.6]]] },
  fleer: { own: [[3, 2.5]], others: [[1, 2.5]], ways: [[[3.9, 2.5], [6.4, 2.5]]] },
  "clumsy fleer": { own: [[3, 2.5]], others: [[1, 2.5]], ways: [[[3.8, 2.5], [4.2, 1.2], [4.9, 3.8], [5.5, 2.5], [6.4, 2.5]]] },
  dodger: { own: [[3.2, 2.5]], others: [[1, 0.9], [1, 4.1]], ways: [[[4.1, 2.5], [6.4, 2.5]]] },
};
const NETWORK: Scene = { own: [[1, 1], [1, 4], [3.5, 2.5], [6, 1], [6, 4]], others: [], ways: [[[1, 1], [6, 4]], [[1, 4], [6, 1]]] };
const SHAPES: Readonly<Record<Team, (x: number, y: number) => string>> = {
  pursuer: (x, y) => `M${x} ${y - 0.75}l0.8 1.4h-1.6z`,
  evader: (x, y) => `M${x - 0.7} ${y}a0.7 0.7 0 1 0 1.4 0a0.7 0.7 0 1 0 -1.4 0z`,
};

/** Return the picture of a script; of any other name, that of a network. */
export function picture(name: string, team: Team): SVGSVGElement {
  const scene = SCENES[name.replace(/^careful /, "")] ?? NETWORK;
  const shapes = (of: Team, points: Points): SVGElement =>
    svg("path", { class: `of-${of}s`, d: points.map(([x, y]) => SHAPES[of](x, y)).join("") });
  return svg("svg", { class: "player-picture", viewBox: "0 0 7 5", "aria-hidden": "true" },
    svg("path", { class: "ways", d: scene.ways.map(scene === NETWORK ? line : arrow).join("") }),
    shapes(team, scene.own), shapes(team === "pursuer" ? "evader" : "pursuer", scene.others));
}

const line = (points: Points): string => `M${points.map((point) => point.join(" ")).join("L")}`;

/** Return a line with a head. */
function arrow(points: Points): string {
  const [[u, v], [x, y]] = points.slice(-2) as [Points[number], Points[number]];
  const [right, down] = [Math.sign(x - u) * 0.7, Math.sign(y - v) * 0.7];
  return `${line(points)}M${x - right - down} ${y - down - right}L${x} ${y}L${x - right + down} ${y - down + right}`;
}
