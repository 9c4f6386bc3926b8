#!/usr/bin/env python3
"""The guide tells the truth: every block of JSON is a part of the example that its section shows, every example is shown, every link leads somewhere."""
import json
import pathlib
import re
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]
GUIDE = ROOT / "scene/formats/GUIDE.md"


def is_part(part, whole):
    """Objects may leave out members, arrays of objects elements; all else is the same."""
    if isinstance(part, dict) and isinstance(whole, dict):
        return all(key in whole and is_part(value, whole[key]) for key, value in part.items())
    if isinstance(part, list) and isinstance(whole, list) and all(isinstance(one, dict) for one in part):
        rest = iter(whole)
        return all(any(is_part(one, other) for other in rest) for one in part)
    return part == whole


def check_section(title, text):
    """Problems of one section, and the examples that it links to."""
    linked = re.findall(r"\(\.\./examples/([\w.]+)\)", text)
    scenes = [json.loads((ROOT / "scene/examples" / name).read_text()) for name in linked if name.endswith(".json")]
    problems = []
    for block in re.findall(r"```json\n(.*?)```", text, re.DOTALL):
        try:
            part = json.loads("{" + block + "}")
        except json.JSONDecodeError as error:
            problems.append(f"{title}: not JSON: {error}: {block}")
            continue
        if not any(is_part(part, scene) for scene in scenes):
            problems.append(f"{title}: not a part of {linked}: {block}")
    return problems, linked


def main():
    text = GUIDE.read_text()
    problems, shown = [], set()
    for section in re.split(r"^## ", text, flags=re.MULTILINE)[1:]:
        title, _, body = section.partition("\n")
        found, linked = check_section(title, body)
        problems += found
        shown.update(linked)
    for target in re.findall(r"\]\(([^)#]+)\)", text):
        if not (GUIDE.parent / target).exists():
            problems.append(f"there is no {target}")
    examples = {path.name for path in (ROOT / "scene/examples").iterdir() if path.suffix in (".json", ".nff")}
    problems += [f"the guide does not show {name}" for name in sorted(examples - shown)]
    print("\n".join(problems + [f"{len(shown)} examples, {len(problems)} problems"]))
    return 1 if problems or not shown else 0


if __name__ == "__main__":
    sys.exit(main())
