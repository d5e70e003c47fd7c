"""What the dice and the hands of the class material do, if a class plays by the rules.

    python docs/class_material/simulate.py

The dice are those of 50,000 groups. There is no chance in the hands: the first two decide the rest.
"""

import numpy as np

GROUPS, GENERATIONS, SIX = 50_000, 6, 6
CHANGES = np.array([-1, -1, 0, 0, 1, 1])  # by the third die


def play_dice(selection: bool, rng: np.random.Generator) -> tuple[np.ndarray, np.ndarray]:
    """Return each group's last mean, and how many of its six letters are left."""
    numbers = rng.integers(1, SIX + 1, (GROUPS, SIX))
    letters = np.tile(np.arange(SIX), (GROUPS, 1))
    row = np.arange(GROUPS)[:, None]
    for _ in range(GENERATIONS):
        first, second, third = rng.integers(SIX, size=(3, GROUPS, SIX))
        better = selection & (numbers[row, second] > numbers[row, first])
        parent = np.where(better, second, first)
        numbers, letters = numbers[row, parent] + CHANGES[third], letters[row, parent]
    left = (letters[:, :, None] == np.arange(SIX)).any(axis=1).sum(axis=1)
    return numbers.mean(axis=1), left


def answer_last(theirs: list[int]) -> int:
    """Return the hand that beats the other's last one."""
    return (theirs[-1] + 1) % 3


def answer_all(theirs: list[int]) -> int:
    """Return the hand that beats the other's most frequent one; of several, the latest."""
    counts = [theirs.count(hand) for hand in range(3)]
    return answer_last([hand for hand in theirs if counts[hand] == max(counts)])


def play_hands(answer, first: int, second: int, rounds: int) -> list[tuple[int, int]]:
    """Return the hands of both players in each round: 0 rock, 1 paper, 2 scissors."""
    mine, theirs = [first], [second]
    for _ in range(rounds - 1):
        mine, theirs = [*mine, answer(theirs)], [*theirs, answer(mine)]
    return [*zip(mine, theirs, strict=True)]


def main() -> None:
    """Print the numbers that `answers.md` quotes."""
    rng = np.random.default_rng(0)
    ends: dict[str, np.ndarray] = {}
    for name, selection in (("with", True), ("without", False)):
        means, left = play_dice(selection, rng)
        ends[name] = means
        low, high = np.quantile(means, [0.1, 0.9])
        print(f"{name} selection: mean {means.mean():.1f}, eight of ten {low:.1f} to {high:.1f}")
        print(f"    at most two letters left: {100 * (left <= 2).mean():.0f} % of the groups")
    below = np.searchsorted(np.sort(ends["without"]), ends["with"]) / GROUPS
    print(f"with above without: {100 * below.mean():.0f} % of all pairs of groups")
    for answer in (answer_last, answer_all):
        for first, second in ((0, 1), (0, 0)):
            hands = play_hands(answer, first, second, rounds=12)
            won = [sum((a - b) % 3 == side for a, b in hands) for side in (1, 2)]
            print(answer.__name__, " ".join("RPS"[a] + "RPS"[b] for a, b in hands), won)


if __name__ == "__main__":
    main()
