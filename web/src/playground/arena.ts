// The boards: one for the scene's rules, and one for those to compare with. Pointer and keyboard
// choose agents and their moves (mode "act"), or place agents and obstacles (mode "build").

import { Board } from "../board/board.ts";
import { MOVES, isCell, towards } from "../board/recording.ts";
import type { Cell } from "../board/recording.ts";
import { html } from "../page/dom.ts";
import { ACTIONS } from "../page/names.ts";
import {
  agentOn,
  agentName,
  agents,
  isWall,
  moved,
  nAgents,
  removed,
  variantOf,
  withNext,
  withWall,
} from "./scene.ts";
import type { Control, Store } from "./store.ts";

const ARROW_ACTIONS: Record<string, number> = { ArrowUp: 1, ArrowRight: 2, ArrowDown: 3, ArrowLeft: 4 };
/** The keys around S, as they lie on a keyboard: for moves that arrow keys lack. */
const DIAGONAL_ACTIONS: Record<string, number> = { e: 5, c: 6, y: 7, z: 7, q: 8 };

/** Return the boards, which show what a store holds. */
export function arena(store: Store): HTMLElement {
  const element = html("div", { class: "arena" });
  const arms = [arm(store, 0), arm(store, 1)];
  element.append(...arms.map((each) => each.element));
  store.shownBy(() => arms.forEach((each) => each.update()), "frame");
  return element;
}

function arm(store: Store, place: number): Control {
  const canvas = html("canvas", { tabindex: 0, "aria-describedby": "board-keys" });
  const name = html("h2", { class: "arm-name" });
  const element = html("figure", { class: "arm" }, name, canvas);
  const board = new Board(canvas, { axes: true, trail: 1 });
  const cursor: Cursor = { cell: [0, 0] };
  listenToPointer(store, board);
  const update = (): void => {
    const game = store.games[place];
    element.hidden = !game;
    if (!game) return;
    const { mode, scene } = store;
    canvas.setAttribute("role", "application");
    canvas.ariaLabel = `Board, ${scene.rows} by ${scene.cols} cells`;
    canvas.dataset["mode"] = mode;
    name.textContent = rulesName(store, place);
    name.hidden = store.games.length < 2;
    const atEnd = store.player.arrived && store.player.step === store.game.length;
    board.look = {
      plan: mode === "act" && atEnd && !game.over ? game.actions(scene.next) : null,
      selected: mode === "act" ? store.selected : null,
      cursor: mode === "build" && document.activeElement === canvas ? cursor.cell : null,
    };
    board.show(game.recording, store.player.time);
  };
  canvas.addEventListener("focus", update);
  canvas.addEventListener("blur", update);
  listenToKeys(store, canvas, cursor, update);
  return { element, update };
}

/** Return the name of the rules of a board. */
export function rulesName(store: Store, place: number): string {
  const rules = place ? store.scene.others : store.scene.rules;
  const variant = rules && variantOf(rules, store.data.variants);
  return variant || "own rules";
}

// ---- Pointer

/** Return the cell of an agent at the present moment; null if it is gone. */
function present(store: Store, agent: number): Cell | null {
  const start = agents(store.game.scene())[agent];
  return start && !start.gone ? start.cell : null;
}

function listenToPointer(store: Store, board: Board): void {
  let gesture: ((cell: Cell) => void) | null = null;
  board.canvas.addEventListener("pointerdown", (event) => {
    const cell = board.cellAt(event.clientX, event.clientY);
    if (!cell || event.button !== 0 || store.running) return;
    board.canvas.setPointerCapture(event.pointerId);
    const agent = board.agentAt(event.clientX, event.clientY);
    gesture = store.mode === "build" ? buildGesture(store, cell, agent) : actGesture(store, cell, agent);
  });
  board.canvas.addEventListener("pointermove", (event) => {
    const cell = board.cellAt(event.clientX, event.clientY);
    if (cell) gesture?.(cell);
  });
  for (const end of ["pointerup", "pointercancel"] as const) {
    board.canvas.addEventListener(end, () => (gesture = null));
  }
}

/** Press an agent to choose it, and drag to say where it goes; or press a cell beside the chosen one. */
function actGesture(store: Store, cell: Cell, agent: number | null): ((cell: Cell) => void) | null {
  if (agent === null) {
    const own = store.selected === null ? null : present(store, store.selected);
    if (own && Math.max(Math.abs(own[0] - cell[0]), Math.abs(own[1] - cell[1])) === 1) {
      command(store, towards(own, cell, store.scene.diagonal));
    }
    return null;
  }
  // A second press on the chosen agent lets it stay.
  const again = store.selected === agent;
  store.selected = agent;
  const own = present(store, agent);
  if (!own) return null;
  if (again) command(store, 0);
  return (now) => command(store, towards(own, now, store.scene.diagonal));
}

/** Drag an agent to another cell, or draw obstacles; on an obstacle, erase them. */
function buildGesture(store: Store, cell: Cell, agent: number | null): (cell: Cell) => void {
  let part = false;
  const change = (scene: ReturnType<Store["game"]["scene"]>): void => {
    store.change(scene, { part });
    part = true;
  };
  if (agent !== null) {
    store.selected = agent;
    return (to) => {
      const now = store.game.scene();
      if (agentOn(now, to) === null && !isWall(now, to)) change(moved(now, agent, to));
    };
  }
  const wall = !isWall(store.game.scene(), cell);
  const paint = (to: Cell): void => {
    const now = store.game.scene();
    if (agentOn(now, to) === null && isWall(now, to) !== wall) change(withWall(now, to, wall));
  };
  paint(cell);
  return paint;
}

/** Give the chosen agent a command, and tell which. */
export function command(store: Store, action: number): void {
  const { selected, scene } = store;
  if (selected === null || store.running || store.game.over) return;
  if (scene.next[selected] !== action) store.change(withNext(scene, selected, action));
  store.say(`${agentName(scene, selected)}: ${ACTIONS[action]}.`);
}

// ---- Keyboard

/** The cell that arrow keys have reached in mode "build". */
type Cursor = { cell: Cell };

function listenToKeys(store: Store, canvas: HTMLCanvasElement, cursor: Cursor, update: () => void): void {
  canvas.addEventListener("keydown", (event) => {
    if (event.ctrlKey || event.metaKey || event.altKey) return;
    const done = store.mode === "act" ? actKey(store, event) : buildKey(store, event, cursor);
    update();
    if (done) event.preventDefault();
  });
}

/** Keys that move the chosen agent or choose another one; also used by the page. */
export function actKey(store: Store, event: KeyboardEvent): boolean {
  const key = event.key.length === 1 ? event.key.toLowerCase() : event.key;
  const action =
    ARROW_ACTIONS[key] ??
    (store.scene.diagonal ? DIAGONAL_ACTIONS[key] : undefined) ??
    ({ s: 0, Delete: 0 } as Record<string, number>)[key];
  if (action !== undefined) {
    if (store.selected === null) choose(store, 1);
    command(store, action);
    return true;
  }
  if (key !== "n" && key !== "p") return false;
  choose(store, key === "n" ? 1 : -1);
  return true;
}

/** Choose the next living agent, or the one before. */
export function choose(store: Store, by: number): void {
  const count = nAgents(store.scene);
  const alive = store.game.recording.moments.at(-1)!.alive;
  let agent = store.selected ?? (by > 0 ? -1 : count);
  for (let tried = 0; tried < count; tried++) {
    agent = (agent + by + count) % count;
    if (!alive[agent]) continue;
    store.selected = agent;
    const [row, col] = present(store, agent)!;
    return store.say(`${agentName(store.scene, agent)} at (${row}, ${col}).`);
  }
}

function buildKey(store: Store, event: KeyboardEvent, cursor: Cursor): boolean {
  const now = store.game.scene();
  const action = ARROW_ACTIONS[event.key];
  if (action !== undefined) {
    const carried = event.shiftKey ? agentOn(now, cursor.cell) : null;
    const to = [cursor.cell[0] + MOVES[action]![0], cursor.cell[1] + MOVES[action]![1]] as const;
    if (isCell(now, to)) cursor.cell = to;
    const free = agentOn(now, cursor.cell) === null && !isWall(now, cursor.cell);
    if (carried !== null && free) store.change(moved(now, carried, cursor.cell));
    const [row, col] = cursor.cell;
    store.say(`(${row}, ${col}): ${contents(store, cursor.cell)}.`);
    return true;
  }
  const agent = agentOn(now, cursor.cell);
  if (event.key === " " || event.key === "Enter") {
    if (agent === null) store.change(withWall(now, cursor.cell, !isWall(now, cursor.cell)));
    else store.selected = agent;
    return true;
  }
  if (event.key === "Delete" && agent !== null) {
    store.change(removed(now, agent));
    return true;
  }
  return false;
}

function contents(store: Store, cell: Cell): string {
  const now = store.game.scene();
  const agent = agentOn(now, cell);
  if (agent !== null) return agentName(now, agent);
  return isWall(now, cell) ? "obstacle" : "free";
}
