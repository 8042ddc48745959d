// The colours of the page: Okabe and Ito's, which people with any sort of colour blindness can tell apart.
// Kinds of points also differ in shape, so that no statement is made by colour alone.
// Each theme has colours of the surface, its highlight, pockets, and the lines. Cells and U1 have those of their points.

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
  pockets: '#4a7a2a',
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
  pockets: '#a5cf6b',
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
