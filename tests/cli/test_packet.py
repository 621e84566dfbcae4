"""`kinlab packet` as a shell runs it."""

import subprocess
import sys

import pytest


def test_decode_keeps_the_contract(kinlab):
    answer = kinlab("packet", "decode", "FF", "FF", "01", "05", "03", "1E", "52", "02", "84", "--json")
    assert answer.code == 0
    assert answer.json["instruction"] == "WRITE"
    assert {"name", "offset", "bytes", "value", "meaning"} <= set(answer.json["fields"][0])
    assert sum(len(f["bytes"].split()) for f in answer.json["fields"]) == 9


def test_a_damaged_packet_is_taken_apart_as_far_as_it_goes(kinlab):
    answer = kinlab("packet", "decode", "FFFF010503 1E520285", "--json")
    assert answer.code == 1
    assert answer.json["ok"] is False
    assert answer.json["problems"][0]["offset"] == 8
    assert kinlab("packet", "decode", "FF FF 01").code == 1


def test_build_is_the_inverse_of_decode(kinlab):
    built = kinlab("packet", "build", "write", 1, "goal_position", "594", "--json")
    assert built.json["packet"] == "FF FF 01 05 03 1E 52 02 84"
    decoded = kinlab("packet", "decode", built.json["packet"], "--json")
    assert decoded.json["fields"] == built.json["fields"]


def test_build_takes_negative_numbers_and_another_model(kinlab):
    built = kinlab("packet", "build", "write", 3, "goal_position", -1, "--model", "XL430", "--json")
    assert built.json["packet"] == "FF FF FD 00 03 09 00 03 74 00 FF FF FF FF E3 C9"


def test_crc(kinlab):
    answer = kinlab("packet", "crc", "FF FF FD 00 01 03 00 01", "--json")
    assert answer.json["crc"] == 0x4E19
    assert answer.json["crc_bytes"] == "19 4E"
    assert kinlab("packet", "crc", "FF FF 01 02 01", "--json").json["checksum"] == 0xFB


def test_table(kinlab):
    text = kinlab("packet", "table", "RX-24F").out
    assert "RX-24F: model number 24, Protocol 1.0" in text
    assert "goal_position" in text
    assert len(kinlab("packet", "table", "RX", "--json").json["registers"]) == 37


@pytest.mark.parametrize(
    ("args", "code", "word"),
    [
        (["decode", "FF", "GG"], 2, "position 4"),
        (["build", "write", "1", "goal_positon", "1"], 2, "did you mean goal_position"),
        (["build", "pong", "1"], 2, "did you mean ping"),
        (["table", "RX-42F"], 2, "RX-24F"),
        (["-c", "pong 1"], 2, "did you mean ping"),
        (["-c", "ping 1; expect silence"], 1, "expected silence"),
        (["-c", "ping 9"], 1, "no intact answer"),
        (["--port", "/dev/there-is-none", "-c", "ping 1"], 1, "no such device"),
        (["none.dxl"], 2, "none.dxl"),
        (["nonsense"], 2, "No such command"),
    ],
)
def test_mistakes(kinlab, args, code, word):
    answer = kinlab("packet", *args)
    assert answer.code == code
    assert word in answer.err


def test_lines_from_the_command_line(kinlab):
    answer = kinlab(
        "packet", "-c", "trace off; write 1 goal_position 90deg; wait 0.5; read 1 present_position"
    )
    assert answer.code == 0
    assert "Present Position 307" in answer.out


def test_lines_as_one_json_document_even_when_they_fail(kinlab):
    answer = kinlab("packet", "--json", "-c", "ping 1; ping 9; ping 2")
    assert answer.code == 1
    assert [r["line"] for r in answer.json["results"]] == ["ping 1", "ping 9"]
    assert answer.json["results"][0]["exchange"]["answers"][0]["ok"] is True


def test_lines_from_a_file(kinlab, tmp_path):
    script = tmp_path / "lesson.dxl"
    script.write_text("ping 1\nexpect FF FF 01 02 00 FC\n")
    assert kinlab("packet", script).code == 0
    script.write_text("ping 1\nexpect silence\n")
    failed = kinlab("packet", script)
    assert failed.code == 1
    assert "line 2" in failed.err


def test_lines_from_standard_input():
    done = subprocess.run(
        [sys.executable, "-m", "kinlab", "packet"],
        input="trace off\nping 1\n",
        capture_output=True,
        text=True,
    )
    assert (done.returncode, done.stdout) == (0, "servo 1: ok\n")


def test_a_robot_is_a_chain(kinlab):
    answer = kinlab("packet", "--chain", "xl430-hexapod", "--json", "-c", "scan")
    servos = answer.json["results"][0]["servos"]
    assert [s["id"] for s in servos] == list(range(1, 19))
    assert [s["model"] for s in servos[:3]] == ["2XL430-W250-T", "2XL430-W250-T", "XL430-W250-T"]


def test_a_line_imports_neither_numpy_nor_a_face():
    code = (
        "import sys\nfrom kinlab.cli import main\n"
        "try:\n    main(['packet', '-c', 'ping 1'])\nexcept SystemExit:\n    pass\n"
        "print('MODULES', *sys.modules)"
    )
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    loaded = set(done.stdout.split("MODULES ")[1].split())
    assert not loaded & {"numpy", "prompt_toolkit", "rich", "serial", "textual", "pydantic", "yaml"}
