"""The report at the end of ``matrixworld evolve``: what a newcomer asks first.

Tables and intervals are those of `judge`.
"""

from __future__ import annotations

import shlex
import time
from collections import Counter
from collections.abc import Iterable, Mapping, Sequence
from pathlib import Path
from typing import Any

from tqdm import tqdm

from matrixworld._util.files import save_json
from matrixworld._util.teams import PLURALS
from matrixworld.analysis import Estimate, sentence
from matrixworld.cli import console, pages
from matrixworld.coevolution import Progress, ProgressBar, SavedRun
from matrixworld.coevolution.evaluation.kept_scores import kept_scores
from matrixworld.coevolution.evaluation.scores import BESIDE_EPISODES, BestScript
from matrixworld.coevolution.games.pursuit import PursuitSettings
from matrixworld.coevolution.groups import RunGroup, by_clarity, grouped
from matrixworld.coevolution.jobs.job import Job
from matrixworld.coevolution.settings.race_settings import RaceSettings
from matrixworld.coevolution.settings.schedules import Against
from matrixworld.coevolution.types import BOTH, TEAMS, other
from matrixworld.explorer.runs_page import PAGE


def report(
    job: Job,
    root: Path,
    finished: Sequence[Path],
    failed: Mapping[Path, str],
    began: float,
    threads: int | None = None,
) -> None:
    """Score and judge the finished runs of a job, draw figures, and print the results.

    `finished` are their directories, and `failed` says why other runs failed, by theirs; `began` is
    the time of `time.monotonic` when the job began.
    """
    groups = [group.inside(root) for group in _groups_of(job, root, finished)]
    of_runs = [group for group in groups if group.runs]
    _play_scores(of_runs, threads)
    if of_runs:
        draw(of_runs, root)
    # The summary of a run that was started by itself lies in the same directory.
    if root not in finished:
        save_json(root / "summary.json", _numbers(groups, root, failed))
    took = tqdm.format_interval(time.monotonic() - began)
    page = f" Open {root / PAGE}" if of_runs else ""
    done = counted_runs(len(finished), job.values())
    console.say(f"{done} done in {took}.{page}", bold=True)
    _print_results(groups, root)
    for path, problem in failed.items():
        console.print_wrapped(f"Failed: {path}: {problem}")
    if of_runs:
        for why, typed in _hints(of_runs, root):
            console.say(f"\n{why}\n  {typed}")


def counted_runs(count: int, settings: Iterable[RaceSettings]) -> str:
    """Return the number of runs of a job, such as "3 races"; "runs" if a team is alone in some."""
    return console.counted(count, "race" if all(each.is_race for each in settings) else "run")


def _groups_of(job: Job, root: Path, finished: Sequence[Path]) -> list[RunGroup]:
    """Return the runs of a job in groups, but those whose directory is lost."""
    runs = [SavedRun(root / name) for name in job]
    return grouped([run for run in runs if run.exists], finished=finished)


def _races_of_pursuit(groups: Sequence[RunGroup]) -> list[RunGroup]:
    """Return the groups that held-out opponents can score."""
    return [
        group
        for group in groups
        if group.runs and group.is_race and isinstance(group.runs[0].settings.game, PursuitSettings)
    ]


def _play_scores(groups: Sequence[RunGroup], threads: int | None) -> None:
    """Play the races against held-out opponents; their directories keep the scores."""
    runs = [run for group in _races_of_pursuit(groups) for run in group.runs]
    with ProgressBar() as bar:
        kept_scores(runs, threads=threads, report=bar)


def _numbers(groups: Sequence[RunGroup], root: Path, failed: Mapping[Path, str]) -> dict[str, Any]:
    """Return what summary.json holds of a job."""
    singles = [single for group in groups if group.runs for single in group.singles]
    return {
        "groups": {group.name: group.to_json() for group in groups},
        "runs": {_place(single.runs[0].path, root): single.run_to_json() for single in singles},
        "failed": {_place(path, root): problem for path, problem in failed.items()},
    }


def _print_results(groups: Sequence[RunGroup], root: Path) -> None:
    """Print what happened in each group, the clearest race, scores, and what teams do."""
    for group in by_clarity(groups):
        console.print_head(group.name)
        console.print_wrapped("\n".join(_results_of(group)))
        console.print_missing(group)
    races = [group for group in groups if group.runs and group.is_race]
    if any(group.several for group in races):
        clearest = by_clarity([single for group in races for single in group.singles])[0]
        console.print_head(f"The clearest race: {clearest.inside(root).name}")
        console.print_wrapped(sentence(clearest.judgement))
    of_pursuit = _races_of_pursuit(groups)
    if of_pursuit:
        console.say()
        console.print_table(_against_strangers(of_pursuit), "<<<<<")
        console.print_wrapped(_how_scored(of_pursuit[0]))
    for group in of_pursuit:
        _print_what_evolved(group)


def _print_what_evolved(group: RunGroup) -> None:
    """Print what the best generations of the first run do, and in how many runs inputs count."""
    every = kept_scores(group.runs)
    told = []
    for team in PLURALS.values():
        evolved = every[0][team]["evolved"]
        if evolved:
            told.append(f"Generation {evolved['generation']}: {evolved['sentence']}")
            told += [evolved["text"]] if evolved["text"] else []
            if len(every) > 1:
                told += _in_all_seeds(team, [scores[team]["evolved"] for scores in every])
    if told:
        console.print_head(f"What evolved: {group.name}, seed {group.seeds[0]}")
        console.print_wrapped("\n".join(told))


def _in_all_seeds(team: str, evolved: Sequence[Mapping[str, Any]]) -> list[str]:
    """Return in how many runs each input of a team is worth something, or is better left out."""
    signs = Counter(
        (term["input"], Estimate(*(term["lost"][end] for end in ("value", "low", "high"))).sign)
        for each in evolved
        for term in each["terms"]
        if term["lost"]
    )
    lines = []
    for sign, words in ((1, "is worth something"), (-1, "is better left out")):
        counts = {name: count for (name, of), count in signs.most_common() if of == sign}
        if counts:
            listed = ", ".join(f"{name} {count}" for name, count in counts.items())
            seeds = f"Seeds, of {len(evolved)}, in which an input of {team} {words}"
            lines.append(f"{seeds}: {listed}.")
    return lines


def _against_strangers(groups: Sequence[RunGroup]) -> list[list[str]]:
    """Return a table of the scores of races against held-out opponents, and what stands beside."""
    beside = kept_scores(groups[0].runs)[0]
    scripts = _best_scripts(beside)
    return [
        ["score against strangers", *(head for team in BOTH for head in (f"{team}: best", "last"))],
        *map(_mean_scores, groups),
        [
            "the best script",
            *(cell for one in scripts for cell in (f"{one.score:.2f} {one.name}", "")),
        ],
        [
            "untrained teams",
            *(c for each in PLURALS.values() for c in (f"{beside[each]['untrained']:.2f}", "")),
        ],
    ]


def _best_scripts(scores: Mapping[str, Any]) -> list[BestScript]:
    """Return the best scripts of both teams that kept scores have."""
    return [BestScript(**scores[team]["best script"]) for team in PLURALS.values()]


def _how_scored(group: RunGroup) -> str:
    """Return where scores were played and how often, and who knows more than its view."""
    scores = kept_scores(group.runs)[0]
    both = [scores[team] for team in PLURALS.values()]
    opponents = " and ".join(str(len(each["against"])) for each in both)
    scripts = _best_scripts(scores)
    among = " and ".join(str(script.among) for script in scripts)
    place = console.place_of(group.runs[0].settings)
    told = (
        f"{place}: {both[0]['episodes']} episodes against each of {opponents} opponents "
        f"(untrained: {BESIDE_EPISODES}); the best of {among} scripts."
    )
    return f"{told} {console.beyond_views(group, dict(zip(TEAMS, scripts, strict=True)))}".strip()


def _mean_scores(group: RunGroup) -> list[str]:
    """Return the mean scores of the best and of the last generation of each team."""
    scores = [each for team in TEAMS for each in (group.best_held_out(team), group.held_out(team))]
    return [group.name, *(f"{each.mean():.2f}" for each in scores)]


def draw(groups: Sequence[RunGroup], root: Path) -> None:
    """Draw the figures and write the page; figures of an earlier report are replaced."""
    from matrixworld import plots
    from matrixworld.plots.saved import figures_of

    files = figures_of(groups, root)
    with ProgressBar() as bar:
        for number, (file, figure) in enumerate(files.items()):
            bar(Progress("draw figures", number, len(files)))
            plots.save_figure(figure(), file)
    pages.write_explorer(groups, root / PAGE)


def _results_of(group: RunGroup) -> list[str]:
    """Return in sentences what happened in a group, or that none of its seeds is finished."""
    if not group.runs:
        return [console.seeds_finished(group)]
    if group.is_race:
        return [sentence(group.judgement)]
    settings = group.runs[0].settings
    means = group.means()
    schedule = settings.schedule
    assert isinstance(schedule, Against)  # one team evolved
    team = settings.teams[TEAMS.index(schedule.team)]
    has_own = schedule.team == "evader" and "other_score" in means
    score = means["other_score"] if has_own else next(iter(means.values()))
    epochs = console.counted(schedule.epochs, "epoch")
    lines = [
        f"{settings.game.known.score_words[0]} {score}",
        f"{team} after {epochs} against {' and '.join(schedule.met)}",
    ]
    if "length" in means:
        lines.append(f"an episode takes {means['length'].value:.0f} steps")
    return lines


def _hints(groups: Sequence[RunGroup], root: Path) -> list[tuple[str, str]]:
    """Return what to do next, and the command for it."""
    last = groups[-1].runs[-1]
    schedule = last.settings.schedule
    path = root if sum(len(group.runs) for group in groups) == 1 else last.path
    if last.settings.exact:
        best = console.command("solve --run", path)
        return [("Watch it:", console.command("replay", path)), ("Beside perfect play:", best)]
    if isinstance(schedule, Against):
        team = f"--set schedule.team={other(schedule.team)}"
        met = f"--set schedule.opponent={shlex.quote(str(path))}"
        options = ["--set schedule.start=null"] if schedule.start else []
        options += ["--set 'schedule.training_opponents=[]'"] if schedule.training_opponents else []
        config = last.path / "config.json"
        opponent = console.command("evolve --config", config, team, met, *options)
        return [("Watch it:", console.command("replay", path)), ("Its opponent learns:", opponent)]
    reasons = ("Reasons and intervals:", console.command("judge --explain", root))
    if any(group.several for group in groups):
        return [("Verdict on each seed:", console.command("judge --each", root)), reasons]
    why = "One seed is one anecdote; with your other options:"
    return [(why, console.command("evolve --seeds 0-9")), reasons]


def _place(path: Path, root: Path) -> str:
    return path.relative_to(root).as_posix()
