"""The files of runs: how they are made, read, written and gone on with."""
