// A second shape over the first: flat, previous, preview, a mode, another branch. Fabric as a thin tint, rods as lines.

import { BufferAttribute, BufferGeometry, DynamicDrawUsage, Group, LineSegments, Mesh, type RawShaderMaterial } from 'three';
import type { Colour } from '../core/colours';
import { forEachEdge } from '../core/picking';
import type { TopologyPack } from '../core/protocol';
import { everywhere } from './everywhere';
import { material, setColour, vec } from './shading';

const kVertex = /* glsl */ `
in vec3 position;
void main() {
  vec4 seen = modelViewMatrix * vec4(position, 1.0);
  seen.xyz *= 0.999; // where both shapes are the same the ghost lies on top
  gl_Position = projectionMatrix * seen;
}
`;
const kFragment = /* glsl */ `
uniform vec3 ink;
uniform float alpha;
void main() { colour = vec4(ink, alpha); }
`;

export class Ghost {
  readonly group = new Group();
  private readonly fabric: Mesh<BufferGeometry, RawShaderMaterial>;
  private readonly rods: LineSegments<BufferGeometry, RawShaderMaterial>;
  private topology = -1;
  private nodes = 0;

  constructor(colour: Colour, fabricAlpha: number, rodAlpha: number) {
    const paint = (alpha: number) =>
      material(kVertex, kFragment, { ink: { value: vec(colour) }, alpha: { value: alpha } }, { transparent: true, depthWrite: false });
    this.fabric = new Mesh(everywhere(new BufferGeometry()), paint(fabricAlpha));
    this.rods = new LineSegments(everywhere(new BufferGeometry()), paint(rodAlpha));
    this.fabric.frustumCulled = this.rods.frustumCulled = false;
    this.fabric.renderOrder = 4;
    this.rods.renderOrder = 5;
    this.group.add(this.fabric, this.rods);
    this.group.visible = false;
  }

  setColour(colour: Colour): void {
    setColour(this.fabric.material.uniforms.ink, colour);
    setColour(this.rods.material.uniforms.ink, colour);
  }

  hide(): void {
    this.group.visible = false;
  }

  /** (nodes, 3) of the topology; arrays of another length are not shown. */
  show(topology: TopologyPack, positions: Float32Array): void {
    this.build(topology);
    this.group.visible = positions.length === 3 * this.nodes;
    if (!this.group.visible) return;
    const places = this.fabric.geometry.getAttribute('position') as BufferAttribute;
    places.array = positions;
    places.needsUpdate = true;
  }

  private build(topology: TopologyPack): void {
    if (this.topology === topology.topology) return;
    this.topology = topology.topology;
    this.nodes = topology.plan_places.length / 2;
    const places = new BufferAttribute(new Float32Array(3 * this.nodes), 3);
    places.setUsage(DynamicDrawUsage);
    const edges: number[] = [];
    forEachEdge(topology, (_chain, _edge, a, b) => edges.push(a, b));
    for (const [object, index] of [
      [this.fabric, topology.triangles],
      [this.rods, Uint32Array.from(edges)],
    ] as const) {
      object.geometry.dispose();
      object.geometry = everywhere(new BufferGeometry());
      object.geometry.setAttribute('position', places);
      object.geometry.setIndex(new BufferAttribute(index, 1));
    }
  }
}
