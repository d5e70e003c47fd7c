// Line charts: axes, lines and marks as SVG, drawn anew when their room changes.

import { html, svg } from "../page/dom.ts";
import { ticks } from "./format.ts";
import type { Band, Curve } from "./data.ts";

export interface Axis {
  readonly low: number;
  readonly high: number;
  readonly label: string;
  /** Whether ticks are whole numbers. */
  readonly whole?: boolean;
}

/** The axes of a chart and its scales, in pixels. */
export interface Frame extends Readonly<Record<"left" | "right" | "top" | "bottom", number>> {
  readonly root: SVGSVGElement;
  /** What moves with the selection; `update` of the chart clears it. */
  readonly marks: SVGGElement;
  x(value: number): number;
  y(value: number): number;
  /** The value of the horizontal axis at a place in the window. */
  at(clientX: number): number;
}

const MARGIN = { right: 12, top: 10, bottom: 42 };
/** Pixels of a tick's label; of its letters, and of the axis's own label beside it. */
const TICK_ROOM = { x: 56, y: 34, letter: 8, label: 30 };

/** Return an empty chart of a size in pixels. */
export function frame(width: number, height: number, horizontal: Axis, vertical: Axis): Frame {
  const { top } = MARGIN;
  const bottom = Math.max(top + 40, height - MARGIN.bottom);
  const rows = ticks(vertical.low, vertical.high, (bottom - top) / TICK_ROOM.y, vertical.whole);
  const left = TICK_ROOM.label + TICK_ROOM.letter * Math.max(2, ...rows.map((value) => shown(value).length));
  const right = Math.max(left + 40, width - MARGIN.right);
  const scale =
    (axis: Axis, from: number, to: number) =>
    (value: number): number =>
      from + ((value - axis.low) / (axis.high - axis.low || 1)) * (to - from);
  const x = scale(horizontal, left, right);
  const y = scale(vertical, bottom, top);
  const marks = svg("g");
  const root = svg("svg", { width, height, viewBox: `0 0 ${width} ${height}`, class: "plot" });
  const axes = svg("g", { class: "axes" });
  for (const value of rows) {
    axes.append(
      svg("line", { x1: left, x2: right, y1: y(value), y2: y(value), class: "grid" }),
      svg(
        "text",
        { x: left - 8, y: y(value), "text-anchor": "end", "dominant-baseline": "middle" },
        shown(value),
      ),
    );
  }
  for (const value of ticks(
    horizontal.low,
    horizontal.high,
    (right - left) / TICK_ROOM.x,
    horizontal.whole,
  )) {
    axes.append(svg("text", { x: x(value), y: bottom + 16, "text-anchor": "middle" }, shown(value)));
  }
  axes.append(
    svg("line", { x1: left, x2: right, y1: bottom, y2: bottom, class: "axis" }),
    svg(
      "text",
      { x: (left + right) / 2, y: height - 6, "text-anchor": "middle", class: "label" },
      horizontal.label,
    ),
    svg(
      "text",
      {
        transform: `translate(12 ${(top + bottom) / 2}) rotate(-90)`,
        "text-anchor": "middle",
        class: "label",
      },
      vertical.label,
    ),
  );
  root.append(axes, marks);
  const at = (clientX: number): number => {
    const place = clientX - root.getBoundingClientRect().left;
    return horizontal.low + ((place - left) / (right - left)) * (horizontal.high - horizontal.low);
  };
  return { root, marks, left, right, top, bottom, x, y, at };
}

const shown = (value: number): string => String(Number(value.toPrecision(6))).replace("-", "−");

/** Add a curve; where it is not defined, it is interrupted. */
export function line(into: Frame, xs: readonly number[], ys: Curve, style: string): void {
  let path = "";
  let pen = "M";
  ys.forEach((value, i) => {
    if (value === null) {
      pen = "M";
    } else {
      path += `${pen}${into.x(xs[i]!).toFixed(1)} ${into.y(value).toFixed(1)}`;
      pen = "L";
    }
  });
  into.root.insertBefore(svg("path", { d: path, class: `line ${style}` }), into.marks);
}

/** Add the band between two curves. */
export function band(into: Frame, { low, high }: Band, style: string): void {
  if (!low || !high) return;
  const points = (ends: Curve): string[] =>
    ends.map((value, i) => `${into.x(i).toFixed(1)} ${into.y(value ?? 0).toFixed(1)}`);
  into.root.insertBefore(
    svg("path", { d: `M${[...points(high), ...points(low).reverse()].join("L")}Z`, class: `band ${style}` }),
    into.marks,
  );
}

/** Add a mark on a value of the horizontal axis: a line, and a dot where a curve is. */
export function mark(into: Frame, value: number, style: string, dot: number | null = null): void {
  const place = into.x(value);
  into.marks.append(
    svg("line", { x1: place, x2: place, y1: into.top, y2: into.bottom, class: `mark ${style}` }),
  );
  if (dot !== null) {
    into.marks.append(svg("circle", { cx: place, cy: into.y(dot), r: 5, class: `dot ${style}` }));
  }
}

/** Add an entry for each named curve, above the chart. */
export function legend(...entries: readonly (readonly [text: string, style: string])[]): HTMLElement {
  return html(
    "p",
    { class: "legend small" },
    ...entries.map(([text, style]) => html("span", { class: `key ${style}` }, text)),
  );
}

/**
 * Return an element that holds a chart and draws it as wide as it is, and what draws its marks, or
 * all of it, anew.
 *
 * `draw` makes the chart for a size, `mark` what moves with the selection, and `choose` gets the value
 * of the horizontal axis that is clicked.
 */
export function chart(
  label: string,
  draw: (width: number, height: number) => Frame,
  mark: (into: Frame) => void = () => undefined,
  choose: (value: number, into: Frame, event: MouseEvent) => void = () => undefined,
): { element: HTMLElement; update(): void; redraw(): void } {
  const element = html("div", { class: "chart chooses", role: "img", "aria-label": label });
  let shownFrame: Frame | null = null;
  const update = (): void => {
    shownFrame?.marks.replaceChildren();
    if (shownFrame) mark(shownFrame);
  };
  element.addEventListener(
    "click",
    (event) => shownFrame && choose(shownFrame.at(event.clientX), shownFrame, event),
  );
  const redraw = (): void => {
    const { clientWidth, clientHeight } = element;
    if (clientWidth < 50 || clientHeight < 50) return;
    shownFrame = draw(clientWidth, clientHeight);
    element.replaceChildren(shownFrame.root);
    update();
  };
  new ResizeObserver(redraw).observe(element);
  return { element, update, redraw };
}
