// Sliders and choices with a name and a value that can be read.

import { html, select } from "../page/dom.ts";

/** Return a slider over values; `change` gets the chosen one while it moves. */
export function slider<Value>(
  name: string,
  values: readonly Value[],
  first: Value,
  shown: (value: Value) => string,
  change: (value: Value) => void,
): HTMLElement {
  const input = html("input", {
    type: "range",
    min: 0,
    max: values.length - 1,
    step: 1,
    "aria-label": name,
    oninput: () => change(show()),
  });
  const output = html("output", { class: "numbers" });
  const show = (): Value => {
    const value = values[Number(input.value)]!;
    output.textContent = input.ariaValueText = shown(value);
    return value;
  };
  input.value = String(values.indexOf(first));
  show();
  return html("label", { class: "slider" }, html("span", {}, name), input, output);
}

export function choice(
  name: string,
  options: readonly string[],
  change: (option: string) => void,
): HTMLElement {
  return html(
    "label",
    { class: "slider" },
    html("span", {}, name),
    select(
      options.map((each) => [each, each]),
      change,
    ),
  );
}
