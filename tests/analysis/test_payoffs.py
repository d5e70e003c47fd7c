"""Payoffs from arrays and files; errors name file and line."""

import numpy as np
import pytest

from matrixworld import analysis

MATRIX = np.array([[0.0, 0.25, 0.5], [0.75, 1.0, 0.125]])


def written(folder, text):
    path = folder / "payoff.csv"
    path.write_bytes(text.encode() if isinstance(text, str) else text)
    return path


NOTED = "note;Evader;Capture rate;Pursuer\n;2;0;0\né;5;,25;0\n;9;0,5;0\n" + (
    "b;2;.75;3\n;5;1,0;3\n;9;1,25e-1;3\n"
)


@pytest.mark.parametrize(
    "text",
    [
        "0,.25,.5\n.75,1,.125\n",
        "# capture rates; of pursuers\ne0,e1,e2\n\n0, .25, .5\n.75,1,.125\n,,\n",
        "\ufeff0,.25,.5\r\n.75,1,.125\r\n",
        # Labels: a table of pandas, with and without a name; archived generations; agents.
        ",0,1,2\n0,0.0,0.25,0.5\n1,0.75,1.0,0.125\n",
        "pursuer,0,1,2\n0,0.0,0.25,0.5\n1,0.75,1.0,0.125\n",
        ";0;10;20\n0;0;0,25;0,5\n10;0,75;1;0,125\n",
        ",amy,bob,cy\nzed,0,.25,.5\nyves,.75,1,.125\n",
        # As spreadsheets and NumPy write it in some countries.
        "0;,25;0,5\n0,75;1,0;0,125\n",
        '0,"0,25","0,5"\n"0,75",1,"0,125"\n',
        "0\t0,25\t0.5\n0,75\t1\t.125\n",
        "-1e-12,.25,.5\n.75,1.000000000001,.125\n",
        "0,.25,.5\r.75,1,.125".encode("utf-8-sig"),
        # One line for each pair; with an index, as pandas writes it.
        "pursuer,evader,capture_rate\n1,2,.125\n0,0,0\n0,1,.25\n0,2,.5\n1,0,.75\n1,1,1\n",
        ",pursuer,evader,capture_rate\n0,3,5,0\n1,3,6,.25\n2,3,7,.5\n3,4,5,.75\n4,4,6,1\n5,4,7,.125",
        NOTED,
    ],
)  # fmt: skip
def test_csv_files(tmp_path, text):
    payoffs = analysis.read_payoffs(written(tmp_path, text))
    np.testing.assert_array_equal(payoffs.matrices, MATRIX[None])
    assert payoffs.scores is None


def test_csv_files_of_runs_and_episodes(tmp_path):
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


LONG = "pursuer,evader,capture_rate\n"


@pytest.mark.parametrize(
    ("text", "message"),
    [
        ("", "expected a table of capture rates, got no lines"),
        ("a,b\n", "expected lines of capture rates, got a header only"),
        ("0,1\n0\n", "line 2: expected 2 cells as in the first line, got 1"),
        ("0,1\n\n0,x\n", r"line 3: expected a capture rate in \[0, 1\], got 'x'"),
        # A line with a number is no header, and no line vanishes.
        ("0.5,,0.7\n0.4,0.5,0.6\n", r"line 1: expected a capture rate in \[0, 1\], got ''"),
        (",0.5\n0.4,0.5\n", "line 1: .* got ''"),
        ("50,60\n40,30\n", "line 1: .* got '50'"),
        ("0_1,0.5\n", "line 1: .* got '0_1'"),
        ("0.5 0.6\n0.4 0.3\n", "line 2: .* got '0.4 0.3'"),
        ("who,x,y\nzed,.5,.6\n1,.4,.3\n", "line 2: .* got 'zed'"),
        ("zed,.5,.6\namy,.4,.3\n", "line 1: .* got 'zed'"),
        ('.5,".6\n.4,.3\n', "expected a CSV file, got: unexpected end"),
        (b"\x89PNG\0\1\2\3", "expected a CSV file of text"),
        ("pursuer,evader,rate\n0,0,.5\n", "line 1: .* once each, got pursuer, evader, rate"),
        ("pursuer,capture_rate\n0,.5\n", "line 1: expected the columns pursuer, evader and"),
        (LONG, "expected lines of capture rates, got a header only"),
        (LONG + "0,,1\n", r"line 2: expected numbers of pursuer, evader, got \['0', ''\]"),
        (LONG + "0,1.0,1\n", r"line 2: expected numbers of .* got \['0', '1.0'\]"),
        (LONG + "0,0,1\n0,0,1\n", "line 3: expected pursuer 0, evader 0 once.* column episode"),
        (LONG + "0,0,1\n1,1,1\n", "got none for pursuer 0, evader 1"),
    ],
)  # fmt: skip
def test_bad_csv_files_are_refused(tmp_path, text, message):
    path = written(tmp_path, text)
    with pytest.raises(ValueError, match=message) as caught:
        analysis.read_payoffs(path)
    assert str(caught.value).startswith(str(path))


def test_npz_files(tmp_path):
    path = tmp_path / "payoff.npz"
    scores = np.random.default_rng(1).random((3, 4, 5), dtype=np.float32)
    np.savez(path, mean=scores.mean(axis=2), scores=scores, lengths=np.ones(3))
    found = analysis.read_payoffs(str(path))
    np.testing.assert_array_equal(found.scores, scores[None])
    np.savez(path, capture_rate=MATRIX, lengths=np.ones(3))
    np.testing.assert_array_equal(analysis.read_payoffs(path).matrices, MATRIX[None])
    np.savez_compressed(path, anything=np.stack([MATRIX, MATRIX]))
    assert analysis.read_payoffs(path).matrices.shape == (2, 2, 3)


def test_files_with_other_contents_are_refused(tmp_path):
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


def test_several_files_are_several_runs(tmp_path):
    one, two = tmp_path / "one.npz", tmp_path / "two.npz"
    np.savez(one, payoff=MATRIX)
    np.savez(two, payoff=MATRIX / 2)
    csv = written(tmp_path, "0,.25,.5\n.75,1,.125\n")
    found = analysis.read_payoffs([one, str(two), csv])
    np.testing.assert_array_equal(found.matrices, [MATRIX, MATRIX / 2, MATRIX])


def test_arrays():
    assert analysis.read_payoffs(MATRIX.tolist()).matrices.shape == (1, 2, 3)
    assert analysis.read_payoffs(np.zeros((4, 2, 3))).matrices.shape == (4, 2, 3)
    for shape in ((2, 3, 5), (1, 2, 3, 5)):
        scores = np.random.default_rng(0).random(shape)
        found = analysis.read_payoffs(scores, per_episode=True)
        assert found.scores.shape == (1, 2, 3, 5)
        thrice = analysis.read_payoffs(np.repeat(scores, 3, axis=-1), per_episode=True)
        np.testing.assert_array_equal(thrice.scores, found.scores)  # copies tell nothing more
    for bad, per_episode in ((np.zeros(3), False), (np.zeros((2,) * 4), False), (MATRIX, True)):
        with pytest.raises(ValueError, match="none of them empty, got shape"):
            analysis.read_payoffs(bad, per_episode=per_episode)
