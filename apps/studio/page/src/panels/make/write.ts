// Writing files into the folder of the studio, and saying what was written.

import { signal } from '@preact/signals';
import { announce } from '../../core/commands';
import { send } from '../../core/connection';
import { fault, project } from '../../core/store';
import { fileStem } from '../logic/file_names';
import { bytesText } from '../logic/number_text';
import { takePicture } from './picture';

/** What was written last, as a sentence. */
export const written = signal('');

/** Name of the design without folder and ending: what files are called after. */
export function designStem(): string {
  return fileStem(project.value?.file || project.value?.name || 'design');
}

export function pictureFile(legends: boolean): string {
  return legends ? `${designStem()}.png` : `${designStem()}-plain.png`;
}

/** The file that is being written; '': none. */
export const writing = signal('');

export async function writeExport(format: string): Promise<void> {
  writing.value = `${designStem()}.${format}`;
  const answer = await send({ do: 'export', format });
  writing.value = '';
  if (answer.ok) say(String(answer.file), Number(answer.bytes));
}

export async function writePicture(legends: boolean): Promise<void> {
  const file = pictureFile(legends);
  writing.value = file;
  const png_base64 = await takePicture(legends);
  if (png_base64 === null) {
    writing.value = '';
    fault.value = {
      code: 'no_picture',
      where: '',
      message: 'There is no picture to write: the shape is not on screen.',
      hint: 'Place the plan below or beside the shape.',
    };
    return;
  }
  const answer = await send({ do: 'picture', file, png_base64 });
  writing.value = '';
  if (answer.ok) say(file, Math.round((png_base64.length * 3) / 4));
}

function say(file: string, bytes: number): void {
  written.value = `Written: ${file}, ${bytesText(bytes)}.`;
  announce(written.value);
}
