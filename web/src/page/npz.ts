// Files of the format npz, which NumPy reads and writes: a zip archive of arrays, each a .npy file.

import { strFromU8, strToU8, unzipSync, zipSync } from "fflate";

type Numbers = Uint8Array | Int8Array | Int32Array | Float32Array | Float64Array;

/** An array: numbers in the order of C, or a single text. */
export interface NpyArray {
  /** As in NumPy: "<i4", "<f4", "<f8", "|b1", "|i1", "|S9" for 9 bytes, or "<U" for a text. */
  readonly dtype: string;
  readonly shape: readonly number[];
  readonly data: Numbers | string;
}

const TYPES: Readonly<Record<string, (content: ArrayBuffer) => Numbers>> = {
  "|b1": (content) => new Uint8Array(content),
  "|i1": (content) => new Int8Array(content),
  "<i4": (content) => new Int32Array(content),
  "<i8": (content) => Int32Array.from(new BigInt64Array(content), Number),
  "<f4": (content) => new Float32Array(content),
};
const MAGIC = "\x93NUMPY\x01\x00";
const START = MAGIC.length + 2;
const ALIGNED = 64; // bytes of a header are a multiple

/** Return the bytes of an npz file. */
export function writeNpz(arrays: Readonly<Record<string, NpyArray>>): Uint8Array {
  return zipSync(
    Object.fromEntries(Object.entries(arrays).map(([name, array]) => [`${name}.npy`, npy(array)])),
  );
}

function npy({ dtype, shape, data }: NpyArray): Uint8Array {
  // NumPy keeps the characters of a text as numbers of 32 bits.
  const points = typeof data === "string" ? Array.from(data, (each) => each.codePointAt(0)!) : null;
  const sizes = shape.map((each) => `${each}, `).join("");
  const header = `{'descr': '${points ? `<U${points.length}` : dtype}', 'fortran_order': False, 'shape': (${sizes}), }`;
  const length = Math.ceil((START + header.length + 1) / ALIGNED) * ALIGNED - START;
  const head = MAGIC + String.fromCharCode(length & 255, length >> 8) + header.padEnd(length - 1) + "\n";
  const content = points ? Int32Array.from(points) : (data as Numbers);
  const bytes = new Uint8Array(head.length + content.byteLength);
  bytes.set(strToU8(head, true));
  bytes.set(new Uint8Array(content.buffer, content.byteOffset, content.byteLength), head.length);
  return bytes;
}

/** Return the arrays of an npz file. Throws an error if the bytes are none. */
export function readNpz(bytes: Uint8Array): Record<string, NpyArray> {
  return Object.fromEntries(
    Object.entries(unzipSync(bytes)).map(([name, file]) => [name.replace(/\.npy$/, ""), arrayOf(file)]),
  );
}

function arrayOf(bytes: Uint8Array): NpyArray {
  const end = START + bytes[START - 2]! + 256 * bytes[START - 1]!;
  const header = strFromU8(bytes.subarray(START, end), true);
  const found = /'descr': '([^']+)', 'fortran_order': False, 'shape': \(([\d, ]*)\)/.exec(header);
  const dtype = found?.[1] ?? "";
  const shape = (found?.[2] ?? "")
    .split(",")
    .filter((each) => each.trim())
    .map(Number);
  const content = bytes.slice(end).buffer as ArrayBuffer;
  const text = dtype.startsWith("<U") && String.fromCodePoint(...new Int32Array(content));
  const data = text === false ? TYPES[dtype]?.(content) : text.replace(/\0+$/, "");
  if (data === undefined) {
    throw new TypeError(`expected an array of numbers or a text, got ${header.slice(0, 80)}`);
  }
  return { dtype, shape, data };
}
