// The lesson that needs no installation: sections whose parts appear with the predictions. The same
// script is the worker of the races that evolve, and the page that counts the votes of a class.

import "./lesson.css";
import { loadEngine } from "../engine/engine.ts";
import type { Engine } from "../engine/engine.ts";
import { work } from "../evolve/worker.ts";
import { saveFile } from "../page/dialog.ts";
import { html, started } from "../page/dom.ts";
import { top } from "../page/top.ts";
import { isPrediction, predictionsOf, readLesson } from "./data.ts";
import type { Lesson, Part, Section, WidgetPart } from "./data.ts";
import { handsMatrix, handsWidget } from "./hands.ts";
import { flatCurve, racesToGuess, rightOfWay, sameDiagonals } from "./pictures.ts";
import { gamesWidget, numbersWidget } from "./numbers.ts";
import { exercisePart, exitWidget, paragraphs, predictionPart } from "./parts.ts";
import { chase, evolving, explorer, judgement } from "./races.ts";
import { Store } from "./store.ts";
import { votePage } from "./vote_page.ts";

/** The part of the address that asks for the votes of a class. */
const VOTES = "#votes";
/** Widgets that take the whole width; others stand beside the text where there is room. */
const WIDE = ["explorer"];

/** Return the prediction that a part waits for; undefined if it waits for none. */
const waitsFor = (part: Part): string | undefined => ("needs" in part ? part.needs : undefined);

const isWidget = (part: Part): part is WidgetPart => "widget" in part;

/** Return parts in blocks: a text with what belongs to it, one widget at most. */
function blocksOf(parts: readonly Part[]): Part[][] {
  const blocks: Part[][] = [];
  for (const part of parts) {
    const last = blocks.at(-1);
    if (!last || "text" in part || (isWidget(part) && last.some(isWidget))) blocks.push([part]);
    else last.push(part);
  }
  return blocks;
}

/** Return the style of a block: a widget beside the other parts, alone, or below them. */
function styleOf(block: readonly Part[]): string {
  const widget = block.find(isWidget);
  return widget && block.length > 1 && !WIDE.includes(widget.widget) && !widget.grows
    ? "block beside"
    : "block";
}

class Page {
  readonly #lesson: Lesson;
  readonly #store: Store;
  #start: (engine: Engine) => void = () => undefined;
  readonly #engine = new Promise<Engine>((resolve) => (this.#start = resolve));
  readonly #widgets: Readonly<Record<string, (part: WidgetPart) => HTMLElement>> = {
    chase: () => chase(this.#lesson, this.#engine),
    evolving: (part) => evolving(this.#lesson, this.#engine, part),
    "right-of-way": rightOfWay,
    flat: flatCurve,
    hands: handsWidget,
    "hands-matrix": handsMatrix,
    games: gamesWidget,
    numbers: numbersWidget,
    matrices: () => racesToGuess(this.#lesson),
    explorer: () => explorer(this.#lesson, this.#engine),
    judgement: () => judgement(this.#lesson),
    "same-diagonal": sameDiagonals,
    exit: (part) => exitWidget(part, this.#store),
  };

  constructor(lesson: Lesson) {
    this.#lesson = lesson;
    this.#store = new Store(lesson.edition);
    const store = this.#store;
    const asked = predictionsOf(lesson).size;
    const counted = html("span", { class: "small muted", role: "status" });
    const count = (): void => {
      const kept = store.keeps
        ? "They stay in this browser."
        : "This browser keeps nothing: save before you close the page.";
      counted.textContent = `${store.count} of ${asked} predictions made. ${kept}`;
    };
    store.addEventListener("choice", count);
    const anew = (): void => {
      if (
        !confirm("Delete all predictions and answers in this browser, for another student? Save them first.")
      ) {
        return;
      }
      store.forget();
      location.reload();
    };
    document.getElementById("page")!.replaceWith(
      top(lesson.title, lesson.lead),
      html(
        "nav",
        { class: "sections", "aria-label": "Sections" },
        ...lesson.sections.map((section, at) =>
          html("a", { href: `#${section.id}` }, `${at + 1}. ${section.title}`),
        ),
      ),
      html("main", {}, ...lesson.sections.map((section, at) => this.#sectionOf(section, at))),
      html(
        "footer",
        { class: "card" },
        html(
          "div",
          { class: "buttons" },
          html(
            "button",
            {
              type: "button",
              class: "primary save",
              onclick: () => saveFile("predictions.jsonl", store.file),
            },
            "Save my predictions",
          ),
          html("button", { type: "button", onclick: () => print() }, "Print"),
          html("button", { type: "button", onclick: anew }, "Start anew"),
          counted,
        ),
        html(
          "p",
          { class: "small muted" },
          `The page sends nothing anywhere. matrixworld ${lesson.version}, edition ${lesson.edition} of the course. Teachers: `,
          html("a", { href: VOTES }, "count the votes of a class"),
          ".",
        ),
      ),
    );
    count();
  }

  /** Compile the engine, for what waits for it. */
  async load(): Promise<void> {
    this.#start(await loadEngine());
  }

  #elementOf(part: Part): HTMLElement {
    if ("text" in part) return html("div", { class: "text" }, ...paragraphs(part.text));
    if (isWidget(part)) return this.#widgets[part.widget]!(part);
    if ("exercise" in part) return exercisePart(part, this.#store);
    return predictionPart(part, this.#store);
  }

  /** Return a section that shows its parts up to its first open prediction, and more when it is made. */
  #sectionOf(section: Section, number: number): HTMLElement {
    const { sections } = this.#lesson;
    const waiting = html("p", { class: "waiting muted", role: "status" });
    const made = html(
      "section",
      { class: "card", id: section.id, "aria-labelledby": `title-${section.id}` },
      html(
        "h2",
        { id: `title-${section.id}` },
        `${number + 1}. ${section.title}`,
        html("span", { class: "muted small" }, `${section.minutes} minutes`),
      ),
      waiting,
    );
    const blocks = blocksOf(section.parts);
    const rooms = blocks.map((block) => html("div", { class: styleOf(block) }));
    const places = blocks.flatMap((block, at) => block.map(() => rooms[at]!));
    let shown = 0;
    const grow = (): void => {
      waiting.textContent = "";
      for (; shown < section.parts.length; shown++) {
        const before = section.parts[shown - 1];
        const part = section.parts[shown]!;
        const open = [isPrediction(before) ? before.predict : undefined, waitsFor(part)].find(
          (name) => name && this.#store.choice(name) === undefined,
        );
        if (open) {
          const place = sections.findIndex(({ parts }) =>
            parts.some((each) => isPrediction(each) && each.predict === open),
          );
          waiting.textContent = `This section goes on with your prediction${place === number ? "" : ` in section ${place + 1}`}.`;
          return;
        }
        waiting.before(places[shown]!);
        places[shown]!.append(this.#elementOf(part));
      }
      waiting.remove();
    };
    this.#store.addEventListener("choice", grow);
    grow();
    return made;
  }
}

function show(): void {
  const lesson = readLesson();
  const voting = (): boolean => location.hash === VOTES;
  const votes = voting();
  window.addEventListener("hashchange", () => voting() !== votes && location.reload());
  if (votes) return void started(Promise.resolve(votePage(lesson)));
  const page = new Page(lesson);
  // The page is drawn before the engine is compiled.
  requestAnimationFrame(() => setTimeout(() => started(page.load())));
}

if (typeof document === "undefined") work(globalThis as unknown as Parameters<typeof work>[0]);
else show();
