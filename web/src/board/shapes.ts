// Outlines of what a board shows. Each adds its path around a point; the caller fills or strokes it.

type Context = CanvasRenderingContext2D;

const TURN = 2 * Math.PI;

export function disc(ctx: Context, x: number, y: number, size: number): void {
  ctx.beginPath();
  ctx.arc(x, y, size / 2, 0, TURN);
}

/** A triangle that points up, with round corners and its centre of mass near the point. */
export function triangle(ctx: Context, x: number, y: number, size: number): void {
  const half = size / 2;
  const corners = [
    [0, -0.97],
    [0.97, 0.83],
    [-0.97, 0.83],
  ].map(([right, down]) => [x + right! * half, y + down! * half]);
  ctx.beginPath();
  // The path starts in the middle of a side, so that all three corners become round.
  ctx.moveTo((corners[2]![0]! + corners[0]![0]!) / 2, (corners[2]![1]! + corners[0]![1]!) / 2);
  corners.forEach(([cx, cy], i) => {
    const [nx, ny] = corners[(i + 1) % 3]!;
    ctx.arcTo(cx!, cy!, nx!, ny!, size * 0.09);
  });
  ctx.closePath();
}

export function cross(ctx: Context, x: number, y: number, size: number): void {
  const reach = size * 0.32;
  ctx.beginPath();
  ctx.moveTo(x - reach, y - reach);
  ctx.lineTo(x + reach, y + reach);
  ctx.moveTo(x + reach, y - reach);
  ctx.lineTo(x - reach, y + reach);
}

/** A star of eight rays. */
export function burst(ctx: Context, x: number, y: number, size: number): void {
  ctx.beginPath();
  for (let corner = 0; corner < 16; corner++) {
    const reach = (size / 2) * (corner % 2 ? 0.6 : 0.95);
    const angle = (TURN * corner) / 16;
    ctx.lineTo(x + reach * Math.sin(angle), y - reach * Math.cos(angle));
  }
  ctx.closePath();
}

/** A shaft and an open head; stroke it. */
export function arrow(ctx: Context, x0: number, y0: number, x1: number, y1: number, head: number): void {
  const angle = Math.atan2(y1 - y0, x1 - x0);
  ctx.beginPath();
  ctx.moveTo(x0, y0);
  ctx.lineTo(x1, y1);
  for (const side of [-1, 1]) {
    ctx.moveTo(x1, y1);
    ctx.lineTo(x1 - head * Math.cos(angle + side * 0.6), y1 - head * Math.sin(angle + side * 0.6));
  }
}
