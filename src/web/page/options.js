// Options as the program's sentences name them, `--columns 2,3,4 --atoms "no water"`, as the package takes them:
// { columns: '2,3,4', atoms: ['no water'] }. An option that is not known is an error in one sentence.

const texts = ['format', 'columns', 'models', 'radii', 'depth', 'probe', 'pockets'];
const numbers = ['z', 'frame', 'most', 'mostCells', 'mostUnstable', 'mostPockets'];
const flags = ['skipInvalid', 'unlimited', 'finite', 'cells'];
const lists = ['atoms', 'chains'];

export function options_of(text) {
  const options = {};
  const words = (text.match(/"[^"]*"|[^\s=]+/g) ?? []).map((word) => word.replaceAll('"', ''));
  for (let k = 0; k < words.length; ++k) {
    const name = words[k].replace(/^--/, '').replace(/-([a-z])/g, (_, letter) => letter.toUpperCase());
    const value = flags.includes(name) ? true : words[++k];
    if (value === undefined) throw new Error(`${words[k - 1]} has no value`);
    if (lists.includes(name)) (options[name] ??= []).push(value);
    else if (numbers.includes(name)) options[name] = Number(value);
    else if (texts.includes(name) || value === true) options[name] = value;
    else throw new Error(`there is no option ${words[k - 1]} here`);
  }
  return options;
}

// The same text with other radii, or with none.
export const with_radii = (text, radii) =>
  `${text.replace(/\s*--radii[\s=]+\S+/, '')}${radii && ` --radii ${radii}`}`.trim();
