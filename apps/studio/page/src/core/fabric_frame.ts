// What a frame of the fabric needs beside its places: smooth normals, how thin it has become and the field's values at
// the vertices. One pass over the triangles, one over the vertices.

export class FabricFrame {
  readonly normals: Float32Array;
  /** (nodes, 3): thickness relative to the plan's, value, weight of the soft selection. */
  readonly extra: Float32Array;
  private readonly planAreas: Float32Array;
  /** Sum of the plan's areas around a vertex. */
  private readonly planSums: Float32Array;
  private readonly sums: Float32Array;

  constructor(
    private readonly triangles: Uint32Array,
    planPlaces: Float32Array,
    nodes: number,
  ) {
    this.normals = new Float32Array(3 * nodes);
    this.extra = new Float32Array(3 * nodes);
    this.planAreas = new Float32Array(triangles.length / 3);
    this.planSums = new Float32Array(nodes);
    this.sums = new Float32Array(nodes);
    for (let t = 0; t < this.planAreas.length; ++t) {
      const [a, b, c] = [triangles[3 * t], triangles[3 * t + 1], triangles[3 * t + 2]];
      const ux = planPlaces[2 * b] - planPlaces[2 * a];
      const uy = planPlaces[2 * b + 1] - planPlaces[2 * a + 1];
      const vx = planPlaces[2 * c] - planPlaces[2 * a];
      const vy = planPlaces[2 * c + 1] - planPlaces[2 * a + 1];
      const area = Math.abs(ux * vy - uy * vx);
      this.planAreas[t] = area;
      for (const v of [a, b, c]) this.planSums[v] += area;
    }
  }

  /** Values are of triangles; vertices get the mean weighted by the plan's areas. */
  update(positions: Float32Array, values: Float32Array | null): void {
    const { triangles, normals, extra, planAreas, planSums, sums } = this;
    normals.fill(0);
    sums.fill(0);
    for (let i = 1; i < extra.length; i += 3) extra[i] = 0;
    for (let t = 0, i = 0; i < triangles.length; ++t, i += 3) {
      const a = triangles[i];
      const b = triangles[i + 1];
      const c = triangles[i + 2];
      const ax = positions[3 * a];
      const ay = positions[3 * a + 1];
      const az = positions[3 * a + 2];
      const ux = positions[3 * b] - ax;
      const uy = positions[3 * b + 1] - ay;
      const uz = positions[3 * b + 2] - az;
      const vx = positions[3 * c] - ax;
      const vy = positions[3 * c + 1] - ay;
      const vz = positions[3 * c + 2] - az;
      const nx = uy * vz - uz * vy;
      const ny = uz * vx - ux * vz;
      const nz = ux * vy - uy * vx;
      const area = Math.sqrt(nx * nx + ny * ny + nz * nz);
      const value = values ? values[t] * planAreas[t] : 0;
      addTo(normals, 3 * a, nx, ny, nz);
      addTo(normals, 3 * b, nx, ny, nz);
      addTo(normals, 3 * c, nx, ny, nz);
      sums[a] += area;
      sums[b] += area;
      sums[c] += area;
      extra[3 * a + 1] += value;
      extra[3 * b + 1] += value;
      extra[3 * c + 1] += value;
    }
    for (let v = 0; v < planSums.length; ++v) {
      if (planSums[v] === 0) continue;
      extra[3 * v] = planSums[v] / Math.max(sums[v], 1e-12);
      extra[3 * v + 1] /= planSums[v];
    }
  }
}

/** Weights of the soft selection into the third column; null: none. */
export function setWeights(extra: Float32Array, weights: Float32Array | null): void {
  for (let v = 0; 3 * v < extra.length; ++v) extra[3 * v + 2] = weights ? weights[v] : 0;
}

function addTo(out: Float32Array, at: number, x: number, y: number, z: number): void {
  out[at] += x;
  out[at + 1] += y;
  out[at + 2] += z;
}
