"""Players: whatever can play for a team, from a script's name to a function or a file."""

from __future__ import annotations

import sys
import traceback
from collections.abc import Callable
from dataclasses import dataclass, replace
from functools import cache, lru_cache, partial
from importlib import import_module
from itertools import count
from pathlib import Path
from types import ModuleType
from typing import Any, NamedTuple, TypeAlias

from matrixworld._util import checks
from matrixworld._util.alarms import TooSlowError, alarm
from matrixworld._util.files import read_text
from matrixworld._util.teams import PLURALS
from matrixworld.play.functions import Function, PlayerError
from matrixworld.play.policies import GenomePolicy, read_genome
from matrixworld.world.config import WorldConfig
from matrixworld.world.masks import check_script, check_team
from matrixworld.world.policy import SCRIPTS, TEAMS, EnginePolicy, Population, TablePolicy, Team
from matrixworld.world.program import Program
from matrixworld.world.rating import INPUTS

Plays: TypeAlias = EnginePolicy | Function
"""What chooses a team's actions in a world: what the engine plays, or a function that is asked."""

SOLVED = "solved"
"""The name of perfect play, in small worlds."""

FUNCTIONS: dict[Team, tuple[str, str]] = {
    "pursuer": ("pursue", "choose"),
    "evader": ("evade", "choose"),
}
"""The functions of a file of Python that can play for a team, the first one that it has."""

SUFFIXES = (".py", ".npz", ".txt")
KEPT = 8
"""The most worlds of which a player keeps what plays there."""

_MOST_TOKENS = 2**12
_RUNS = count()  # of files: each has a module of its own

KINDS = (
    "the name of a script, a line of text, a file (.py, .npz, .txt) or run directory, a "
    "Population, NetworkPolicy, RatingPolicy, SavedRun, Solution, its policy, a Table, a torch "
    "module or a function"
)


class Options(NamedTuple):
    """What else `player` is told."""

    name: str = ""
    fov: int | None = None
    seconds: float | None = None


@dataclass(frozen=True, eq=False)
class Player:
    """One that can play for a team; `player` makes it of anything.

    Parameters
    ----------
    team : {"pursuer", "evader"}
        The team that it plays for.
    name : str
        What it is called.
    kind : str
        What it is, in words.
    given : object
        What it was made of.
    made : callable
        Returns, for a `WorldConfig`, what plays there; ValueError if nothing does.
    options : Options
        The other arguments of `player`.
    """

    team: Team
    name: str
    kind: str
    given: Any
    made: Callable[[WorldConfig], Plays]
    options: Options

    def __repr__(self) -> str:
        return f"Player({self.name}: {self.kind}, for {PLURALS[self.team]})"

    def __reduce__(self) -> tuple[Any, ...]:
        """Keep what it was made of, for other processes."""
        return partial(player, **self.options._asdict()), (self.given, self.team)

    def at(self, config: WorldConfig) -> Plays:
        """Return what plays in a world: a `Function`, or what the engine takes.

        ValueError if it sees too little there, has other views or moves, or is of another world.
        """
        plays = self.made(config)
        if isinstance(plays, Population):
            plays.policy.check_fits(self.name, config)
            check_team(self.name, plays, config, self.team)
        elif isinstance(plays, str):
            check_script(self.name, plays, config)
        elif isinstance(plays, TablePolicy) and plays.steps not in (None, config.max_steps):
            expected = f"a world with max_steps {plays.steps}, which it counts"
            raise ValueError(f"{self.name}: expected {expected}, got {config.max_steps}")
        return plays


def player(
    given: Any, team: Team, *, name: str = "", fov: int | None = None, seconds: float | None = None
) -> Player:
    """Return a player of anything that can play for a team.

    ======================================  ========================================================
    ``"chaser"``                            a script (`SCRIPTS`)
    ``"evolved-1"``                         an opponent that comes with the package, in the worlds
                                            of its rules
    ``"solved"``                            perfect play, in small worlds
    ``"0.3 * teammate - adversary"``        a program over named inputs (`Program`)
    ``"anna.py"``                           a file of Python with a function ``pursue`` or ``evade``
                                            (see `Function`), or ``choose``; it is run
    ``"anna.npz"``, ``"anna.txt"``          a genome of `play.save_genome`; a program as text
    ``"runs/race"``                         a run: its last generation
    `Population`, `NetworkPolicy`,          genomes
    `RatingPolicy`, saved run
    `Solution`, its `policy`, `Table`       play in the states of a small world
    function, torch module                  see `Function`
    ======================================  ========================================================

    Parameters
    ----------
    given : object
        One of these, or a `Player`.
    team : {"pursuer", "evader"}
        The team that it plays for.
    name : str, optional
        What it is called. The default is what `given` says.
    fov : int, optional
        Side of the view that a function gets, odd: the middle of a larger one. The default is the
        world's.
    seconds : float, optional
        Longest time of one call of a function, where alarm signals exist. The default is none.

    Returns
    -------
    Player
        Every call that plays, records, grades or races takes it, and makes one of what it is given.

    Raises
    ------
    FileNotFoundError, PlayerError, TypeError, ValueError
        If nothing there can play for the team. PlayerError: a file of Python fails.

    Examples
    --------
    >>> import matrixworld as mw
    >>> mw.player("-adversary", "pursuer")
    Player(-adversary: program, for pursuers)
    >>> def north(view):
    ...     return 1
    >>> mw.player(north, "evader")
    Player(north: function of views, for evaders)
    """
    checks.check_choice("team", team, TEAMS)
    if isinstance(given, Player):
        if given.team != team:
            raise ValueError(f"{given.name}: expected a player of {PLURALS[team]}, got {given}")
        if not (name or fov or seconds):
            return given
        name, given = name or given.name, given.given
    options = Options(name, fov, seconds)
    if isinstance(given, str | Path) and _is_file(given, ".py"):
        given = PythonFile.read(given)  # other processes need not see the file
        kind, title, made = _made(_function_in(given, team, options), team, options)
    else:
        kind, title, made = _made(given, team, options)
    return Player(team, name or title, kind, given, lru_cache(KEPT)(made), options)


def placed(argument: str, given: Any, team: Team, config: WorldConfig) -> Plays:
    """Return what plays of a player in a world; errors begin with the name of an argument."""
    try:
        return player(given, team).at(config)
    except PlayerError:
        raise
    except (TypeError, ValueError) as error:
        kind = TypeError if isinstance(error, TypeError) else ValueError
        raise kind(f"{argument}: {error}") from error


class PythonFile(NamedTuple):
    """The text of a file of Python that has a player. It is run when that is to play."""

    name: str
    text: str

    @classmethod
    def read(cls, path: str | Path) -> PythonFile:
        """Return a file; FileNotFoundError if there is none."""
        if not Path(path).is_file():
            raise FileNotFoundError(f"{path}: expected a file of Python, got none: no such file")
        return cls(Path(path).name, read_text(Path(path), "program"))


_Made: TypeAlias = tuple[str, str, Callable[[WorldConfig], Plays]]
"""Kind, name, and what plays in a world."""


def _made(given: Any, team: Team, options: Options) -> _Made:
    name = options.name
    if isinstance(given, PythonFile):
        later = cache(lambda: _function_in(given, team, options))
        return "file of Python", given.name, lambda config: later()
    if isinstance(given, str | Path):
        return _named(given, team, options)
    if isinstance(given, GenomePolicy):
        given = given.population()
    if isinstance(given, Population):
        genomes = given
        return genomes.policy.kind, name or _title(genomes), lambda config: genomes
    if isinstance(given, TablePolicy):
        return "table", name or "table", lambda config: _of_team(given, team)
    if hasattr(given, "teams") and team in given.teams:  # a saved run; its class is not known here
        named = options._replace(name=name or Path(given.path).name)
        return _made(given.teams[team], team, named)
    if hasattr(given, "policy") and hasattr(given, "probabilities"):  # a solution, or a table
        return "table", name or type(given).__name__.lower(), lambda config: given.policy(team)
    if isinstance(given, Function):
        return given.form, given.name, lambda config: given
    if callable(given):
        function = Function(given, **options._asdict())
        return function.form, function.name, lambda config: function
    raise TypeError(f"expected {KINDS}, got {checks.shown(given)}")


def _title(genomes: Population) -> str:
    n = len(genomes.genomes)
    return genomes.policy.kind if n == 1 else f"{n} genomes"


def _of_team(policy: TablePolicy, team: Team) -> TablePolicy:
    if policy.team != team:
        expected, got = PLURALS[team], PLURALS[policy.team]
        raise ValueError(f"table: expected one of {expected}, got one of {got}")
    return policy


def _named(given: str | Path, team: Team, options: Options) -> _Made:
    """Return what a name, a path or a line of text stands for."""
    text, path, name = str(given), Path(given), options.name
    if text in SCRIPTS:
        return "script", text, lambda config: text
    if text == SOLVED:
        return "perfect play", text, lambda config: _solved(config, team)
    if text.startswith("evolved-"):
        return "held-out opponent", text, lambda config: _held_out(text, team, config)
    if text and is_folder(path):
        # Runs are known to co-evolution alone, which is above this module.
        [run] = _runs_in(path)
        last = import_module("matrixworld.coevolution.runs.stored").last_generation(run, team)
        return _made(last, team, options._replace(name=name or path.name))
    if (isinstance(given, Path) or is_path(text)) and not path.is_file():
        expected = f"a file ({', '.join(SUFFIXES)}) or a run directory"
        raise FileNotFoundError(f"{path}: expected {expected}, got none")
    if path.suffix == ".npz":
        of, genomes = read_genome(path)
        if of != team:
            raise ValueError(f"{path}: expected a genome of {PLURALS[team]}, got one of {of}s")
        return _made(genomes, team, options._replace(name=name or path.name))
    if path.suffix == ".txt":
        lines = path.read_text(encoding="utf-8").splitlines()
        kept = " ".join(line for line in lines if not line.lstrip().startswith("#"))
        return _line(kept.strip(), name or path.name)
    if isinstance(given, Path) or is_path(text):
        raise ValueError(f"{path}: expected a file {', '.join(SUFFIXES)}, got {path.suffix!r}")
    return _line(text, name or text)


def _runs_in(path: Path) -> list[Path]:
    """Return the only run in a directory, in a list; ValueError unless there is one."""
    found: list[Path] = import_module("matrixworld.coevolution.runs.places").find_runs(path)
    if len(found) != 1:
        names = ", ".join(str(run) for run in found[:4]) + ", ..." * (len(found) > 4)
        raise ValueError(f"{path}: expected a directory with one run, got {names or 'none'}")
    return found


def _line(text: str, name: str) -> _Made:
    """Return a program of one line."""
    program = Program(inputs=tuple(INPUTS), length=_MOST_TOKENS)
    try:
        tokens = program.tokens(program.genome(text))
    except ValueError as error:
        if text.replace("-", "_").isidentifier():
            names = ", ".join([*SCRIPTS, SOLVED])
            others = f"a file, a run directory, or a line of {', '.join(INPUTS)}"
            raise ValueError(f"expected one of {names}, {others}, got {text!r}") from error
        example = "a line such as '0.3 * teammate - adversary'"
        raise ValueError(f"{name!r}: expected {example}: {error}") from error
    # As short as it can be, of the inputs that it reads: its genome can be read and changed.
    read = tuple(each for each in INPUTS if each in tokens) or tuple(INPUTS)[:1]
    short = Program(inputs=read, length=len(tokens))

    def made(config: WorldConfig) -> Population:
        placed = replace(short, fov=config.fov, n_actions=config.n_actions)
        return Population(placed.encode(tokens), placed)

    return "program", name, made


def is_folder(given: str | Path) -> bool:
    """Return whether a text is the path of a directory; a long line of text is none."""
    try:
        return Path(given).is_dir()
    except OSError:
        return False


def _is_file(given: str | Path, *suffixes: str) -> bool:
    """Return whether a text is a path with one of some suffixes."""
    return Path(given).suffix in suffixes and not is_folder(given)


def is_path(text: str) -> bool:
    """Return whether a text is the path of a player's file or run, and no name or line."""
    return bool(text) and ("/" in text or _is_file(text, *SUFFIXES) or is_folder(text))


def _function_in(file: PythonFile, team: Team, options: Options) -> Function:
    """Run a file of Python and return its function for a team."""
    found = _run(file, options.seconds)
    for known in FUNCTIONS[team]:
        if callable(found.get(known)):
            named = options._replace(name=options.name or file.name)
            return Function(found[known], **named._asdict())
    own = [each for each, value in found.items() if callable(value)]
    raise ValueError(
        f"{file.name}: expected a function {' or '.join(FUNCTIONS[team])} for {PLURALS[team]}, got "
        f"{', '.join(own) or 'none'}"
    )


def _run(file: PythonFile, seconds: float | None) -> dict[str, Any]:
    """Run a file of Python and return its names; PlayerError, with a line, if it fails."""
    module = ModuleType(f"matrixworld_player_{Path(file.name).stem}_{next(_RUNS)}")
    module.__file__ = file.name
    sys.modules[module.__name__] = module  # so that memories can hold objects of its classes
    try:
        with alarm(seconds):
            exec(compile(file.text, file.name, "exec"), vars(module))
    except (Exception, SystemExit, TooSlowError) as error:
        frames = reversed(traceback.extract_tb(error.__traceback__))
        line = next((each.lineno for each in frames if each.filename == file.name), None)
        line = error.lineno if isinstance(error, SyntaxError) else line
        where = f"{file.name}, line {line}" if line else file.name
        what = (
            f"expected it to run within {seconds} s"
            if isinstance(error, TooSlowError)
            else (f"{type(error).__name__}: {error}")
        )
        raise PlayerError(f"{where}: {what}") from error
    return {name: value for name, value in vars(module).items() if not name.startswith("__")}


def teams_of(given: Any, *, seconds: float | None = None) -> tuple[Team, ...]:
    """Return the teams that something can play for: both, unless it says otherwise.

    Functions ``pursue`` and ``evade`` are of one team; so are genomes in files and tables. A file
    of Python is run, for at most so many `seconds`. Errors are those of `player`.
    """
    if isinstance(given, Player | TablePolicy):
        return (given.team,)
    if isinstance(given, Function):
        given = given.function
    if getattr(given, "team", None) in TEAMS:  # a table
        team: Team = given.team
        return (team,)
    path = Path(given) if isinstance(given, str | Path) else None
    if path is not None and path.suffix == ".npz" and path.is_file():
        return (read_genome(path)[0],)
    if path is not None and _is_file(path, ".py"):
        given = PythonFile.read(path)
    if isinstance(given, PythonFile):
        found = _run(given, seconds)
        return _named_for(lambda name: callable(found.get(name))) or TEAMS
    if callable(given):
        name = getattr(given, "__name__", "")
        return _named_for(lambda expected: name == expected) or TEAMS
    return TEAMS


def _named_for(has: Callable[[str], bool]) -> tuple[Team, ...]:
    """Return the teams with a function of their own, or else with one for both."""
    for place in range(2):
        if found := tuple(team for team in TEAMS if has(FUNCTIONS[team][place])):
            return found
    return ()


def _solved(config: WorldConfig, team: Team) -> TablePolicy:
    # The solver takes players, and so is above this module.
    policy: TablePolicy = import_module("matrixworld.solver").solve(config).policy(team)
    return policy


def _held_out(name: str, team: Team, config: WorldConfig) -> Population:
    every = import_module("matrixworld.coevolution.evaluation.held_out").held_out(
        team, config.rules
    )
    if name not in every:
        evolved = [each for each in every if each.startswith("evolved-")]
        got = ", ".join(evolved) or "none: they exist for the rules of the nine variants"
        raise ValueError(f"{name}: expected an evolved opponent of these rules, which has {got}")
    found: Population = every[name]
    return found
