// What can be turned while a race goes on, and what a new race begins with.

import { html, select } from "../page/dom.ts";
import { LEAST_VIEW, MOST_AGENTS, MOST_SEED, POPULATIONS, STEPS, VIEWS } from "./choice.ts";
import type { Choice } from "./choice.ts";
import { SCHEDULES } from "./data.ts";

type Option = readonly [value: string | number, text: string];

function field(name: string, about: string, control: HTMLElement, style = ""): HTMLElement {
  return html("label", { class: `field ${style}`, title: about },
    html("span", { class: "field-name" }, name), control, html("span", { class: "about small muted" }, about));
}

/** What a control asks for: another choice, and whether it needs a new race. */
export type Ask = (change: Partial<Choice>, anew?: boolean) => void;

/** Return the controls of the race that goes on, those of a new one, and what shows a choice in both. */
export function controls(ask: Ask): { now: HTMLElement; anew: HTMLElement; show: (choice: Choice) => void } {
  const schedules = Object.entries(SCHEDULES);
  const schedule = select(schedules, (value) => ask({ schedule: value }));
  const beside = select([["", "Nothing"], ...schedules], (value) => ask({ beside: value || null }, true));
  const counts = Array.from({ length: MOST_AGENTS }, (_, i): Option => [i + 1, String(i + 1)]);
  const pursuers = select(counts, (value) => ask({ pursuers: Number(value) }));
  const evaders = select(counts, (value) => ask({ evaders: Number(value) }));
  const view = select(VIEWS.map((size) => [size, `${size} x ${size}`]), (value) => ask({ view: Number(value), ...(Number(value) < LEAST_VIEW ? { way: false } : {}) }));
  const way = html("input", { type: "checkbox", onchange: () => ask({ way: way.checked, ...(way.checked ? { view: Math.max(LEAST_VIEW, Number(view.value)) } : {}) }) });
  const population = select([[0, "usual"], ...POPULATIONS.map((size): Option => [size, String(size)])], (value) => ask({ population: Number(value) }));
  const steps = select(STEPS.map((count) => [count, String(count)]), (value) => ask({ steps: Number(value) }));
  const learner = select([["es", "evolution strategy"], ["ga", "genetic algorithm"]], (value) => ask({ learner: value as "es" }, true));
  const policy = select([["", "a network over the cells of its view"], ["1", "weights of named inputs"]], (value) => ask({ ratings: value === "1" }, true));
  const seed = html("input", { type: "number", min: 0, max: MOST_SEED, step: 1, inputmode: "numeric" });
  seed.addEventListener("change", () => ask({ seed: Math.min(MOST_SEED, Math.max(0, Math.round(Number(seed.value)) || 0)) }, true));
  const another = html("button", { type: "button", onclick: () => ask({ seed: Math.floor(Math.random() * 1000) }, true) }, "Another seed");
  const card = (title: string, ...fields: HTMLElement[]): HTMLElement =>
    html("section", { class: "card controls", "aria-label": title }, html("fieldset", {}, html("legend", {}, title), ...fields));
  return {
    now: card("Change it while it evolves",
      field("Opponents", "whom the teams meet while they learn", schedule, "wide"),
      field("Pursuers", "triangles", pursuers),
      field("Evaders", "discs", evaders),
      field("View", "cells that an agent sees around itself", view),
      field("Right of way", "agents never take a move that could put them at fault", html("span", {}, way)),
      field("Population", "candidates that are compared at a time", population),
      field("Steps", "of a match", steps)),
    anew: card("Begin anew",
      field("Side by side with", "a second race of the same seed", beside, "wide"),
      field("Learner", "how a team learns", learner, "half"),
      field("What evolves", "what an agent decides by", policy, "half"),
      field("Seed", "the luck of the race", html("span", { class: "seed" }, seed, another), "half")),
    show: (choice) => {
      [schedule.value, beside.value, view.value, learner.value] = [choice.schedule, choice.beside ?? "", String(choice.view), choice.learner];
      [population.value, steps.value, seed.value, way.checked] = [String(choice.population), String(choice.steps), String(choice.seed), choice.way];
      policy.value = choice.ratings ? "1" : "";
      [pursuers.value, evaders.value] = [String(choice.pursuers), String(choice.evaders)];
    },
  };
}
