// The canvas of the 3D view and what draws into it. It is made before anything else, for without a graphics card the
// browser needs a quarter of a second to set one up in the background, in which panels and the first shape can come.

export interface Machine {
  canvas: HTMLCanvasElement;
  context: WebGL2RenderingContext;
  name: string;
  software: boolean;
}

const kSoftware = /swiftshader|llvmpipe|software|softpipe|basic render/i;

function contextOf(canvas: HTMLCanvasElement, antialias: boolean): WebGL2RenderingContext | null {
  return canvas.getContext('webgl2', { alpha: true, antialias, depth: true, stencil: false, powerPreference: 'high-performance' });
}

let early: { canvas: HTMLCanvasElement; context: WebGL2RenderingContext | null } | null = null;

/** Begins to set up a canvas; returns at once. */
export function prepareMachine(): void {
  const canvas = document.createElement('canvas');
  early = { canvas, context: contextOf(canvas, false) };
}

/** The canvas to draw into; null: there is no WebGL 2. Software keeps the plain one that was prepared; a graphics card gets
 *  one with antialiasing, which can be chosen only when a context is made, and costs it nothing. */
export function takeMachine(): Machine | null {
  if (!early) prepareMachine();
  const plain = early;
  early = null;
  if (!plain?.context) return null;
  const info = plain.context.getExtension('WEBGL_debug_renderer_info');
  const name = String(plain.context.getParameter(info ? info.UNMASKED_RENDERER_WEBGL : plain.context.RENDERER));
  if (kSoftware.test(name)) return { canvas: plain.canvas, context: plain.context, name, software: true };
  const canvas = document.createElement('canvas');
  const context = contextOf(canvas, true);
  plain.context.getExtension('WEBGL_lose_context')?.loseContext();
  return context && { canvas, context, name, software: false };
}
