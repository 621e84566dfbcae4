"""What all commands have in common."""

import os
import subprocess
import sys

import pytest

from kinlab.cli.commands import COMMANDS


def _modules(*args: str) -> set[str]:
    """The modules that a fresh `kinlab` has imported when it ends."""
    code = (
        "import sys\nfrom kinlab.cli import main\n"
        f"try:\n    main({list(args)!r})\nexcept SystemExit:\n    pass\n"
        "print('MODULES', *sys.modules)"
    )
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    return set(done.stdout.split("MODULES ")[1].split())


@pytest.mark.parametrize("command", COMMANDS)
def test_help_has_a_worked_example_that_names_the_command(kinlab, command):
    answer = kinlab(command, "--help")
    assert answer.code == 0
    assert f"Example: kinlab {command}" in answer.out


@pytest.mark.parametrize("command", COMMANDS)
def test_every_command_speaks_json(kinlab, command):
    assert "--json" in kinlab(command, "--help").out


def test_help_lists_every_command_and_imports_no_heavy_library(kinlab):
    assert all(command in kinlab("--help").out for command in COMMANDS)
    assert not _modules("--help") & {"numpy", "textual", "rerun", "rich", "pydantic", "yaml"}


def test_ik_in_json_imports_neither_a_table_nor_pydantic():
    loaded = _modules("ik", "xl430-hexapod", "75", "10", "-46", "--json")
    assert "numpy" in loaded
    assert not loaded & {"rich", "textual", "rerun", "pydantic", "scipy", "mujoco", "sympy"}


def test_version(kinlab):
    assert kinlab("--version").out.startswith("kinlab ")


def test_a_mistyped_command_is_answered_with_the_nearest(kinlab):
    answer = kinlab("ikk")
    assert answer.code == 2
    assert "Did you mean 'ik'" in answer.err


def test_no_command_shows_help(kinlab):
    answer = kinlab()
    assert answer.code == 0
    assert "Commands:" in answer.out


def test_python_m_kinlab_is_the_same_program():
    done = subprocess.run(
        [sys.executable, "-m", "kinlab", "fk", "udiebot", "0", "0", "0"],
        capture_output=True,
        text=True,
        check=False,
    )
    assert done.returncode == 0
    assert "(360, 0, 0) mm" in done.stdout


def test_a_closed_pipe_ends_quietly():
    command = f"'{sys.executable}' -m kinlab robots eros | head -1"
    done = subprocess.run(["bash", "-c", command], capture_output=True, text=True, check=False)
    assert done.stdout.startswith("eros")
    assert "Traceback" not in done.stderr


def test_without_utf8_the_answer_still_comes(monkeypatch):
    done = subprocess.run(
        [sys.executable, "-m", "kinlab", "ik", "xl430-hexapod", "75", "10", "-46"],
        capture_output=True, check=False, env={"PYTHONIOENCODING": "ascii", "COLUMNS": "100", "PATH": ""},
    )  # fmt: skip
    assert done.returncode == 0
    assert b"82.40" in done.stdout


def test_completion_offers_robots():
    from kinlab.cli.command import complete_robot

    assert complete_robot("ud") == ["udiebot"]


@pytest.mark.skipif(not os.path.exists("/dev/full"), reason="this system has no /dev/full")
@pytest.mark.parametrize("args", [["tour"], ["--help"], ["ik", "udiebot", "160", "0", "-140", "--json"]])
def test_a_full_disk_is_said_and_not_traced_back(args):
    with open("/dev/full", "w") as full:
        done = subprocess.run(
            [sys.executable, "-m", "kinlab", *args],
            stdout=full,
            stderr=subprocess.PIPE,
            text=True,
            check=False,
        )
    assert done.returncode == 1
    assert done.stderr == "kinlab: No space left on device\n"
