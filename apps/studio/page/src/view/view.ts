// The 3D picture: one class around three's WebGLRenderer, fed by typed arrays. It draws only after invalidate(), at most
// once a frame of the screen. Nothing in here knows of the store (view/sync.ts does).

import { Camera as ThreeCamera, ColorManagement, Scene, Vector2, WebGLRenderer } from 'three';
import { homeCamera, projectionMatrix, scaleOf, viewMatrix, type Camera, type Screen } from '../core/camera';
import type { FieldInfo, ShapePack, TopologyPack } from '../core/protocol';
import type { LegendRange } from '../core/store';
import { bounds, type Vec3 } from '../core/vec';
import { Fabric } from './fabric';
import { Ghost } from './ghost';
import { Grid } from './grid';
import type { Machine } from './machine';
import { Markers } from './markers';
import { paletteOf, type Palette } from './palette';
import { Rods } from './rods';
import { ScreenLines } from './screen_lines';
import { colourTables } from './tables';

export interface ViewQuality {
  sides: number;
  pixelRatio: number;
  /** While things move only so large a part of the canvas is drawn, shown enlarged; all of it a moment after they rest. */
  hurriedShare: number;
}

export function highQuality(): ViewQuality {
  return { sides: 12, pixelRatio: Math.min(devicePixelRatio, 2), hurriedShare: 1 };
}
export const kLowQuality: ViewQuality = { sides: 6, pixelRatio: 1, hurriedShare: 0.6 };

/** How long things have to rest before they are drawn finely, ms. A fine picture takes as long as three others: while somebody
 *  drags it would be in the way of the next shape. */
const kRestMs = 220;
const kRestInDragMs = 700;

export type GhostName = 'flat' | 'previous' | 'preview' | 'mode' | 'branch';

// The colours of this page are sRGB from end to end.
ColorManagement.enabled = false;

export class View {
  readonly rods: Rods;
  readonly fabric: Fabric;
  readonly grid: Grid;
  readonly ghosts: Record<GhostName, Ghost>;
  readonly lines = {
    dashed: new ScreenLines(),
    links: new ScreenLines({ depthTest: false, order: 6 }),
  };
  readonly markers = {
    points: new Markers('disc', { order: 7 }),
    pins: new Markers('pyramid'),
    still: new Markers('cube', { depthTest: false, order: 7 }),
    targets: new Markers('disc', { depthTest: false, order: 6 }),
  };
  /** Called after each picture. */
  onDrawn: () => void = () => {};
  palette: Palette = paletteOf(false);

  private readonly renderer: WebGLRenderer;
  private readonly scene = new Scene();
  private readonly eye = new ThreeCamera();
  private readonly tables = colourTables();
  private camera: Camera = homeCamera;
  private screen: Screen = { width: 1, height: 1 };
  private ground = 0;
  private asked = 0;
  private lost = false;
  private restTimer: ReturnType<typeof setTimeout> | undefined;
  private ratio: number;
  /** Of the canvas that is drawn, in both directions; the canvas is enlarged by as much on the page. */
  private share = 1;
  private shownShare = 1;
  /** Signalled once the graphics card, or the processor in its place, has drawn the last picture. */
  private drawn: WebGLSync | null = null;

  readonly canvas: HTMLCanvasElement;

  constructor(
    { canvas, context }: Machine,
    private quality: ViewQuality,
  ) {
    this.canvas = canvas;
    this.renderer = new WebGLRenderer({ canvas, context, alpha: true });
    // Asking each shader whether it is well costs a wait for it; they are the same on every machine, and tests see them.
    this.renderer.debug.checkShaderErrors = false;
    this.ratio = quality.pixelRatio;
    this.rods = new Rods(quality.sides, this.tables, this.palette);
    this.fabric = new Fabric(this.tables, this.palette);
    this.grid = new Grid(this.palette);
    const { palette } = this;
    this.ghosts = {
      flat: new Ghost(palette.flat, 0.14, 0.7),
      previous: new Ghost(palette.previous, 0.16, 0.8),
      preview: new Ghost(palette.preview, 0.3, 0.95),
      mode: new Ghost(palette.mode, 0.26, 0.9),
      branch: new Ghost(palette.mode, 0.26, 0.9),
    };
    this.scene.add(this.rods.mesh, this.fabric.mesh, this.fabric.lines, this.grid.lines);
    for (const ghost of Object.values(this.ghosts)) this.scene.add(ghost.group);
    for (const lines of Object.values(this.lines)) this.scene.add(lines.mesh);
    for (const markers of Object.values(this.markers)) this.scene.add(markers.mesh);
    this.scene.matrixWorldAutoUpdate = false;
    this.eye.matrixAutoUpdate = this.eye.matrixWorldAutoUpdate = false;
    // Shaders are made ready while the first shape is on its way.
    this.renderer.compile(this.scene, this.eye);
    canvas.addEventListener('webglcontextlost', this.onLost);
    canvas.addEventListener('webglcontextrestored', this.onRestored);
  }

  dispose(): void {
    cancelAnimationFrame(this.asked);
    clearTimeout(this.restTimer);
    this.canvas.removeEventListener('webglcontextlost', this.onLost);
    this.canvas.removeEventListener('webglcontextrestored', this.onRestored);
    this.renderer.dispose();
  }

  setScreen(screen: Screen): void {
    this.screen = screen;
    for (const lines of Object.values(this.lines)) lines.setScreen(screen.width, screen.height);
    this.draw();
  }

  /** Things move now: pictures may be coarser until they rest. */
  hurry(inDrag = false): void {
    if (this.quality.hurriedShare === 1) return;
    this.share = this.quality.hurriedShare;
    clearTimeout(this.restTimer);
    this.restTimer = setTimeout(() => {
      this.share = 1;
      this.invalidate();
    }, inDrag ? kRestInDragMs : kRestMs);
  }

  setCamera(camera: Camera): void {
    this.camera = camera;
    this.invalidate();
  }

  setQuality(quality: ViewQuality): void {
    this.quality = quality;
    this.ratio = quality.pixelRatio;
    this.rods.setSides(quality.sides);
    this.setScreen(this.screen);
  }

  setPalette(palette: Palette): void {
    this.palette = palette;
    for (const part of [this.rods, this.fabric, this.grid]) part.setPalette(palette);
    this.ghosts.flat.setColour(palette.flat);
    this.ghosts.previous.setColour(palette.previous);
    this.ghosts.preview.setColour(palette.preview);
    this.ghosts.mode.setColour(palette.mode);
    this.ghosts.branch.setColour(palette.mode);
    this.invalidate();
  }

  setTopology(topology: TopologyPack): void {
    this.rods.setTopology(topology);
    this.fabric.setTopology(topology);
  }

  setShape(shape: ShapePack, rodColours: boolean, fabricColours: boolean): void {
    if (shape.edge_radii) this.rods.setRadii(shape.edge_radii);
    this.rods.setShape(shape.positions, shape.normals, rodColours ? shape.edge_values : null);
    this.fabric.setShape(shape.positions, fabricColours ? shape.triangle_values : null);
    const box = bounds(shape.positions);
    if (box) this.ground = box.low[2] - 0.02 * Math.max(box.high[0] - box.low[0], 1);
    this.invalidate();
  }

  /** Colours of a field on rods or fabric; null: plain. */
  setColours(part: 'rods' | 'fabric', field: FieldInfo | null, { low, high, locked }: LegendRange): void {
    const { uniforms } = this[part];
    uniforms.coloured.value = field ? (locked ? 2 : 1) : 0;
    if (field) uniforms.table.value = field.diverging ? this.tables.diverging : this.tables.sequential;
    (uniforms.range.value as Vector2).set(low, 1 / Math.max(high - low, 1e-12));
    this.invalidate();
  }

  /** 0: as it is, 1: as pale as the ground. */
  setFaded(faded: number): void {
    this.rods.uniforms.faded.value = faded;
    this.fabric.uniforms.faded.value = faded;
    this.invalidate();
  }

  invalidate(): void {
    if (this.asked === 0) this.asked = requestAnimationFrame(this.onFrame);
  }

  // Without a graphics card a picture takes longer than a frame: the next one waits, so that the rest of the page does not.
  private readonly onFrame = () => {
    const gl = this.renderer.getContext() as WebGL2RenderingContext;
    if (this.drawn && !this.lost && gl.getSyncParameter(this.drawn, gl.SYNC_STATUS) !== gl.SIGNALED) {
      this.asked = requestAnimationFrame(this.onFrame);
      return;
    }
    this.draw();
  };

  /** PNG of the picture at `ratio` times its size; transparent where nothing is. */
  async capture(ratio: number, grid: boolean): Promise<HTMLCanvasElement> {
    const shown = this.grid.lines.visible;
    this.grid.lines.visible = shown && grid;
    this.ratio = ratio;
    this.share = 1;
    this.draw();
    const copy = document.createElement('canvas');
    copy.width = this.canvas.width;
    copy.height = this.canvas.height;
    copy.getContext('2d')?.drawImage(this.canvas, 0, 0);
    this.grid.lines.visible = shown;
    this.setQuality(this.quality);
    return copy;
  }

  private readonly onLost = (event: Event) => {
    event.preventDefault();
    this.lost = true;
  };

  // three rebuilds its own objects; textures and buffers are uploaded again with the next picture.
  private readonly onRestored = () => {
    this.lost = false;
    this.drawn = null;
    this.invalidate();
  };

  draw(): void {
    cancelAnimationFrame(this.asked);
    this.asked = 0;
    if (this.lost || this.screen.width < 2 || this.screen.height < 2) return;
    this.fitCanvas();
    const { camera, screen, eye } = this;
    eye.matrixWorldInverse.fromArray(viewMatrix(camera));
    eye.matrixWorld.copy(eye.matrixWorldInverse).invert();
    eye.projectionMatrix.fromArray(projectionMatrix(camera, screen));
    eye.projectionMatrixInverse.copy(eye.projectionMatrix).invert();
    const pixel = scaleOf(camera, screen);
    const unitPixel = camera.orthographic ? pixel : pixel / camera.distance;
    this.rods.uniforms.pixel.value = unitPixel;
    for (const markers of Object.values(this.markers)) markers.setPixel(unitPixel);
    const middle: Vec3 = [camera.target[0], camera.target[1], this.ground];
    this.grid.place(middle, pixel * screen.height);
    this.renderer.render(this.scene, eye);
    const gl = this.renderer.getContext() as WebGL2RenderingContext;
    if (this.drawn) gl.deleteSync(this.drawn);
    this.drawn = gl.fenceSync(gl.SYNC_GPU_COMMANDS_COMPLETE, 0);
    gl.flush();
    this.onDrawn();
  }

  /** A canvas that gets another size is empty until it is drawn (and getting it takes long): only draw() may do that. */
  private fitCanvas(): void {
    const { width, height } = this.screen;
    const [w, h] = [Math.floor(width * this.ratio), Math.floor(height * this.ratio)];
    const { share, renderer, canvas } = this;
    if (canvas.width !== w || canvas.height !== h) {
      renderer.setPixelRatio(this.ratio);
      renderer.setSize(width, height, false);
    } else if (share === this.shownShare) {
      return;
    }
    this.shownShare = share;
    renderer.setViewport(0, 0, width * share, height * share);
    renderer.setScissor(0, 0, width * share, height * share);
    renderer.setScissorTest(share < 1);
    canvas.style.transform = share < 1 ? `scale(${1 / share})` : '';
  }
}
