// Names and values in two columns.

export function Facts({ of }: { of: ReadonlyArray<readonly [string, string]> }) {
  return (
    <dl class="facts">
      {of.map(([name, value]) => (
        <div key={name} class="fact">
          <dt>{name}</dt>
          <dd>{value}</dd>
        </div>
      ))}
    </dl>
  );
}
