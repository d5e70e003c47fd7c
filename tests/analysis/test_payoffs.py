"""Payoffs from arrays and files; errors name file and line."""

from pathlib import Path

import numpy as np
import pytest

from matrixworld import analysis

MATRIX = np.array([[0.0, 0.25, 0.5], [0.75, 1.0, 0.125]])


def written(folder: Path, text: str) -> Path:
    path = folder / "payoff.csv"
    path.write_text(text, encoding="utf-8")
    return path


@pytest.mark.parametrize(
    "text",
    [
        "0,.25,.5\n.75,1,.125\n",
        "# capture rates\ne0,e1,e2\n\n0, .25, .5\n.75,1,.125",
        ",0,1,2\n0,0,0.25,0.5\n1,0.75,1,0.125\n",
        "\ufeff0,.25,.5\r\n.75,1,.125\r\n",
        "pursuer,evader,capture_rate\n1,2,.125\n0,0,0\n0,1,.25\n0,2,.5\n1,0,.75\n1,1,1\n",
        "Evader,note,Capture_rate,Pursuer\n"
        "5,a,0,3\n6,b,.25,3\n7,c,.5,3\n5,d,.75,4\n6,e,1,4\n7,f,.125,4",
    ],
)
def test_csv_files(tmp_path: Path, text: str) -> None:
    payoffs = analysis.read_payoffs(written(tmp_path, text))
    np.testing.assert_array_equal(payoffs.matrices, MATRIX[None])
    assert payoffs.scores is None


def test_csv_files_of_runs_and_episodes(tmp_path: Path) -> None:
    # Quarters: written as text and read without rounding.
    scores = np.random.default_rng(0).integers(0, 5, (2, 3, 4, 5)) / 4
    lines = ["run,pursuer,evader,episode,capture_rate"]
    lines += [",".join(map(str, key)) + f",{rate}" for key, rate in np.ndenumerate(scores)]
    path = written(tmp_path, "\n".join(lines))
    payoffs = analysis.read_payoffs(path)
    np.testing.assert_array_equal(payoffs.scores, scores)
    np.testing.assert_allclose(payoffs.matrices, scores.mean(axis=3))
    # The header and run 0.
    without_run = [line.split(",", 1)[1] for line in lines if line[0] in "r0"]
    single = analysis.read_payoffs(written(tmp_path, "\n".join(without_run)))
    np.testing.assert_array_equal(single.scores, scores[:1])


@pytest.mark.parametrize(
    ("text", "message"),
    [
        ("", "expected a table of capture rates, got no lines"),
        ("0,1\n0\n", "line 2: expected 2 cells as in the lines before, got 1"),
        ("0,1\n\n0,x\n", r"line 3: expected a capture rate in \[0, 1\], got 'x'"),
        ("pursuer,evader,capture_rate\n0,a,0\n", "line 2: expected whole numbers, got '0', 'a'"),
        (
            "pursuer,evader,capture_rate\n0,0,1\n0,0,1\n",
            "line 3: expected pursuer 0, evader 0 once",
        ),
        ("pursuer,evader,capture_rate\n0,0,1\n1,1,1\n", "got none for pursuer 0, evader 1"),
    ],
)
def test_bad_csv_files_are_refused(tmp_path: Path, text: str, message: str) -> None:
    path = written(tmp_path, text)
    with pytest.raises(ValueError, match=message) as caught:
        analysis.read_payoffs(path)
    assert str(caught.value).startswith(str(path))


def test_npz_files(tmp_path: Path) -> None:
    path = tmp_path / "payoff.npz"
    scores = np.random.default_rng(1).random((3, 4, 5), dtype=np.float32)
    np.savez(path, capture_rate=scores.mean(axis=2), capture_rates=scores, lengths=np.ones(3))
    found = analysis.read_payoffs(str(path))
    np.testing.assert_array_equal(found.scores, scores[None])
    np.savez(path, capture_rate=MATRIX, lengths=np.ones(3))
    np.testing.assert_array_equal(analysis.read_payoffs(path).matrices, MATRIX[None])
    np.savez_compressed(path, anything=np.stack([MATRIX, MATRIX]))
    assert analysis.read_payoffs(path).matrices.shape == (2, 2, 3)


def test_files_with_other_contents_are_refused(tmp_path: Path) -> None:
    path = tmp_path / "payoff.npz"
    np.savez(path, one=MATRIX, two=MATRIX)
    with pytest.raises(ValueError, match=r"one array, or one named .*got \['one', 'two'\]"):
        analysis.read_payoffs(path)
    np.savez(path, payoff=MATRIX + 1)
    with pytest.raises(ValueError, match=r"payoff.npz: .*\[0, 1\], got 1.25 at index \(0, 1\)"):
        analysis.read_payoffs(path)
    with pytest.raises(ValueError, match="expected a .csv or an .npz file, got suffix '.txt'"):
        analysis.read_payoffs("payoff.txt")
    with pytest.raises(FileNotFoundError, match="none.csv"):
        analysis.read_payoffs(tmp_path / "none.csv")


def test_several_files_are_several_runs(tmp_path: Path) -> None:
    one, two = tmp_path / "one.npz", tmp_path / "two.npz"
    np.savez(one, payoff=MATRIX)
    np.savez(two, payoff=MATRIX / 2)
    csv = written(tmp_path, "0,.25,.5\n.75,1,.125\n")
    found = analysis.read_payoffs([one, str(two), csv])
    np.testing.assert_array_equal(found.matrices, [MATRIX, MATRIX / 2, MATRIX])
    np.savez(two, payoff=MATRIX.T)
    with pytest.raises(ValueError, match="two.npz: expected the shape of"):
        analysis.read_payoffs([one, two])


def test_arrays() -> None:
    assert analysis.read_payoffs(MATRIX.tolist()).matrices.shape == (1, 2, 3)
    assert analysis.read_payoffs(np.zeros((4, 2, 3))).matrices.shape == (4, 2, 3)
    for shape in ((2, 3, 5), (1, 2, 3, 5)):
        found = analysis.read_payoffs(np.zeros(shape), per_episode=True)
        assert found.scores.shape == (1, 2, 3, 5)
    for bad, per_episode in ((np.zeros(3), False), (np.zeros((2,) * 4), False), (MATRIX, True)):
        with pytest.raises(ValueError, match="none of them empty, got shape"):
            analysis.read_payoffs(bad, per_episode=per_episode)
