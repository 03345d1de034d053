// The right column: what the mode of work is about, and what is selected.

import { Fragment } from 'preact';
import { selection, workMode } from '../../core/store';
import { sideShown } from '../layout_state';
import { counted } from '../logic/number_text';
import { Section } from '../parts/section';
import { ConstraintsSection } from './constraints_section';
import { ExplorePanel } from './explore_panel';
import { FabricSection } from './fabric_section';
import { MakePanel } from './make_panel';
import { PointsSection } from './points_section';
import { AllRodsSection, MeasuresSection, ProjectSection } from './project_section';
import { RodsSection } from './rods_section';
import { KeepAsSet } from './set_section';
import { ShapePanel } from './shape_panel';

export function RightSide() {
  if (!sideShown('inspector')) return null;
  return (
    <aside class="side right" aria-label="Inspector">
      <div id="inspector" class="side-body" role="tabpanel" aria-labelledby={`tab-${workMode.value}`} tabIndex={-1}>
        <Fragment key={workMode.value}>
          <Panels />
        </Fragment>
      </div>
    </aside>
  );
}

function Panels() {
  switch (workMode.value) {
    case 'explore':
      return (
        <>
          <ExplorePanel />
          <ConstraintsSection />
          <Selected />
        </>
      );
    case 'shape':
      return (
        <>
          <ShapePanel />
          <ConstraintsSection open={false} />
          <Selected />
        </>
      );
    case 'make':
      return (
        <>
          <MakePanel />
          <MeasuresSection />
        </>
      );
    case 'draw':
      return (
        <>
          <Selected />
          <FabricSection />
          <AllRodsSection />
          <ProjectSection />
          <MeasuresSection />
          <ConstraintsSection open={false} />
        </>
      );
  }
}

/** What is selected; nothing where that is nothing. */
function Selected() {
  const { nodes } = selection.value;
  return (
    <>
      <PointsSection />
      <RodsSection />
      <KeepAsSet />
      {nodes.size > 0 && (
        <Section title={counted(nodes.size, 'place', 'places')}>
          <p class="soft">Places of the shape, for a handle: change to Shape and pull them.</p>
        </Section>
      )}
    </>
  );
}
