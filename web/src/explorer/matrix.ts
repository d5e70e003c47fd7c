// The payoff matrix: pursuer generations upwards, evader generations to the right, and along both
// sides the mean score of each generation against all opponents.

import type { Team } from "../engine/teams.ts";
import { html, svg } from "../page/dom.ts";
import { listenToArrows } from "./arrow_keys.ts";
import { cellOf } from "./data.ts";
import type { Band, Run } from "./data.ts";
import { capital, interval, rate, ticks } from "./format.ts";
import { gameWords, generationName } from "./game.ts";
import { drawCells, scaleOfRates } from "./heatmap.ts";
import { loupe, needsLoupe } from "./loupe.ts";
import type { Store } from "./store.ts";

/** Room around the cells, in pixels: axes on the left and below, curves above and on the right. */
const MARGIN = { left: 52, bottom: 46, top: 76, right: 84 };
const GAP = 10;
const LEAST_SIDE = 160;
/** Room of the curve on the right and of the one above. */
const WIDE = MARGIN.right - GAP - 14;
const HIGH = MARGIN.top - GAP - 14;

type Point = [x: number, y: number];

/** In pixels; `cell` is the side of a cell. The matrix is `columns` cells wide and `rows` high. */
type Places = Readonly<Record<"width" | "height" | "left" | "top" | "cell" | "rows" | "columns", number>>;

/** The matrix of the selected run, with its curves. */
export class MatrixPanel {
  readonly element: HTMLElement;
  readonly #store: Store;
  readonly #runs: readonly Run[];
  readonly #canvas = html("canvas", { "aria-hidden": "true" });
  readonly #overlay = svg("svg", { "aria-hidden": "true" });
  readonly #marks = svg("g");
  readonly #room: HTMLElement;
  readonly #pair = html("h2");
  readonly #rate = html("strong", { class: "rate numbers" });
  readonly #more = html("span", { class: "small muted" });
  readonly #all = html("p", { class: "of-both-teams small muted numbers" });
  #scale: HTMLElement;
  #places: Places | null = null;

  constructor(runs: readonly Run[], store: Store) {
    this.#runs = runs;
    this.#store = store;
    this.#room = html(
      "div",
      {
        class: "matrix",
        id: "matrix",
        "aria-label": "Payoff matrix. Arrow keys choose a match, Enter plays it.",
        onpointermove: (event: PointerEvent) => this.#point(event),
        onpointerleave: () => store.point({}),
        onclick: (event: MouseEvent) => this.#choose(event),
        onkeydown: ({ key }: KeyboardEvent) => key === "Enter" && this.#play(),
      },
      this.#canvas,
      this.#overlay,
    );
    const readout = html(
      "header",
      { class: "readout", "aria-live": "polite" },
      html("div", {}, this.#pair, this.#all),
      html("div", { class: "of-cell" }, this.#rate, this.#more),
    );
    this.#scale = scaleOfRates(...gameWords(this.#run).ends);
    this.element = html(
      "section",
      { class: "card matrix-card", "aria-label": "Payoff matrix" },
      readout,
      this.#room,
      this.#scale,
    );
    this.#say();
    new ResizeObserver(() => this.#draw()).observe(this.#room);
    // A click gives the keys to the player, also those of a button that was pressed before; Tab and M
    // give them to the matrix.
    this.#room.addEventListener("mousedown", (event) => {
      event.preventDefault();
      if (document.activeElement instanceof HTMLElement) document.activeElement.blur();
    });
    listenToArrows(this.#room, store, () => this.#run.payoff.shape);
    store.on("run", () => {
      const scale = scaleOfRates(...gameWords(this.#run).ends);
      this.#scale.replaceWith(scale);
      this.#scale = scale;
      this.#draw();
    });
    store.on("match hover", () => this.#mark());
  }

  get #run(): Run {
    return this.#runs[this.#store.selected.run]!;
  }

  #draw(): void {
    const [rows, columns] = this.#run.payoff.shape;
    const { clientWidth: width, clientHeight: height } = this.#room;
    if (width < 50) return;
    const side = Math.max(
      LEAST_SIDE,
      Math.min(width - MARGIN.left - MARGIN.right, height - MARGIN.top - MARGIN.bottom),
    );
    const cell = side / Math.max(rows, columns);
    const left = Math.max(MARGIN.left, (width - columns * cell - MARGIN.right + MARGIN.left) / 2);
    const top = MARGIN.top + Math.max(0, (height - MARGIN.top - MARGIN.bottom - rows * cell) / 2);
    const places = { width, height, left, top, cell, rows, columns };
    this.#places = places;
    drawCells(this.#canvas, this.#run.payoff, { left, top, width: columns * cell, height: rows * cell });
    // In parts of the room, which has another size on paper.
    for (const [name, pixels, whole] of [
      ["left", left, width],
      ["top", top, height],
      ["width", columns * cell, width],
      ["height", rows * cell, height],
    ] as const) {
      this.#canvas.style.setProperty(name, `${(100 * pixels) / whole}%`);
    }
    this.#room.style.setProperty("--shape", `${width} / ${height}`);
    this.#overlay.setAttribute("viewBox", `0 0 ${width} ${height}`);
    this.#overlay.replaceChildren(
      axes(places, gameWords(this.#run).generation),
      ...diagonal(places),
      ...this.#curves(places),
      this.#marks,
    );
    this.#mark();
  }

  /** Dots on the curves at the generations that are shown. */
  #dots(places: Places): SVGElement[] {
    const scores = this.#run.findings?.generalization;
    if (!scores) return [];
    const { selected, hover } = this.#store;
    const g = hover.pursuer ?? selected.pursuer;
    const h = hover.evader ?? selected.evader;
    const [px, py] = ofPursuers(places, scores.pursuers.mean[g] ?? 0, g);
    const [ex, ey] = ofEvaders(places, scores.evaders.mean[h] ?? 0, h);
    return [
      svg("circle", { class: "dot of-pursuers", cx: px, cy: py, r: 5 }),
      svg("circle", { class: "dot of-evaders", cx: ex, cy: ey, r: 5 }),
    ];
  }

  #curves(places: Places): SVGElement[] {
    const scores = this.#run.findings?.generalization;
    if (!scores) return [];
    const { left, top, cell, rows, columns } = places;
    const { curves } = gameWords(this.#run);
    const right = left + columns * cell + GAP;
    const above = top - GAP;
    const box = { class: "side" };
    return [
      svg("rect", { ...box, x: right, y: top, width: WIDE, height: rows * cell }),
      svg("rect", { ...box, x: left, y: above - HIGH, width: columns * cell, height: HIGH }),
      ...curve(scores.pursuers, (score, g) => ofPursuers(places, score, g), "of-pursuers"),
      ...curve(scores.evaders, (score, h) => ofEvaders(places, score, h), "of-evaders"),
      svg("text", { class: "tick", x: right, y: top + rows * cell + 16, "text-anchor": "start" }, "0"),
      svg("text", { class: "tick", x: right + WIDE, y: top + rows * cell + 16, "text-anchor": "end" }, "1"),
      svg("text", { class: "tick", x: left - 6, y: above - 4, "text-anchor": "end" }, "0"),
      svg("text", { class: "tick", x: left - 6, y: above - HIGH + 8, "text-anchor": "end" }, "1"),
      svg(
        "text",
        { class: "label of-pursuers", x: right + WIDE, y: top + rows * cell + 34, "text-anchor": "end" },
        curves.pursuer,
      ),
      svg(
        "text",
        {
          class: "label of-evaders",
          x: left + columns * cell + GAP,
          y: above - HIGH + 10,
          "text-anchor": "start",
        },
        curves.evader,
      ),
    ];
  }

  /** Show what is selected, and what is under the pointer. */
  #mark(): void {
    const places = this.#places;
    if (!places) return;
    const { selected, hover } = this.#store;
    const { left, top, cell, rows, columns } = places;
    const y = (g: number): number => top + (rows - 1 - g) * cell;
    const marks: SVGElement[] = [];
    const across = (g: number, style: string) =>
      svg("rect", { class: style, x: left, y: y(g), width: columns * cell + GAP + WIDE, height: cell });
    const down = (h: number, style: string) =>
      svg("rect", {
        class: style,
        x: left + h * cell,
        y: top - GAP - HIGH,
        width: cell,
        height: GAP + HIGH + rows * cell,
      });
    marks.push(across(selected.pursuer, "strip pursuer"), down(selected.evader, "strip evader"));
    if (hover.pursuer !== null && hover.pursuer < rows) marks.push(across(hover.pursuer, "strip hover"));
    if (hover.evader !== null && hover.evader < columns) marks.push(down(hover.evader, "strip hover"));
    marks.push(...this.#dots(places));
    const at = { x: left + selected.evader * cell, y: y(selected.pursuer), width: cell, height: cell };
    marks.push(svg("rect", { class: "chosen under", ...at }), svg("rect", { class: "chosen", ...at }));
    this.#marks.replaceChildren(...marks);
    this.#say();
  }

  #say(): void {
    const { selected, hover } = this.#store;
    const g = hover.pursuer ?? selected.pursuer;
    const h = hover.evader ?? selected.evader;
    const cell = cellOf(this.#run, g, h);
    this.#pair.replaceChildren(
      html("span", { class: "pursuer" }, capital(generationName(this.#run, "pursuer", g))),
      " against ",
      html("span", { class: "evader" }, generationName(this.#run, "evader", h)),
    );
    this.#rate.textContent = cell ? rate(cell.rate, 3) : "-";
    const mean = cell && cell.rates.length > 1 ? `, mean of ${cell.rates.length} episodes` : "";
    this.#more.textContent = cell ? gameWords(this.#run).score + mean : "no episodes were played";
    this.#all.textContent = this.#scores(g, h);
  }

  #scores(g: number, h: number): string {
    const scores = this.#run.findings?.generalization;
    if (!scores) return "";
    const one = (band: Band, at: number): string =>
      interval(band.mean[at] ?? null, band.low?.[at] ?? null, band.high?.[at] ?? null);
    const { means } = gameWords(this.#run);
    return `Against all: ${means.pursuer} ${one(scores.pursuers, g)}, ${means.evader} ${one(scores.evaders, h)}`;
  }

  #under(event: PointerEvent | MouseEvent): { g: number; h: number; inside: boolean } | null {
    const places = this.#places;
    if (!places) return null;
    const box = this.#room.getBoundingClientRect();
    const h = Math.floor((event.clientX - box.left - places.left) / places.cell);
    const g = places.rows - 1 - Math.floor((event.clientY - box.top - places.top) / places.cell);
    const row = g >= 0 && g < places.rows;
    const column = h >= 0 && h < places.columns;
    return row || column ? { g: row ? g : -1, h: column ? h : -1, inside: row && column } : null;
  }

  #point(event: PointerEvent): void {
    const at = this.#under(event);
    this.#store.point(at ? { pursuer: at.g < 0 ? null : at.g, evader: at.h < 0 ? null : at.h } : {});
  }

  #choose(event: MouseEvent): void {
    const at = this.#under(event);
    if (!at) return;
    if (at.inside && needsLoupe(this.#places!.cell)) return this.#look(at.g, at.h);
    this.#store.select({ ...(at.g < 0 ? {} : { pursuer: at.g }), ...(at.h < 0 ? {} : { evader: at.h }) });
    if (at.inside) this.#play();
  }

  #look(g: number, h: number): void {
    const over = loupe(this.#run, g, h, (cell) => {
      over.remove();
      if (!cell) return;
      this.#store.select(cell);
      this.#play();
    });
    this.#room.append(over);
  }

  #play(): void {
    this.#room.dispatchEvent(new CustomEvent("play", { bubbles: true }));
  }
}

function axes(
  { left, top, cell, rows, columns }: Places,
  generation: Readonly<Record<Team, string>>,
): SVGElement {
  const made = svg("g", { class: "axes" });
  const bottom = top + rows * cell;
  const every = (count: number): number[] => ticks(0, count - 1, Math.min(count, (count * cell) / 44), true);
  for (const h of every(columns)) {
    made.append(
      svg("text", { class: "tick", x: left + (h + 0.5) * cell, y: bottom + 16, "text-anchor": "middle" }, h),
    );
  }
  for (const g of every(rows)) {
    made.append(
      svg(
        "text",
        {
          class: "tick",
          x: left - 7,
          y: bottom - (g + 0.5) * cell,
          "text-anchor": "end",
          "dominant-baseline": "middle",
        },
        g,
      ),
    );
  }
  made.append(
    svg(
      "text",
      { class: "label of-evaders", x: left + (columns * cell) / 2, y: bottom + 36, "text-anchor": "middle" },
      generation.evader,
    ),
    svg(
      "text",
      {
        class: "label of-pursuers",
        transform: `translate(${left - 36} ${top + (rows * cell) / 2}) rotate(-90)`,
        "text-anchor": "middle",
      },
      generation.pursuer,
    ),
  );
  return made;
}

/** Lines above and below the cells of equal generations, which stay visible. */
function diagonal({ left, top, cell, rows, columns }: Places): SVGElement[] {
  const made = svg("g", { class: "diagonal" });
  const cells = Math.min(rows, columns);
  if (cells < 3) return [];
  const bottom = top + rows * cell;
  for (const first of ["H", "V"]) {
    let path = `M${left} ${bottom}`;
    for (let i = 1; i <= cells; i++) {
      const x = `H${left + i * cell}`;
      const y = `V${bottom - i * cell}`;
      path += first === "H" ? x + y : y + x;
    }
    made.append(svg("path", { d: path, class: "under" }), svg("path", { d: path }));
  }
  // Beside the stair, parallel to it.
  const x = left + (cells / 2) * cell - 0.7 * cell - 4;
  const y = bottom - (cells / 2) * cell - 0.7 * cell - 4;
  return [
    made,
    svg(
      "text",
      { class: "on-cells", transform: `translate(${x} ${y}) rotate(-45)`, "text-anchor": "middle" },
      "same generation",
    ),
  ];
}

/** The place of a score on the curve on the right, and on the curve above. */
const ofPursuers = ({ left, top, cell, rows, columns }: Places, score: number, g: number): Point => [
  left + columns * cell + GAP + score * WIDE,
  top + (rows - g - 0.5) * cell,
];
const ofEvaders = ({ left, top, cell }: Places, score: number, h: number): Point => [
  left + (h + 0.5) * cell,
  top - GAP - score * HIGH,
];

function curve(
  scores: Band,
  place: (score: number, generation: number) => Point,
  style: string,
): SVGElement[] {
  const points = (values: Band["mean"]): string[] =>
    values.map((score, generation) =>
      place(score ?? 0, generation)
        .map((value) => value.toFixed(1))
        .join(" "),
    );
  const made: SVGElement[] = [];
  if (scores.low && scores.high) {
    made.push(
      svg("path", {
        class: `band ${style}`,
        d: `M${[...points(scores.high), ...points(scores.low).reverse()].join("L")}Z`,
      }),
    );
  }
  made.push(svg("path", { class: `line ${style}`, d: `M${points(scores.mean).join("L")}` }));
  return made;
}
