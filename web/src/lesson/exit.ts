// The exit question.

import { saveFile } from "../page/dialog.ts";
import { html } from "../page/dom.ts";
import type { WidgetPart } from "./data.ts";
import { inline } from "./parts.ts";
import type { Store } from "./store.ts";

/** A shorter text answers no part of the question. */
const SHORTEST = 40;

export function exitWidget({ question = "", points = [] }: WidgetPart, store: Store): HTMLElement {
  const field = html("textarea", { id: "exit-answer", rows: 8 });
  const printed = html("p", { class: "printed" });
  const status = html("p", { class: "small muted", role: "status" });
  const done = html("button", { type: "submit", class: "primary" }, "I am done");
  const form = html("form", { class: "exercise" },
    html("label", { for: "exit-answer" }, html("strong", {}, "Exit question. "), question), field, printed,
    html("div", { class: "buttons" }, done,
      html("button", { type: "button", onclick: () => saveFile("exit_answer.txt", `${question}\n\n${field.value}\n`) }, "Save my answer"), status));
  const show = (): void => {
    printed.textContent = store.exit.exit;
    if (!store.exit.done) return;
    [field.readOnly, done.hidden] = [true, true];
    form.append(html("div", { class: "reply" }, html("p", {}, html("strong", {}, "A good answer has:")),
      html("ul", {}, ...points.map((point) => html("li", {}, ...inline(point))))));
  };
  field.value = store.exit.exit;
  field.addEventListener("input", () => {
    store.exit = { exit: field.value };
    printed.textContent = field.value;
  });
  form.addEventListener("submit", (event) => {
    event.preventDefault();
    if (field.value.trim().length < SHORTEST) {
      status.textContent = "Write two explanations and an experiment first. Then the page shows what a good answer has.";
      return;
    }
    status.textContent = "";
    store.exit = { done: true };
    show();
  });
  show();
  return html("div", { class: "widget" }, form);
}
