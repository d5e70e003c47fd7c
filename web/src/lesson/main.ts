// The lesson that needs no installation: sections whose parts appear with the predictions.

import "./lesson.css";
import { loadEngine } from "../engine/engine.ts";
import type { Engine } from "../engine/engine.ts";
import { html } from "../page/dom.ts";
import { themeButton } from "../page/theme.ts";
import { readLesson } from "./data.ts";
import type { Outcome, Part, Prediction, Section, WidgetPart } from "./data.ts";
import { exitWidget, saveFile } from "./exit.ts";
import { handsMatrix, handsWidget } from "./hands.ts";
import { flatCurve, racesToGuess, sameDiagonals } from "./matrices.ts";
import { gamesWidget, numbersWidget } from "./numbers.ts";
import { exercisePart, outcomeOf, paragraphs, predictionPart } from "./parts.ts";
import { chase, explorer, judgement } from "./races.ts";
import { rightOfWay } from "./right_of_way.ts";
import { Store } from "./store.ts";

const isPrediction = (part: Part | undefined): part is Prediction => part !== undefined && "predict" in part;
const isOutcome = (part: Part): part is Outcome => "outcome" in part && !isPrediction(part);

const lesson = readLesson();
const store = new Store();
const predictions = new Map(lesson.sections.flatMap(({ parts }) => parts.filter(isPrediction).map((part) => [part.predict, part])));

const WIDGETS: Readonly<Record<string, (part: WidgetPart) => HTMLElement>> = {
  chase: () => chase(lesson, engine),
  "right-of-way": rightOfWay,
  flat: flatCurve,
  hands: handsWidget,
  "hands-matrix": handsMatrix,
  games: gamesWidget,
  numbers: numbersWidget,
  matrices: () => racesToGuess(lesson),
  explorer: () => explorer(lesson, engine),
  judgement: () => judgement(lesson),
  "same-diagonal": sameDiagonals,
  exit: (part) => exitWidget(part, store),
};

/** Return the prediction that a part waits for; undefined if it waits for none. */
const waitsFor = (part: Part): string | undefined =>
  "widget" in part ? part.needs : isOutcome(part) ? part.outcome : undefined;

function elementOf(part: Part): HTMLElement {
  if ("text" in part) return html("div", { class: "text" }, ...paragraphs(part.text));
  if ("widget" in part) return WIDGETS[part.widget]!(part);
  if ("exercise" in part) return exercisePart(part, store);
  if (isPrediction(part)) return predictionPart(part, store);
  const asked = predictions.get(part.outcome)!;
  return html("div", { class: "prediction" }, html("p", {}, html("strong", {}, asked.question)), outcomeOf(asked, store.choice(part.outcome)!));
}

/** Return a section that shows its parts up to its first open prediction, and more when it is made. */
function sectionOf(section: Section, number: number): HTMLElement {
  const waiting = html("p", { class: "waiting muted", role: "status" });
  const made = html("section", { class: "card", id: section.id, "aria-labelledby": `title-${section.id}` },
    html("h2", { id: `title-${section.id}` }, `${number + 1}. ${section.title}`, html("span", { class: "muted small" }, `${section.minutes} minutes`)), waiting);
  let shown = 0;
  const grow = (): void => {
    waiting.textContent = "";
    for (; shown < section.parts.length; shown++) {
      const [before, part] = [section.parts[shown - 1], section.parts[shown]!];
      const open = [isPrediction(before) ? before.predict : undefined, waitsFor(part)].find((name) => name && store.choice(name) === undefined);
      if (open) {
        const place = lesson.sections.findIndex(({ parts }) => parts.some((each) => isPrediction(each) && each.predict === open));
        waiting.textContent = `This section goes on with your prediction${place === number ? "" : ` in section ${place + 1}`}.`;
        return;
      }
      waiting.before(elementOf(part));
    }
    waiting.remove();
  };
  store.addEventListener("choice", grow);
  grow();
  return made;
}

let start: (engine: Engine) => void = () => undefined;
const engine = new Promise<Engine>((resolve) => (start = resolve));

const counted = html("span", { class: "small muted", role: "status" });
const count = (): void => void (counted.textContent = `${store.count} of ${predictions.size} predictions made. `
  + (store.keeps ? "They stay in this browser." : "This browser keeps nothing: save before you close the page."));
store.addEventListener("choice", count);
const anew = (): void => {
  if (!confirm("Delete all predictions and answers in this browser, for another student? Save them first.")) return;
  store.forget();
  location.reload();
};

document.getElementById("page")!.replaceWith(
  html("header", { class: "top" },
    html("div", {}, html("h1", {}, lesson.title), html("p", { class: "lead" }, lesson.lead)),
    html("div", { class: "tools" }, themeButton())),
  html("nav", { class: "sections", "aria-label": "Sections" },
    ...lesson.sections.map((section, at) => html("a", { href: `#${section.id}` }, `${at + 1}. ${section.title}`))),
  html("main", {}, ...lesson.sections.map(sectionOf)),
  html("footer", { class: "card" },
    html("div", { class: "buttons" },
      html("button", { type: "button", class: "primary save", onclick: () => saveFile("predictions.jsonl", store.file) }, "Save my predictions"),
      html("button", { type: "button", onclick: () => print() }, "Print"),
      html("button", { type: "button", onclick: anew }, "Start anew"), counted),
    html("p", { class: "small muted" }, `The page sends nothing anywhere. matrixworld ${lesson.version}`)));
count();

// The page is drawn before the engine is compiled.
requestAnimationFrame(() => setTimeout(() => {
  loadEngine().then(start, (error: unknown) => {
    document.querySelector("main")!.prepend(html("p", { class: "card problem", role: "alert" }, `The engine does not start here: ${String(error)}`));
  }).finally(() => (document.body.dataset["ready"] = "true"));
}));
