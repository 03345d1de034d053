// What the materials of the view have in common: raw GLSL 3 (no colour conversion, so that legends and picture show the
// same colours), one key light that goes with the camera and a hemisphere.

import { DoubleSide, GLSL3, RawShaderMaterial, Vector3, type IUniform, type Side } from 'three';
import type { Colour } from '../core/colours';

export const kHead = /* glsl */ `
precision highp float;
precision highp int;
precision highp sampler2D;
uniform mat4 modelViewMatrix;
uniform mat4 projectionMatrix;
`;

export const kFragmentHead = /* glsl */ `
precision highp float;
precision highp int;
precision highp sampler2D;
out vec4 colour;
`;

/** Light in the space of the camera: from the upper left, a little behind the viewer. */
export const kLight = /* glsl */ `
const vec3 kKey = vec3(-0.38, 0.62, 0.69);
float lit(vec3 n) {
  float key = max(dot(n, kKey), 0.0);
  float wrap = 0.5 + 0.5 * dot(n, kKey);
  return 0.58 + 0.17 * wrap + 0.30 * key;
}
float glint(vec3 n, vec3 toEye, float power) {
  return pow(max(dot(n, normalize(kKey + toEye)), 0.0), power);
}
// Beyond a locked range (coloured: 2) there are no colours: hatched. share: 0 to 1 within it.
float hatched(float coloured, float share) {
  bool within = coloured < 1.5 || (share > -0.002 && share < 1.002);
  return within || mod(gl_FragCoord.x + gl_FragCoord.y, 7.0) < 4.5 ? 1.0 : 0.5;
}
`;

export type Uniforms = Record<string, IUniform>;

export function vec(colour: Colour): Vector3 {
  return new Vector3(colour[0] / 255, colour[1] / 255, colour[2] / 255);
}

export function setColour(uniform: IUniform, colour: Colour): void {
  (uniform.value as Vector3).set(colour[0] / 255, colour[1] / 255, colour[2] / 255);
}

export function material(
  vertexShader: string,
  fragmentShader: string,
  uniforms: Uniforms,
  options: { transparent?: boolean; depthTest?: boolean; depthWrite?: boolean; side?: Side } = {},
): RawShaderMaterial {
  return new RawShaderMaterial({
    glslVersion: GLSL3,
    vertexShader: kHead + vertexShader,
    fragmentShader: kFragmentHead + fragmentShader,
    uniforms,
    side: DoubleSide,
    ...options,
  });
}
