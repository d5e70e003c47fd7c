// Pictures that move: the format GIF89a, with the colours that are there most often.

/** Hundredths of a second that a frame is shown, and that the last one is. */
const DELAY = 12;
const LAST = 150;
const MOST_COLOURS = 256;
/** Bits of each channel that tell colours apart. */
const BITS = 5;
const MOST_CODES = 4096;

/** Return the bytes of a film that begins again and again. Frames have the same size. */
export function gifOf(frames: readonly ImageData[]): Uint8Array<ArrayBuffer> {
  const { width, height } = frames[0]!;
  const { table, place } = coloursOf(frames);
  const bytes: number[] = [...letters("GIF89a"), ...word(width), ...word(height), 0xf7, 0, 0, ...table];
  bytes.push(0x21, 0xff, 11, ...letters("NETSCAPE2.0"), 3, 1, 0, 0, 0);
  frames.forEach((frame, number) => {
    bytes.push(0x21, 0xf9, 4, 0, ...word(number === frames.length - 1 ? LAST : DELAY), 0, 0);
    bytes.push(0x2c, 0, 0, 0, 0, ...word(width), ...word(height), 0, 8);
    const packed = compressed(keysOf(frame).map((key) => place[key]!));
    for (let at = 0; at < packed.length; at += 255) {
      const block = packed.slice(at, at + 255);
      bytes.push(block.length, ...block);
    }
    bytes.push(0);
  });
  return Uint8Array.from([...bytes, 0x3b]);
}

const letters = (text: string): number[] => [...text].map((each) => each.charCodeAt(0));
const word = (number: number): number[] => [number & 255, number >> 8];

/** Return the colour of each pixel as a number of 3 x `BITS` bits. */
function keysOf({ data }: ImageData): Uint16Array {
  const keys = new Uint16Array(data.length / 4);
  const cut = 8 - BITS;
  for (let at = 0; at < keys.length; at++) {
    keys[at] =
      ((data[4 * at]! >> cut) << (2 * BITS)) |
      ((data[4 * at + 1]! >> cut) << BITS) |
      (data[4 * at + 2]! >> cut);
  }
  return keys;
}

/** Return the colours of a film, and the place of the one that is nearest to each key. */
function coloursOf(frames: readonly ImageData[]): { table: number[]; place: Uint8Array } {
  const counts = new Map<number, number>();
  for (const frame of frames) {
    for (const key of keysOf(frame)) counts.set(key, (counts.get(key) ?? 0) + 1);
  }
  const kept = [...counts]
    .sort(([, a], [, b]) => b - a)
    .slice(0, MOST_COLOURS)
    .map(([key]) => key);
  const channels = (key: number): number[] => [key >> (2 * BITS), (key >> BITS) & 31, key & 31];
  const distance = (a: number, b: number): number =>
    channels(a).reduce((sum, each, channel) => sum + (each - channels(b)[channel]!) ** 2, 0);
  const place = new Uint8Array(2 ** (3 * BITS));
  for (const key of counts.keys()) {
    const own = kept.indexOf(key);
    place[key] =
      own >= 0
        ? own
        : kept.reduce((best, each, at) => (distance(key, each) < distance(key, kept[best]!) ? at : best), 0);
  }
  const table = kept.flatMap((key) => channels(key).map((each) => Math.round((each * 255) / 31)));
  return { table: [...table, ...Array<number>(3 * MOST_COLOURS - table.length).fill(0)], place };
}

/** Return numbers from 0 to 255 by the method of Lempel, Ziv and Welch (1984), as GIF has it. */
function compressed(numbers: Uint16Array): number[] {
  const clear = 256;
  const end = 257;
  const bytes: number[] = [];
  let codes = new Map<number, number>();
  let next = end + 1;
  let size = 9;
  let held = 0;
  let bits = 0;
  const put = (code: number): void => {
    held |= code << bits;
    for (bits += size; bits >= 8; bits -= 8) {
      bytes.push(held & 255);
      held >>>= 8;
    }
  };
  put(clear);
  let prefix = numbers[0]!;
  for (const number of numbers.subarray(1)) {
    const known = codes.get(prefix * 256 + number);
    if (known !== undefined) {
      prefix = known;
      continue;
    }
    put(prefix);
    if (next === MOST_CODES) {
      put(clear);
      codes = new Map();
      next = end + 1;
      size = 9;
    } else {
      codes.set(prefix * 256 + number, next);
      if (next === 2 ** size) size += 1;
      next += 1;
    }
    prefix = number;
  }
  put(prefix);
  put(end);
  if (bits) bytes.push(held & 255);
  return bytes;
}
