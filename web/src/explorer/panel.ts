// A panel of a run: what it is, the card that it is drawn on, and those of words alone: what
// happened, and the settings.

import { html } from "../page/dom.ts";
import type { Run } from "./data.ts";
import { capital } from "./format.ts";

/** A panel of one run; `update` shows what is selected or under the pointer. */
export interface Panel {
  readonly element: HTMLElement;
  update?(): void;
}

/** Return a card with a title and a line that says how to read it. */
export function card(title: string, hint: string, ...content: (Node | null)[]): HTMLElement {
  return html(
    "section",
    { class: "card panel", "aria-label": title },
    html("header", {}, html("h2", {}, title), html("p", { class: "small muted" }, hint)),
    ...content,
  );
}

// ---- What happened in the race, with the numbers that decide

const SIGNS: Readonly<Record<string, string>> = { present: "●", absent: "○", "cannot tell": "?" };

export function diagnosisPanel(run: Run): Panel | null {
  const { findings } = run;
  if (!findings?.table.length) return null; // there is no judgement while a run goes on
  const [, ...rows] = findings.table;
  const items = rows.map(([condition, verdict, numbers, window], row) => {
    // Numbers that the game tells beside the scores come last, without a verdict.
    const reason = verdict === "told" ? "" : reasonOf(findings.reasons[row] ?? "");
    return html(
      "li",
      { class: `finding ${verdict.replace(" ", "-")}` },
      html("span", { class: "sign", "aria-hidden": "true" }, SIGNS[verdict] ?? ""),
      html(
        "div",
        {},
        html(
          "p",
          {},
          html("strong", {}, condition),
          ` ${verdict}`,
          html("span", { class: "muted" }, ` · ${window}`),
        ),
        reason ? html("p", { class: "small" }, `${reason}.`) : null,
        html("p", { class: "small muted numbers" }, numbers),
      ),
    );
  });
  const element = card(
    "What happened",
    "Each condition is present, absent, or its 95 % interval cannot tell. The intervals are about this run.",
    html("p", { class: "headline" }, findings.sentence),
    html("ul", { class: "findings" }, ...items),
    ...refusedOf(findings.refused ?? {}),
    run.limits ? html("p", { class: "small" }, run.limits) : null,
  );
  element.classList.add("diagnosis");
  return { element };
}

/** Return what is not judged, by the reason. */
function refusedOf(refused: Readonly<Record<string, string>>): HTMLElement[] {
  const reasons = [...new Set(Object.values(refused))];
  return reasons.map((reason) => {
    const names = Object.keys(refused).filter((name) => refused[name] === reason);
    return html("p", { class: "small muted" }, `Not judged, because ${reason}: ${names.join(", ")}.`);
  });
}

/** Return the reason of a sentence "Cycling: absent, because ...". */
function reasonOf(text: string): string {
  const [, reason = ""] = text.split(/, because (.*)/s);
  return capital(reason.replace(/\.$/, ""));
}

/** The settings of the run that differ from the defaults, as the command takes them. */
export function settingsPanel({ settings, command }: Run): Panel {
  const rows = settings.map(({ name, value, help }) =>
    html(
      "tr",
      {},
      html("th", { scope: "row" }, html("code", {}, `--set ${name}=${value}`)),
      html("td", { class: "muted" }, help),
    ),
  );
  const table = html(
    "table",
    { class: "small" },
    html("caption", { class: "heard" }, "Settings other than the default"),
    ...rows,
  );
  const element = card(
    "Settings",
    "All others are the defaults. This command plays the race again:",
    html("pre", { class: "command" }, command),
    rows.length ? html("div", { class: "wide-table" }, table) : null,
  );
  element.classList.add("settings");
  return { element };
}
