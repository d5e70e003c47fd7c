"""OpenSpiel: small worlds and payoff matrices as its games."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from matrixworld._util.checks import check_floats
from matrixworld.solve.solution import rounds_of
from matrixworld.solve.states import States, config_of
from matrixworld.version import imported
from matrixworld.world.config import WorldConfig

__all__ = ["matrix_game", "world_game"]


def world_game(world: WorldConfig | States, *, steps: int | None = None) -> Any:
    """Return a small world as a game of two players with perfect information.

    Player 0 is the pursuers and player 1 the evaders: a team is one player, whose actions are the
    joint actions of `matrixworld.solve.States`. Chance draws the start. Where all agents move at
    once, every round is a simultaneous move of both players; ``pyspiel.convert_to_turn_based`` is
    for algorithms that need turns. In rules with turns every turn is a move of one player.

    An episode ends as in the world, or after `steps` rounds. Then the pursuers get the capture
    rate, and the evaders minus the capture rate: the value is that of `matrixworld.solve.solve`.

    Parameters
    ----------
    world : WorldConfig or States
        The world, or its states.
    steps : int, optional
        Rounds of an episode. The default is the world's `max_steps`.

    Returns
    -------
    pyspiel.Game
        Not registered by a name. Its observation tensor has the places of the agents, (A, rows,
        cols), which evaders count as captured, the turn, and the share of the rounds left.
    """
    library = imported("pyspiel", "open-spiel")
    rounds = rounds_of(config_of(world), steps)
    states = States.of(world)

    class WorldState(_State, library.State):  # type: ignore[misc, name-defined]
        """States of the library are of its class."""

    class WorldGame(library.Game):  # type: ignore[misc, name-defined]
        """Games of the library are of its class."""

        def __init__(self) -> None:
            self.states, self.rounds, self.player = states, rounds, library.PlayerId
            turns = range(states.n_turns)
            self.successors = [states.successors(turn) for turn in turns]
            self.cells = [states.cells(turn) for turn in turns]
            self.captured = [states.captured(turn) for turn in turns]
            kinds = library.GameType
            moves = "SIMULTANEOUS" if states.n_turns == 1 else "SEQUENTIAL"
            kind = kinds(
                short_name="matrixworld",
                long_name=f"MatrixWorld, {states!r}",
                dynamics=getattr(kinds.Dynamics, moves),
                chance_mode=kinds.ChanceMode.EXPLICIT_STOCHASTIC,
                information=kinds.Information.PERFECT_INFORMATION,
                utility=kinds.Utility.ZERO_SUM,
                reward_model=kinds.RewardModel.TERMINAL,
                max_num_players=2,
                min_num_players=2,
                provides_information_state_string=True,
                provides_information_state_tensor=False,
                provides_observation_string=True,
                provides_observation_tensor=True,
                parameter_specification={},
            )
            size = library.GameInfo(
                num_distinct_actions=max(max(each.shape[1:]) for each in self.successors),
                max_chance_outcomes=len(states.starts),
                num_players=2,
                min_utility=-1.0,
                max_utility=1.0,
                utility_sum=0.0,
                max_game_length=rounds * states.n_turns,
            )
            super().__init__(kind, size, {})

        def new_initial_state(self) -> Any:
            return WorldState(self)

        def make_py_observer(self, iig_obs_type: Any = None, params: Any = None) -> Any:
            return _Observer(states)

    return WorldGame()


class _State:
    """The methods of the library's `State`: a moment before a turn, or the draw of the start."""

    get_game: Any

    def __init__(self, game: Any) -> None:
        super().__init__(game)  # type: ignore[call-arg]  # of the library
        # Copies of a state copy its attributes: the tables stay with the game.
        self.at, self.turn, self.left = -1, 0, game.rounds

    def current_player(self) -> Any:
        game = self.get_game()
        if self.at < 0:
            return game.player.CHANCE
        if self.is_terminal():
            return game.player.TERMINAL
        if game.states.n_turns == 1:
            return game.player.SIMULTANEOUS
        _, pursuers, evaders = game.successors[self.turn].shape
        return int(evaders > pursuers)

    def chance_outcomes(self) -> list[tuple[int, float]]:
        n = len(self.get_game().states.starts)
        return [(start, 1 / n) for start in range(n)]

    def _legal_actions(self, player: int) -> list[int]:
        return list(range(self.get_game().successors[self.turn].shape[1 + player]))

    def _apply_action(self, action: int) -> None:
        if self.at < 0:
            self.at = int(self.get_game().states.starts[action])
        else:
            self._apply_actions([0, action] if self.current_player() else [action, 0])

    def _apply_actions(self, actions: list[int]) -> None:
        game = self.get_game()
        self.at = int(game.successors[self.turn][self.at, actions[0], actions[1]])
        self.turn = (self.turn + 1) % game.states.n_turns
        self.left -= self.turn == 0

    def _action_to_string(self, player: int, action: int) -> str:
        return f"start {action}" if player < 0 else f"{('pursuers', 'evaders')[player]} {action}"

    def is_terminal(self) -> bool:
        return 0 <= self.at < self.get_game().states.n_ends or not self.left

    def returns(self) -> list[float]:
        if not self.is_terminal():
            return [0.0, 0.0]
        rate = float(self.get_game().captured[self.turn][self.at].mean())
        return [rate, -rate]

    def __str__(self) -> str:
        return f"state {self.at} of turn {self.turn}, {self.left} rounds left"


class _Observer:
    """The library's interface of observers: both players see everything."""

    def __init__(self, states: States) -> None:
        config = states.config
        shapes = {
            "cells": (config.n_agents, config.rows * config.cols),
            "captured": (config.n_evaders,),
            "turn": (states.n_turns,),
            "left": (1,),
        }
        sizes = [int(np.prod(shape)) for shape in shapes.values()]
        self.tensor: NDArray[np.float32] = np.zeros(sum(sizes), np.float32)
        parts = np.split(self.tensor, np.cumsum(sizes)[:-1])
        self.dict = {
            name: part.reshape(shape)
            for part, (name, shape) in zip(parts, shapes.items(), strict=True)
        }

    def set_from(self, state: Any, player: int) -> None:
        self.tensor.fill(0.0)
        if state.at < 0:
            return
        game = state.get_game()
        cells = game.cells[state.turn][state.at]
        there = np.flatnonzero(cells >= 0)
        self.dict["cells"][there, cells[there]] = 1.0
        self.dict["captured"][:] = game.captured[state.turn][state.at]
        self.dict["turn"][state.turn] = 1.0
        self.dict["left"][:] = state.left / game.rounds

    def string_from(self, state: Any, player: int) -> str:
        return str(state)


def matrix_game(payoff: ArrayLike) -> Any:
    """Return a payoff matrix as a zero-sum game, whose actions are the generations of both teams.

    Parameters
    ----------
    payoff : array_like of float, shape (G, H)
        What the pursuers of row g get against the evaders of column h, such as the `Payoff` of a
        run: capture rates.

    Returns
    -------
    pyspiel.MatrixGame
    """
    library = imported("pyspiel", "open-spiel")
    rates = check_floats("payoff", np.asarray(payoff))
    if rates.ndim != 2:
        raise ValueError(f"payoff: expected shape (G, H), got {rates.shape}")
    rows, columns = (list(map(str, range(n))) for n in rates.shape)
    names = "matrixworld_payoff", "MatrixWorld, payoff matrix"
    return library.create_matrix_game(*names, rows, columns, rates, -rates)
