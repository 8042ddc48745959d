// The colours of the page: Okabe and Ito's, which people with any sort of colour blindness can tell apart.
// Kinds of points also differ in shape, so that no statement is made by colour alone.
// Each theme has colours of the surface, its highlight, pockets, cycles and lines. Cells and U1 have those of their
// points. Elements have the colours that chemists know; what is far away fades into `haze`.

export const kind_names = ['samples', 'index 1', 'index 2', 'index 3', 'regular stationary'];

// 0 disc, 1 square, 2 triangle, 3 star, 4 diamond; as in the fragment shader of point_cloud.js.
const light = {
  kinds: ['#5b6472', '#0072b2', '#d98800', '#c04d00', '#b45a92'],
  surface: '#d8c6a4',
  highlight: '#e69f00',
  s1: '#3f8fc4',
  s3: '#c04d00',
  u1: '#0072b2',
  u2: '#00805d',
  pockets: '#c2127e',
  cycle: '#6a3fc4',
  mouths: '#ffeaf5',
  outline: '#1c2430',
  elements: {
    C: '#868e9b', N: '#2f62d9', O: '#d93a2b', H: '#dde1e6', D: '#dde1e6', S: '#d6ac00', P: '#e07b1a',
    F: '#3aa845', Cl: '#3aa845', Br: '#8e3b2f', I: '#7b3fa0', Fe: '#b5562a', Zn: '#7d80b0', Mg: '#3d9155',
    Ca: '#3d9155', Na: '#8a55c8', K: '#8a55c8', other: '#949dab',
  },
  haze: '#ece5d6',
  claimed: '#c04d00',
  truth: '#00805d',
  ink: '#1c2430',
  muted: '#657081',
  grid: '#ddd5c4',
  paper: '#fffdf8',
  accent: '#005f96',
};

const dark = {
  kinds: ['#a9b2c0', '#56b4e9', '#f0ad24', '#f07a32', '#d98cb9'],
  surface: '#b9ae9b',
  highlight: '#f5b83d',
  s1: '#56b4e9',
  s3: '#f07a32',
  u1: '#56b4e9',
  u2: '#2cc79b',
  pockets: '#ff4fb0',
  cycle: '#a98bff',
  mouths: '#ffe0f1',
  outline: '#fffdf8',
  elements: {
    C: '#a3abb8', N: '#6f97ff', O: '#ff6a58', H: '#f2f4f7', D: '#f2f4f7', S: '#f0cc3a', P: '#ff9d45',
    F: '#5fd06a', Cl: '#5fd06a', Br: '#c96d5c', I: '#b07ad6', Fe: '#e08a5a', Zn: '#a5a8d8', Mg: '#62c07c',
    Ca: '#62c07c', Na: '#b48be8', K: '#b48be8', other: '#8a93a2',
  },
  haze: '#151d28',
  claimed: '#f07a32',
  truth: '#2cc79b',
  ink: '#ece8dd',
  muted: '#98a3b5',
  grid: '#2d3644',
  paper: '#171d27',
  accent: '#6fc1f0',
};

export const palettes = { light, dark };

export function components(hex) {
  const value = parseInt(hex.slice(1), 16);
  return [(value >> 16) / 255, ((value >> 8) & 255) / 255, (value & 255) / 255];
}
