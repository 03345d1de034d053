// The page: a bar, three columns, one line at the foot.

import { AppDialogs } from './dialogs/dialogs';
import { RecoverBar } from './dialogs/recover_bar';
import { LeftSide } from './left/left_side';
import { Middle } from './middle/middle';
import { RightSide } from './right/right_side';
import { TopBar } from './top/top_bar';
import { VerdictBar } from './verdict/verdict_bar';

export function App() {
  return (
    <div class="app">
      <div class="frame">
        <div>
          <TopBar />
          <RecoverBar />
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
