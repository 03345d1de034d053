// Names of files.

/** Without folder and ending. */
export function fileStem(file: string): string {
  const name = file.slice(file.lastIndexOf('/') + 1);
  return name.replace(/\.(lissom|json|svg|dxf|obj|png|stl)$/i, '') || 'design';
}

/** With the ending of documents where it has none. */
export function documentName(typed: string): string {
  const name = typed.trim();
  return /\.lissom$/i.test(name) || name === '' ? name : `${name}.lissom`;
}
