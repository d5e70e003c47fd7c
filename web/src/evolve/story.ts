// The story of a race: what was chosen, what was changed on its way, and how far it was watched. A
// link holds it, and another page plays it again, bit for bit.

import { TEAMS } from "../engine/teams.ts";
import { text } from "../explorer/data.ts";
import { changeOf, choiceOf, partsOf, settingsOf } from "./choice.ts";
import type { Choice, Parts } from "./choice.ts";
import type { EvolveData } from "./data.ts";
import { genesOf } from "./network.ts";
import { shapeOf } from "./race.ts";

/** A change on the way, after so many epochs of each race. */
export interface Change {
  readonly change: Partial<Choice>;
  readonly at: readonly number[];
}

export interface Story {
  readonly choice: Choice;
  readonly changes: readonly Change[];
  /**
   * The epochs that were watched of each race; none before it begins, and infinitely many while it
   * goes on.
   */
  readonly watched: readonly number[];
}

/** A match against a champion, and what a friend made of it. */
export interface Dare {
  /** The genomes of both teams. */
  readonly pursuer: Float32Array;
  readonly evader: Float32Array;
  readonly seed: string;
  readonly episode: number;
  readonly seat: number;
  /** The friend's steps or captures, and how much the pursuers catch, in percent. */
  readonly score: number;
  readonly rate: number;
}

/** Longer addresses are cut on their way. */
export const LONGEST = 8000;

/**
 * What tells versions of the page apart whose races differ: a digest of its engine and its settings
 * (FNV-1a).
 */
export function markOf(data: EvolveData): string {
  let hash = 0x811c9dc5;
  for (const character of text("script-engine") + JSON.stringify(data)) {
    hash = Math.imul(hash ^ character.charCodeAt(0), 0x01000193);
  }
  return (hash >>> 0).toString(36);
}

const BETWEEN = { changes: "~~", parts: "~", value: ":", races: "_" } as const;
/** While a race goes on, it is watched to its end. */
const END = "end";

/** Return the choice at the end of a story. */
export const lastChoice = ({ choice, changes }: Story): Choice =>
  changes.reduce((last, { change }) => ({ ...last, ...change }), choice);

/** Return the part of an address that holds a story, and a dare. */
export function addressOf(data: EvolveData, { choice, changes, watched }: Story, dare?: Dare): string {
  const races = (each: readonly number[]): string =>
    each.map((epochs) => (epochs === Infinity ? END : epochs)).join(BETWEEN.races);
  const then = changes
    .map(({ change, at }) =>
      [races(at), ...Object.entries(changeOf(change)).map((entry) => entry.join(BETWEEN.value))].join(
        BETWEEN.parts,
      ),
    )
    .join(BETWEEN.changes);
  const parts = {
    ...partsOf(data, choice),
    ...(watched.length ? { race: markOf(data), to: races(watched), ...(then ? { then } : {}) } : {}),
    ...(dare
      ? {
          play: [dare.seed, dare.episode, dare.seat, dare.score, dare.rate].join("."),
          pursuer: packed(dare.pursuer),
          evader: packed(dare.evader),
        }
      : {}),
  };
  return Object.entries(parts)
    .map(([name, value]) => `${name}=${value}`)
    .join("&");
}

/** Return the story and the dare of an address, and what is wrong with it in words. */
export function storyOf(
  data: EvolveData,
  address: string,
): { story: Story; dare: Dare | null; problem: string } {
  const found = [...new URLSearchParams(address.length > 2 * LONGEST ? "" : address.replace(/^#/, ""))];
  const {
    race = "",
    to = "",
    then = "",
    play = "",
    pursuer = "",
    evader = "",
    ...rest
  } = Object.fromEntries(found) as Parts;
  const wrong: string[] = [];
  const choice = choiceOf(data, rest, (part) => wrong.push(part));
  const epoch = (part: string): number => {
    if (part === END) return Infinity;
    return /^\d{1,6}$/.test(part) ? Number(part) : NaN;
  };
  const epochs = (part: string): number[] => part.split(BETWEEN.races).map(epoch);
  const changes = then
    .split(BETWEEN.changes)
    .filter(Boolean)
    .reduce<Change[]>((before, one) => {
      const [at = "", ...parts] = one.split(BETWEEN.parts);
      const last = lastChoice({ choice, changes: before, watched: [] });
      const named = Object.fromEntries(parts.map((part) => part.split(BETWEEN.value) as [string, string]));
      const changed = choiceOf(data, named, (part) => wrong.push(part), last);
      const change = Object.fromEntries(Object.entries(changed).filter(([name]) => name in named));
      return [...before, { change, at: epochs(at) }];
    }, []);
  const watched = race || to ? epochs(to) : [];
  const races = choice.beside ? 2 : 1;
  const whole = [...changes.map(({ at }) => at), ...(watched.length ? [watched] : [])].every(
    (at) => at.length === races && !at.some(Number.isNaN),
  );
  const dare = play ? dareOf(data, choice, play, pursuer, evader) : null;
  if (!whole) wrong.push(`to=${to}`);
  if (play && !dare) wrong.push(`play=${play}`);
  let problem = "";
  if (address.length > 2 * LONGEST) {
    problem = "The link is too long, and shows nothing. ";
  } else if (wrong.length) {
    const named = wrong.slice(0, 3).map((part) => part.slice(0, 60));
    problem = `Something in the link is wrong, and left out: ${named.join("; ")}. `;
  } else if (watched.length && race !== markOf(data)) {
    problem = "The link is of another version of this page: the race may be another one. ";
  }
  return { story: { choice, changes: whole ? changes : [], watched: whole ? watched : [] }, dare, problem };
}

function dareOf(
  data: EvolveData,
  choice: Choice,
  play: string,
  pursuer: string,
  evader: string,
): Dare | null {
  const found = /^(\d{1,20})\.(\d{1,4})\.(\d{1,3})\.(\d{1,4})\.(\d{1,3})$/.exec(play);
  const genomes = [unpacked(pursuer), unpacked(evader)];
  if (
    !found ||
    !genomes[0]?.length ||
    !genomes[1]?.length ||
    Number(found[3]) >= choice.pursuers + choice.evaders
  ) {
    return null;
  }
  const settings = settingsOf(data, choice);
  if (TEAMS.some((team, place) => genomes[place]!.length !== genesOf(shapeOf(settings, data.masks, team)))) {
    return null;
  }
  const [episode, seat, score, rate] = found.slice(2).map(Number) as [number, number, number, number];
  return {
    pursuer: genomes[0],
    evader: genomes[1]!,
    seed: String(BigInt.asUintN(64, BigInt(found[1]!))),
    episode,
    seat,
    score,
    rate,
  };
}

/** Return numbers as letters that an address may hold. */
const packed = (numbers: Float32Array): string =>
  btoa(String.fromCharCode(...new Uint8Array(numbers.slice().buffer)))
    .replaceAll("+", "-")
    .replaceAll("/", ".")
    .replaceAll("=", "");

function unpacked(letters: string): Float32Array | null {
  if (!/^[\w.-]*$/.test(letters)) return null;
  try {
    const bytes = Uint8Array.from(atob(letters.replaceAll("-", "+").replaceAll(".", "/")), (each) =>
      each.charCodeAt(0),
    );
    const numbers = bytes.length % 4 ? null : new Float32Array(bytes.buffer);
    return numbers?.every(Number.isFinite) ? numbers : null;
  } catch {
    return null; // letters that no number has
  }
}
