// Decodes the numbers of the page's data: {type, count, data}, base64 of a zlib stream of the little-endian bytes in
// planes (all first bytes, then all second bytes, ...). It returns a typed array, which may be empty.
// A stream of another length than `count` says is an error, never a shorter array.

const arrays = { f64: Float64Array, f32: Float32Array, u32: Uint32Array, u8: Uint8Array };

export const can_decode = () => typeof DecompressionStream === 'function';

function bytes_of_base64(text) {
  if (typeof Uint8Array.fromBase64 === 'function') return Uint8Array.fromBase64(text);
  const binary = atob(text);
  const bytes = new Uint8Array(binary.length);
  for (let i = 0; i < bytes.length; ++i) bytes[i] = binary.charCodeAt(i);
  return bytes;
}

async function inflated(bytes, length) {
  const reader = new Blob([bytes]).stream().pipeThrough(new DecompressionStream('deflate')).getReader();
  const all = new Uint8Array(length);
  let place = 0;
  for (;;) {
    const { done, value } = await reader.read();
    if (done) break;
    if (place + value.length > length) throw new Error('The data of this page are damaged: a stream is too long.');
    all.set(value, place);
    place += value.length;
  }
  if (place !== length) throw new Error('The data of this page are damaged: a stream is too short.');
  return all;
}

export async function decode(blob) {
  const type = arrays[blob.type];
  if (blob.count === 0) return new type(0);
  const size = type.BYTES_PER_ELEMENT;
  const planes = await inflated(bytes_of_base64(blob.data), blob.count * size);
  if (size === 1) return planes;
  const bytes = new Uint8Array(planes.length);
  for (let plane = 0; plane < size; ++plane) {
    const from = plane * blob.count;
    for (let i = 0, to = plane; i < blob.count; ++i, to += size) bytes[to] = planes[from + i];
  }
  return new type(bytes.buffer);
}

// Decodes the named blobs of an object, all at once.
export async function decode_all(object, names) {
  const values = await Promise.all(names.map((name) => decode(object[name])));
  return Object.fromEntries(names.map((name, i) => [name, values[i]]));
}
