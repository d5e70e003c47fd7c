// Pictures: payoff matrices that are guessed, three with the same diagonal, and who may enter a free cell.

import { chart, frame, line } from "../explorer/chart.ts";
import { drawCells, scaleOfRates } from "../explorer/heatmap.ts";
import { html, svg } from "../page/dom.ts";
import type { Crossing, Lesson, WidgetPart } from "./data.ts";

type Rows = readonly (readonly number[])[];

/**
 * Return a picture of a matrix, pursuer generations upwards, evader generations to the right; rows
 * may be short.
 */
export function matrixOf(
  rows: Rows,
  caption: string,
  size = rows.length,
): HTMLElement & { draw?: () => void } {
  const canvas = html("canvas", { role: "img", "aria-label": caption });
  const room = html("div", { class: "cells-of-matrix" }, canvas);
  const made: HTMLElement & { draw?: () => void } = html(
    "figure",
    {},
    html("figcaption", {}, caption),
    room,
    html(
      "p",
      { class: "small muted" },
      html("span", { class: "pursuer" }, "↑ pursuers"),
      " ",
      html("span", { class: "evader" }, "evaders →"),
    ),
  );
  made.draw = () => {
    const side = room.clientWidth;
    if (side) {
      drawCells(
        canvas,
        { shape: [size, size], first: [0, 0], capture_rate: rows },
        { left: 0, top: 0, width: side, height: side },
      );
    }
  };
  new ResizeObserver(() => made.draw?.()).observe(room);
  return made;
}

const scale = (): HTMLElement => scaleOfRates("0 all escape", "1 all caught");

export const racesToGuess = ({ runs }: Lesson): HTMLElement =>
  html(
    "div",
    { class: "widget" },
    html(
      "div",
      { class: "matrices" },
      ...runs.map((run, at) => matrixOf(run.payoff.capture_rate, `Matrix ${"ABC"[at]}`)),
    ),
    scale(),
  );

const GENERATIONS = 31;
/** What a generation more or less changes. */
const STEP = 0.016;

/** Three races whose diagonals are one half: both teams get better, both get worse, nothing happens. */
export function sameDiagonals(): HTMLElement {
  const race = (step: number): Rows =>
    Array.from({ length: GENERATIONS }, (_, g) =>
      Array.from({ length: GENERATIONS }, (__, h) => 0.5 + step * (g - h)),
    );
  const made = [
    [STEP, "Both get better"],
    [-STEP, "Both get worse"],
    [0, "Nothing happens"],
  ] as const;
  return html(
    "div",
    { class: "widget" },
    html("div", { class: "matrices" }, ...made.map(([step, caption]) => matrixOf(race(step), caption))),
    scale(),
  );
}

/** The curve of the vote. */
export function flatCurve(): HTMLElement {
  const generations = Array.from({ length: GENERATIONS }, (_, generation) => generation);
  const made = chart(
    "A capture rate that stays at one half from generation 0 to 30",
    (width, height) => {
      const into = frame(
        width,
        height,
        { low: 0, high: GENERATIONS - 1, label: "generation", whole: true },
        { low: 0, high: 1, label: "capture rate" },
      );
      line(
        into,
        generations,
        generations.map(() => 0.5),
        "of-both",
      );
      return into;
    },
    () => undefined,
    () => undefined,
  );
  return html("div", { class: "widget" }, made.element);
}

// ---- Right of way

const CELL = 32;

export const rightOfWay = ({ crossings = [] }: WidgetPart): HTMLElement =>
  html(
    "div",
    { class: "widget crossings" },
    ...crossings.map((each) =>
      html(
        "figure",
        {},
        html("figcaption", {}, each.title),
        picture(each),
        html("p", { class: "small muted" }, each.text),
      ),
    ),
  );

/**
 * Return nine cells, with pursuers around the one in the middle: an arrow for one that may go, a
 * bar for one that waits.
 */
function picture({ title, text, ways }: Crossing): SVGElement {
  const lines = [0, 1, 2, 3].map((at) => `M${at * CELL} 0V${3 * CELL}M0 ${at * CELL}H${3 * CELL}`).join("");
  return svg(
    "svg",
    { viewBox: `-1 -1 ${3 * CELL + 2} ${3 * CELL + 2}`, role: "img", "aria-label": `${title}: ${text}` },
    svg("path", { class: "grid", d: lines }),
    ...ways.map(([down, right, goes], agent) =>
      svg(
        "g",
        { transform: `translate(${1.5 * CELL} ${1.5 * CELL})` },
        svg(
          "g",
          { transform: `translate(${-CELL * right} ${-CELL * down})` },
          svg("path", { class: "filled-pursuer", d: "M0 -12 12 9H-12z" }),
          svg("text", { y: 6.5, "text-anchor": "middle" }, `P${agent}`),
        ),
        // Drawn for a move to the right, and turned.
        svg("path", {
          class: goes ? "goes" : "waits",
          d: goes ? "M-18 0H-5M-9 -4 -4 0 -9 4" : "M-16 -13V13",
          transform: `rotate(${(Math.atan2(down, right) * 180) / Math.PI})`,
        }),
      ),
    ),
  );
}
