"""Print the lowest allowed version of every dependency that an installation for tests has.

The output is a constraints file for pip: ``name==version``, one a line.
"""

import re
from pathlib import Path

try:
    import tomllib
except ModuleNotFoundError:  # Python 3.10
    from pip._vendor import tomli as tomllib

PROJECT = Path(__file__).parents[1] / "pyproject.toml"
REQUIREMENT = re.compile(r"(?P<name>[\w-]+)(\[[\w,]+\])?>=(?P<version>[\d.]+)(,<[\d.]+)?(; .+)?$")
# Dependencies of the lowest versions, where their newest releases warn about them.
PINNED = ["pyparsing<3.3"]

project = tomllib.loads(PROJECT.read_text(encoding="utf-8"))["project"]
extras = project["optional-dependencies"]
installed = [*project["dependencies"], *extras["video"], *extras["cluster"], *extras["test"]]
for requirement in installed:
    if requirement.startswith(project["name"]):
        continue  # an extra that names another one
    match = REQUIREMENT.match(requirement)
    if match is None:
        raise SystemExit(f"{PROJECT.name}: expected name>=version, got {requirement!r}")
    print(f"{match['name']}=={match['version']}")
print(*PINNED, sep="\n")
