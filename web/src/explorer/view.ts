// The view of an agent: what lies around it, as the three layers of its network's input hold it.

import { paletteOf } from "../board/palette.ts";
import { disc, triangle } from "../board/shapes.ts";
import type { WorldConfig } from "../engine/types.ts";

const EVADERS = 0;
const PURSUERS = 1;
const OBSTACLES = 2;
const SIDE = 176;

/** Draw a view (3, fov, fov); an agent that is gone sees nothing. */
export function drawView(
  canvas: HTMLCanvasElement,
  config: WorldConfig,
  view: Uint8Array | null,
  agent: number,
): void {
  const ratio = devicePixelRatio || 1;
  const colors = paletteOf(canvas);
  canvas.width = canvas.height = SIDE * ratio;
  const ctx = canvas.getContext("2d");
  if (!ctx) return;
  const { fov } = config;
  const cell = canvas.width / fov;
  ctx.fillStyle = colors.paper;
  ctx.fillRect(0, 0, canvas.width, canvas.height);
  for (let at = 0; view && at < fov * fov; at++) {
    const x = ((at % fov) + 0.5) * cell;
    const y = (Math.floor(at / fov) + 0.5) * cell;
    const has = (layer: number): boolean => Boolean(view[layer * fov * fov + at]);
    if (has(OBSTACLES)) {
      ctx.fillStyle = colors.obstacle;
      ctx.fillRect(x - cell / 2, y - cell / 2, cell, cell);
    }
    // Agents of both teams may be on one cell.
    const shift = has(EVADERS) && has(PURSUERS) ? cell * 0.18 : 0;
    if (has(EVADERS)) mark(ctx, disc, x + shift, y + shift, cell * 0.74, colors.evader);
    if (has(PURSUERS)) mark(ctx, triangle, x - shift, y - shift, cell * 0.86, colors.pursuer);
  }
  ctx.strokeStyle = agent < config.n_pursuers ? colors.pursuer : colors.evader;
  ctx.lineWidth = 2 * ratio;
  const middle = Math.floor(fov / 2) * cell;
  ctx.strokeRect(middle, middle, cell, cell);
}

type Shape = (ctx: CanvasRenderingContext2D, x: number, y: number, size: number) => void;

function mark(
  ctx: CanvasRenderingContext2D,
  shape: Shape,
  x: number,
  y: number,
  size: number,
  color: string,
): void {
  shape(ctx, x, y, size);
  ctx.fillStyle = color;
  ctx.fill();
}
