// Attributes of instances, written anew each time and made anew only when their number changes.

import { InstancedBufferAttribute, type InstancedBufferGeometry, type Mesh } from 'three';

/** Makes room for `n` instances: another geometry when the number is another one. */
export function resize(mesh: Mesh<InstancedBufferGeometry>, n: number, make: () => InstancedBufferGeometry, columns: Record<string, number>): void {
  if (mesh.geometry.instanceCount === n) return;
  mesh.geometry.dispose();
  const geometry = make();
  geometry.instanceCount = n;
  for (const [name, width] of Object.entries(columns)) {
    geometry.setAttribute(name, new InstancedBufferAttribute(new Float32Array(width * n), width));
  }
  mesh.geometry = geometry;
}

/** The array behind an attribute, to be written now. */
export function writing(mesh: Mesh<InstancedBufferGeometry>, name: string): Float32Array {
  const attribute = mesh.geometry.getAttribute(name) as InstancedBufferAttribute;
  attribute.needsUpdate = true;
  return attribute.array as Float32Array;
}
