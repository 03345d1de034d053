// What this is.

import { hello, rendererName } from '../../core/store';
import { Facts } from '../parts/facts';
import { closeDialog, Modal } from '../parts/modal';

export function AboutDialog() {
  return (
    <Modal title="About lissom" onClose={() => closeDialog('about')}>
      <div class="stack">
        <p>Design rods on stretched fabric: they settle while you drag.</p>
        <Facts
          of={[
            ['Version', hello.value?.version ?? 'unknown'],
            ['Folder', hello.value?.folder ?? 'unknown'],
            ['Drawn by', rendererName.value || 'unknown'],
            ['Licence', 'GPL-3.0-or-later'],
          ]}
        />
        <p class="small soft">Icons: lucide (ISC). Plots: uPlot (MIT). Drawing: three.js (MIT). Page: Preact (MIT).</p>
      </div>
    </Modal>
  );
}
