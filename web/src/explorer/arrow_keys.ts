// Arrow keys choose a match: on the matrix, and on the charts that show its generations.

import type { Team } from "../engine/teams.ts";
import type { Store } from "./store.ts";

const MOVES: Readonly<Record<string, readonly [up: number, right: number]>> = {
  ArrowUp: [1, 0],
  ArrowDown: [-1, 0],
  ArrowRight: [0, 1],
  ArrowLeft: [0, -1],
};
/** Generations of a step with Shift. */
const MANY = 5;

/**
 * Give an element the focus of the keyboard; up and down change a team's generation, left and right
 * the other's.
 */
export function listenToArrows(
  element: HTMLElement,
  store: Store,
  shape: () => readonly [number, number],
  upright: Team = "pursuer",
): void {
  element.tabIndex = 0;
  element.setAttribute("role", "application");
  element.addEventListener("keydown", (event) => {
    const move = MOVES[event.key];
    if (!move) return;
    const [pursuers, evaders] = upright === "pursuer" ? move : [move[1], move[0]];
    const [rows, columns] = shape();
    const by = event.shiftKey ? MANY : 1;
    const { pursuer, evader } = store.selected;
    store.select({
      pursuer: clamp(pursuer + by * pursuers, rows),
      evader: clamp(evader + by * evaders, columns),
    });
    event.preventDefault();
    event.stopPropagation();
  });
}

const clamp = (value: number, count: number): number => Math.min(count - 1, Math.max(0, value));
