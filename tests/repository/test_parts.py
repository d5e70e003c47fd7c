"""Parts of the nightly tests: each test is in one of them, the same one everywhere."""

from collections import Counter
from types import SimpleNamespace

import shared
from slow import PARTS, part_of


class Item(SimpleNamespace):
    """A test, as far as the choice of tests looks at it."""

    def add_marker(self, mark):
        self.skipped = mark.kwargs["reason"]


def made_up():
    """Return tests of which each third is nightly, each fifth slow."""
    marks = {"nightly": 3, "slow": 5}
    return [
        Item(
            nodeid=f"tests/test_{n % 7}.py::test[{n}]",
            keywords={m for m in marks if n % marks[m] == 0},
        )
        for n in range(600)
    ]


def chosen(**options):
    """Return the names of tests that options play, and of those that they leave out."""
    items, left_out = made_up(), []
    config = SimpleNamespace(
        getoption=lambda name, default: options.get(name.strip("-").replace("-", "_"), default),
        hook=SimpleNamespace(pytest_deselected=lambda items: left_out.extend(items)),
    )
    shared.pytest_collection_modifyitems(config, items)
    names = [item.nodeid for item in items if not hasattr(item, "skipped")]
    return names, [item.nodeid for item in left_out]


def test_the_parts_together_are_all_nightly_tests_once():
    nightly = [item.nodeid for item in made_up() if "nightly" in item.keywords]
    others = [item.nodeid for item in made_up() if "nightly" not in item.keywords]
    assert chosen(nightly=True) == ([item.nodeid for item in made_up()], [])
    seen = Counter()
    for part in range(PARTS):
        played, left_out = chosen(nightly_part=part)
        assert sorted(played + left_out) == sorted(nightly + others)
        assert [name for name in played if name in others] == others
        mine = [name for name in played if name in nightly]
        assert len(nightly) / PARTS / 2 < len(mine) < len(nightly) / PARTS * 2
        seen.update(mine)
    assert seen == Counter(nightly)


def test_without_these_options_nightly_tests_are_skipped():
    played, left_out = chosen(slow=True)
    assert played == [item.nodeid for item in made_up() if "nightly" not in item.keywords]
    assert left_out == []


def test_parts_are_the_same_everywhere():
    names = ("tests/test_a.py::test_a", "tests/test_a.py::test_b[x]", "tests/b/test_b.py::test_c")
    assert [part_of(name) for name in names] == [9, 3, 4]
