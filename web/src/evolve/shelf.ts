// Races that have ended, as the browser keeps them until its tab is closed: a click on Back, or a
// reload, loses none.

import type { Kept } from "./lane.ts";

/** Races that are kept at most: each takes some 200 kB of the 5 MB that a page may have. */
const MOST = 8;
const KEY = "matrixworld-evolve";

/** A race: its address after #, and a title for readers. */
export interface Place {
  readonly address: string;
  readonly title: string;
}

const places = (): Place[] => JSON.parse(storage()?.getItem(KEY) ?? "[]") as Place[];

/** The place where a page may keep things; null where it may not, as in a frame of a notebook. */
function storage(): Storage | null {
  try {
    return sessionStorage;
  } catch {
    return null;
  }
}

/** Return the races that are kept, the oldest first. */
export const kept = places;

/** What an address begins with before and after a race has gone on. */
const rootOf = ({ address }: Place): string => address.split(/&?race=/)[0]!;

/** Keep the lanes of a race, in the place of what it was before it went on; the oldest races make room. */
export function keep(place: Place, lanes: readonly Kept[]): void {
  const store = storage();
  const text = JSON.stringify(lanes, (_, value: unknown) =>
    value instanceof Float32Array
      ? { floats: Array.from(value) }
      : value instanceof Map
        ? { entries: [...(value as Map<string, unknown>)] }
        : value,
  );
  const others = places().filter((each) => rootOf(each) !== rootOf(place));
  for (const { address } of places().filter((each) => rootOf(each) === rootOf(place))) {
    store?.removeItem(`${KEY} ${address}`);
  }
  let all = [...others, place];
  for (let tried = 0; store && tried <= MOST; tried++) {
    for (const gone of all.splice(0, Math.max(0, all.length - MOST))) {
      store.removeItem(`${KEY} ${gone.address}`);
    }
    try {
      store.setItem(`${KEY} ${place.address}`, text);
      store.setItem(KEY, JSON.stringify(all));
      return;
    } catch (error) {
      if (!(error instanceof DOMException) || all.length < 2) return; // no room for a single race: the link still plays it again
      store.removeItem(`${KEY} ${all[0]!.address}`);
      all = all.slice(1);
    }
  }
}

/** Return the lanes of a race that is kept; null if it is not. */
export function found(address: string): Kept[] | null {
  const text = storage()?.getItem(`${KEY} ${address}`);
  return text
    ? (JSON.parse(text, (_, value: { floats?: number[]; entries?: [string, unknown][] } | null) =>
        Array.isArray(value?.floats)
          ? Float32Array.from(value.floats)
          : Array.isArray(value?.entries)
            ? new Map(value.entries)
            : value,
      ) as Kept[])
    : null;
}
