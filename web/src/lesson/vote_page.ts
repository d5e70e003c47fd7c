// The votes of a class: files are dropped, and each question shows how many chose what; then its outcome.

import { html } from "../page/dom.ts";
import { top } from "../page/top.ts";
import { predictionsOf } from "./data.ts";
import type { Lesson, Prediction } from "./data.ts";
import { paragraphs } from "./parts.ts";
import { MOST_BYTES, countVotes } from "./votes.ts";
import type { SavedFile, Votes } from "./votes.ts";

export function votePage(lesson: Lesson): void {
  const asked = { edition: lesson.edition, predictions: predictionsOf(lesson) };
  const told = html("p", { role: "status" });
  const left = html("ul", { class: "left" });
  const questions = html("div", { class: "questions" });
  const open = new Set<string>(); // questions whose outcome is shown
  let files: readonly SavedFile[] = [];
  const show = (): void => {
    const votes = countVotes(files, asked);
    told.textContent = files.length
      ? `${files.length} ${files.length === 1 ? "file" : "files"}, ${votes.pupils} ${votes.pupils === 1 ? "pupil" : "pupils"}.${votes.left.length ? " Not counted:" : ""}`
      : "No files yet.";
    left.replaceChildren(
      ...votes.left.map(({ file, reason }) => html("li", {}, html("strong", {}, file), ` ${reason}`)),
    );
    questions.replaceChildren(
      ...[...asked.predictions.values()].map((part) => questionOf(part, votes, open, show)),
    );
  };
  const add = async (given: Iterable<File>): Promise<void> => {
    const read = [...given].map(async (file) => ({
      name: file.name,
      text: file.size > MOST_BYTES ? null : await file.text(),
    }));
    files = [...files, ...(await Promise.all(read))];
    show();
  };
  const input = html("input", {
    type: "file",
    multiple: true,
    accept: ".jsonl",
    id: "vote-files",
    onchange: () => void add(input.files!).then(() => (input.value = "")),
  });
  const forget = html(
    "button",
    {
      type: "button",
      onclick: () => {
        files = [];
        open.clear();
        show();
      },
    },
    "Remove all files",
  );
  const zone = html(
    "section",
    { class: "card drop", "aria-label": "Files" },
    html(
      "p",
      {},
      html(
        "label",
        { for: "vote-files" },
        "Drop the files that your pupils have saved anywhere on this page, or choose them: ",
      ),
    ),
    input,
    html("div", { class: "buttons" }, told, forget),
    left,
    html(
      "p",
      { class: "small muted" },
      "A pupil saves predictions.jsonl at the end of the lesson. Names of files do not matter. Each pupil counts once: a second file of a pupil is named as double. Nothing leaves this computer.",
    ),
  );
  document.addEventListener("dragover", (event) => event.preventDefault());
  document.addEventListener("drop", (event) => {
    event.preventDefault();
    void add(event.dataTransfer?.files ?? []);
  });
  document
    .getElementById("page")!
    .replaceWith(
      top(
        "How the class voted",
        html("span", {}, `${lesson.title} `, html("a", { href: "#" }, "Back to the lesson")),
      ),
      html("main", {}, zone, questions),
      html(
        "footer",
        { class: "small muted" },
        `matrixworld ${lesson.version}, edition ${lesson.edition} of the course`,
      ),
    );
  show();
}

/**
 * Return a question with the votes on each option, and a button that shows the outcome; a first
 * vote waits for the second one.
 */
function questionOf(part: Prediction, votes: Votes, open: Set<string>, show: () => void): HTMLElement {
  const { predict: name, options, outcome } = part;
  const counts = votes.counts.get(name)!;
  const all = [...counts.values()].reduce((sum, count) => sum + count, 0);
  const shown = open.has(name);
  const first = part.again ? votes.counts.get(part.again)! : undefined;
  const rows = Object.entries(options).map(([option, text]) => {
    const filled = html("span", { class: "filled" });
    filled.style.width = `${(100 * counts.get(option)!) / Math.max(1, all)}%`;
    const right = shown && option === outcome;
    return html(
      "li",
      { class: right ? "vote right" : "vote" },
      html("span", {}, `${option}. ${text}`, right && html("strong", {}, " ✓ the outcome")),
      html("span", { class: "bar", "aria-hidden": "true" }, filled),
      html(
        "span",
        { class: "numbers" },
        `${counts.get(option)} of ${all}`,
        first && html("span", { class: "muted" }, `, at first ${first.get(option)}`),
      ),
    );
  });
  const reveal = html(
    "button",
    {
      type: "button",
      id: `outcome-${name}`,
      onclick: () => {
        open.add(name);
        show();
      },
    },
    "Show the outcome",
  );
  return html(
    "section",
    { class: "card question", id: `votes-${name}` },
    html("h2", {}, part.question),
    html("ul", { class: "of-votes" }, ...rows),
    part.later
      ? html("p", { class: "muted" }, part.later)
      : shown
        ? html("div", { class: "reply" }, ...paragraphs(part.explanation ?? ""))
        : html("div", {}, reveal),
  );
}
