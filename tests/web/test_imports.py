"""The modules of the pages import each other in one direction."""

import re
from graphlib import CycleError, TopologicalSorter
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[2]
FOLDERS = ("web/src", "tutorials/class_tournament/page")
IMPORT = re.compile(r'\b(?:import|from)\s*\(?\s*"(\.[^"]+\.ts)"')


def modules():
    """Return the modules, each with those that it imports."""
    files = [file for folder in FOLDERS for file in (ROOT / folder).rglob("*.ts")]
    return {file: imported(file) for file in files}


def imported(file):
    found = IMPORT.findall(file.read_text(encoding="utf-8"))
    return {(file.parent / path).resolve() for path in found}


def circle(imports):
    """Return the modules of a circle, each of which imports the next; empty if there is none."""
    try:
        TopologicalSorter(imports).prepare()
    except CycleError as error:
        return error.args[1][::-1]
    return []


def test_no_imports_lead_back_to_their_module():
    """An import of a type counts, too: who reads one module of a circle has to read all of them."""
    imports = modules()
    explorer, engine = ROOT / "web/src/explorer", ROOT / "web/src/engine"
    assert {explorer / "store.ts", engine / "types.ts"} <= imports[explorer / "data.ts"]
    assert set().union(*imports.values()) <= imports.keys()
    found = [file.relative_to(ROOT).as_posix() for file in circle(imports)]
    assert not found, " imports ".join(found)


@pytest.mark.parametrize("statement", ['import "./b.ts"', 'import type {\n  B,\n} from "./b.ts"'])
def test_a_circle_is_found(tmp_path, statement):
    first, second = tmp_path / "a.ts", tmp_path / "b.ts"
    first.write_text(f"{statement};\n", encoding="utf-8")
    second.write_text('export { a } from "./a.ts";\n', encoding="utf-8")
    found = circle({file: imported(file) for file in (first, second)})
    assert found in ([first, second, first], [second, first, second])
