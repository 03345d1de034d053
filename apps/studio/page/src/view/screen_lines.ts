// Lines of a width in pixels: each segment is a quad that the vertex shader opens on the screen (WebGL's
// own lines are one pixel wide everywhere).

import { BufferAttribute, InstancedBufferGeometry, Mesh, Vector2, type RawShaderMaterial } from 'three';
import type { Colour } from '../core/colours';
import { everywhere } from './everywhere';
import { resize, writing } from './instances';
import { material } from './shading';

const kVertex = /* glsl */ `
uniform vec2 screen;      // pixels
uniform float lift;       // towards the eye, parts of the depth
in vec2 position;         // along 0..1, across -1..1
in vec3 from;
in vec3 to;
in vec4 paint;
in float width;           // pixels
out vec4 painted;
void main() {
  vec4 a = modelViewMatrix * vec4(from, 1.0);
  vec4 b = modelViewMatrix * vec4(to, 1.0);
  a.xyz *= 1.0 - lift;
  b.xyz *= 1.0 - lift;
  vec4 ca = projectionMatrix * a;
  vec4 cb = projectionMatrix * b;
  vec2 pa = ca.xy / ca.w * screen * 0.5;
  vec2 pb = cb.xy / cb.w * screen * 0.5;
  vec2 d = pb - pa;
  float length_ = max(length(d), 1e-4);
  vec2 side = vec2(-d.y, d.x) / length_;
  vec4 c = mix(ca, cb, position.x);
  c.xy += side * position.y * width / screen * c.w;
  painted = paint;
  gl_Position = c;
}
`;

const kFragment = /* glsl */ `
in vec4 painted;
void main() { colour = painted; }
`;

export interface Stroke {
  from: ArrayLike<number>;
  to: ArrayLike<number>;
  colour: Colour;
  alpha?: number;
  width?: number;
}

export class ScreenLines {
  readonly mesh: Mesh<InstancedBufferGeometry, RawShaderMaterial>;

  constructor(options: { depthTest?: boolean; lift?: number; order?: number } = {}) {
    const uniforms = {
      screen: { value: new Vector2(1, 1) },
      lift: { value: options.lift ?? 0.002 },
    };
    const paint = material(kVertex, kFragment, uniforms, {
      transparent: true,
      depthWrite: false,
      depthTest: options.depthTest ?? true,
    });
    this.mesh = new Mesh(quad(), paint);
    this.mesh.frustumCulled = false;
    this.mesh.renderOrder = options.order ?? 3;
    this.mesh.visible = false;
  }

  setScreen(width: number, height: number): void {
    (this.mesh.material.uniforms.screen.value as Vector2).set(width, height);
  }

  set(strokes: readonly Stroke[]): void {
    const n = strokes.length;
    this.mesh.visible = n > 0;
    if (n === 0) return;
    resize(this.mesh, n, quad, { from: 3, to: 3, paint: 4, width: 1 });
    const [from, to, paint, width] = ['from', 'to', 'paint', 'width'].map((name) => writing(this.mesh, name));
    strokes.forEach((stroke, i) => {
      from.set([stroke.from[0], stroke.from[1], stroke.from[2]], 3 * i);
      to.set([stroke.to[0], stroke.to[1], stroke.to[2]], 3 * i);
      paint.set([stroke.colour[0] / 255, stroke.colour[1] / 255, stroke.colour[2] / 255, stroke.alpha ?? 1], 4 * i);
      width[i] = stroke.width ?? 1.5;
    });
  }
}

function quad(): InstancedBufferGeometry {
  const geometry = everywhere(new InstancedBufferGeometry());
  geometry.setAttribute('position', new BufferAttribute(Float32Array.of(0, -1, 1, -1, 1, 1, 0, 1), 2));
  geometry.setIndex([0, 1, 2, 0, 2, 3]);
  return geometry;
}
