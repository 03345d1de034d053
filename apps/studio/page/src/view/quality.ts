// Finds out what draws before the real context is made: antialiasing can be chosen only then.

export interface Machine {
  /** Empty: no WebGL 2. */
  name: string;
  software: boolean;
}

const kSoftware = /swiftshader|llvmpipe|software|softpipe|basic render/i;

export function probeMachine(): Machine {
  const canvas = document.createElement('canvas');
  canvas.width = canvas.height = 1;
  const gl = canvas.getContext('webgl2');
  if (!gl) return { name: '', software: true };
  const info = gl.getExtension('WEBGL_debug_renderer_info');
  const name = String(gl.getParameter(info ? info.UNMASKED_RENDERER_WEBGL : gl.RENDERER));
  gl.getExtension('WEBGL_lose_context')?.loseContext();
  return { name, software: kSoftware.test(name) };
}
