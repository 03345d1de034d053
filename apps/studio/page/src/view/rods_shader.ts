// Rods as elliptic tubes. The state of a slot is two texels: place and value, material axis n. The ring at a slot lies
// square to the mean of its two edges, with half axes r_n along n and r_b along t x n.

import { kLight } from './shading';

export const rodVertex = /* glsl */ `
uniform sampler2D state;
uniform sampler2D radii;
uniform sampler2D marks;
uniform int columns;
uniform float sides;
uniform float pixel;      // size of a pixel at distance 1 (orthographic: at any distance), mm
uniform float leastPixels;
in vec4 corner;           // slot, slot before, slot after, side + 64 * cap
out vec3 normal;
out vec3 toEye;
out float value;
out vec4 mark;

ivec2 texel(int i) { return ivec2(i % columns, i / columns); }
vec4 stateAt(int slot, int part) { return texelFetch(state, texel(2 * slot + part), 0); }

void main() {
  int slot = int(corner.x);
  int cap = int(corner.w) / 64;
  float side = corner.w - 64.0 * float(cap);
  vec4 place = stateAt(slot, 0);
  vec3 t = normalize(stateAt(int(corner.z), 0).xyz - stateAt(int(corner.y), 0).xyz);
  vec3 n = stateAt(slot, 1).xyz;
  n = normalize(n - t * dot(n, t));
  vec3 b = cross(t, n);
  vec2 r = texelFetch(radii, texel(slot), 0).xy;
  vec4 middle = modelViewMatrix * vec4(place.xyz, 1.0);
  float depth = projectionMatrix[3][3] == 1.0 ? 1.0 : -middle.z;
  // Thin rods stay visible from afar: no thinner than some pixels, in the same proportion.
  r *= max(1.0, leastPixels * pixel * depth / max(r.x, r.y));
  r = max(r, vec2(0.35 * pixel * depth));
  float angle = 6.2831853 * side / sides;
  vec2 e = vec2(cos(angle), sin(angle));
  vec3 offset = cap > 2 ? vec3(0.0) : r.x * e.x * n + r.y * e.y * b;
  vec3 outward = cap == 0 ? e.x / r.x * n + e.y / r.y * b : (cap % 2 == 1 ? -t : t);
  vec4 seen = modelViewMatrix * vec4(place.xyz + offset, 1.0);
  normal = mat3(modelViewMatrix) * outward;
  toEye = projectionMatrix[3][3] == 1.0 ? vec3(0.0, 0.0, 1.0) : -seen.xyz;
  value = place.w;
  mark = texelFetch(marks, texel(slot), 0);
  gl_Position = projectionMatrix * seen;
}
`;

export const rodFragment = /* glsl */ `
uniform sampler2D table;
uniform vec2 range;       // low, 1 / (high - low)
uniform float coloured;
uniform float faded;
uniform vec3 base;
uniform vec3 ground;
uniform vec3 selectColour;
uniform vec3 hoverColour;
uniform vec3 warnColour;
in vec3 normal;
in vec3 toEye;
in float value;
in vec4 mark;             // selected, hovered, soft weight, among the worst
${kLight}
void main() {
  vec3 n = normalize(normal);
  vec3 c = base;
  if (coloured > 0.5) {
    float share = (value - range.x) * range.y;
    c = hatched(coloured, share) * texture(table, vec2(clamp(share, 0.0, 1.0), 0.5)).rgb;
  }
  c = mix(c, selectColour, max(mark.x, mark.z * 0.85));
  c = mix(c, warnColour, mark.w);
  c = mix(c, hoverColour, mark.y * 0.8);
  vec3 shaded = c * lit(n) + 0.20 * glint(n, normalize(toEye), 40.0);
  colour = vec4(mix(shaded, ground, faded), 1.0);
}
`;
