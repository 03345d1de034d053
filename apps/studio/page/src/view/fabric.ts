// The fabric of the shape. Places go to the graphics card straight from the message; normals, thickness and values are
// computed here.

import { BufferAttribute, BufferGeometry, DynamicDrawUsage, LineSegments, Mesh, Vector2, type RawShaderMaterial } from 'three';
import { FabricFrame, setWeights } from '../core/fabric_frame';
import type { TopologyPack } from '../core/protocol';
import { everywhere } from './everywhere';
import { fabricFragment, fabricVertex } from './fabric_shader';
import type { Palette } from './palette';
import { material, setColour, vec } from './shading';
import type { ColourTables } from './tables';

const kLineVertex = /* glsl */ `
in vec3 position;
void main() {
  vec4 seen = modelViewMatrix * vec4(position, 1.0);
  seen.xyz *= 0.9995; // a hair nearer than the fabric
  gl_Position = projectionMatrix * seen;
}
`;
const kLineFragment = /* glsl */ `
uniform vec3 ink;
void main() { colour = vec4(ink, 0.35); }
`;

export class Fabric {
  readonly mesh: Mesh<BufferGeometry, RawShaderMaterial>;
  readonly lines: LineSegments<BufferGeometry, RawShaderMaterial>;
  private frame: FabricFrame | null = null;
  private triangles: Uint32Array | null = null;

  constructor(tables: ColourTables, palette: Palette) {
    const uniforms = {
      table: { value: tables.sequential },
      range: { value: new Vector2(0, 1) },
      coloured: { value: 0 },
      faded: { value: 0 },
      opacity: { value: 0.8 },
      front: { value: vec(palette.fabric) },
      behind: { value: vec(palette.fabricBack) },
      ground: { value: vec(palette.ground) },
      selectColour: { value: vec(palette.select) },
    };
    this.mesh = new Mesh(everywhere(new BufferGeometry()), material(fabricVertex, fabricFragment, uniforms, { transparent: true }));
    this.lines = new LineSegments(
      everywhere(new BufferGeometry()),
      material(kLineVertex, kLineFragment, { ink: { value: vec(palette.ink) } }, { transparent: true, depthWrite: false }),
    );
    for (const object of [this.mesh, this.lines]) {
      object.frustumCulled = false;
      object.visible = false;
    }
    this.mesh.renderOrder = 1;
    this.lines.renderOrder = 2;
  }

  get uniforms() {
    return this.mesh.material.uniforms;
  }

  setTopology(topology: TopologyPack): void {
    const nodes = topology.plan_places.length / 2;
    this.frame = new FabricFrame(topology.triangles, topology.plan_places, nodes);
    this.mesh.geometry.dispose();
    const geometry = everywhere(new BufferGeometry());
    geometry.setIndex(new BufferAttribute(topology.triangles, 1));
    geometry.setAttribute('position', dynamic(new Float32Array(3 * nodes), 3));
    geometry.setAttribute('normal', dynamic(this.frame.normals, 3));
    geometry.setAttribute('extra', dynamic(this.frame.extra, 3));
    this.mesh.geometry = geometry;
    this.triangles = topology.triangles;
    if (this.lines.visible) this.buildLines();
  }

  /** Shows the mesh; its lines are made only then, for a drag may bring a new mesh with every step. */
  showLines(shown: boolean): void {
    if (shown && !this.lines.visible) this.buildLines();
    this.lines.visible = shown;
  }

  private buildLines(): void {
    const position = this.mesh.geometry.getAttribute('position');
    if (!this.triangles || !position) return;
    this.lines.geometry.dispose();
    this.lines.geometry = everywhere(new BufferGeometry());
    this.lines.geometry.setAttribute('position', position);
    this.lines.geometry.setIndex(new BufferAttribute(edgesOf(this.triangles), 1));
  }

  setShape(positions: Float32Array, values: Float32Array | null): void {
    if (!this.frame) return;
    this.frame.update(positions, values);
    const { position, normal, extra } = this.mesh.geometry.attributes as Record<string, BufferAttribute>;
    position.array = positions;
    for (const attribute of [position, normal, extra]) attribute.needsUpdate = true;
  }

  /** Weights of the soft selection, one per node; null: none. */
  setWeights(weights: Float32Array | null): void {
    if (!this.frame) return;
    setWeights(this.frame.extra, weights);
    this.mesh.geometry.getAttribute('extra').needsUpdate = true;
  }

  setPalette(palette: Palette): void {
    setColour(this.uniforms.front, palette.fabric);
    setColour(this.uniforms.behind, palette.fabricBack);
    setColour(this.uniforms.ground, palette.ground);
    setColour(this.uniforms.selectColour, palette.select);
    setColour(this.lines.material.uniforms.ink, palette.ink);
  }
}

function dynamic(array: Float32Array, columns: number): BufferAttribute {
  const attribute = new BufferAttribute(array, columns);
  attribute.setUsage(DynamicDrawUsage);
  return attribute;
}

/** Every edge of a triangle mesh once. */
function edgesOf(triangles: Uint32Array): Uint32Array {
  const seen = new Set<number>();
  const out: number[] = [];
  for (let t = 0; t < triangles.length; t += 3) {
    for (let k = 0; k < 3; ++k) {
      const a = Math.min(triangles[t + k], triangles[t + ((k + 1) % 3)]);
      const b = Math.max(triangles[t + k], triangles[t + ((k + 1) % 3)]);
      const key = a * 4194304 + b;
      if (seen.has(key)) continue;
      seen.add(key);
      out.push(a, b);
    }
  }
  return Uint32Array.from(out);
}
