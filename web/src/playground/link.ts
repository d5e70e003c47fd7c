// Scenes as text in a link:  #rules=SB&size=2x5&pursuers=0.0_0.2&evaders=1.4&next=240
//
// `matrixworld.explorer.playground` writes the same in Python and explains the parts. A text from elsewhere
// may hold anything: every part is checked, and the message says what was expected.

import type { Cell, Penalty, Rewards, Rules } from "../engine/types.ts";
import type { PageData } from "./data.ts";
import { CHAMPION, MOST_AGENTS, MOST_SIDE, MOST_STEPS, STAY, agents, variantOf } from "./scene.ts";
import type { Command, Scene, Start } from "./scene.ts";

/** A text that is no scene; the message has the form "<part>: expected X, got Y". */
export class LinkError extends Error {}

const LIST = "_";
const NETWORK = "n";
const LARGEST_SEED = 2n ** 64n - 1n;
const LONGEST = 20_000; // characters of a link
const SHOWN = 40; // characters of a text in a message

const DEFAULT = { fov: 11, maxSteps: 500, rewards: "paper" } as const;
const PARTS = [
  "rules",
  "others",
  "rewards",
  "size",
  "diagonal",
  "fov",
  "limit",
  "seed",
  "ended",
  "walls",
  "pursuers",
  "evaders",
  "played",
  "next",
] as const;

function refuse(part: string, expected: string, got: string): never {
  const shown = got.length > SHOWN ? `${got.slice(0, SHOWN)}…` : got;
  throw new LinkError(`${part}: expected ${expected}, got "${shown}"`);
}

// ---- To text

/** Return the text of a scene: what follows # in a link. */
export function linkOf(scene: Scene, data: PageData): string {
  const code = (commands: readonly Command[]): string => commands.map((each) => letter(each, data)).join("");
  const cellOf = (index: number): string => `${Math.floor(index / scene.cols)}.${index % scene.cols}`;
  const rewards = rewardsText(scene.rewards, data);
  const seed = [scene.seed, scene.episode, scene.steps].join(".");
  const parts: Record<(typeof PARTS)[number], string> = {
    rules: rulesText(scene.rules, data),
    others: scene.others ? rulesText(scene.others, data) : "",
    rewards: rewards === DEFAULT.rewards ? "" : rewards,
    size: `${scene.rows}x${scene.cols}`,
    diagonal: scene.diagonal ? "1" : "",
    fov: scene.fov === DEFAULT.fov ? "" : String(scene.fov),
    limit: scene.maxSteps === DEFAULT.maxSteps ? "" : String(scene.maxSteps),
    seed: seed === "0.0.0" ? "" : seed,
    ended: scene.ended ? "1" : "",
    walls: scene.walls.map(cellOf).join(LIST),
    pursuers: scene.pursuers.map(startText).join(LIST),
    evaders: scene.evaders.map(startText).join(LIST),
    played: scene.played.map(code).join(LIST),
    next: scene.next.every((command) => command === STAY) ? "" : code(scene.next),
  };
  return PARTS.filter((part) => parts[part])
    .map((part) => `${part}=${parts[part]}`)
    .join("&");
}

function startText({ cell, gone, captured, everCaptured }: Start): string {
  const capture = captured ? "c" : everCaptured ? "e" : "";
  return `${cell[0]}.${cell[1]}${capture}${gone ? "x" : ""}`;
}

function rulesText(rules: Rules, data: PageData): string {
  const values = data.fields.map(({ name }) => String(rules[name]).toLowerCase());
  return variantOf(rules, data.variants) ?? values.join(".");
}

function rewardsText(rewards: Rewards, data: PageData): string {
  const own = JSON.stringify(rewards);
  const name = Object.keys(data.rewards).find((each) => JSON.stringify(data.rewards[each]) === own);
  return (
    name ??
    Object.values(rewards)
      .map((value) => String(value))
      .join(LIST)
  );
}

/** Return the character of a command: a digit for an action, a letter for a script or a network. */
function letter(command: Command, data: PageData): string {
  if (typeof command === "number") return String(command);
  if (command === CHAMPION) return NETWORK;
  const script = data.scripts.findIndex(({ name }) => name === command);
  return String.fromCharCode("a".charCodeAt(0) + script);
}

// ---- From text

/** Return the scene of a text; throws LinkError with what is wrong. */
export function sceneOf(text: string, data: PageData): Scene {
  if (text.length > LONGEST) refuse("link", `at most ${LONGEST} characters`, `${text.length} characters`);
  const parts = partsOf(text);
  const read = (part: (typeof PARTS)[number], missing = ""): string => parts.get(part) ?? missing;
  const rules = readRules("rules", read("rules"), data);
  const [rows, cols] = readSize(read("size"));
  const cells = (part: "pursuers" | "evaders"): Start[] =>
    list(read(part)).map((each) => readStart(part, each, rows, cols));
  const [seed, episode, steps] = readSeed(read("seed", "0.0.0"));
  const start = {
    rules,
    others: parts.has("others") ? readRules("others", read("others"), data) : null,
    rewards: readRewards(read("rewards", DEFAULT.rewards), data),
    rows,
    cols,
    seed,
    episode,
    steps,
    diagonal: readFlag("diagonal", read("diagonal", "0")),
    fov: readNumber("fov", read("fov", String(DEFAULT.fov)), 1, 255),
    maxSteps: readNumber("limit", read("limit", String(DEFAULT.maxSteps)), 1, 2 ** 31 - 1),
    ended: readFlag("ended", read("ended", "0")),
    walls: readWalls(read("walls"), rows, cols),
    pursuers: cells("pursuers"),
    evaders: cells("evaders"),
    played: [],
    next: [],
  };
  checkNumbers(start);
  return withCommands(start, list(read("played")), read("next"), data);
}

function partsOf(text: string): Map<string, string> {
  const parts = new Map<string, string>();
  for (const part of text.replace(/^#/, "").split("&").filter(Boolean)) {
    const [name, value] = part.includes("=")
      ? [part.slice(0, part.indexOf("=")), part.slice(part.indexOf("=") + 1)]
      : [part, ""];
    if (!(PARTS as readonly string[]).includes(name)) refuse("link", `parts ${PARTS.join(", ")}`, name);
    if (parts.has(name)) refuse(name, "it once", "it twice");
    parts.set(name, value);
  }
  return parts;
}

const list = (text: string): string[] => (text ? text.split(LIST) : []);

function readNumber(part: string, text: string, least: number, most: number): number {
  const number = /^\d{1,10}$/.test(text) ? Number(text) : NaN;
  if (!(number >= least && number <= most)) refuse(part, `a number from ${least} to ${most}`, text);
  return number;
}

function readFlag(part: string, text: string): boolean {
  if (text !== "0" && text !== "1") refuse(part, "0 or 1", text);
  return text === "1";
}

function readSize(text: string): [rows: number, cols: number] {
  const [rows, cols, ...more] = text.split("x");
  if (rows === undefined || cols === undefined || more.length) {
    refuse("size", "rows and columns, such as 4x6", text);
  }
  return [readNumber("size", rows, 1, MOST_SIDE), readNumber("size", cols, 1, MOST_SIDE)];
}

function readCell(part: string, text: string, rows: number, cols: number): Cell {
  const found = /^(\d{1,4})\.(\d{1,4})$/.exec(text);
  const cell: Cell = [Number(found?.[1]), Number(found?.[2])];
  if (!found || cell[0] >= rows || cell[1] >= cols) {
    refuse(part, `cells of a ${rows} x ${cols} grid, such as 0.2`, text);
  }
  return cell;
}

function readStart(part: "pursuers" | "evaders", text: string, rows: number, cols: number): Start {
  const found = /^(.*?)([ce]?)(x?)$/.exec(text)!;
  const cell = readCell(part, found[1]!, rows, cols);
  if (part === "pursuers" && found[2]) refuse(part, "no captured pursuer", text);
  return { cell, gone: found[3] === "x", captured: found[2] === "c", everCaptured: found[2] !== "" };
}

function readWalls(text: string, rows: number, cols: number): number[] {
  const walls = list(text).map((each) => {
    const [row, col] = readCell("walls", each, rows, cols);
    return row * cols + col;
  });
  return [...new Set(walls)].sort((a, b) => a - b);
}

function readRules(part: string, text: string, data: PageData): Rules {
  const variant = Object.hasOwn(data.variants, text) ? data.variants[text] : undefined;
  if (variant) return variant;
  const values = text.split(".");
  const expected = `${Object.keys(data.variants).join(", ")} or ${data.fields.length} values joined by "."`;
  if (values.length !== data.fields.length) refuse(part, expected, text);
  const entries = data.fields.map(({ name, values: known }, field) => {
    const value = known.find((each) => each.name.toLowerCase() === values[field])?.name;
    if (value === undefined) {
      refuse(`${part}, ${name}`, known.map((each) => each.name.toLowerCase()).join(" or "), values[field]!);
    }
    return [name, value === "true" ? true : value === "false" ? false : value];
  });
  return Object.fromEntries(entries) as Rules;
}

function readRewards(text: string, data: PageData): Rewards {
  if (Object.hasOwn(data.rewards, text)) return data.rewards[text]!;
  const known = Object.entries(data.rewards[DEFAULT.rewards]!);
  const values = text.split(LIST);
  if (values.length !== known.length) {
    refuse("rewards", `${Object.keys(data.rewards).join(", ")} or ${known.length} values`, text);
  }
  return Object.fromEntries(
    known.map(([name, like], i) => [name, readReward(name, values[i]!, like)]),
  ) as unknown as Rewards;
}

function readReward(name: string, text: string, like: unknown): Penalty | string | boolean {
  if (name === "blame" && (text === "FAULT" || text === "INVOLVED")) return text;
  if (typeof like === "boolean" && (text === "true" || text === "false")) return text === "true";
  const numbers = text.split(",").map((each) => (/^-?[\d.]+(e[+-]?\d+)?$/i.test(each) ? Number(each) : NaN));
  const kinds = name.endsWith("_collide") ? [1, 3] : [1];
  const wrong = typeof like !== "number" || !kinds.includes(numbers.length);
  if (wrong || !numbers.every((each) => Math.abs(each) < 3.4e38)) {
    refuse(`rewards, ${name}`, `a value like ${like}`, text);
  }
  return numbers.length === 1 ? numbers[0]! : (numbers as [number, number, number]);
}

function readSeed(text: string): [seed: bigint, episode: bigint, steps: number] {
  const found = /^(\d{1,20})\.(\d{1,20})\.(\d{1,9})$/.exec(text);
  if (!found) return refuse("seed", "seed.episode.steps, such as 0.0.0", text);
  const seed = BigInt(found[1]!);
  const episode = BigInt(found[2]!);
  if (seed > LARGEST_SEED || episode > LARGEST_SEED) refuse("seed", "numbers below 2^64", text);
  return [seed, episode, Number(found[3])];
}

function checkNumbers(scene: Scene): void {
  for (const team of ["pursuers", "evaders"] as const) {
    const count = scene[team].length;
    if (count < 1 || count > MOST_AGENTS) refuse(team, `1 to ${MOST_AGENTS} agents`, `${count}`);
  }
  if (scene.fov % 2 === 0) refuse("fov", "an odd number", String(scene.fov));
  if (scene.steps > scene.maxSteps) refuse("seed", `at most ${scene.maxSteps} steps`, String(scene.steps));
}

function withCommands(scene: Scene, played: string[], next: string, data: PageData): Scene {
  const count = agents(scene).length;
  if (played.length > MOST_STEPS) refuse("played", `at most ${MOST_STEPS} steps`, `${played.length} steps`);
  const read =
    (part: string) =>
    (text: string): Command[] => {
      if (text.length !== count) refuse(part, `${count} characters, one for each agent`, text);
      return [...text].map((each) => readCommand(part, each, scene.diagonal ? 9 : 5, data));
    };
  return {
    ...scene,
    played: played.map(read("played")),
    next: next ? read("next")(next) : Array<Command>(count).fill(STAY),
  };
}

function readCommand(part: string, text: string, actions: number, data: PageData): Command {
  const action = /^\d$/.test(text) ? Number(text) : NaN;
  if (action < actions) return action;
  if (text === NETWORK && data.champions) return CHAMPION;
  const script = data.scripts[text.charCodeAt(0) - "a".charCodeAt(0)];
  const last = String.fromCharCode("a".charCodeAt(0) + data.scripts.length - 1);
  return script?.name ?? refuse(part, `actions 0 to ${actions - 1} or scripts a to ${last}`, text);
}
