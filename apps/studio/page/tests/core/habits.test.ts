import { beforeEach, describe, expect, test } from 'vitest';
import { command, commands, isEnabled, keyOverrides, register, run } from '../../src/core/commands';
import { chordOf, dispatch } from '../../src/core/keys';
import { clearLatencies, latencies, noteEcho, noteHandleMove, noteMove, notePreview, noteShape } from '../../src/core/latency';
import { motionOf, wheelMotion, type Press } from '../../src/core/navigation';

const press = (key: string, more = {}) => ({ key, ctrlKey: false, metaKey: false, shiftKey: false, altKey: false, ...more });

describe('keys', () => {
  let ran: string[] = [];
  beforeEach(() => {
    ran = [];
    keyOverrides.value = {};
    register(
      { id: 't.undo', title: 'Undo', group: 'Edit', keys: ['Ctrl+Z'], run: () => ran.push('undo') },
      { id: 't.never', title: 'Never', group: 'Edit', keys: ['N'], enabled: () => false, run: () => ran.push('never') },
      { id: 't.space', title: 'Space', group: 'Edit', keys: ['Space'], run: () => ran.push('space') },
    );
  });

  test('have names', () => {
    expect(chordOf(press('z', { ctrlKey: true }))).toBe('Ctrl+Z');
    expect(chordOf(press('Z', { metaKey: true, shiftKey: true }))).toBe('Ctrl+Shift+Z');
    expect(chordOf(press('?', { shiftKey: true }))).toBe('?');
    expect(chordOf(press('+', { shiftKey: true }))).toBe('Plus');
    expect(chordOf(press(' '))).toBe('Space');
    expect(chordOf(press('Delete', { shiftKey: true, altKey: true }))).toBe('Alt+Shift+Delete');
    expect(chordOf(press('Shift', { shiftKey: true }))).toBe('');
  });

  test('run what they belong to, once it is enabled', () => {
    expect(dispatch(press('z', { ctrlKey: true }), null)).toBe(true);
    expect(dispatch(press('n'), null)).toBe(false);
    expect(dispatch(press('Shift'), null)).toBe(false);
    expect(ran).toEqual(['undo']);
  });

  test('leave text fields and buttons theirs', () => {
    const field = { tagName: 'INPUT', type: 'text' };
    expect(dispatch(press(' '), field)).toBe(false);
    expect(dispatch(press('z', { ctrlKey: true }), field)).toBe(false);
    expect(dispatch(press(' '), { tagName: 'BUTTON' })).toBe(false);
    expect(dispatch(press('z', { ctrlKey: true }), { tagName: 'BUTTON' })).toBe(true);
    expect(dispatch(press(' '), { tagName: 'DIV' })).toBe(true);
  });

  test('can be given to other commands', () => {
    keyOverrides.value = { 't.undo': ['U'] };
    expect(dispatch(press('z', { ctrlKey: true }), null)).toBe(false);
    expect(dispatch(press('u'), null)).toBe(true);
  });

  test('a command registered again replaces the first', () => {
    const before = commands().length;
    register({ id: 't.undo', title: 'Undo it', group: 'Edit', run: () => ran.push('new') });
    expect(commands()).toHaveLength(before);
    expect(command('t.undo')?.title).toBe('Undo it');
    expect(run('t.undo')).toBe(true);
    expect(run('t.never')).toBe(false);
    expect(run('t.unknown')).toBe(false);
    expect(isEnabled(command('t.never') ?? commands()[0])).toBe(false);
    expect(ran).toEqual(['new']);
  });
});

describe('navigation', () => {
  const hold = (button: number, more: Partial<Press> = {}): Press => ({ button, shiftKey: false, ctrlKey: false, metaKey: false, altKey: false, ...more });

  test('the left button never moves the view', () => {
    for (const preset of ['rhino', 'blender', 'cad', 'trackpad'] as const) expect(motionOf(preset, hold(0))).toBeNull();
  });

  test('presets are as in the programs that they are named after', () => {
    expect(motionOf('rhino', hold(2))).toBe('orbit');
    expect(motionOf('rhino', hold(2, { shiftKey: true }))).toBe('pan');
    expect(motionOf('rhino', hold(2, { ctrlKey: true }))).toBe('zoom');
    expect(motionOf('blender', hold(1))).toBe('orbit');
    expect(motionOf('blender', hold(1, { shiftKey: true }))).toBe('pan');
    expect(motionOf('blender', hold(1, { ctrlKey: true }))).toBe('zoom');
    expect(motionOf('cad', hold(1))).toBe('orbit');
    expect(motionOf('cad', hold(1, { ctrlKey: true }))).toBe('pan');
    expect(motionOf('cad', hold(1, { shiftKey: true }))).toBe('zoom');
    expect(motionOf('trackpad', hold(2, { shiftKey: true }))).toBe('pan');
    expect([motionOf('rhino', hold(1)), motionOf('blender', hold(2)), motionOf('cad', hold(2)), motionOf('trackpad', hold(1))]).toEqual(['pan', 'pan', 'pan', 'orbit']);
  });

  test('the wheel zooms; two fingers turn and a pinch zooms on a trackpad', () => {
    const wheel = { deltaX: 0, deltaY: 100, deltaMode: 0, ctrlKey: false, shiftKey: false };
    expect(wheelMotion('rhino', wheel).factor).toBeGreaterThan(1.1);
    expect(wheelMotion('rhino', { ...wheel, deltaY: -100 }).factor).toBeLessThan(0.9);
    expect(wheelMotion('rhino', { ...wheel, deltaY: 5, deltaMode: 1 }).factor).toBeCloseTo(Math.exp(90 * 0.0016));
    expect(wheelMotion('trackpad', wheel)).toMatchObject({ motion: 'orbit', dy: -100 });
    expect(wheelMotion('trackpad', { ...wheel, shiftKey: true }).motion).toBe('pan');
    expect(wheelMotion('trackpad', { ...wheel, deltaY: 8, ctrlKey: true })).toMatchObject({ motion: 'zoom' });
  });
});

describe('times', () => {
  test('from the pointer to its echo, to the first shape, to the settled one', () => {
    clearLatencies();
    noteMove(100);
    noteEcho(112);
    noteMove(130);
    noteShape(150, false, false);
    noteShape(180, true, false);
    noteShape(400, true, true);
    noteShape(500, true, true);
    noteEcho(600);
    noteEcho(700);
    expect(latencies()['pointer echo']).toEqual([12, 470]);
    expect(latencies()['move to shape']).toEqual([80]);
    expect(latencies().settle).toEqual([270]);
  });

  test('of previews', () => {
    clearLatencies();
    notePreview(5);
    expect(latencies().preview).toHaveLength(0);
    noteHandleMove();
    notePreview(performance.now() + 7);
    expect(latencies().preview[0]).toBeGreaterThanOrEqual(7);
  });
});
