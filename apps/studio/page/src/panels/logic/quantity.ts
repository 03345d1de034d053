// Reads what people type into a number field: "1.2", "1,2 mm", "3 cm + 4", "2 * (1.2 + 0.3)", "110 %".

/** Units that mean the same kind of thing, each with its size. */
const families: ReadonlyArray<Readonly<Record<string, number>>> = [
  { um: 1e-6, 'µm': 1e-6, mm: 1e-3, cm: 1e-2, dm: 1e-1, m: 1, in: 0.0254, '"': 0.0254 },
  { 'mm²': 1e-6, mm2: 1e-6, 'cm²': 1e-4, cm2: 1e-4, 'm²': 1, m2: 1 },
  { '°': Math.PI / 180, deg: Math.PI / 180, rad: 1 },
  { uN: 1e-6, mN: 1e-3, N: 1, kN: 1e3 },
  { Pa: 1, kPa: 1e3, MPa: 1e6, GPa: 1e9, 'N/mm²': 1e6, 'N/mm2': 1e6 },
  { '': 1, '1': 1, '%': 0.01 },
];

export type Reading = { value: number } | { problem: string };

interface Part {
  number: number;
  /** A number with a unit, already in that of the field. */
  united: boolean;
}

class Refusal extends Error {}

/** How many of `unit` one `from` is; undefined where they do not go together. */
export function factorTo(from: string, unit: string): number | undefined {
  for (const family of families) {
    const a = family[from];
    const b = family[unit];
    if (a !== undefined && b !== undefined) return a / b;
  }
  return undefined;
}

/** The value of a text in `unit`, or what is wrong with it. */
export function readQuantity(text: string, unit: string): Reading {
  const trimmed = text.trim();
  if (trimmed === '') return { problem: unit === '' ? 'Type a number.' : `Type a number of ${unit}.` };
  try {
    const reader = new Reader(trimmed, unit);
    const value = reader.sum().number;
    reader.expectEnd();
    if (!Number.isFinite(value)) return { problem: 'This sum has no value: it divides by nothing.' };
    return { value };
  } catch (refusal) {
    if (refusal instanceof Refusal) return { problem: refusal.message };
    throw refusal;
  }
}

class Reader {
  private at = 0;

  constructor(
    private readonly text: string,
    private readonly unit: string,
  ) {}

  sum(): Part {
    let left = this.product();
    for (let sign = this.taken('+-−'); sign; sign = this.taken('+-−')) {
      const right = this.product();
      left = {
        number: sign === '+' ? left.number + right.number : left.number - right.number,
        united: left.united || right.united,
      };
    }
    return left;
  }

  expectEnd(): void {
    this.skipSpace();
    if (this.at < this.text.length) throw this.surprise();
  }

  private product(): Part {
    let left = this.factor();
    for (let sign = this.taken('*×/'); sign; sign = this.taken('*×/')) {
      const right = this.factor();
      if (left.united && right.united) throw new Refusal('Only one of the two numbers can have a unit here.');
      left = {
        number: sign === '/' ? left.number / right.number : left.number * right.number,
        united: left.united || right.united,
      };
    }
    return left;
  }

  private factor(): Part {
    if (this.taken('-−')) {
      const part = this.factor();
      return { ...part, number: -part.number };
    }
    if (this.taken('+')) return this.factor();
    if (this.taken('(')) {
      const inner = this.sum();
      if (!this.taken(')')) throw new Refusal('A closing bracket is missing.');
      return this.withUnit(inner);
    }
    this.skipSpace();
    const match = /^(\d+([.,]\d*)?|[.,]\d+)(e[+-]?\d+)?/i.exec(this.text.slice(this.at));
    if (!match) throw this.surprise();
    this.at += match[0].length;
    return this.withUnit({ number: Number(match[0].replace(',', '.')), united: false });
  }

  private withUnit(part: Part): Part {
    this.skipSpace();
    const match = /^(N\/mm[²2]|[a-zµ]+[²2]?|[°%"])/i.exec(this.text.slice(this.at));
    if (!match) return part;
    const name = match[0];
    const factor = factorTo(name, this.unit);
    if (factor === undefined) {
      throw new Refusal(this.unit === '' ? `This is a plain number, not ${name}.` : `This is in ${this.unit}, not in ${name}.`);
    }
    if (part.united) throw new Refusal(`There is a unit before ${name} already.`);
    this.at += name.length;
    return { number: part.number * factor, united: true };
  }

  /** The next character where it is one of these, now read. */
  private taken(characters: string): string | undefined {
    this.skipSpace();
    const next = this.text[this.at];
    if (next === undefined || !characters.includes(next)) return undefined;
    this.at += 1;
    return next;
  }

  private skipSpace(): void {
    while (this.text[this.at] === ' ' || this.text[this.at] === '\u00a0') this.at += 1;
  }

  private surprise(): Refusal {
    const rest = this.text.slice(this.at, this.at + 12);
    return new Refusal(rest === '' ? 'A number is missing at the end.' : `"${rest}" is not a number.`);
  }
}
