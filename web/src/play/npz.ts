// Files of the format npz, which NumPy reads and writes: a zip archive of arrays, each a .npy file.

type Numbers = Uint8Array | Int8Array | Int32Array | Float32Array;

/** An array: numbers in the order of C, or a single text. */
export interface NpyArray {
  /** As in NumPy: "<i4", "<f4", "|b1", "|i1", or "<U" for a text. */
  readonly dtype: string;
  readonly shape: readonly number[];
  readonly data: Numbers | string;
}

const TYPES: Readonly<Record<string, new (buffer: ArrayBuffer) => ArrayLike<number | bigint>>> = {
  "|b1": Uint8Array, "|u1": Uint8Array, "|i1": Int8Array, "<i4": Int32Array, "<i8": BigInt64Array, "<f4": Float32Array,
};
const MAGIC = [0x93, ...new TextEncoder().encode("NUMPY"), 1, 0];
const LOCAL = 0x04034b50;
const CENTRAL = 0x02014b50;
const END = 0x06054b50;
const DEFLATED = 8;
const MOST_BYTES = 2 ** 28;

type Bytes = Uint8Array<ArrayBuffer>;

const joined = async (parts: readonly BlobPart[]): Promise<Bytes> => new Uint8Array(await new Blob([...parts]).arrayBuffer());

async function piped(bytes: Bytes, through: CompressionStream | DecompressionStream): Promise<Bytes> {
  const reader = new Blob([bytes]).stream().pipeThrough(through).getReader();
  const parts: BlobPart[] = [];
  let size = 0;
  for (let { done, value } = await reader.read(); !done; { done, value } = await reader.read()) {
    if ((size += value!.length) > MOST_BYTES) throw new RangeError(`expected at most ${MOST_BYTES} bytes`);
    parts.push(value!);
  }
  return joined(parts);
}

// ---- Writing

/** Return little-endian numbers as bytes; each is a value and its size in bytes. */
function packed(...fields: readonly (readonly [value: number, bytes: number])[]): Bytes {
  return Uint8Array.from(fields.flatMap(([value, bytes]) => Array.from({ length: bytes }, (_, place) => (value >>> (8 * place)) & 255)));
}

function npy({ dtype, shape, data }: NpyArray): Promise<Bytes> {
  // NumPy keeps the characters of a text as numbers of 32 bits.
  const points = typeof data === "string" ? Array.from(data, (each) => each.codePointAt(0)!) : null;
  const descr = points ? `<U${points.length}` : dtype;
  const sizes = shape.map((each) => `${each}, `).join("");
  const header = `{'descr': '${descr}', 'fortran_order': False, 'shape': (${sizes}), }`;
  const padded = header.padEnd(Math.ceil((MAGIC.length + 2 + header.length + 1) / 64) * 64 - MAGIC.length - 3) + "\n";
  return joined([Uint8Array.from(MAGIC), packed([padded.length, 2]), padded, (points ? Int32Array.from(points) : data) as BlobPart]);
}

const CRC = Int32Array.from({ length: 256 }, (_, byte) => {
  let rest = byte;
  for (let bit = 0; bit < 8; ++bit) rest = (rest >>> 1) ^ (rest & 1 ? 0xedb88320 : 0);
  return rest;
});

function crc32(bytes: Bytes): number {
  return ~bytes.reduce((sum, byte) => (sum >>> 8) ^ CRC[(sum ^ byte) & 255]!, -1);
}

/** Return the bytes of an npz file. */
export async function writeNpz(arrays: Readonly<Record<string, NpyArray>>): Promise<Bytes> {
  const [files, directory]: [Bytes[], Bytes[]] = [[], []];
  let offset = 0;
  for (const [name, array] of Object.entries(arrays)) {
    const [file, plain] = [new TextEncoder().encode(`${name}.npy`), await npy(array)];
    const data = await piped(plain, new CompressionStream("deflate-raw"));
    const about = packed([20, 2], [0, 2], [DEFLATED, 2], [0, 2], [0x21, 2], [crc32(plain), 4], [data.length, 4], [plain.length, 4], [file.length, 2], [0, 2]);
    const local = await joined([packed([LOCAL, 4]), about, file, data]);
    files.push(local);
    directory.push(await joined([packed([CENTRAL, 4], [20, 2]), about, packed([0, 2], [0, 2], [0, 2], [0, 4], [offset, 4]), file]));
    offset += local.length;
  }
  const listed = await joined(directory);
  const count = files.length;
  const end = packed([END, 4], [0, 2], [0, 2], [count, 2], [count, 2], [listed.length, 4], [offset, 4], [0, 2]);
  return joined([...files, listed, end]);
}

// ---- Reading

/** Return the arrays of an npz file. Throws an error if the bytes are none. */
export async function readNpz(bytes: Bytes): Promise<Record<string, NpyArray>> {
  const view = new DataView(bytes.buffer);
  let end = bytes.length - 22;
  while (view.getUint32(end, true) !== END) --end; // a DataView throws before its start
  const arrays: Record<string, NpyArray> = {};
  let at = view.getUint32(end + 16, true);
  for (let left = view.getUint16(end + 10, true); left > 0; --left) {
    const short = (place: number): number => view.getUint16(at + place, true);
    const [method, size, local] = [short(10), view.getUint32(at + 20, true), view.getUint32(at + 42, true)];
    const name = new TextDecoder().decode(bytes.subarray(at + 46, at + 46 + short(28)));
    const start = local + 30 + view.getUint16(local + 26, true) + view.getUint16(local + 28, true);
    const data = bytes.slice(start, start + size);
    arrays[name.replace(/\.npy$/, "")] = arrayOf(method === DEFLATED ? await piped(data, new DecompressionStream("deflate-raw")) : data);
    at += 46 + short(28) + short(30) + short(32);
  }
  return arrays;
}

function arrayOf(bytes: Bytes): NpyArray {
  const length = new DataView(bytes.buffer).getUint16(8, true);
  const header = new TextDecoder().decode(bytes.subarray(10, 10 + length));
  const found = /'descr': '([^']+)', 'fortran_order': False, 'shape': \(([\d, ]*)\)/.exec(header);
  if (!found) throw new TypeError(`expected an array, got ${header.slice(0, 80)}`);
  const [dtype, shape] = [found[1]!, found[2]!.split(",").filter((each) => each.trim()).map(Number)];
  const content = bytes.slice(10 + length).buffer;
  if (dtype.startsWith("<U")) {
    const points = Array.from(new Int32Array(content)).filter(Boolean);
    return { dtype, shape, data: points.map((each) => String.fromCodePoint(each)).join("") };
  }
  const Type = TYPES[dtype];
  if (!Type) throw new TypeError(`expected numbers, got ${dtype}`);
  return { dtype, shape, data: (dtype === "<i8" ? Int32Array.from(new BigInt64Array(content), Number) : new Type(content)) as Numbers };
}
