// Checks of exercises: what is not right yet, in words.

import { showRate } from "../explorer/heatmap.ts";
import { html } from "../page/dom.ts";
import type { Exercise } from "./data.ts";

/** The input of an exercise; `check` returns what is not right yet, or null. */
interface Checked {
  readonly input: HTMLElement;
  readonly check: () => string | null;
  readonly answer: () => string;
  readonly set: (answer: string) => void;
}

export const checkOf = (part: Exercise): Checked =>
  part.answer === undefined ? raceOfCells() : ofNumber(part, part.answer);

function ofNumber(part: Exercise, right: number): Checked {
  const input = html("input", {
    type: "text",
    inputmode: "decimal",
    size: 8,
    "aria-label": "Your answer, a number",
    autocomplete: "off",
  });
  const check = (): string | null => {
    const given = input.value.trim().replace(",", ".");
    const number = Number(given);
    if (given === "" || Number.isNaN(number)) return "Expected a number, such as 0.5.";
    const near = (value: number): boolean => Math.abs(number - value) <= (part.tolerance ?? 0) + 1e-9;
    if (near(right)) return null;
    return part.clues?.find(([value]) => near(value))?.[1] ?? part.otherwise ?? "Expected another number.";
  };
  return { input, check, answer: () => input.value, set: (answer) => (input.value = answer) };
}

const SIZE = 4;
const RATES = [0.5, 0.8, 0.2] as const;

/** Exercise 4.1: cells to press, whose diagonal stays at one half. */
function raceOfCells(): Checked {
  const rates: number[] = new Array(SIZE * SIZE).fill(0.5);
  const show = (button: HTMLButtonElement, at: number): void =>
    showRate(
      button,
      rates[at]!,
      `generation ${Math.floor(at / SIZE)} of the pursuers against generation ${at % SIZE} of the evaders`,
      1,
    );
  const buttons = rates.map((_, at) => {
    const made = html("button", {
      type: "button",
      disabled: at % (SIZE + 1) === 0,
      onclick: () => {
        rates[at] = RATES[(RATES.indexOf(rates[at] as 0.5) + 1) % RATES.length]!;
        show(made, at);
      },
    });
    show(made, at);
    return made;
  });
  const generations = Array.from({ length: SIZE }, (_, generation) => generation);
  const input = html(
    "div",
    {
      class: "cells numbers",
      role: "group",
      "aria-label": "Capture rates: rows are pursuers, columns evaders",
    },
    html("span"),
    html("span", { class: "evader all" }, "generation of the evaders"),
    html("span", { class: "pursuer" }, "generation of the pursuers"),
    ...generations.map((h) => html("span", { class: "evader" }, h)),
    ...generations.flatMap((g) => [
      html("span", { class: "pursuer" }, g),
      ...buttons.slice(g * SIZE, (g + 1) * SIZE),
    ]),
  );
  const means = (of: (generation: number, other: number) => number): number[] =>
    generations.map(
      (generation) => generations.reduce((sum, other) => sum + rates[of(generation, other)]!, 0) / SIZE,
    );
  const check = (): string | null => {
    const rows = means((g, h) => g * SIZE + h);
    const columns = means((h, g) => g * SIZE + h);
    const rising = (values: readonly number[], sign: number): boolean =>
      values.every((value, at) => !at || sign * (value - values[at - 1]!) > 1e-9);
    if (!rising(rows, 1)) {
      return `The means of the rows are ${told(rows)}. They are the strengths of the pursuers, and should grow from row to row.`;
    }
    if (!rising(columns, -1)) {
      return `The means of the columns are ${told(columns)}. They say how often the evaders are captured, and should fall from column to column.`;
    }
    return null;
  };
  const set = (answer: string): void => {
    answer.split(" ").forEach((rate, at) => (rates[at] = Number(rate)));
    buttons.forEach(show);
  };
  return { input, check, answer: () => rates.join(" "), set };
}

const told = (values: readonly number[]): string => values.map((value) => value.toFixed(2)).join(", ");
