"""Small worlds and payoff matrices as games of OpenSpiel: copy this file.

``pip install open_spiel``
"""

import numpy as np
import pyspiel

from matrixworld.solver import States


def matrix_game(payoff):
    """Return a payoff matrix (G, H) of what pursuers get against evaders as a zero-sum game."""
    rates = np.ma.filled(np.ma.asarray(payoff, float), np.nan)
    if rates.ndim != 2 or not rates.size or not np.isfinite(rates).all():
        raise ValueError(f"payoff: expected finite numbers of shape (G, H), got {payoff!r}")
    rows, columns = (list(map(str, range(n))) for n in rates.shape)
    names = "matrixworld_payoff", "MatrixWorld, payoff matrix"
    return pyspiel.create_matrix_game(*names, rows, columns, rates, -rates)


class WorldGame(pyspiel.Game):
    """A small world as a game of two players with perfect information.

    Player 0 is the pursuers and player 1 the evaders: a team is one player, whose actions are the
    joint actions of `matrixworld.solver.States`. Chance draws the start. Where all agents move at
    once, every round is a simultaneous move of both players; ``pyspiel.convert_to_turn_based`` is
    for algorithms that need turns. In rules with turns every turn is a move of one player.

    An episode ends as in the world, or after its ``max_steps``. Then the pursuers get the capture
    rate, and the evaders minus the capture rate: the value is that of `matrixworld.solver.solve`.
    """

    def __init__(self, config):
        states = self.states = States(config)
        self.rounds = config.max_steps
        turns = range(states.n_turns)
        self.successors = [states.successors(turn) for turn in turns]
        self.cells = [states.cells(turn) for turn in turns]
        self.captured = [states.captured(turn) for turn in turns]
        kind, moves = pyspiel.GameType, "SIMULTANEOUS" if states.n_turns == 1 else "SEQUENTIAL"
        own_type = kind(
            short_name="matrixworld",
            long_name=f"MatrixWorld, {states!r}",
            dynamics=getattr(kind.Dynamics, moves),
            chance_mode=kind.ChanceMode.EXPLICIT_STOCHASTIC,
            information=kind.Information.PERFECT_INFORMATION,
            utility=kind.Utility.ZERO_SUM,
            reward_model=kind.RewardModel.TERMINAL,
            max_num_players=2,
            min_num_players=2,
            provides_information_state_string=True,
            provides_information_state_tensor=False,
            provides_observation_string=True,
            provides_observation_tensor=True,
            parameter_specification={},
        )
        size = pyspiel.GameInfo(
            num_distinct_actions=max(max(each.shape[1:]) for each in self.successors),
            max_chance_outcomes=len(states.starts),
            num_players=2,
            min_utility=-1.0,
            max_utility=1.0,
            utility_sum=0.0,
            max_game_length=self.rounds * states.n_turns,
        )
        super().__init__(own_type, size, {})

    def new_initial_state(self):
        """Return the moment before chance draws the start."""
        return WorldState(self)

    def make_py_observer(self, iig_obs_type=None, params=None):
        """Return what writes the observation tensor."""
        return Observer(self)


class WorldState(pyspiel.State):
    """A moment before a turn, or the draw of the start."""

    def __init__(self, game):
        super().__init__(game)
        # Copies of a state copy its attributes: the tables stay with the game.
        self.at, self.turn, self.left = -1, 0, game.rounds

    def current_player(self):
        """Return who moves."""
        game = self.get_game()
        if self.at < 0:
            return pyspiel.PlayerId.CHANCE
        if self.is_terminal():
            return pyspiel.PlayerId.TERMINAL
        if game.states.n_turns == 1:
            return pyspiel.PlayerId.SIMULTANEOUS
        _, pursuers, evaders = game.successors[self.turn].shape
        return int(evaders > pursuers)

    def chance_outcomes(self):
        """Return the starts with their probabilities."""
        n = len(self.get_game().states.starts)
        return [(start, 1 / n) for start in range(n)]

    def _legal_actions(self, player):
        return list(range(self.get_game().successors[self.turn].shape[1 + player]))

    def _apply_action(self, action):
        if self.at < 0:
            self.at = int(self.get_game().states.starts[action])
        else:
            self._apply_actions([0, action] if self.current_player() else [action, 0])

    def _apply_actions(self, actions):
        game = self.get_game()
        self.at = int(game.successors[self.turn][self.at, actions[0], actions[1]])
        self.turn = (self.turn + 1) % game.states.n_turns
        self.left -= self.turn == 0

    def _action_to_string(self, player, action):
        return f"start {action}" if player < 0 else f"{('pursuers', 'evaders')[player]} {action}"

    def is_terminal(self):
        """Return whether the episode is over."""
        return 0 <= self.at <= self.get_game().states.config.n_evaders or not self.left

    def returns(self):
        """Return what both players get."""
        if not self.is_terminal():
            return [0.0, 0.0]
        rate = float(self.get_game().captured[self.turn][self.at].mean())
        return [rate, -rate]

    def __str__(self):
        return f"state {self.at} of turn {self.turn}, {self.left} rounds left"


class Observer:
    """The observation tensor: places of agents (A, cells), captures, turn, share of rounds left."""

    def __init__(self, game):
        config = game.states.config
        shapes = {
            "cells": (config.n_agents, config.rows * config.cols),
            "captured": (config.n_evaders,),
            "turn": (game.states.n_turns,),
            "left": (1,),
        }
        sizes = [int(np.prod(shape)) for shape in shapes.values()]
        self.tensor = np.zeros(sum(sizes), np.float32)
        parts = np.split(self.tensor, np.cumsum(sizes)[:-1])
        self.dict = {n: p.reshape(shapes[n]) for n, p in zip(shapes, parts, strict=True)}

    def set_from(self, state, player):
        """Write what both players see."""
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

    def string_from(self, state, player):
        """Return the state as text."""
        return str(state)
