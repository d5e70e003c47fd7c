"""Each notebook begins with this script: where `course` lies, and matrixworld if it is missing."""

import sys
from importlib.util import find_spec
from pathlib import Path

from IPython import get_ipython

HERE = Path(__file__).resolve().parents[1]
sys.path.append(str(HERE))
if find_spec("matrixworld") is None:  # from a wheel beside the notebooks, or from the repository
    wheels = sorted(HERE.glob("matrixworld_pursuit-*.whl"))
    found = wheels[-1] if wheels else HERE.parent
    if not (wheels or (found / "pyproject.toml").exists()):
        sys.exit(f"{HERE}: expected a wheel of matrixworld; tutorials/README.md says where it is")
    get_ipython().run_line_magic("pip", f'install --quiet "{found}"')
get_ipython().run_line_magic("matplotlib", "inline")
