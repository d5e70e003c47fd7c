"""``matrixworld judge``, ``score``, ``tournament`` and ``explain``: what has evolved."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any

import click

from matrixworld import analysis
from matrixworld._util import checks
from matrixworld._util.files import save_arrays
from matrixworld._util.readable import plain_values
from matrixworld.analysis import intervals
from matrixworld.analysis import judgement as judgements
from matrixworld.analysis.payoffs import EPISODES_TO_JUDGE, GENERATIONS_TO_JUDGE, Payoffs
from matrixworld.cli import cluster, console, options
from matrixworld.cli.setting_options import usage_errors
from matrixworld.coevolution import ProgressBar, open_run, storage, tournament, types
from matrixworld.coevolution.evaluation import scores as held_out
from matrixworld.coevolution.evaluation.explanation import EPISODES
from matrixworld.coevolution.groups import RunGroup, by_clarity

# Judgements:

SINGLE_RUN = "The intervals are about this run. Runs with other seeds may differ."
SIGNS = {judgements.PRESENT: "+", judgements.ABSENT: "-", judgements.CANNOT_TELL: "?"}
NOT_FINISHED = "."
STRIP_LEGEND = (
    f"{', '.join(f'{sign} {verdict}' for verdict, sign in SIGNS.items())}, {NOT_FINISHED} not "
    "finished. In brackets: number of seeds with each verdict."
)


@click.command("judge")
@options.runs(".csv", ".npz")
@click.option("--all", "everything", is_flag=True, help="all measures, after the judgement")
@click.option("--each", is_flag=True, help="judge each run and each file by itself")
@click.option("--explain", "explained", is_flag=True, help="the reasons in sentences, too")
@options.integer("--episodes", "episodes behind each cell of a file that holds means only")
@options.shared("json", "force")
def judge_command(
    sources: list[Path],
    everything: bool,
    each: bool,
    explained: bool,
    episodes: int | None,
    json_file: Path | None,
    force: bool,
) -> None:
    """Say what happened in races.

    Each condition, such as an arms race or cycling, is present or absent, or the intervals cannot
    tell. RUN is the directory of a job or of a run. Runs that differ in their seed only are judged
    together, with the verdict on each seed.

    FILE is a payoff matrix of your own, .csv or .npz: pursuers in rows, evaders in columns, capture
    rates from 0 to 1; or one line for each pair, run and episode. Several files are judged
    together, as runs of one race.
    """
    options.check_outputs(json_file, force=force)
    files = [path for path in sources if path.is_file()]
    runs = [path for path in sources if path not in files]
    if episodes is not None and not files:
        raise click.UsageError("--episodes: expected a FILE; runs know their episodes")
    judged: dict[str, tuple[Payoffs, RunGroup | None]] = {}
    with usage_errors():
        for group in by_clarity(options.finished_groups(runs)) if runs else ():
            got = "a run of one team"
            checks.expect(group.is_race, group.name, "a race", got, click.UsageError)
            for one in group.singles if each else [group]:
                judged[one.name] = one.payoffs, one
        # One file may hold several runs; a list is of files of one run each.
        parts: list[Path | list[Path]] = [files] if len(files) > 1 and not each else [*files]
        for part in parts:
            name = ", ".join(map(str, part)) if isinstance(part, list) else str(part)
            judged[name] = analysis.read_payoffs(part, episodes=episodes), None
    for payoffs, _ in judged.values() if everything else ():
        fits, got = min(payoffs.shape) >= 2, " x ".join(map(str, payoffs.shape))
        checks.expect(fits, "--all", "at least 2 x 2 generations", got, click.UsageError)
    found: dict[str, Any] = {}
    for name, (payoffs, of_runs) in judged.items():
        judgement = of_runs.judgement if of_runs else analysis.judge(payoffs)
        console.print_head(name)
        print_judgement(judgement)
        if of_runs and of_runs.several:
            console.say()
            print_strip(judgement, of_runs.seeds, of_runs.missing)
            console.print_missing(of_runs)
            console.print_wrapped(STRIP_LEGEND)
        if judgement.runs == 1:
            console.print_wrapped(SINGLE_RUN)
        if of_runs:
            console.print_wrapped(of_runs.runs[0].settings.schedule.limits)
        if explained:
            console.say()
            console.print_wrapped(analysis.explain(judgement))
        found[name] = judgement.to_json()
        if everything:
            console.say(f"\n{analysis.measure_table(payoffs)}")
            measures = plain_values(analysis.measure_all(payoffs))
            found[name] = {"judgement": found[name], "measures": measures}
    console.say(f"\n{console.TERMS}")
    options.write_json(json_file, {"groups": found})


def print_judgement(judgement: analysis.Judgement) -> None:
    """Print a judgement: its sentence, what was judged, its table, what limits it."""
    console.print_wrapped(analysis.sentence(judgement))
    runs = "1 run" if judgement.runs == 1 else f"{judgement.runs} runs"
    (rows, columns), (first, second) = judgement.shape, judgement.teams
    played = f", {judgement.episodes:,} episodes of each pair" if judgement.episodes else ""
    if judgement.exact:
        played = ", all episodes equal"
    counted = f"{rows} generations of {first} and {columns} of {second}"
    console.say(f"\n{runs}, {counted}{played}")
    console.print_table(judgements.judgement_cells(judgement), "<<<<")
    if judgement.episodes is None:
        console.print_wrapped(
            "The payoffs do not say how many episodes are behind each cell, and without their "
            'noise some conditions have the verdict "cannot tell". Give the number with --episodes.'
        )
    elif judgement.episodes < EPISODES_TO_JUDGE:
        console.print_wrapped(
            f"It takes at least {EPISODES_TO_JUDGE} episodes of each cell to tell all conditions "
            "from noise; matrixworld tournament RUN --episodes NUMBER plays more."
        )
    if min(judgement.shape) < 2 * GENERATIONS_TO_JUDGE:
        console.print_wrapped(
            f"It takes at least {GENERATIONS_TO_JUDGE} generations of each team to judge a race, "
            f"and {2 * GENERATIONS_TO_JUDGE} to judge its halves."
        )


def print_strip(
    judgement: analysis.Judgement, seeds: Sequence[int], missing: Sequence[int]
) -> None:
    """Print the verdict on each seed in columns, and how many seeds have which verdict."""
    every = sorted([*seeds, *missing])
    beside = max(1, (console.width() - 50) // (2 + max(len(str(seed)) for seed in every)))
    for first in range(0, len(every), beside):
        part, is_last = every[first : first + beside], first + beside >= len(every)
        together = f"together (seeds: {', '.join(SIGNS.values())})" if is_last else ""
        rows = [("seed", *map(str, part), together)]
        for name, finding in judgement.findings.items():
            signs = {s: SIGNS[v] for s, v in zip(seeds, finding.by_run, strict=True)}
            numbers = ", ".join(str(finding.by_run.count(verdict)) for verdict in SIGNS)
            end = f"{finding.verdict} ({numbers})" if is_last else ""
            rows.append((name, *(signs.get(seed, NOT_FINISHED) for seed in part), end))
        console.print_table(rows, "<" + ">" * len(part) + "<")


# Scores:

ALL = "all"
LEGEND = (
    "In brackets: 95% interval over the episodes. Runs with other seeds may differ by more. In the "
    "mean every opponent has the same weight."
)
SEEDS_LEGEND = (
    "In brackets: 95% interval of the mean over seeds. In the mean every opponent has the same "
    f"weight. The interval of an interquartile mean takes {intervals.fewest_runs()} seeds."
)


def _generation(ctx: click.Context, param: click.Parameter, value: str) -> int | None:
    try:
        return None if value == ALL else int(value)
    except ValueError:
        raise click.BadParameter(f"expected a generation or {ALL}, got {value!r}") from None


@click.command("score")
@options.runs()
@click.option(
    "--generation",
    default="-1",
    callback=_generation,
    metavar="NUMBER|all",
    help="which one, negative numbers from the last; all: means of every one  [default: the last]",
)
@options.shared("episodes", "seed", "json", "force", "threads", "cluster")
def score_command(
    runs: list[Path],
    json_file: Path | None,
    force: bool,
    threads: int | None,
    where: str | None,
    **chosen: Any,
) -> None:
    """Score teams against held-out opponents.

    The opponents are scripts of different skill and, in worlds with the default views and actions,
    small networks that come with the package. No run has learnt against them, and with one --seed
    all runs meet them in the same episodes: runs can be compared.

    RUN is the directory of a job or of a run. A single run need not be finished. Of runs that
    differ in their seed only the table shows mean and interval over the seeds. Runs with
    training_worlds are also scored in each of these.

    With --cluster the workers of a Dask cluster play blocks of the matches. It pays with
    --generation all and many episodes. The workers need not see RUN.
    """
    options.check_outputs(json_file, force=force)
    with usage_errors():
        groups = options.finished_groups(runs, unfinished=True)
        every = [run for group in groups for run in group.runs]
        with cluster.on_cluster(where, threads) as executor, ProgressBar() as bar:
            play = {"threads": threads, "executor": executor, "report": bar, **chosen}
            played = held_out.score_runs(every, **play)
            trained = [
                (group, world, held_out.score_runs(group.runs, world=world, **play))
                for group in groups
                for world in group.runs[0].settings.training_worlds
            ]
    of_worlds = [played, *(scores for _, _, scores in trained)]
    matches = sum(each.matches for runs in of_worlds for run in runs for each in run.values())
    found: dict[str, Any] = {}
    for group in groups:
        finished = f": {console.seeds_finished(group)}" if group.several else ""
        console.print_head(f"{group.name}{finished}")
        found[group.name] = {
            "seeds": list(group.seeds),
            "missing": list(group.missing),
            "held_out": held_out.HELD_OUT_VERSION,
            **_print_scores(group, [played.pop(0) for _ in group.runs]),
        }
        console.print_missing(group)
    for group, world, scores in trained:
        size = f"{world.rows} x {world.cols}, {world.n_pursuers} v {world.n_evaders}"
        walls = ", with obstacles" if world.density or world.map is not None else ""
        console.print_head(f"{group.name} in a world of training: {size}{walls}")
        in_world = {"world": world.to_json(), **_print_scores(group, scores)}
        found[group.name].setdefault("training_worlds", []).append(in_world)
    console.say()
    console.print_wrapped(LEGEND if max(len(group.runs) for group in groups) == 1 else SEEDS_LEGEND)
    console.say(f"{matches:,} matches were played.")
    options.write_json(json_file, {"seed": chosen["seed"], "groups": found})


def _print_scores(
    group: RunGroup, of_runs: Sequence[Mapping[types.Team, held_out.HeldOutScores]]
) -> dict[str, Any]:
    """Print the scores of the runs of a group, and return them as values of JSON by team."""
    plain = {}
    for team, first in of_runs[0].items():
        scores = [of_run[team] for of_run in of_runs]
        console.say(held_out.score_table(scores))
        if first.left_out:
            console.print_wrapped(f"Left out: {first.left_out}.")
        rows = range(len(first.generations))
        by_seed = zip(group.seeds, scores, strict=True)
        plain[f"{team}s"] = {
            "generations": list(first.generations),
            "estimates": plain_values([held_out.estimates_of(scores, row) for row in rows]),
            "by_seed": {str(seed): each.to_json() for seed, each in by_seed},
        }
    return plain


# Tournaments:


@click.command("tournament")
@click.argument("run", type=click.Path(path_type=Path))
@options.shared("race", "episodes", "seed")
@options.shared("force", "threads", "cluster")
def tournament_command(
    run: Path,
    race: str | None,
    episodes: int,
    seed: int,
    force: bool,
    threads: int | None,
    where: str | None,
) -> None:
    """Play every generation against every other.

    If RUN holds several races, each has its tournament, or --race chooses one. RUN need not be
    finished: the generations that it has are played. Its own files stay as they are.

    The payoff is written into RUN (.npz, named after the options), and a heat map (.png). With the
    seed of RUN the first episodes of each pair are those of RUN's own payoff. The race is judged.

    With --cluster the workers of a Dask cluster play blocks of the matrix. They need not see RUN.
    """
    from matrixworld import plots

    runs = (storage.find_runs(run) if race is None else []) or [options.run_in(run, race)]
    for played in map(open_run, runs):
        target = played.path / f"tournament-{episodes}-seed{seed}.npz"
        figure = target.with_suffix(".png")
        options.check_outputs(target, figure, force=force)
        with cluster.on_cluster(where, threads) as executor, ProgressBar() as bar:
            payoff = tournament(
                played.game, *played.teams.values(), seed=seed, episodes=episodes, threads=threads,
                report=bar, executor=executor,
            )  # fmt: skip
        judgement = analysis.judge(payoff.payoffs())
        title = f"{played.title}\n{analysis.sentence(judgement)}"
        save_arrays(target, payoff.arrays())
        plots.save_figure(plots.payoff_heatmap(payoff.matrix, title=title), figure)
        console.print_head(str(played.path))
        console.say(f"{payoff}\n")
        print_judgement(judgement)
        console.say(f"\n{console.TERMS}")
        console.say(f"\nWritten: {target}, {figure.name}")


# Explanations:


@click.command("explain")
@click.argument("run", type=click.Path(path_type=Path))
@options.shared("race")
@click.option(
    "--team",
    type=click.Choice(types.TEAMS),
    metavar="TEAM",
    help="pursuer or evader  [default: each that learned]",
)
@click.option("--generation", default=-1, metavar="NUMBER", help="which one  [default: the last]")
@options.integer("--episodes", "episodes against each opponent", least=2, default=EPISODES)
@options.shared("seed", "json", "force", "threads")
def explain_command(
    run: Path,
    race: str | None,
    team: types.Team | None,
    json_file: Path | None,
    force: bool,
    **chosen: Any,
) -> None:
    """Say what teams do.

    Policies that rate moves by named inputs: a sentence, how far each input moves the rating, and
    what leaving it out costs in matches. Networks over cells: a decision tree that imitates them,
    with its own score beside theirs, since trees that mostly agree may still play badly. Trees need
    the extra `explain`.

    RUN is the directory of a run, or of a job of one, which need not be finished. Scores are
    against held-out opponents, in episodes that no other command plays.
    """
    options.check_outputs(json_file, force=force)
    found: dict[str, Any] = {}
    with usage_errors():
        saved = open_run(options.run_in(run, race))
        _ = saved.pursuit  # games of your own have other policies
        for each in [team] if team else saved.settings.learning_teams:
            with ProgressBar() as bar:
                explanation = saved.explain(each, **chosen, report=bar)
            console.print_head(f"{saved.path}: {each}s of generation {explanation.generation}")
            console.say(explanation)
            found[f"{each}s"] = explanation.to_json()
    options.write_json(json_file, {"run": str(saved.path), "seed": chosen["seed"], **found})
