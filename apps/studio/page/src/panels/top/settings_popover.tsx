// Look, navigation and speed: kept in the browser.

import {
  navigation,
  quality,
  rendererName,
  softwareRenderer,
  theme,
  uiScale,
  type NavigationPreset,
  type Quality,
  type Theme,
} from '../../core/store';
import { Choice } from '../parts/choice';
import { Icon } from '../parts/icon';
import { Popover } from '../parts/popover';

const themes: ReadonlyArray<{ value: Theme; title: string }> = [
  { value: 'system', title: 'System' },
  { value: 'light', title: 'Light' },
  { value: 'dark', title: 'Dark' },
];

const presets: ReadonlyArray<{ value: NavigationPreset; title: string; help: string }> = [
  { value: 'rhino', title: 'Rhino', help: 'Right button turns, Shift and right button moves, wheel zooms.' },
  { value: 'blender', title: 'Blender', help: 'Middle button turns, Shift and middle button moves, wheel zooms.' },
  { value: 'cad', title: 'CAD', help: 'Middle button turns, Ctrl and middle button moves, wheel zooms.' },
  { value: 'trackpad', title: 'Trackpad', help: 'Two fingers turn, Shift and two fingers move, a pinch zooms.' },
];

const qualities: ReadonlyArray<{ value: Quality; title: string }> = [
  { value: 'auto', title: 'As the machine allows' },
  { value: 'high', title: 'Fine' },
  { value: 'low', title: 'Fast' },
];

export function SettingsPopover() {
  return (
    <Popover role="dialog" label="Look and navigation" icon="settings">
      {() => (
        <div class="stack">
          <fieldset class="radios">
            <legend>Theme</legend>
            {themes.map(({ value, title }) => (
              <label key={value} class="switch">
                <input type="radio" name="theme" checked={theme.value === value} onChange={() => (theme.value = value)} />
                <Icon name={value} />
                {title}
              </label>
            ))}
          </fieldset>
          <Choice
            label="Size of the interface"
            value={String(uiScale.value)}
            options={[1, 1.25, 1.5, 1.75, 2].map((s) => ({ value: String(s), title: `${100 * s} %` }))}
            onChoose={(value) => (uiScale.value = Number(value))}
          />
          <Choice label="Navigation like" value={navigation.value} options={presets} onChoose={(value) => (navigation.value = value)} />
          <p class="small soft">{presets.find((p) => p.value === navigation.value)?.help}</p>
          <Choice label="Drawing" value={quality.value} options={qualities} onChoose={(value) => (quality.value = value)} />
          <p class="small soft">
            {softwareRenderer.value ? 'Drawn without a graphics card' : 'Drawn by the graphics card'}
            {rendererName.value && `: ${rendererName.value}`}.
          </p>
        </div>
      )}
    </Popover>
  );
}
