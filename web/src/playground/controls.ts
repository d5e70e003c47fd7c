// What a person presses to move an agent: keys, a pad on the screen, swipes and taps on the board.

import type { Board } from "../board/board.ts";
import { MOVES, towards } from "../board/recording.ts";
import type { Cell } from "../board/recording.ts";
import { html } from "../page/dom.ts";
import { ACTIONS } from "../page/names.ts";
import { ARROWS } from "./words.ts";

/** W A S D as in most games, with the diagonals around them; where Y and Z are exchanged, Y as well. */
const KEYS: Readonly<Record<string, number>> = {
  " ": 0,
  ArrowUp: 1,
  w: 1,
  ArrowRight: 2,
  d: 2,
  ArrowDown: 3,
  s: 3,
  ArrowLeft: 4,
  a: 4,
  e: 5,
  c: 6,
  y: 7,
  z: 7,
  q: 8,
};
/** The order of a numeric keypad, and of the pad on the screen, row by row. */
const PAD = [8, 1, 5, 4, 0, 2, 7, 3, 6];
const KEYPAD = [7, 8, 9, 4, 5, 6, 1, 2, 3];
/** The shortest swipe, in pixels. */
const SWIPE = 24;
/** A swipe is diagonal if its shorter part is more than this share of the longer one: 22.5 degrees. */
const DIAGONAL = Math.tan(Math.PI / 8);

/** Return the action of a key; undefined for other keys. */
export function actionOf(event: KeyboardEvent, diagonal: boolean): number | undefined {
  if (event.ctrlKey || event.metaKey || event.altKey) return undefined;
  const keypad = KEYPAD.findIndex((number) => event.code === `Numpad${number}`);
  const action = PAD[keypad] ?? KEYS[event.key.length === 1 ? event.key.toLowerCase() : event.key];
  return action !== undefined && action > 4 && !diagonal ? undefined : action;
}

/** Return the pad: a button for each direction. */
export function pad(act: (action: number) => void): { element: HTMLElement; show(diagonal: boolean): void } {
  const buttons = PAD.map((action) =>
    html(
      "button",
      { type: "button", "aria-label": ACTIONS[action], onclick: () => act(action) },
      ARROWS[action],
    ),
  );
  return {
    element: html("div", { class: "play-pad", role: "group", "aria-label": "Your move" }, ...buttons),
    show: (diagonal) =>
      buttons.forEach((button, place) => button.classList.toggle("absent", PAD[place]! > 4 && !diagonal)),
  };
}

/** Return the action nearest to a direction. */
function towardsAbout(down: number, right: number, diagonal: boolean): number {
  const least = DIAGONAL * Math.max(Math.abs(down), Math.abs(right));
  const sharp = (part: number): number => (Math.abs(part) < least ? 0 : part);
  return towards([0, 0], diagonal ? [sharp(down), sharp(right)] : [down, right], diagonal);
}

/** Listen to swipes, and to taps on a cell in the direction of the move; `own` is the agent's cell. */
export function listenToPointer(
  board: Board,
  own: () => { cell: Cell; diagonal: boolean } | null,
  act: (action: number) => void,
): void {
  let start: readonly [x: number, y: number] | null = null;
  const { canvas } = board;
  canvas.addEventListener(
    "pointerdown",
    ({ button, clientX, clientY }) => (start = button === 0 ? [clientX, clientY] : null),
  );
  canvas.addEventListener("pointercancel", () => (start = null));
  canvas.addEventListener("pointerup", ({ clientX, clientY }) => {
    const from = start;
    const here = own();
    start = null;
    if (!from || !here) return;
    const right = clientX - from[0];
    const down = clientY - from[1];
    const cell = board.cellAt(clientX, clientY);
    if (Math.hypot(right, down) >= SWIPE) act(towardsAbout(down, right, here.diagonal));
    else if (cell) act(towardsAbout(cell[0] - here.cell[0], cell[1] - here.cell[1], here.diagonal));
  });
}

/** Return where one cell lies from another, such as "3 north, 2 east". */
export function bearing(from: Cell, to: Cell): string {
  const part = (axis: 0 | 1): string => {
    const by = to[axis] - from[axis];
    const action = MOVES.findIndex((move) => move[axis] === Math.sign(by) && move[1 - axis] === 0);
    return by ? `${Math.abs(by)} ${ACTIONS[action]}` : "";
  };
  return [part(0), part(1)].filter(Boolean).join(", ") || "on your cell";
}
