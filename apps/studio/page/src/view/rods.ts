// The rods of the shape: one indexed mesh for all of them. A frame is one small texture.

import {
  BufferAttribute,
  BufferGeometry,
  DataTexture,
  FloatType,
  Mesh,
  NearestFilter,
  RGBAFormat,
  RGFormat,
  UnsignedByteType,
  Vector2,
  type RawShaderMaterial,
} from 'three';
import { chainsOf, fillSlots, slotRadii, tubeMesh, type Chains } from '../core/chains';
import type { TopologyPack } from '../core/protocol';
import { everywhere } from './everywhere';
import type { Palette } from './palette';
import { rodFragment, rodVertex } from './rods_shader';
import { material, setColour, vec } from './shading';
import type { ColourTables } from './tables';

const kColumns = 1024;

function texture(data: Float32Array | Uint8Array, format: typeof RGBAFormat | typeof RGFormat, texels: number): DataTexture {
  const type = data instanceof Float32Array ? FloatType : UnsignedByteType;
  const made = new DataTexture(data as never, kColumns, rowsFor(texels), format, type, undefined, undefined, undefined, NearestFilter, NearestFilter);
  made.needsUpdate = true;
  return made;
}

function rowsFor(texels: number): number {
  return Math.max(1, Math.ceil(texels / kColumns));
}

export class Rods {
  readonly mesh: Mesh<BufferGeometry, RawShaderMaterial>;
  private chains: Chains | null = null;
  private topology: TopologyPack | null = null;
  private slots = new Float32Array(0);
  private state: DataTexture | null = null;
  private radii: DataTexture | null = null;
  private marks: DataTexture | null = null;

  constructor(
    private sides: number,
    tables: ColourTables,
    palette: Palette,
  ) {
    const uniforms = {
      state: { value: null },
      radii: { value: null },
      marks: { value: null },
      columns: { value: kColumns },
      sides: { value: sides },
      pixel: { value: 1 },
      leastPixels: { value: 0.9 },
      table: { value: tables.diverging },
      range: { value: new Vector2(0, 1) },
      coloured: { value: 0 },
      faded: { value: 0 },
      base: { value: vec(palette.rod) },
      ground: { value: vec(palette.ground) },
      selectColour: { value: vec(palette.select) },
      hoverColour: { value: vec(palette.hover) },
      warnColour: { value: vec(palette.warn) },
    };
    this.mesh = new Mesh(everywhere(new BufferGeometry()), material(rodVertex, rodFragment, uniforms));
    this.mesh.frustumCulled = false;
    this.mesh.visible = false;
  }

  get uniforms() {
    return this.mesh.material.uniforms;
  }

  setTopology(topology: TopologyPack): void {
    this.topology = topology;
    this.chains = chainsOf(topology);
    this.makeRoom(this.chains.count);
    this.setRadii(topology.edge_radii);
    this.build();
  }

  setSides(sides: number): void {
    if (sides === this.sides) return;
    this.sides = sides;
    this.uniforms.sides.value = sides;
    if (this.topology) this.build();
  }

  setRadii(edgeRadii: Float32Array): void {
    if (!this.chains || !this.radii) return;
    (this.radii.image.data as unknown as Float32Array).set(slotRadii(this.chains, edgeRadii));
    this.radii.needsUpdate = true;
  }

  /** A frame: places, axes and values (null: plain). */
  setShape(positions: Float32Array, normals: Float32Array, values: Float32Array | null): void {
    if (!this.chains || !this.topology || !this.state) return;
    fillSlots(this.chains, this.topology.rod_nodes, positions, normals, values, this.slots);
    this.state.needsUpdate = true;
  }

  /** Marks of the slots, 0 to 255: selected, hovered, soft weight, among the worst. */
  setMarks(fill: (slot: number, rod: number, node: number) => [number, number, number, number]): void {
    if (!this.chains || !this.topology || !this.marks) return;
    const data = this.marks.image.data as Uint8Array;
    for (let s = 0; s < this.chains.count; ++s) data.set(fill(s, this.chains.rod[s], this.topology.rod_nodes[s]), 4 * s);
    this.marks.needsUpdate = true;
  }

  setPalette(palette: Palette): void {
    setColour(this.uniforms.base, palette.rod);
    setColour(this.uniforms.ground, palette.ground);
    setColour(this.uniforms.selectColour, palette.select);
    setColour(this.uniforms.hoverColour, palette.hover);
    setColour(this.uniforms.warnColour, palette.warn);
  }

  private build(): void {
    if (!this.topology || !this.chains) return;
    const { vertices, index } = tubeMesh(this.topology, this.chains, this.sides);
    this.mesh.geometry.dispose();
    const geometry = everywhere(new BufferGeometry());
    geometry.setAttribute('corner', new BufferAttribute(vertices, 4));
    geometry.setIndex(new BufferAttribute(index, 1));
    this.mesh.geometry = geometry;
  }

  /** Textures for so many slots; those of the mesh before do when they have as many rows. */
  private makeRoom(count: number): void {
    const floats = 4 * kColumns * rowsFor(2 * count);
    if (this.slots.length === floats && this.state) return;
    this.slots = new Float32Array(floats);
    this.dispose();
    this.state = texture(this.slots, RGBAFormat, 2 * count);
    this.radii = texture(new Float32Array(2 * kColumns * rowsFor(count)), RGFormat, count);
    this.marks = texture(new Uint8Array(4 * kColumns * rowsFor(count)), RGBAFormat, count);
    this.uniforms.state.value = this.state;
    this.uniforms.radii.value = this.radii;
    this.uniforms.marks.value = this.marks;
  }

  private dispose(): void {
    this.state?.dispose();
    this.radii?.dispose();
    this.marks?.dispose();
  }
}
