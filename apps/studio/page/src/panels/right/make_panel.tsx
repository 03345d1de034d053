// Make it: what has to be right first, pictures, and the files to make it from.

import { useMemo } from 'preact/hooks';
import { measures, plan, project, verdict, warnings } from '../../core/store';
import { preflight, preflightSummary, type Check } from '../logic/preflight';
import { Icon, type IconName } from '../parts/icon';
import { Section } from '../parts/section';
import { Button } from '../parts/button';
import { dirty, save } from '../files';
import { WarningActions } from '../verdict/warning_list';
import { dialog } from '../../core/store';
import { ExportSection } from './export_section';
import { PictureSection } from './picture_section';

const marks: Readonly<Record<Check['state'], { icon: IconName; word: string }>> = {
  ready: { icon: 'ready', word: 'Ready' },
  look: { icon: 'warning', word: 'Worth a look' },
  stop: { icon: 'trouble', word: 'Has to be put right' },
};

export function MakePanel() {
  const facts = {
    verdict: verdict.value,
    warnings: warnings.value,
    measures: measures.value,
    plan: plan.value,
    saved: !dirty.value && project.value?.file !== '',
  };
  const checks = useMemo(() => preflight(facts), Object.values(facts));
  return (
    <>
      <Section title="Before you make it" aside={`${checks.filter((c) => c.state === 'ready').length} of ${checks.length}`}>
        <p>{preflightSummary(checks)}</p>
        <ul class="checks">
          {checks.map((check) => (
            <li key={check.key} class="check" data-state={check.state}>
              <span role="img" aria-label={marks[check.state].word} title={marks[check.state].word}>
                <Icon name={marks[check.state].icon} />
              </span>
              <div class="stack">
                <strong>{check.title}</strong>
                <p>{check.text}</p>
                <CheckActions check={check} />
              </div>
            </li>
          ))}
        </ul>
      </Section>
      <ExportSection />
      <PictureSection />
    </>
  );
}

function CheckActions({ check }: { check: Check }) {
  if (check.state === 'ready') return null;
  if (check.key === 'saved') return <Button onClick={() => void save()}>Save</Button>;
  if (check.key === 'standing') return <Button onClick={() => (dialog.value = 'verdict')}>Say why</Button>;
  const [first] = check.warnings;
  return first === undefined ? null : <WarningActions warning={warnings.value[first]} index={first} />;
}
