"""The published schema accepts every good document and refuses wrong ones wherever a schema can see the mistake."""
import json
import pathlib
import re
import sys

import jsonschema

ROOT = pathlib.Path(__file__).resolve().parents[2]
DOCUMENTS = ROOT / "tests" / "documents"

# Mistakes in the structure of a document. The others (names, conflicts, units, geometry) need the program.
REFUSED = """version-as-text newer-version unknown-key other-json not-an-object units-unknown-measure rods-not-a-list
number-for-name empty-name text-for-flag two-coordinates line-of-three-points fraction-of-an-edge no-edges missing-material
missing-section null-value direction-as-word unknown-hold unknown-torsion unknown-natural-shape unknown-axes-word
zero-radius-in-list poisson-ratio zero-modulus path-without-steps numerical-damping holds-nothing gravity-false
missing-tolerance no-unit-in-text decimal-comma word-for-number empty-quantity infinite-text unknown-hold-direction""".split()


def examples(path):
    return re.findall(r"```json\n(.*?)```", path.read_text(encoding="utf-8"), re.S)


def main():
    schema = json.loads((ROOT / "docs" / "guide" / "lissom.schema.json").read_text(encoding="utf-8"))
    jsonschema.Draft202012Validator.check_schema(schema)
    validator = jsonschema.Draft202012Validator(schema)
    failures = []
    good = {path.name: path.read_text(encoding="utf-8") for path in sorted((DOCUMENTS / "good").glob("*.lissom"))}
    good |= {f"guide, example {i}": text for i, text in enumerate(examples(ROOT / "docs" / "guide" / "document.md"), 1)}
    for name, text in good.items():
        for error in validator.iter_errors(json.loads(text)):
            failures.append(f"{name}: /{'/'.join(map(str, error.path))}: {error.message[:200]}")
    for name in REFUSED:
        paths = list((DOCUMENTS / "bad").glob(f"[0-9]*-{name}.lissom"))
        if len(paths) != 1:
            failures.append(f"{name}: {len(paths)} files")
        elif validator.is_valid(json.loads(paths[0].read_text(encoding="utf-8"))):
            failures.append(f"{name}: the schema accepts it")
    for failure in failures:
        print(failure)
    print(f"{len(good)} good and {len(REFUSED)} wrong documents, {len(failures)} failures")
    return 1 if failures or len(good) < 6 else 0


if __name__ == "__main__":
    sys.exit(main())
