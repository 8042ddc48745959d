// The WebGL renderer. Where the browser draws in software, edges of big inputs are not smoothed: smoothing takes four
// times as long there, and nothing on a graphics card. Throws where there is no WebGL.

import { WebGLRenderer } from 'three';

function draws_in_software() {
  const gl = document.createElement('canvas').getContext('webgl2');
  if (!gl) throw new Error('There is no WebGL 2.');
  const info = gl.getExtension('WEBGL_debug_renderer_info');
  const name = info ? gl.getParameter(info.UNMASKED_RENDERER_WEBGL) : '';
  gl.getExtension('WEBGL_lose_context')?.loseContext();
  return /swiftshader|llvmpipe|softpipe|software|basic render/i.test(name);
}

export function make_renderer(canvas, is_big) {
  const antialias = !is_big || !draws_in_software();
  return new WebGLRenderer({ canvas, antialias, alpha: true, powerPreference: 'high-performance' });
}
