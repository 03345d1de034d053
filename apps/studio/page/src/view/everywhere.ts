// three sorts by bounding spheres, which it would compute from attributes that mean something else here. Everything is
// drawn in the order of renderOrder instead; one sphere stands for all.

import { Sphere, Vector3, type BufferGeometry } from 'three';

const kEverywhere = new Sphere(new Vector3(), 1);

export function everywhere<G extends BufferGeometry>(geometry: G): G {
  geometry.boundingSphere = kEverywhere;
  return geometry;
}
