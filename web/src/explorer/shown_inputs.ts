// Which cells the inputs of a move are about: found in the view of the agent, as the engine computes
// their numbers from it.

import type { ShownInputs } from "../board/inputs.ts";
import { MOVES } from "../board/recording.ts";
import type { Team } from "../engine/teams.ts";
import type { Cell, InputName, WorldConfig } from "../engine/types.ts";

/** What the page asks of a move. */
export interface Asked {
  readonly config: WorldConfig;
  /** What the agent sees, (3, fov, fov): evaders, pursuers, obstacles. */
  readonly view: Uint8Array;
  readonly team: Team;
  /** The cell of the agent. */
  readonly at: Cell;
  readonly move: number;
}

/** Return what is drawn of these inputs of a move. */
export function shownInputs(asked: Asked, inputs: readonly InputName[]): Omit<ShownInputs, "moved"> {
  const { config, view, team, at, move } = asked;
  const { fov, diagonal } = config;
  const half = Math.floor(fov / 2);
  const moves = MOVES.slice(0, diagonal ? 9 : 5);
  const layer = (number: number): Cell[] =>
    Array.from(view.subarray(number * fov * fov, (number + 1) * fov * fov)).flatMap((is, place) =>
      is ? [[Math.floor(place / fov) - half, (place % fov) - half] as Cell] : [],
    );
  const [evaders, pursuers, walls] = [layer(0), layer(1), layer(2)];
  const [mates, adversaries] = team === "pursuer" ? [pursuers, evaders] : [evaders, pursuers];
  const isIn = (cells: readonly Cell[], [row, col]: Cell): boolean =>
    cells.some(([r, c]) => r === row && c === col);
  const distance = (a: Cell, b: Cell): number => {
    const [rows, cols] = [Math.abs(a[0] - b[0]), Math.abs(a[1] - b[1])];
    return diagonal ? Math.max(rows, cols) : rows + cols;
  };
  const after = (cell: Cell, by: Cell): Cell => [cell[0] + by[0], cell[1] + by[1]];
  const around = (cell: Cell): Cell[] => moves.slice(1).map((by) => after(cell, by));
  const nearest = (cells: readonly Cell[], to: Cell): Cell[] => {
    const least = Math.min(...cells.map((each) => distance(each, to)));
    return cells.filter((each) => distance(each, to) === least);
  };
  const isFree = (cell: Cell): boolean => !isIn(walls, cell);
  const onGrid = (cell: Cell): Cell => after(at, cell);

  const here: Cell = [0, 0];
  const there = moves[move]!;
  const near = nearest(adversaries, here);

  const waysOut = (evader: Cell, pursuers: readonly Cell[]): Record<"escape" | "held", Cell[]> => {
    const next = [evader, ...around(evader)].filter(isFree);
    const reached = (cell: Cell): boolean => pursuers.some((each) => distance(each, cell) <= 1);
    return { escape: next.filter((cell) => !reached(cell)), held: next.filter(reached) };
  };
  const ways =
    team === "evader"
      ? [waysOut(there, adversaries)]
      : near.map((evader) => waysOut(evader, [there, ...mates]));

  const pairs: (readonly [middle: Cell, one: Cell, other: Cell])[] =
    team === "evader"
      ? near.flatMap((one) =>
          nearest(
            adversaries.filter((each) => each !== one),
            here,
          ).map((other) => [there, one, other] as const),
        )
      : near.flatMap((evader) => nearest(mates, evader).map((mate) => [evader, there, mate] as const));

  const sides = adversaries
    .flatMap(around)
    .filter((side) => Math.max(...side.map(Math.abs)) <= half && isFree(side) && !isIn(mates, side));

  const rays = MOVES.slice(1, 5).flatMap(([row, col]) => {
    const ray = Array.from({ length: half }, (_, k): Cell => [there[0] + k * row, there[1] + k * col]);
    return ray.filter((cell) => !isFree(cell)).slice(0, 1);
  });

  const has = (input: InputName): boolean => inputs.includes(input);
  const found = {
    ways: has("escapes") ? first(ways, (each) => each.escape.length) : null,
    sides: has("opposite") ? first(pairs, (each) => -opposition(...each)) : null,
    openSide: has("open_side") ? first(sides, (side) => distance(side, there)) : null,
    exits: has("exits") ? around(there).filter(isFree) : [],
    wall: has("room") ? first(rays, (cell) => distance(cell, there)) : null,
  };
  return {
    to: onGrid(there),
    escape: (found.ways?.escape ?? []).map(onGrid),
    held: (found.ways?.held ?? []).map(onGrid),
    sides: found.sides && [onGrid(found.sides[0]), onGrid(found.sides[1]), onGrid(found.sides[2])],
    openSide: found.openSide && onGrid(found.openSide),
    exits: found.exits.map(onGrid),
    wall: found.wall && onGrid(found.wall),
  };
}

/** Return the first of those with the least measure; null of none. */
function first<Each>(all: readonly Each[], measure: (each: Each) => number): Each | null {
  const measures = all.map(measure);
  return all[measures.indexOf(Math.min(...measures))] ?? null;
}

/** Return (1 - cosine) / 2 of the directions from the cell in the middle to two others. */
export function opposition(middle: Cell, one: Cell, other: Cell): number {
  const [a, b] = [one, other].map((end) => [end[0] - middle[0], end[1] - middle[1]] as const);
  const lengths = Math.hypot(...a!) * Math.hypot(...b!);
  return lengths ? (1 - (a![0] * b![0] + a![1] * b![1]) / lengths) / 2 : 0.5;
}
