// What happened in the race, in words, with the numbers that decide.

import { html } from "../page/dom.ts";
import type { Run } from "./data.ts";
import { capital } from "./format.ts";
import { card } from "./panel.ts";
import type { Panel } from "./panel.ts";

const SIGNS: Readonly<Record<string, string>> = { present: "●", absent: "○", "cannot tell": "?" };

export function diagnosisPanel(run: Run): Panel | null {
  const { findings } = run;
  if (!findings?.table.length) return null; // there is no judgement while a run goes on
  const [, ...rows] = findings.table;
  const items = rows.map(([condition, verdict, numbers, window], row) => {
    const reason = reasonOf(findings.reasons[row] ?? "");
    return html("li", { class: `finding ${verdict.replace(" ", "-")}` },
      html("span", { class: "sign", "aria-hidden": "true" }, SIGNS[verdict] ?? ""),
      html("div", {},
        html("p", {}, html("strong", {}, condition), ` ${verdict}`, html("span", { class: "muted" }, ` · ${window}`)),
        reason ? html("p", { class: "small" }, `${reason}.`) : null,
        html("p", { class: "small muted numbers" }, numbers)));
  });
  const element = card(
    "What happened", "Each condition is present, absent, or its 95 % interval cannot tell. The intervals are about this run.",
    html("p", { class: "headline" }, findings.sentence),
    html("p", {}, findings.headline),
    ...findings.numbers.map((line) => html("p", { class: "numbers" }, `${capital(line)}.`)),
    html("ul", { class: "findings" }, ...items),
    run.limits ? html("p", { class: "small" }, run.limits) : null,
  );
  element.classList.add("diagnosis");
  return { element };
}

/** Return the reason of a sentence "Cycling: absent, because ...". */
function reasonOf(text: string): string {
  const [, reason = ""] = text.split(/, because (.*)/s);
  return capital(reason.replace(/\.$/, ""));
}
