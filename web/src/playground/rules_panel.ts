// The rules: a variant, or each field of a row; the rules to compare with; the board and the rewards.

import type { Rules } from "../engine/types.ts";
import { html } from "../page/dom.ts";
import { rulesName } from "./arena.ts";
import type { Field } from "./data.ts";
import { MOST_SIDE, resized, sameRules, variantOf } from "./scene.ts";
import type { Scene } from "./scene.ts";
import type { Control, Store } from "./store.ts";
import { linesOf } from "./words.ts";

/** Return the card of the rules. */
export function rulesPanel(store: Store): HTMLElement {
  const controls = [
    variants(store),
    ...store.data.fields.map((field) => fieldChoice(store, field)),
    comparison(store),
    board(store),
  ];
  store.shownBy(() => controls.forEach((control) => control.update()));
  return html("section", { class: "card rules" }, ...controls.map((control) => control.element));
}

const change = (store: Store, scene: Scene): void => {
  store.stop();
  store.change(scene);
};

function variants(store: Store): Control {
  const names = Object.keys(store.data.variants);
  const buttons = names.map((name) =>
    html(
      "button",
      {
        type: "button",
        class: "chip",
        title: store.data.titles[name],
        onclick: () => change(store, { ...store.scene, rules: store.data.variants[name]! }),
      },
      name,
    ),
  );
  const title = html("p", { class: "muted small variant-title" });
  return {
    element: html(
      "div",
      { class: "variants" },
      html("h2", {}, "Rules"),
      html("div", { class: "chips", role: "group", "aria-label": "Variant" }, ...buttons),
      title,
    ),
    update: () => {
      const chosen = variantOf(store.scene.rules, store.data.variants);
      names.forEach((name, place) => buttons[place]!.setAttribute("aria-pressed", String(name === chosen)));
      title.textContent = chosen ? store.data.titles[chosen]! : "Rules of your own";
    },
  };
}

/** Return the choice of one field. It is marked where it decided what happened in the step shown. */
function fieldChoice(store: Store, field: Field): Control {
  const inputs = field.values.map(({ name }) =>
    html("input", {
      type: "radio",
      name: field.name,
      value: name,
      onchange: () => change(store, { ...store.scene, rules: withField(store.scene.rules, field, name) }),
    }),
  );
  const labels = field.values.map(({ label }, place) =>
    html("label", {}, inputs[place], html("span", {}, label)),
  );
  const used = html(
    "span",
    { class: "used-mark", title: "This rule decided what happened in the step that is shown" },
    html("span", {}, "decided"),
  );
  const element = html(
    "fieldset",
    { class: "field", title: field.text },
    html("legend", {}, field.label, used),
    html("div", { class: "segments" }, ...labels),
  );
  return {
    element,
    update: () => {
      const { rules } = store.scene;
      inputs.forEach((input) => (input.checked = input.value === String(rules[field.name])));
      // Occupation does not read whether the captured disappear.
      element.disabled = field.name === "captured_disappear" && rules.capture === "OCCUPATION";
      const step = Math.min(store.player.step, store.game.length);
      used.hidden =
        !linesOf(store.scene, store.game, step).some((line) => line.used.includes(field.name)) ||
        element.disabled;
    },
  };
}

function withField(rules: Rules, field: Field, name: string): Rules {
  return { ...rules, [field.name]: name === "true" ? true : name === "false" ? false : name };
}

function comparison(store: Store): Control {
  const names = Object.keys(store.data.variants);
  const compare = (): void => {
    const rules = { "": null, present: store.scene.rules }[select.value];
    change(store, {
      ...store.scene,
      others: rules === undefined ? store.data.variants[select.value]! : rules,
    });
  };
  const select = html(
    "select",
    { id: "compare", onchange: compare },
    html("option", { value: "" }, "nothing"),
    html("option", { value: "present" }, "the present rules"),
    html("option", { value: "own", hidden: true }, "own rules"),
    ...names.map((name) => html("option", { value: name }, `${name}: ${store.data.titles[name]}`)),
  );
  return {
    element: html("div", { class: "pair" }, html("label", { for: "compare" }, "Compare with"), select),
    update: () => {
      const { others } = store.scene;
      const variant = others && names.find((name) => sameRules(others, store.data.variants[name]!));
      select.value = others ? (variant ?? "own") : "";
      select.title = others
        ? `Both boards play the same moves: ${rulesName(store, 0)} and ${rulesName(store, 1)}`
        : "";
    },
  };
}

function board(store: Store): Control {
  const side = (name: "rows" | "cols", label: string): HTMLInputElement => {
    const input = html("input", {
      type: "number",
      min: 1,
      max: MOST_SIDE,
      "aria-label": label,
      onchange: () => {
        const sides = {
          rows: store.scene.rows,
          cols: store.scene.cols,
          [name]: Math.round(Number(input.value)),
        };
        if (sides[name] >= 1 && sides[name] <= MOST_SIDE) resize(store, sides.rows, sides.cols);
        else store.say(`${name}: expected 1 to ${MOST_SIDE}, got ${input.value || "nothing"}`, true);
        input.value = String(store.scene[name]);
      },
    });
    return input;
  };
  const rows = side("rows", "Rows");
  const cols = side("cols", "Columns");
  const diagonal = html("input", {
    type: "checkbox",
    id: "diagonal",
    onchange: () =>
      change(store, {
        ...store.game.scene(),
        diagonal: diagonal.checked,
        next: store.scene.next.map((command) => (typeof command === "number" && command > 4 ? 0 : command)),
      }),
  });
  const rewards = html(
    "select",
    {
      id: "rewards",
      onchange: () => change(store, { ...store.scene, rewards: store.data.rewards[rewards.value]! }),
    },
    ...Object.keys(store.data.rewards).map((name) => html("option", { value: name }, name)),
    html("option", { value: "own", hidden: true }, "those of the link"),
  );
  return {
    element: html(
      "div",
      { class: "board-settings" },
      html(
        "div",
        { class: "pair" },
        html("span", {}, "Board"),
        html("span", { class: "sides" }, rows, "×", cols),
        html("label", { class: "sides" }, diagonal, "diagonal"),
      ),
      html("div", { class: "pair" }, html("label", { for: "rewards" }, "Rewards"), rewards),
    ),
    update: () => {
      const { scene } = store;
      if (document.activeElement !== rows) rows.value = String(scene.rows);
      if (document.activeElement !== cols) cols.value = String(scene.cols);
      diagonal.checked = scene.diagonal;
      const own = JSON.stringify(scene.rewards);
      rewards.value =
        Object.keys(store.data.rewards).find((name) => JSON.stringify(store.data.rewards[name]) === own) ??
        "own";
    },
  };
}

function resize(store: Store, rows: number, cols: number): void {
  const scene = resized(store.game.scene(), rows, cols);
  if (scene.pursuers.length && scene.evaders.length) {
    change(store, scene);
  } else {
    store.say(
      `No ${scene.pursuers.length ? "evader" : "pursuer"} would be left on a ${rows} × ${cols} board.`,
      true,
    );
  }
}
