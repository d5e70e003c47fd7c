// What can be turned: a few things in words of a visitor, and more of it for those who want to know.

import { html, select } from "../page/dom.ts";
import { LEAST_VIEW, MOST_AGENTS, MOST_SEED, POPULATIONS, STEPS, VIEWS } from "./choice.ts";
import type { Choice } from "./choice.ts";
import { SCHEDULES } from "./data.ts";
import type { EvolveData, LearnerName, PolicyName } from "./data.ts";

type Option = readonly [value: string | number, text: string];

/** Seeds that "Another seed" draws from. */
const SEEDS = 1000;
/** The view of networks over cells: larger ones have more weights than a short race can learn. */
const VIEW_OF_CELLS = 5;

function field(name: string, about: string, control: HTMLElement, style = ""): HTMLElement {
  return html(
    "label",
    { class: `field ${style}`, title: about },
    html("span", { class: "field-name" }, name),
    control,
    html("span", { class: "about small muted" }, about),
  );
}

/** What a control asks for: another choice, and whether it needs a new race. */
export type Ask = (change: Partial<Choice>, anew?: boolean) => void;

/** Return the controls of everybody, those for who wants more, and what shows a choice in both. */
export function controls(
  data: EvolveData,
  ask: Ask,
): { main: HTMLElement; more: HTMLElement; show: (choice: Choice) => void } {
  const schedules = Object.entries(SCHEDULES);
  const worldOf = (name: string): Partial<Choice> => {
    const { n_pursuers, n_evaders, max_steps } = data.worlds[name]!;
    return { world: name, pursuers: n_pursuers, evaders: n_evaders, steps: max_steps, walls: null };
  };
  const about = (name: string): string => {
    const { rows, cols, n_pursuers, n_evaders } = data.worlds[name]!;
    return `${name}: ${rows} x ${cols}, ${n_pursuers} against ${n_evaders}`;
  };
  const world = select(
    Object.keys(data.worlds).map((name) => [name, about(name)]),
    (value) => ask(worldOf(value), true),
  );
  const schedule = select(schedules, (value) => ask({ schedule: value }));
  const beside = select([["", "Nothing"], ...schedules], (value) => ask({ beside: value }, true));
  const counts = Array.from({ length: MOST_AGENTS }, (_, i): Option => [i + 1, String(i + 1)]);
  const pursuers = select(counts, (value) => ask({ pursuers: Number(value) }));
  const evaders = select(counts, (value) => ask({ evaders: Number(value) }));
  const view = select(
    VIEWS.map((size) => [size, `${size} x ${size}`]),
    (value) => ask({ view: Number(value), ...(Number(value) < LEAST_VIEW ? { way: false } : {}) }),
  );
  const way = html("input", {
    type: "checkbox",
    onchange: () =>
      ask({ way: way.checked, ...(way.checked ? { view: Math.max(LEAST_VIEW, Number(view.value)) } : {}) }),
  });
  const population = select(
    [[0, "usual"], ...POPULATIONS.map((size): Option => [size, String(size)])],
    (value) => ask({ population: Number(value) }),
  );
  const steps = select(
    STEPS.map((count) => [count, String(count)]),
    (value) => ask({ steps: Number(value) }),
  );
  const learner = select(
    [
      ["es", "evolution strategy"],
      ["ga", "genetic algorithm"],
    ],
    (value) => ask({ learner: value as LearnerName }, true),
  );
  const policy = select(
    [
      ["rating", "weights of named inputs"],
      ["cells", "a network over the cells of its view"],
    ],
    (value) =>
      ask({ policy: value as PolicyName, ...(value === "cells" ? { view: VIEW_OF_CELLS } : {}) }, true),
  );
  const seed = html("input", { type: "number", min: 0, max: MOST_SEED, step: 1, inputmode: "numeric" });
  seed.addEventListener("change", () =>
    ask({ seed: Math.min(MOST_SEED, Math.max(0, Math.round(Number(seed.value)) || 0)) }, true),
  );
  const another = html(
    "button",
    { type: "button", onclick: () => ask({ seed: Math.floor(Math.random() * SEEDS) }, true) },
    "Another seed",
  );
  const card = (title: string, style: string, ...fields: HTMLElement[]): HTMLElement =>
    html(
      "section",
      { class: `controls ${style}`, "aria-label": title },
      html("fieldset", {}, html("legend", {}, title), ...fields),
    );
  return {
    main: card(
      "Try something else",
      "card",
      field("World", "where they meet; begins a new race", world, "wide"),
      field("Pursuers", "triangles; at once", pursuers),
      field("Evaders", "discs; at once", evaders),
      field("Steps", "after which evaders that are free have won", steps),
      field(
        "Seed",
        "the luck of the race; begins a new one",
        html("span", { class: "seed" }, seed, another),
        "half",
      ),
    ),
    more: html(
      "details",
      { class: "card more-controls" },
      html("summary", {}, "More: whom they meet, how they learn, what they see"),
      card(
        "How they learn",
        "",
        field("Opponents", "whom the teams meet while they learn", schedule, "wide"),
        field("Side by side with", "a second race of the same seed", beside, "wide"),
        field("What evolves", "what an agent decides by", policy, "half"),
        field("Learner", "how a team learns", learner, "half"),
        field("View", "cells that an agent sees around itself", view),
        field("Right of way", "agents never take a move that could put them at fault", html("span", {}, way)),
        field("Population", "candidates that are compared at a time", population),
      ),
    ),
    show: (choice) => {
      world.value = choice.world;
      schedule.value = choice.schedule;
      beside.value = choice.beside;
      view.value = String(choice.view);
      learner.value = choice.learner;
      population.value = String(choice.population);
      steps.value = String(choice.steps);
      seed.value = String(choice.seed);
      way.checked = choice.way;
      policy.value = choice.policy;
      pursuers.value = String(choice.pursuers);
      evaders.value = String(choice.evaders);
    },
  };
}
