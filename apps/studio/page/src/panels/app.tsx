import { PlanView } from '../view/plan_view';
import { Viewport } from '../view/viewport';

export function App() {
  return (
    <main class="app">
      <Viewport />
      <PlanView />
    </main>
  );
}
