// Small things of constant size on the screen: control points as discs, pins as pyramids, what is held still as cubes.

import { BufferAttribute, InstancedBufferGeometry, Mesh, type RawShaderMaterial } from 'three';
import type { Colour } from '../core/colours';
import { everywhere } from './everywhere';
import { resize, writing } from './instances';
import { kLight, material } from './shading';

const kVertex = /* glsl */ `
uniform float pixel;      // size of a pixel at distance 1 (orthographic: at any distance), mm
uniform float facing;     // 1: lies in the plane of the screen
in vec3 position;
in vec3 normal;
in vec3 place;
in vec4 paint;
in float size;            // pixels
out vec4 painted;
out vec3 seenNormal;
void main() {
  vec4 middle = modelViewMatrix * vec4(place, 1.0);
  float depth = projectionMatrix[3][3] == 1.0 ? 1.0 : -middle.z;
  float grow = size * pixel * depth;
  vec3 local = facing > 0.5 ? position : mat3(modelViewMatrix) * position;
  seenNormal = facing > 0.5 ? vec3(0.0, 0.0, 1.0) : mat3(modelViewMatrix) * normal;
  vec4 seen = vec4(middle.xyz + grow * local, 1.0);
  seen.xyz *= 0.996;
  painted = paint;
  gl_Position = projectionMatrix * seen;
}
`;

const kFragment = /* glsl */ `
uniform float facing;
in vec4 painted;
in vec3 seenNormal;
${kLight}
void main() {
  float light = facing > 0.5 ? 1.0 : lit(normalize(seenNormal));
  colour = vec4(painted.rgb * light, painted.a);
}
`;

export interface Marker {
  place: ArrayLike<number>;
  colour: Colour;
  /** Pixels across. */
  size: number;
}

type Shape = 'disc' | 'pyramid' | 'cube';

export class Markers {
  readonly mesh: Mesh<InstancedBufferGeometry, RawShaderMaterial>;

  constructor(
    private readonly shape: Shape,
    options: { depthTest?: boolean; order?: number } = {},
  ) {
    const uniforms = { pixel: { value: 1 }, facing: { value: shape === 'disc' ? 1 : 0 } };
    this.mesh = new Mesh(geometryOf(shape), material(kVertex, kFragment, uniforms, { depthTest: options.depthTest ?? true }));
    this.mesh.frustumCulled = false;
    this.mesh.renderOrder = options.order ?? 0;
    this.mesh.visible = false;
  }

  setPixel(pixel: number): void {
    this.mesh.material.uniforms.pixel.value = pixel;
  }

  set(markers: readonly Marker[]): void {
    const n = markers.length;
    this.mesh.visible = n > 0;
    if (n === 0) return;
    resize(this.mesh, n, () => geometryOf(this.shape), { place: 3, paint: 4, size: 1 });
    const [place, paint, size] = ['place', 'paint', 'size'].map((name) => writing(this.mesh, name));
    markers.forEach((marker, i) => {
      place.set([marker.place[0], marker.place[1], marker.place[2]], 3 * i);
      paint.set([marker.colour[0] / 255, marker.colour[1] / 255, marker.colour[2] / 255, 1], 4 * i);
      size[i] = marker.size;
    });
  }
}

/** Shapes of size 1; the pyramid has its tip at the origin. */
function geometryOf(shape: Shape): InstancedBufferGeometry {
  if (shape === 'disc') return fan(16, 0.5, 0, 0);
  if (shape === 'pyramid') return fan(4, 0.5, -1, 0);
  return cube();
}

/** Triangles from a ring at height `low` to a tip at height `tip` and back over the ring's own middle. */
function fan(sides: number, radius: number, low: number, tip: number): InstancedBufferGeometry {
  const places: number[] = [];
  const normals: number[] = [];
  for (let k = 0; k < sides; ++k) {
    const a = (2 * Math.PI * k) / sides;
    const b = (2 * Math.PI * (k + 1)) / sides;
    const m = (a + b) / 2;
    const rim = [radius * Math.cos(a), radius * Math.sin(a), low, radius * Math.cos(b), radius * Math.sin(b), low];
    places.push(...rim, 0, 0, tip);
    const rise = tip > low ? radius / (tip - low) : 1;
    const length = Math.hypot(1, rise);
    for (let i = 0; i < 3; ++i) normals.push(Math.cos(m) / length, Math.sin(m) / length, rise / length);
    if (tip === low) continue;
    places.push(...rim, 0, 0, low);
    for (let i = 0; i < 3; ++i) normals.push(0, 0, -1);
  }
  return built(places, normals);
}

function cube(): InstancedBufferGeometry {
  const places: number[] = [];
  const normals: number[] = [];
  for (let axis = 0; axis < 3; ++axis) {
    for (const sign of [-1, 1]) {
      const corner = (u: number, v: number) => {
        const p = [0, 0, 0];
        p[axis] = sign * 0.4;
        p[(axis + 1) % 3] = u * 0.4;
        p[(axis + 2) % 3] = v * 0.4;
        return p;
      };
      places.push(...corner(-1, -1), ...corner(1, -1), ...corner(1, 1), ...corner(-1, -1), ...corner(1, 1), ...corner(-1, 1));
      const n = [0, 0, 0];
      n[axis] = sign;
      for (let i = 0; i < 6; ++i) normals.push(...n);
    }
  }
  return built(places, normals);
}

function built(places: number[], normals: number[]): InstancedBufferGeometry {
  const geometry = everywhere(new InstancedBufferGeometry());
  geometry.setAttribute('position', new BufferAttribute(Float32Array.from(places), 3));
  geometry.setAttribute('normal', new BufferAttribute(Float32Array.from(normals), 3));
  return geometry;
}
