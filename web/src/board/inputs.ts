// The layer of named inputs: what they are of one move of an agent, drawn where it is.

import type { InputName } from "../engine/types.ts";
import { html, svg } from "../page/dom.ts";
import type { Attributes } from "../page/dom.ts";
import { pixelX, pixelY } from "./layers.ts";
import type { Sheet } from "./layers.ts";
import { isCell } from "./recording.ts";
import type { Cell, Recording } from "./recording.ts";
import { cross, disc, triangle } from "./shapes.ts";

/** The inputs of a move that are drawn, as cells of the grid; a cell may be outside of it. */
export interface ShownInputs {
  /** The cell that the move leads to. */
  readonly to: Cell;
  /** Of `escapes`: the next cells of the evader that no pursuer in view reaches, and those that one does. */
  readonly escape: readonly Cell[];
  readonly held: readonly Cell[];
  /** Of `opposite`: the cell in the middle, and two cells seen from it; null without a pair. */
  readonly sides: readonly [middle: Cell, one: Cell, other: Cell] | null;
  /** Of `open_side`: the nearest cell beside an adversary without obstacle or teammate. */
  readonly openSide: Cell | null;
  /** Of `exits`: the cells around without an obstacle. */
  readonly exits: readonly Cell[];
  /** Of `room`: the nearest obstacle in the row or column. */
  readonly wall: Cell | null;
  /** Agents that stand elsewhere when the agent decides, in its turn. */
  readonly moved: readonly { readonly pursuer: boolean; readonly cell: Cell }[];
}

/** Sizes in cells. */
const TINT_INSET = 0.04;
const SIGN = 0.3;
const DIAMOND = 0.36;
const DOT = 0.13;
/** Where a dot stands between the middle of a cell and that of the next one. */
const DOT_AT = 0.62;
const OUTLINE = 0.94;

/** Draw the inputs of a move; what is outside of the grid is left out. */
export function drawInputs(sheet: Sheet, recording: Recording, shown: ShownInputs): void {
  const { ctx, grid, colors } = sheet;
  const { cell } = grid;
  const x = (at: Cell): number => pixelX(grid, at[1] + 0.5);
  const y = (at: Cell): number => pixelY(grid, at[0] + 0.5);
  const line = Math.max(1.5, cell * 0.06);
  const onGrid = (at: Cell): boolean => isCell(recording, at);
  ctx.lineCap = "round";

  for (const [cells, color] of [
    [shown.escape, colors.evader],
    [shown.held, colors.pursuer],
  ] as const) {
    ctx.fillStyle = color;
    ctx.globalAlpha = 0.28;
    const side = cell * (1 - 2 * TINT_INSET);
    for (const at of cells.filter(onGrid)) ctx.fillRect(x(at) - side / 2, y(at) - side / 2, side, side);
  }
  ctx.globalAlpha = 1;
  ctx.lineWidth = line;
  ctx.fillStyle = ctx.strokeStyle = colors.ink;
  const { sides, openSide, wall, to } = shown;
  if (sides) {
    const [middle, ...ends] = sides;
    for (const end of ends) {
      ctx.beginPath();
      ctx.moveTo(x(middle), y(middle));
      ctx.lineTo(x(end), y(end));
      ctx.stroke();
    }
  }
  if (wall) {
    // To the side of the obstacle, where a bar stands for it.
    const [down, right] = [Math.sign(wall[0] - to[0]), Math.sign(wall[1] - to[1])];
    const [endX, endY] = [x(wall) - (right * cell) / 2, y(wall) - (down * cell) / 2];
    const bar = 0.3 * cell;
    ctx.setLineDash([line, line * 2]);
    ctx.beginPath();
    ctx.moveTo(x(to), y(to));
    ctx.lineTo(endX, endY);
    ctx.stroke();
    ctx.setLineDash([]);
    ctx.beginPath();
    ctx.moveTo(endX - down * bar, endY - right * bar);
    ctx.lineTo(endX + down * bar, endY + right * bar);
    ctx.stroke();
  }
  for (const at of shown.exits.filter(onGrid)) {
    const [right, down] = [x(at) - x(to), y(at) - y(to)];
    disc(ctx, x(to) + DOT_AT * right, y(to) + DOT_AT * down, Math.max(3, cell * DOT));
    ctx.fill();
  }
  if (openSide) {
    diamond(ctx, x(openSide), y(openSide), cell * DIAMOND);
    ctx.stroke();
  }
  ctx.setLineDash([cell * 0.12, cell * 0.08]);
  ctx.strokeRect(x(to) - (cell * OUTLINE) / 2, y(to) - (cell * OUTLINE) / 2, cell * OUTLINE, cell * OUTLINE);
  ctx.setLineDash([]);
}

/** Draw, above the agents, the signs of cells that escape or are held, and agents where they have moved. */
export function drawSigns({ ctx, grid, colors }: Sheet, recording: Recording, shown: ShownInputs): void {
  const { cell } = grid;
  const x = (at: Cell): number => pixelX(grid, at[1] + 0.5);
  const y = (at: Cell): number => pixelY(grid, at[0] + 0.5);
  const halo = Math.max(3, cell * 0.14);
  const line = Math.max(1.5, cell * 0.07);
  const outlined = (path: () => void): void => {
    for (const [color, width] of [
      [colors.paper, halo],
      [colors.ink, line],
    ] as const) {
      ctx.strokeStyle = color;
      ctx.lineWidth = width;
      path();
      ctx.stroke();
    }
  };
  ctx.lineCap = "round";
  for (const at of shown.escape.filter((each) => isCell(recording, each))) {
    outlined(() => disc(ctx, x(at), y(at), cell * SIGN));
  }
  for (const at of shown.held.filter((each) => isCell(recording, each))) {
    outlined(() => cross(ctx, x(at), y(at), cell * SIGN * 1.4));
  }
  ctx.setLineDash([cell * 0.1, cell * 0.08]);
  for (const { pursuer, cell: at } of shown.moved) {
    ctx.strokeStyle = pursuer ? colors.pursuer : colors.evader;
    ctx.lineWidth = line;
    (pursuer ? triangle : disc)(ctx, x(at), y(at), cell * 0.72);
    ctx.stroke();
  }
  ctx.setLineDash([]);
}

/** A square on its corner. */
function diamond(ctx: CanvasRenderingContext2D, x: number, y: number, size: number): void {
  ctx.beginPath();
  ctx.moveTo(x, y - size);
  ctx.lineTo(x + size, y);
  ctx.lineTo(x, y + size);
  ctx.lineTo(x - size, y);
  ctx.closePath();
}

// ---- Legend -------------------------------------------------------------------------------------

type Shape = readonly [tag: "circle" | "path" | "rect", attributes: Attributes];

const tint = (team: string): Shape => ["rect", { x: 1, y: 1, width: 22, height: 22, class: `tint-${team}` }];
const sign = (d: string): Shape => ["path", { d, class: "sign" }];
const circle = (r: number, name: string): Shape => ["circle", { cx: 12, cy: 12, r, class: name }];

/** What each drawn input looks like, and what that means. */
const SIGNS: Partial<Record<InputName, readonly (readonly [meaning: string, ...Shape[]])[]>> = {
  escapes: [
    ["next cell of the evader that no pursuer reaches", tint("evader"), circle(5, "sign")],
    ["next cell that a pursuer reaches", tint("pursuer"), sign("M8 8l8 8m0-8l-8 8")],
  ],
  opposite: [["two sides of the evader", sign("M3 20L12 5l9 15")]],
  open_side: [["nearest free side", sign("M12 3l9 9-9 9-9-9z")]],
  exits: [["way on", circle(4, "filled-sign")]],
  room: [["nearest obstacle", sign("M2 12h2m5 0h2m5 0h2M21 4v16")]],
};

/** Agents that stand elsewhere when an agent decides, in its turn. */
const IN_TURN = ["an agent that has moved before", circle(8, "dashed-sign")] as const;

const HOW =
  "Inputs of a move: point at an agent, or choose it; then point at a cell beside it, tap it or press I for another move.";

/** Return the legend of those of these inputs that are drawn, in a game with turns or without; empty for none. */
export function legendOfInputs(inputs: readonly InputName[], turns: boolean): HTMLElement[] {
  const signs = inputs.flatMap((input) => SIGNS[input] ?? []);
  if (!signs.length) return [];
  return [
    html("p", { class: "small muted" }, HOW),
    html(
      "ul",
      { class: "shapes small", "aria-label": "Inputs of a move on the board" },
      ...[...signs, ...(turns ? [IN_TURN] : [])].map(([meaning, ...shapes]) =>
        html(
          "li",
          {},
          svg("svg", { viewBox: "0 0 24 24", "aria-hidden": "true" }, ...shapes.map((each) => svg(...each))),
          meaning,
        ),
      ),
    ),
  ];
}
