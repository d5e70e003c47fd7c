// The matrix: a cell for each pair, in the order of the standings, with the names along both sides.

import type { Team } from "../../../web/src/engine/teams.ts";
import { html, svg } from "../../../web/src/page/dom.ts";
import { inkOn, viridisText } from "../../../web/src/explorer/colormap.ts";
import { rate } from "../../../web/src/explorer/format.ts";
import { scaleOfRates } from "../../../web/src/explorer/heatmap.ts";
import type { Data, Pair } from "./data.ts";
import type { Store } from "./store.ts";

/** Size of the drawing in its own units, without the names. */
const SIDE = 1000;
/** The most cells of a row in which numbers are readable. */
const READABLE = 14;
/** The least size of a letter on the screen, in pixels: where the drawing would be smaller, it scrolls. */
const SMALLEST_LETTER = 12;
/** The most characters of a name along a side. */
const LONGEST = 16;

const shortened = (name: string): string => (name.length > LONGEST ? `${name.slice(0, LONGEST - 1)}…` : name);

export class MatrixPanel {
  readonly element: HTMLElement;
  readonly #data: Data;
  readonly #store: Store;
  /** Numbers of the entries from the best to the worst: rows downwards, columns to the right. */
  readonly #rows: readonly number[];
  readonly #columns: readonly number[];
  readonly #readout = html("p", { class: "readout numbers", "aria-live": "polite" });
  readonly #marks = svg("g", { class: "marks" });
  readonly #drawing: SVGSVGElement;

  constructor(data: Data, store: Store) {
    this.#data = data;
    this.#store = store;
    this.#rows = data.standings.pursuer.map(({ number }) => number);
    this.#columns = data.standings.evader.map(({ number }) => number);
    this.#drawing = this.#draw();
    this.element = html(
      "section",
      { class: "card matrix-card", "aria-label": "All matches" },
      html(
        "header",
        {},
        html("h2", {}, "All matches"),
        html(
          "p",
          { class: "small muted" },
          "Capture rate; pursuers in rows, evaders in columns, the best ones first. Click a cell to watch its first episode.",
        ),
      ),
      html("div", { class: "drawing" }, this.#drawing),
      scaleOfRates("0", "1"),
      this.#readout,
    );
    store.on("pair", () => this.#mark());
    store.on("hover", () => this.#mark());
    this.#mark();
  }

  #draw(): SVGSVGElement {
    const rows = this.#rows.length;
    const columns = this.#columns.length;
    const size = SIDE / Math.max(rows, columns);
    const font = Math.min(26, Math.max(11, 0.78 * size));
    const margin =
      widest([...this.#data.names.pursuer, ...this.#data.names.evader].map(shortened), font) + 12;
    const width = columns * size + margin;
    const drawing = svg("svg", {
      class: "matrix",
      tabindex: "0",
      role: "img",
      "aria-label": "Matrix of capture rates; arrow keys choose a match, Enter plays it",
      preserveAspectRatio: "xMidYMin meet",
      viewBox: `${-margin} ${-margin} ${width} ${rows * size + margin}`,
      onpointermove: (event: PointerEvent) => this.#store.point(this.#pairAt(event, size)),
      onpointerleave: () => this.#store.point(null),
      onclick: (event: MouseEvent) => {
        const pair = this.#pairAt(event, size);
        if (pair) this.#store.play(pair);
      },
      onkeydown: (event: KeyboardEvent) => this.#key(event),
    });
    const cells = this.#rows.flatMap((g, row) =>
      this.#columns.map((h, column) => {
        const value = this.#data.capture_rate[g]![h]!;
        return svg("rect", {
          x: column * size,
          y: row * size,
          width: size,
          height: size,
          fill: viridisText(value),
          "data-pair": `${g} ${h}`,
        });
      }),
    );
    drawing.append(
      ...cells,
      ...this.#numbers(size),
      ...this.#names("pursuer", size, font),
      ...this.#names("evader", size, font),
      this.#marks,
    );
    this.#marks.dataset["size"] = String(size);
    drawing.style.minWidth = `${(SMALLEST_LETTER / font) * width}px`;
    return drawing;
  }

  /** The rates in the cells, where there are few. */
  #numbers(size: number): SVGTextElement[] {
    if (Math.max(this.#rows.length, this.#columns.length) > READABLE) return [];
    return this.#rows.flatMap((g, row) =>
      this.#columns.map((h, column) => {
        const value = this.#data.capture_rate[g]![h]!;
        return svg(
          "text",
          {
            x: (column + 0.5) * size,
            y: (row + 0.5) * size,
            fill: inkOn(value),
            "font-size": Math.min(30, 0.38 * size),
            class: "in-cell",
          },
          rate(value),
        );
      }),
    );
  }

  #names(team: Team, size: number, font: number): SVGTextElement[] {
    const order = team === "pursuer" ? this.#rows : this.#columns;
    return order.map((number, place) => {
      const middle = (place + 0.5) * size;
      const where =
        team === "pursuer"
          ? { x: -6, y: middle, "text-anchor": "end" }
          : { transform: `translate(${middle} -6) rotate(-90)`, "text-anchor": "start" };
      return svg(
        "text",
        {
          ...where,
          class: `name ${this.#standing(team, number).kind}`,
          "font-size": font,
          "data-name": `${team} ${number}`,
        },
        shortened(this.#data.names[team][number]!),
      );
    });
  }

  #standing(team: Team, number: number): { kind: string } {
    return this.#data.standings[team].find((each) => each.number === number)!;
  }

  /** Return the pair at a pointer; null outside of the cells. */
  #pairAt(event: MouseEvent, size: number): Pair | null {
    const place = new DOMPoint(event.clientX, event.clientY).matrixTransform(
      this.#drawing.getScreenCTM()!.inverse(),
    );
    const pursuer = this.#rows[Math.floor(place.y / size)];
    const evader = this.#columns[Math.floor(place.x / size)];
    return pursuer === undefined || evader === undefined || place.x < 0 || place.y < 0
      ? null
      : { pursuer, evader };
  }

  #key(event: KeyboardEvent): void {
    const moves: Record<string, readonly [number, number]> = {
      ArrowUp: [-1, 0],
      ArrowDown: [1, 0],
      ArrowLeft: [0, -1],
      ArrowRight: [0, 1],
    };
    const move = moves[event.key];
    if (event.key === "Enter") this.#store.play(this.#store.pair);
    else if (move) this.#step(move);
    else return;
    event.preventDefault();
    event.stopPropagation();
  }

  #step([down, right]: readonly [number, number]): void {
    const { pursuer, evader } = this.#store.pair;
    const row = this.#rows[this.#rows.indexOf(pursuer) + down];
    const column = this.#columns[this.#columns.indexOf(evader) + right];
    if (row !== undefined && column !== undefined) this.#store.select({ pursuer: row, evader: column });
  }

  #mark(): void {
    const { pair, hover } = this.#store;
    const size = Number(this.#marks.dataset["size"]);
    const outline = ({ pursuer, evader }: Pair, kind: string): SVGRectElement =>
      svg("rect", {
        class: kind,
        x: this.#columns.indexOf(evader) * size,
        y: this.#rows.indexOf(pursuer) * size,
        width: size,
        height: size,
      });
    this.#marks.replaceChildren(
      outline(pair, "selected-halo"),
      outline(pair, "selected"),
      ...(hover ? [outline(hover, "hovered-halo"), outline(hover, "hovered")] : []),
    );
    const shown = hover ?? pair;
    for (const name of this.#drawing.querySelectorAll<SVGElement>("[data-name]")) {
      const about = [`pursuer ${shown.pursuer}`, `evader ${shown.evader}`].includes(name.dataset["name"]!);
      name.classList.toggle("about", about);
    }
    this.#readout.replaceChildren(...this.#read(shown));
  }

  #read({ pursuer, evader }: Pair): Node[] {
    const { names, capture_rate, lowest, highest, length, episodes } = this.#data;
    const mean = rate(capture_rate[pursuer]![evader]);
    const low = rate(lowest[pursuer]![evader]);
    const high = rate(highest[pursuer]![evader]);
    return [
      html(
        "span",
        {},
        html("span", { class: "pursuer" }, names.pursuer[pursuer]!),
        " against ",
        html("span", { class: "evader" }, names.evader[evader]!),
      ),
      html(
        "span",
        {},
        html("strong", {}, mean),
        html(
          "span",
          { class: "small muted" },
          ` captured; ${low} to ${high} in ${episodes} episodes, ${length[pursuer]![evader]!.toFixed(0)} steps on average`,
        ),
      ),
    ];
  }
}

/** Return the width of the widest name, in bold as that of a selected pair. */
function widest(names: readonly string[], font: number): number {
  const ctx = document.createElement("canvas").getContext("2d")!;
  ctx.font = `700 ${font}px ${getComputedStyle(document.body).fontFamily}`;
  return Math.max(...names.map((name) => ctx.measureText(name).width));
}
