// The ground: a grid that fades away from the object. Its step follows the zoom in decades.

import { BufferAttribute, BufferGeometry, LineSegments, Vector3, type RawShaderMaterial } from 'three';
import { everywhere } from './everywhere';
import type { Palette } from './palette';
import { material, setColour, vec } from './shading';

const kVertex = /* glsl */ `
uniform vec3 middle;      // where the grid is strongest; z is the ground's height
uniform float cell;
uniform float reach;
in vec3 position;         // cells, and 1 for every tenth line
out float strength;
void main() {
  vec3 place = vec3(position.xy * cell + floor(middle.xy / (10.0 * cell)) * 10.0 * cell, middle.z);
  float far = length(place.xy - middle.xy) / reach;
  strength = (position.z > 0.5 ? 0.55 : 0.26) * (1.0 - smoothstep(0.25, 1.0, far));
  gl_Position = projectionMatrix * modelViewMatrix * vec4(place, 1.0);
}
`;
const kFragment = /* glsl */ `
uniform vec3 ink;
in float strength;
void main() { colour = vec4(ink, strength); }
`;

const kHalf = 40;
const kPart = 4;

export class Grid {
  readonly lines: LineSegments<BufferGeometry, RawShaderMaterial>;

  constructor(palette: Palette) {
    const uniforms = {
      middle: { value: new Vector3() },
      cell: { value: 10 },
      reach: { value: 300 },
      ink: { value: vec(palette.grid) },
    };
    const geometry = everywhere(new BufferGeometry());
    geometry.setAttribute('position', new BufferAttribute(gridLines(), 3));
    this.lines = new LineSegments(geometry, material(kVertex, kFragment, uniforms, { transparent: true, depthWrite: false }));
    this.lines.frustumCulled = false;
    this.lines.renderOrder = -1;
  }

  /** `span`: mm that the picture shows from top to bottom. */
  place(middle: readonly [number, number, number], span: number): void {
    const { uniforms } = this.lines.material;
    const cell = Math.pow(10, Math.floor(Math.log10(Math.max(span, 1e-3) / 12)));
    (uniforms.middle.value as Vector3).set(...middle);
    uniforms.cell.value = cell;
    uniforms.reach.value = Math.min(1.3 * span, (kHalf - 10) * cell);
  }

  setPalette(palette: Palette): void {
    setColour(this.lines.material.uniforms.ink, palette.grid);
  }
}

/** Lines in pieces, so that each piece fades by its ends. */
function gridLines(): Float32Array {
  const out: number[] = [];
  for (let i = -kHalf; i <= kHalf; ++i) {
    const tenth = i % 10 === 0 ? 1 : 0;
    for (let j = -kHalf; j < kHalf; j += kPart) {
      out.push(i, j, tenth, i, j + kPart, tenth, j, i, tenth, j + kPart, i, tenth);
    }
  }
  return Float32Array.from(out);
}
