// Fabric: soft light from both sides, more see-through where it is stretched thin and where it faces the eye, a narrow
// shine that shows wrinkles.

import { kLight } from './shading';

export const fabricVertex = /* glsl */ `
in vec3 position;
in vec3 normal;
in vec3 extra;            // thickness relative to the plan's, value, soft weight
out vec3 seenNormal;
out vec3 toEye;
out vec3 carried;
void main() {
  vec4 seen = modelViewMatrix * vec4(position, 1.0);
  seenNormal = mat3(modelViewMatrix) * normal;
  toEye = projectionMatrix[3][3] == 1.0 ? vec3(0.0, 0.0, 1.0) : -seen.xyz;
  carried = extra;
  gl_Position = projectionMatrix * seen;
}
`;

export const fabricFragment = /* glsl */ `
uniform sampler2D table;
uniform vec2 range;
uniform float coloured;
uniform float faded;
uniform float opacity;
uniform vec3 front;
uniform vec3 behind;
uniform vec3 ground;
uniform vec3 selectColour;
in vec3 seenNormal;
in vec3 toEye;
in vec3 carried;
${kLight}
void main() {
  vec3 eye = normalize(toEye);
  vec3 n = normalize(seenNormal);
  bool turned = dot(n, eye) < 0.0;
  if (turned) n = -n;
  vec3 c = turned ? behind : front;
  if (coloured > 0.5) {
    float share = (carried.y - range.x) * range.y;
    c = hatched(coloured, share) * texture(table, vec2(clamp(share, 0.0, 1.0), 0.5)).rgb;
  }
  c = mix(c, selectColour, 0.45 * carried.z);
  float grazing = 1.0 - dot(n, eye);
  vec3 shaded = c * (0.86 * lit(n) + 0.10) + 0.10 * glint(n, eye, 22.0) + 0.10 * glint(n, eye, 90.0);
  shaded *= 1.0 - 0.16 * pow(grazing, 3.0);
  float thick = clamp(carried.x, 0.25, 1.6);
  float alpha = clamp(opacity * (0.55 + 0.45 * thick) + 0.35 * grazing * grazing, 0.0, 1.0);
  if (coloured > 0.5) alpha = max(alpha, 0.94);
  colour = vec4(mix(shaded, ground, faded), alpha);
}
`;
