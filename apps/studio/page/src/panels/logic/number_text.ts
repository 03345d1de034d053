// Numbers as people read them.

/** With so many digits after the point, and no negative nothing. */
export function fixed(value: number, digits: number): string {
  if (!Number.isFinite(value)) return '–';
  const text = value.toFixed(digits);
  return Number(text) === 0 ? (0).toFixed(digits) : text.replace('-', '−');
}

const superscripts: Readonly<Record<string, string>> = {
  '-': '⁻', '0': '⁰', '1': '¹', '2': '²', '3': '³', '4': '⁴', '5': '⁵', '6': '⁶', '7': '⁷', '8': '⁸', '9': '⁹',
};

/** With three digits that count; powers of ten where the number is very large or small: "3 × 10⁻⁷". */
export function short(value: number, digits = 3): string {
  if (!Number.isFinite(value)) return '–';
  if (value === 0) return '0';
  const size = Math.abs(value);
  if (size >= 1e-3 && size < 1e5) {
    const after = Math.max(0, digits - 1 - Math.floor(Math.log10(size)));
    return Number(value.toFixed(Math.min(after, 6))).toString().replace('-', '−');
  }
  const power = Math.floor(Math.log10(size));
  const mantissa = Number((value / 10 ** power).toPrecision(Math.min(2, digits)));
  const raised = [...String(power)].map((c) => superscripts[c] ?? c).join('');
  return `${String(mantissa).replace('-', '−')} × 10${raised}`;
}

/** With its unit; a stretch or a plain number has none. */
export function withUnit(value: number, unit: string, digits?: number): string {
  const number = digits === undefined ? short(value) : fixed(value, digits);
  if (unit === '' || unit === '1') return number;
  return unit === '°' ? `${number}°` : `${number}\u00a0${unit}`;
}

/** "1 warning", "3 warnings". */
export function counted(count: number, one: string, many = `${one}s`): string {
  return `${count} ${count === 1 ? one : many}`;
}

/** "62 ms", "2.4 s". */
export function durationText(milliseconds: number): string {
  return milliseconds < 1000 ? `${short(milliseconds, 2)} ms` : `${short(milliseconds / 1000, 2)} s`;
}

/** The size of a file. */
export function bytesText(bytes: number): string {
  if (bytes < 1000) return `${bytes} B`;
  if (bytes < 1e6) return `${fixed(bytes / 1e3, bytes < 1e4 ? 1 : 0)} kB`;
  return `${fixed(bytes / 1e6, bytes < 1e7 ? 1 : 0)} MB`;
}

/** How long ago, for people. */
export function agoText(seconds: number): string {
  if (seconds < 45) return 'just now';
  if (seconds < 5400) return `${counted(Math.max(1, Math.round(seconds / 60)), 'minute')} ago`;
  if (seconds < 129600) return `${counted(Math.round(seconds / 3600), 'hour')} ago`;
  return `${counted(Math.round(seconds / 86400), 'day')} ago`;
}

/** Time of day, or the date where it was another day; both s since 1970. */
export function whenText(seconds: number, now: number): string {
  const when = new Date(1000 * seconds);
  const sameDay = when.toDateString() === new Date(1000 * now).toDateString();
  const two = (n: number) => String(n).padStart(2, '0');
  if (sameDay) return `${two(when.getHours())}:${two(when.getMinutes())}`;
  return `${when.getFullYear()}-${two(when.getMonth() + 1)}-${two(when.getDate())}`;
}
