"""The named inputs of moves, slow and obvious: from what an agent sees, cell by cell."""

import numpy as np

import matrixworld as mw
from matrixworld import _core
from reference import MOVES

EVADERS, PURSUERS, OBSTACLES = range(3)


def distance(a, b, diagonal):
    rows, cols = abs(a[0] - b[0]), abs(a[1] - b[1])
    return max(rows, cols) if diagonal else rows + cols


def direction(a, b):
    """Return the direction from a to b, of length 1; zeros if they are the same."""
    rows, cols = b[0] - a[0], b[1] - a[1]
    length = np.sqrt(rows * rows + cols * cols) or 1
    return np.float32(rows / length), np.float32(cols / length)


def in_order(step, move, n_actions):
    """Return the place of a move in the order of right of way of a step; 0 goes first."""
    return (move + (step + step // 8) % 8) % (n_actions - 1)


def contact(rules, team):
    """Return whether it is safe to enter an adversary's cell, and to meet one in a free cell."""
    both = rules.pursuer, rules.evader
    own, foreign = both if team == "pursuer" else both[::-1]
    bounce, occupation = mw.Outcome.BOUNCE, rules.capture is mw.Capture.OCCUPATION
    held = own is bounce or (own is mw.Outcome.REACH and foreign is bounce)
    enter = occupation and not held
    if rules.interaction is mw.Interaction.SIMULTANEOUS:
        return enter, own is not bounce and (occupation or foreign is bounce)
    return enter, team == "pursuer" or enter


def slow_inputs(config, view, team, step, ahead):
    """Return the inputs of an agent's moves by name, lists of numbers, from its view.

    `ahead` is the direction of its stride.
    """
    half, diagonal, n_actions = config.fov // 2, config.diagonal, config.n_actions
    moves = [tuple(int(n) for n in move) for move in MOVES[:n_actions]]
    cells = {
        channel: [(int(r) - half, int(c) - half) for r, c in np.argwhere(view[channel])]
        for channel in range(3)
    }
    own, foreign = (PURSUERS, EVADERS) if team == "pursuer" else (EVADERS, PURSUERS)
    mates, adversaries, walls = cells[own], cells[foreign], set(cells[OBSTACLES])

    def beside(cell):
        return [(cell[0] + r, cell[1] + c) for r, c in moves[1:]]

    unit = np.float32(2) / np.float32(config.fov)  # half a view

    def nearest(there, others):
        each = (distance(there, other, diagonal) for other in others)
        return unit * np.float32(min(each, default=config.fov))

    def push(there, others):
        each = (2**14 // (1 + distance(there, other, diagonal)) ** 2 for other in others)
        return sum(each) / 2**14

    def is_mine(adversary):
        own = distance((0, 0), adversary, diagonal)
        return all(distance(mate, adversary, diagonal) >= own for mate in mates)

    def room(there):
        rays = ([(there[0] + k * r, there[1] + k * c) for k in range(half)] for r, c in MOVES[1:5])
        return min(next((k for k, cell in enumerate(ray) if cell in walls), half) for ray in rays)

    def forbidden(move):
        there = moves[move]
        may_enter, may_meet = contact(config.rules, team)
        answer = there in walls or there in mates
        answer |= there in adversaries and not may_enter
        for other, (r, c) in enumerate(moves[1:], start=1):
            origin = there[0] - r, there[1] - c
            first = in_order(step, other, n_actions) < in_order(step, move, n_actions)
            answer |= origin in mates and first
            answer |= origin in adversaries and not may_meet
        return move > 0 and answer

    mine = [adversary for adversary in adversaries if is_mine(adversary)] or adversaries
    sides = [
        side
        for adversary in adversaries
        for side in beside(adversary)
        if max(map(abs, side)) <= half and side not in walls and side not in mates
    ]
    free = [sum(cell not in walls for cell in beside(there)) for there in moves]

    def escapes(evader, pursuers):
        cells = [cell for cell in (evader, *beside(evader)) if cell not in walls]
        safe = [cell for cell in cells if all(distance(cell, p, diagonal) > 1 for p in pursuers)]
        return np.float32(len(safe)) / np.float32(n_actions)

    def opposite(evader, pursuer, other):
        (a, b), (c, d) = direction(evader, pursuer), direction(evader, other)
        return max((np.float32(1) - (a * c + b * d)) * np.float32(0.5), np.float32(0))

    def nearest_of(cells, there):
        least = min((distance(cell, there, diagonal) for cell in cells), default=None)
        return [cell for cell in cells if distance(cell, there, diagonal) == least]

    def odd(there):
        return min((distance(there, each, diagonal) for each in adversaries), default=0) % 2

    goals = nearest_of(adversaries, (0, 0))
    if team == "pursuer":
        left = [min((escapes(e, [there, *mates]) for e in goals), default=1) for there in moves]
        pairs = [(evader, mate) for evader in goals for mate in nearest_of(mates, evader)]
        held = [[opposite(e, there, mate) for e, mate in pairs] for there in moves]
    else:
        left = [escapes(there, adversaries) for there in moves]
        others = {p: [each for each in adversaries if each != p] for p in goals}
        pairs = [(p, other) for p in goals for other in nearest_of(others[p], (0, 0))]
        held = [[opposite(there, p, other) for p, other in pairs] for there in moves]
    return {
        "adversary": [nearest(there, adversaries) for there in moves],
        "pressure": [push(there, adversaries) for there in moves],
        "unclaimed": [nearest(there, mine) for there in moves],
        "open_side": [nearest(there, sides) for there in moves],
        "teammate": [nearest(there, mates) for there in moves],
        "exits": [n / (n_actions - 1) for n in free],
        "room": [unit * np.float32(room(there)) for there in moves],
        "must_yield": [int(forbidden(move)) for move in range(n_actions)],
        "ahead": [int(move == ahead) for move in range(n_actions)],
        "escapes": left,
        "opposite": [max(each, default=0) for each in held],
        "parity": [odd(there) for there in moves],
    }


def direction_of_stride(world, agent):
    """Return the direction that an agent draws for the present 12 steps."""
    word = _core.philox([agent, world.steps // 12, 3, 0], [world.seed, world.episode])[0]
    return 1 + word * (world.config.n_actions - 1) // 2**64


def all_slow_inputs(world):
    """Return by name what `World.inputs` returns, (A, moves), but for search, which is a plan."""
    config, views = world.config, world.views()
    shape = config.n_agents, config.n_actions
    found = {name: np.zeros(shape, np.float32) for name in mw.INPUTS if name != "search"}
    for agent in np.flatnonzero(world.alive):
        team = "pursuer" if agent < config.n_pursuers else "evader"
        ahead = direction_of_stride(world, int(agent))
        for name, values in slow_inputs(config, views[agent], team, world.steps, ahead).items():
            found[name][agent] = values
    return found
