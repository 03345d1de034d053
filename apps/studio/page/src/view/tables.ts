// Both colour maps as small lookup textures.

import { ClampToEdgeWrapping, DataTexture, LinearFilter, RGBAFormat, UnsignedByteType } from 'three';
import { colourTable } from '../core/colours';

const kSteps = 256;

export interface ColourTables {
  diverging: DataTexture;
  sequential: DataTexture;
}

function table(diverging: boolean): DataTexture {
  const made = new DataTexture(colourTable(diverging, kSteps) as never, kSteps, 1, RGBAFormat, UnsignedByteType);
  made.minFilter = made.magFilter = LinearFilter;
  made.wrapS = made.wrapT = ClampToEdgeWrapping;
  made.needsUpdate = true;
  return made;
}

export function colourTables(): ColourTables {
  return { diverging: table(true), sequential: table(false) };
}
