// Other stable shapes of the same design: small pictures, a click flips the structure to that shape.

import { computed } from '@preact/signals';
import { useMemo } from 'preact/hooks';
import { announce } from '../../core/commands';
import { send } from '../../core/connection';
import type { BranchesPack, TopologyPack } from '../../core/protocol';
import { branches, branchShapes, history, shownBranch, topology } from '../../core/store';
import { fixed } from '../logic/number_text';
import { picture, type Line } from '../logic/projection';

/** Rods of a mesh as lines of nodes. */
function rodLines(mesh: TopologyPack): Line[] {
  return Array.from({ length: mesh.rod_starts.length - 1 }, (_, r) => {
    const nodes = [...mesh.rod_nodes.subarray(mesh.rod_starts[r], mesh.rod_starts[r + 1])];
    return { nodes: mesh.rods[r]?.closed && nodes.length > 0 ? [...nodes, nodes[0]] : nodes };
  });
}

/** Number of steps when the shapes were found; another design has other shapes. */
const foundAt = computed(() => (branches.value ? (history.peek()?.at ?? 0) : -1));

export function BranchStrip() {
  const current = foundAt.value === (history.value?.at ?? 0);
  const found = current ? (branches.value?.branches ?? []) : [];
  const shapes = branchShapes.value;
  const mesh = topology.value;
  if (found.length < 2) return null;
  const take = async (k: number) => {
    const answer = await send({ do: 'branch_take', branch: k });
    if (answer.ok) announce('Flipped to the other shape.');
  };
  return (
    <section class="branches" aria-label="Stable shapes">
      <p class="small soft">{found.length} stable shapes: a click flips to one</p>
      <ul class="branch-list">
        {found.map((branch, k) => (
          <li key={k}>
            <button
              type="button"
              class="branch"
              aria-pressed={branch.present}
              disabled={branch.present}
              title={branch.sentence}
              onPointerEnter={() => (shownBranch.value = branch.present ? -1 : k)}
              onPointerLeave={() => (shownBranch.value = -1)}
              onFocus={() => (shownBranch.value = k)}
              onBlur={() => (shownBranch.value = -1)}
              onClick={() => void take(k)}
            >
              {shapes && mesh && shapes.topology === mesh.topology && <Thumbnail of={shapes} mesh={mesh} branch={k} />}
              <span class="small">
                {branch.present ? 'Present shape' : `Shape ${k + 1}`}
                <br />
                {fixed(branch.energy_mj, 2)} mJ, {fixed(branch.height_mm, 1)} mm high
              </span>
            </button>
          </li>
        ))}
      </ul>
    </section>
  );
}

function Thumbnail({ of, mesh, branch }: { of: BranchesPack; mesh: TopologyPack; branch: number }) {
  const drawn = useMemo(() => {
    const nodes = mesh.plan_places.length / 2;
    return picture(of.positions, rodLines(mesh), branch * nodes, 2);
  }, [of, mesh, branch]);
  return (
    <svg class="thumbnail" viewBox={drawn.viewBox} aria-hidden="true">
      <path d={drawn.path} />
    </svg>
  );
}
