// The page: a bar, three columns, one line at the foot.

import { useEffect, useRef } from 'preact/hooks';
import { AppDialogs } from './dialogs/dialogs';
import { GuideBar } from './dialogs/guide_bar';
import { RecoverBar } from './dialogs/recover_bar';
import { watchWidth } from './layout_state';
import { LeftSide } from './left/left_side';
import { Middle } from './middle/middle';
import { RightSide } from './right/right_side';
import { TopBar } from './top/top_bar';
import { VerdictBar } from './verdict/verdict_bar';

export function App() {
  const page = useRef<HTMLDivElement>(null);
  useEffect(() => (page.current ? watchWidth(page.current) : undefined), []);
  return (
    <div ref={page} class="app">
      <div class="frame">
        <div>
          <TopBar />
          <RecoverBar />
          <GuideBar />
        </div>
        <div class="columns">
          <LeftSide />
          <Middle />
          <RightSide />
        </div>
        <VerdictBar />
      </div>
      <AppDialogs />
    </div>
  );
}
