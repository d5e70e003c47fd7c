// Texts, predictions, exercises and the exit question as elements.

import { saveFile } from "../page/dialog.ts";
import { html } from "../page/dom.ts";
import { checkOf } from "./exercises.ts";
import type { Exercise, Prediction, WidgetPart } from "./data.ts";
import type { Store } from "./store.ts";

/** Return paragraphs of a text in which **this** is bold. */
export const paragraphs = (text: string): HTMLElement[] =>
  text
    .trim()
    .split(/\n\s*\n/)
    .map((each) => html("p", {}, ...inline(each)));

const inline = (text: string): Node[] =>
  text
    .split("**")
    .map((each, place) => (place % 2 ? html("strong", {}, each) : document.createTextNode(each)));

/** Return a question with options. The choice is made once, and the reply appears with it. */
export function predictionPart(part: Prediction, store: Store): HTMLElement {
  const { predict: name, options } = part;
  const status = html("p", { class: "small muted", role: "status" });
  const button = html("button", { type: "submit", class: "primary" }, "This is my prediction");
  const radios = Object.keys(options).map((option) =>
    html("input", { type: "radio", name: `prediction-${name}`, value: option }),
  );
  const form = html(
    "form",
    { class: "prediction", id: `prediction-${name}` },
    html(
      "fieldset",
      {},
      html("legend", {}, html("strong", {}, "Predict. "), part.question),
      ...radios.map((radio) =>
        html("label", { class: "option" }, radio, html("span", {}, options[radio.value])),
      ),
    ),
    html("div", { class: "buttons" }, button, status),
  );
  const show = (): void => {
    const choice = store.choice(name);
    if (choice === undefined) return;
    for (const radio of radios) {
      radio.checked = radio.value === choice;
      radio.disabled = true;
    }
    button.hidden = button.disabled = true;
    status.replaceChildren();
    form.append(
      part.later
        ? html("p", { class: "reply" }, part.later)
        : outcomeOf(part, choice, part.again && store.choice(part.again)),
    );
  };
  form.addEventListener("submit", (event) => {
    event.preventDefault();
    const chosen = radios.find((radio) => radio.checked);
    if (!chosen) {
      status.textContent = "Choose one first. Any prediction is a good one.";
    } else {
      store.choose(name, chosen.value);
      show();
    }
  });
  show();
  return form;
}

/** Return what was predicted, at first and now, what is so, and why. */
function outcomeOf(part: Prediction, choice: string, first?: string): HTMLElement {
  const { options, outcome } = part;
  const right = choice === outcome;
  return html(
    "div",
    { class: "reply", role: "status", "data-right": String(right) },
    first && html("p", {}, html("strong", {}, "At the beginning you predicted: "), options[first]),
    html("p", {}, html("strong", {}, right ? "✓ As you predicted: " : "You predicted: "), options[choice]),
    right ? null : html("p", {}, html("strong", {}, "The outcome: "), options[outcome]),
    ...paragraphs(part.explanation ?? ""),
    part.note && html("p", { class: "small muted" }, part.note),
  );
}

/** Return an exercise with its input and a button that checks the answer, as often as one likes. */
export function exercisePart(part: Exercise, store: Store): HTMLElement {
  const { input, check, answer, set } = checkOf(part);
  const reply = html("p", { class: "reply", role: "status", hidden: true });
  const tell = (mistake: string | null): void => {
    reply.hidden = false;
    reply.dataset["right"] = String(mistake === null);
    reply.replaceChildren(
      html("strong", {}, mistake === null ? "✓ Right. " : "✗ Not yet. "),
      mistake ?? part.explanation,
    );
  };
  const form = html(
    "form",
    { class: "exercise", id: `exercise-${part.exercise}` },
    html("div", { class: "text" }, html("p", {}, html("strong", {}, "Exercise. "), ...inline(part.question))),
    part.matrix && tableOf(part.matrix),
    html("div", { class: "buttons" }, input, html("button", { type: "submit" }, "Check")),
    reply,
  );
  form.addEventListener("submit", (event) => {
    event.preventDefault();
    const mistake = check();
    if (mistake === null) store.solve(part.exercise, answer());
    tell(mistake);
  });
  const solved = store.solved(part.exercise);
  if (solved !== undefined) {
    set(solved);
    tell(null);
  }
  return form;
}

function tableOf(matrix: readonly (readonly number[])[]): HTMLElement {
  const names = matrix.map((_, generation) => generation);
  return html(
    "div",
    { class: "wide-table", tabindex: 0 },
    html(
      "table",
      { class: "rates numbers" },
      html(
        "thead",
        {},
        html(
          "tr",
          {},
          html("td"),
          html(
            "th",
            { scope: "colgroup", colspan: names.length, class: "evader" },
            "generation of the evaders",
          ),
        ),
        html(
          "tr",
          {},
          html("th", { class: "pursuer" }, "generation of the pursuers"),
          ...names.map((each) => html("th", { scope: "col" }, each)),
        ),
      ),
      html(
        "tbody",
        {},
        ...matrix.map((row, generation) =>
          html(
            "tr",
            {},
            html("th", { scope: "row" }, generation),
            ...row.map((rate) => html("td", {}, rate.toFixed(1))),
          ),
        ),
      ),
    ),
  );
}

// ---- The exit question

/** A shorter text answers no part of the question. */
const SHORTEST = 40;

export function exitWidget({ question = "", points = [] }: WidgetPart, store: Store): HTMLElement {
  const field = html("textarea", {
    id: "exit-answer",
    rows: 8,
    oninput: () => {
      store.exit = { exit: field.value };
      printed.textContent = field.value;
    },
  });
  const printed = html("p", { class: "printed" });
  const status = html("p", { class: "small muted", role: "status" });
  const done = html("button", { type: "submit", class: "primary" }, "I am done");
  const form = html(
    "form",
    { class: "exercise" },
    html("label", { for: "exit-answer" }, html("strong", {}, "Exit question. "), question),
    field,
    printed,
    html(
      "div",
      { class: "buttons" },
      done,
      html(
        "button",
        { type: "button", onclick: () => saveFile("exit_answer.txt", `${question}\n\n${field.value}\n`) },
        "Save my answer",
      ),
      status,
    ),
  );
  const show = (): void => {
    printed.textContent = store.exit.exit;
    if (!store.exit.done) return;
    field.readOnly = true;
    done.hidden = true;
    form.append(
      html(
        "div",
        { class: "reply" },
        html("p", {}, html("strong", {}, "A good answer has:")),
        html("ul", {}, ...points.map((point) => html("li", {}, ...inline(point)))),
      ),
    );
  };
  field.value = store.exit.exit;
  form.addEventListener("submit", (event) => {
    event.preventDefault();
    if (field.value.trim().length < SHORTEST) {
      status.textContent =
        "Write two explanations and an experiment first. Then the page shows what a good answer has.";
      return;
    }
    status.textContent = "";
    store.exit = { done: true };
    show();
  });
  show();
  return html("div", { class: "widget" }, form);
}
