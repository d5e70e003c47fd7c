"""Check what lies in dist/: licences and bill of materials of each wheel, contents of the archive.

Writes build/recipe.yaml, the recipe of conda-forge with the archive's digest.
"""

import hashlib
import json
import re
import sys
import tarfile
import zipfile
from pathlib import Path

from cyclonedx.schema import SchemaVersion
from cyclonedx.validation.json import JsonStrictValidator
from packaging.requirements import Requirement
from rattler_build import PlatformConfig, RenderConfig, Stage0Recipe, VariantConfig

if sys.version_info >= (3, 11):
    import tomllib
else:
    import tomli as tomllib

ROOT = Path(__file__).parents[1]
LICENCES = {"LICENSE", *(f"licenses/{path.name}" for path in (ROOT / "licenses").glob("*.txt"))}
# What the tests of an unpacked archive need, and what no archive holds.
NEEDED = {"CMakeLists.txt", "cpp", "docs", "evolution", "licenses", "python", "tests", "tutorials"}
UNWANTED = re.compile(r"\.(so|o|pyc)$|/(build|node_modules|__pycache__|\.venv[^/]*)/")
LARGEST = 16_000_000  # bytes of an archive
PYTHONS = ["3.10.* *_cpython", "3.13.* *_cp313"]  # with and without `tomli`
COMPILERS = {
    "cxx_compiler": ["gxx"],
    "c_stdlib": ["sysroot"],
    "m2w64_cxx_compiler": ["gxx"],
    "m2w64_c_stdlib": ["m2w64-sysroot"],
}
"""Names that conda-forge gives to compilers and their libraries, on Windows those of MinGW."""
OTHER_NAMES = {"matplotlib": "matplotlib-base"}


def expect(good: object, said: str) -> None:
    if not good:
        sys.exit(said)


def check_wheel(path: Path) -> None:
    with zipfile.ZipFile(path) as wheel:
        inside = [name.partition(".dist-info/")[2] for name in wheel.namelist()]
        lost = {f"licenses/{name}" for name in LICENCES} - set(inside)
        expect(not lost, f"{path.name}: expected the licences {sorted(lost)}")
        bills = [name for name in wheel.namelist() if ".dist-info/sboms/" in name]
        ours = [name for name in bills if name.endswith("/matrixworld.cdx.json")]
        expect(ours, f"{path.name}: expected a bill of materials, got {bills}")
        text = wheel.read(ours[0]).decode()
    wrong = JsonStrictValidator(SchemaVersion.V1_6).validate_str(text)
    expect(wrong is None, f"{path.name}: the bill of materials is no CycloneDX: {wrong}")
    parts = [f"{part['name']} {part['version']}" for part in json.loads(text)["components"]]
    expect(all(re.search(r" \d", part) for part in parts), f"expected versions, got {parts}")
    print(f"{path.name}: {path.stat().st_size / 1e6:.1f} MB, {len(LICENCES)} licences;", *parts)


def check_archive(path: Path) -> None:
    with tarfile.open(path) as archive:
        names = archive.getnames()
    inside = {name.partition("/")[2] for name in names}
    lost = (NEEDED | LICENCES) - {name.split("/")[0] for name in inside} - inside
    expect(not lost, f"{path.name}: expected {sorted(lost)}")
    unwanted = sorted(filter(UNWANTED.search, names))
    expect(not unwanted, f"{path.name}: expected sources alone, got {unwanted[:5]}")
    size = path.stat().st_size
    expect(size < LARGEST, f"{path.name}: expected less than {LARGEST} bytes, got {size}")
    print(f"{path.name}: {size / 1e6:.1f} MB, {len(names)} files")


def needs(python: str) -> set[str]:
    """Return what pyproject.toml says that an installation needs, as conda writes it."""
    project = tomllib.loads((ROOT / "pyproject.toml").read_text(encoding="utf-8"))["project"]
    requirements = [Requirement(text) for text in project["dependencies"]]
    return {
        f"{OTHER_NAMES.get(each.name, each.name)} {each.specifier}"
        for each in requirements
        if each.marker is None or each.marker.evaluate({"python_version": python[:4]})
    }


def write_recipe(archive: Path) -> None:
    """Fill in the digest, and compare the requirements of the recipe with the package's."""
    text = (ROOT / ".ci/recipe.yaml").read_text(encoding="utf-8")
    digest = hashlib.sha256(archive.read_bytes()).hexdigest()
    recipe = ROOT / "build/recipe.yaml"
    recipe.parent.mkdir(exist_ok=True)
    recipe.write_text(text.replace("0" * 64, digest), encoding="utf-8")
    for python in PYTHONS:
        settings = {**COMPILERS, "python": [python]}
        for system in ("linux-64", "win-64"):
            target = RenderConfig(platform=PlatformConfig(target_platform=system))
            given = Stage0Recipe.from_file(recipe).render(VariantConfig(settings), target)
            (rendered,) = given  # no system is left out
            run = set(map(str, rendered.recipe.requirements.run)) - {"python"}
            expect(run == needs(python), f"recipe: expected {needs(python)}, got {run}")
    print(f"{recipe.relative_to(ROOT)}: sha256 {digest}")


def main() -> None:
    wheels, archives = (sorted((ROOT / "dist").glob(kind)) for kind in ("*.whl", "*.tar.gz"))
    expect(wheels, "dist: expected a wheel")
    expect(len(archives) == 1, f"dist: expected one source archive, got {archives}")
    for wheel in wheels:
        check_wheel(wheel)
    check_archive(archives[0])
    write_recipe(archives[0])


if __name__ == "__main__":
    main()
