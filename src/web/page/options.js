// Options as the program's sentences name them, `--columns 2,3,4 --atoms "no water"`, as the package takes them:
// { columns: '2,3,4', atoms: ['no water'] }. An option that is not known, or has no value, is an error.

const kinds = {
  ...{ format: String, columns: String, models: String, radii: String, depth: String, probe: String, pockets: String },
  ...{ z: Number, frame: Number, most: Number, mostCells: Number, mostUnstable: Number, mostPockets: Number },
  ...{ skipInvalid: Boolean, unlimited: Boolean, finite: Boolean, cells: Boolean, atoms: Array, chains: Array },
};

export function options_of(text) {
  const options = {};
  const words = text.replace(/(--[\w-]+)=/g, '$1 ').match(/"[^"]*"|\S+/g) ?? [];
  while (words.length > 0) {
    const word = words.shift();
    const name = word.replace(/^--/, '').replace(/-([a-z])/g, (_, letter) => letter.toUpperCase());
    const kind = Object.hasOwn(kinds, name) && kinds[name];
    if (!kind) throw new Error(`there is no option ${word} here`);
    const value = kind === Boolean || words.shift()?.replaceAll('"', '');
    if (value === undefined) throw new Error(`${word} has no value`);
    if (kind === Array) (options[name] ??= []).push(value);
    else options[name] = kind(value);
  }
  return options;
}

// The same text with other radii, or with none.
export const with_radii = (text, radii) =>
  `${text.replace(/\s*--radii[\s=]+\S+/, '')}${radii && ` --radii ${radii}`}`.trim();
