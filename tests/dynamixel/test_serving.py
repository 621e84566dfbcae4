"""Emulated chains for other programs: ptys and TCP, and clients that behave as they like."""

import os
import signal
import socket
import stat
import subprocess
import sys
import termios
import threading
import time
import tty
from contextlib import ExitStack, suppress
from itertools import count

import pytest
import serial

from kinlab.cli import main
from kinlab.dynamixel import Bus, Chain, PortError
from kinlab.dynamixel.codec.packets import Packet, encode
from kinlab.dynamixel.serving import Server
from kinlab.dynamixel.serving.pty import PtyLink
from kinlab.dynamixel.serving.tcp import MOST_CLIENTS, TcpListener
from kinlab.errors import UsageError

PING = encode(Packet(1, 1, 1))
PONG = bytes.fromhex("FF FF 01 02 00 FC")
OTHER_PING, OTHER_PONG = encode(Packet(1, 2, 1)), bytes.fromhex("FF FF 02 02 00 FB")
PATIENCE = 60.0  # s that a busy machine may take to answer


@pytest.fixture
def serve(tmp_path):
    """A served chain of three AX-12A: its server, the link to its pty, its TCP address."""
    with ExitStack() as servers:
        numbers = count()

        def start(byte_times=False, **settings):
            link = PtyLink(tmp_path / f"tty{next(numbers)}", 1_000_000)
            listener = TcpListener("0")
            chain = Chain.of([("AX-12A", [i]) for i in (1, 2, 3)], byte_times=byte_times)
            server = servers.enter_context(Server(chain, listener, **settings))
            server.add(link)
            thread = threading.Thread(target=server.run)
            thread.start()
            servers.callback(thread.join)
            servers.callback(server.stop)
            host, port = listener.address.split(":")
            return server, link.link, (host, int(port))

        yield start


def receive(client, count):
    """At least that many bytes from a socket, or all that came."""
    client.settimeout(PATIENCE)
    data = b""
    while len(data) < count:
        try:
            piece = client.recv(4096)
        except TimeoutError:
            break
        if not piece:
            break
        data += piece
    return data


def patient(name):
    """A master that waits for its answer, however busy the machine is."""
    bus = Bus(str(name), protocol=1)
    bus.port.latency = PATIENCE
    return bus


def read(fd, count):
    """That many bytes from a descriptor that does not block."""
    end, data = time.monotonic() + PATIENCE, b""
    while len(data) < count and time.monotonic() < end:
        try:
            data += os.read(fd, 4096)
        except BlockingIOError:
            time.sleep(0.001)
    return data


class TestPty:
    def test_the_link_is_made_and_removed(self, tmp_path):
        link = PtyLink(tmp_path / "ttyDXL", 1_000_000)
        assert stat.S_ISCHR((tmp_path / "ttyDXL").stat().st_mode)
        assert link.baud == 1_000_000
        link.close()
        assert list(tmp_path.iterdir()) == []

    def test_two_chains_on_one_name_are_refused(self, tmp_path):
        first = PtyLink(tmp_path / "ttyDXL", 1_000_000)
        with pytest.raises(PortError, match="ttyDXL is there already"):
            PtyLink(tmp_path / "ttyDXL", 1_000_000)
        first.close()

    def test_a_file_of_that_name_is_left_alone(self, tmp_path):
        (tmp_path / "notes").write_text("precious")
        with pytest.raises(PortError, match="there already"):
            PtyLink(tmp_path / "notes", 1_000_000)
        assert (tmp_path / "notes").read_text() == "precious"

    def test_a_link_that_a_killed_chain_left_is_taken_over(self, tmp_path):
        (tmp_path / "ttyDXL").symlink_to("/dev/pts/999999")
        PtyLink(tmp_path / "ttyDXL", 1_000_000).close()

    def test_a_folder_that_is_not_there(self, tmp_path):
        with pytest.raises(PortError, match="cannot make the link"):
            PtyLink(tmp_path / "none" / "ttyDXL", 1_000_000)

    @pytest.mark.parametrize("exclusive", [True, False, None])
    def test_a_pyserial_client_with_a_blocking_read(self, serve, exclusive):
        _, link, _ = serve()
        with serial.Serial(str(link), 1_000_000, timeout=PATIENCE, exclusive=exclusive) as port:
            port.write(PING)
            assert port.read(6) == PONG

    def test_a_client_that_opens_the_file_bare_and_sets_nothing(self, serve):
        _, link, _ = serve()
        fd = os.open(link, os.O_RDWR | os.O_NOCTTY | os.O_NONBLOCK)
        os.write(fd, PING)
        assert read(fd, 6) == PONG
        os.close(fd)

    def test_a_client_that_sets_the_line_up_itself_and_flushes_both_ways(self, serve):
        _, link, _ = serve()
        fd = os.open(link, os.O_RDWR | os.O_NOCTTY | os.O_NONBLOCK)
        tty.setraw(fd)
        settings = termios.tcgetattr(fd)
        settings[4] = settings[5] = termios.B1000000
        termios.tcsetattr(fd, termios.TCSANOW, settings)
        termios.tcflush(fd, termios.TCIOFLUSH)
        for _ in range(20):
            os.write(fd, PING)
            termios.tcdrain(fd)
            assert read(fd, 6) == PONG
        os.close(fd)

    def test_a_client_that_writes_byte_by_byte(self, serve, eventually):
        _, link, _ = serve()
        with serial.Serial(str(link), 1_000_000, timeout=0.5) as port:

            def answered():
                for byte in PING:
                    port.write(bytes([byte]))
                    time.sleep(0.002)
                return port.read(6) == PONG

            # On a busy machine a byte may come so late that the servo has forgotten those before it.
            eventually(answered)

    def test_a_packet_swallowed_by_a_false_beginning_is_answered_after_a_pause(self, serve):
        _, link, _ = serve()
        with serial.Serial(str(link), 1_000_000, timeout=PATIENCE) as port:
            port.write(b"\xff\xff\x05\x40" + PING)
            assert port.read(6) == PONG

    def test_clients_that_come_and_go(self, serve):
        _, link, _ = serve()
        for _ in range(10):
            with serial.Serial(str(link), 1_000_000, timeout=PATIENCE) as port:
                port.write(PING)
                assert port.read(6) == PONG

    def test_control_characters_are_bytes_like_any_other(self, serve):
        _, link, _ = serve()
        with serial.Serial(str(link), 1_000_000, timeout=PATIENCE) as port:
            for address in (0x03, 0x04, 0x0A, 0x0D, 0x11, 0x13):
                port.write(encode(Packet(1, 1, 2, bytes([address, 1]))))
                assert len(port.read(7)) == 7

    def test_another_speed_is_silence_and_the_right_one_an_answer(self, serve):
        _, link, _ = serve()
        with serial.Serial(str(link), 57600, timeout=0.2) as port:
            port.write(PING)
            assert port.read(6) == b""
            port.baudrate = 1_000_000
            port.timeout = PATIENCE
            port.write(PING)
            assert port.read(6) == PONG

    def test_a_client_that_never_reads_does_not_stop_the_chain(self, serve, eventually):
        _, link, address = serve()
        with serial.Serial(str(link), 1_000_000, timeout=PATIENCE, write_timeout=PATIENCE) as port:
            for _ in range(4000):
                port.write(PING)
            with socket.create_connection(address) as other:
                other.sendall(PING)
                assert receive(other, 6) == PONG
            port.timeout = 0.5

            def answered():
                # What is left of the flood, cut anywhere, comes before the answer, or is thrown away under its reader.
                with suppress(serial.SerialException):
                    port.write(OTHER_PING)
                    return port.read_until(OTHER_PONG).endswith(OTHER_PONG)

            eventually(answered)

    def test_byte_times_delay_the_answer_and_lose_nothing(self, serve):
        _, link, _ = serve(byte_times=True)
        with serial.Serial(str(link), 1_000_000, timeout=PATIENCE) as port:
            for _ in range(20):
                port.write(PING)
                assert port.read(6) == PONG

    def test_the_master_of_this_house(self, serve):
        _, link, address = serve()
        for name in (str(link), "{}:{}".format(*address)):
            with patient(name) as bus:
                assert bus.ping(2).model == "AX-12A"
                bus.write(2, "goal_position", "100deg")
                assert bus.read(2, "goal_position") == 341


class TestTcp:
    def test_it_listens_on_loopback_unless_told_otherwise(self):
        listener = TcpListener("0")
        assert listener.address.startswith("127.0.0.1:")
        listener.close()

    @pytest.mark.parametrize("address", ["", "port", "127.0.0.1:99999", "127.0.0.1:"])
    def test_what_is_no_address(self, address):
        with pytest.raises(UsageError, match="no TCP address"):
            TcpListener(address)

    def test_a_port_that_is_taken(self):
        first = TcpListener("0")
        with pytest.raises(PortError, match="cannot listen"):
            TcpListener(first.address)
        first.close()

    def test_the_slow_the_flooding_and_the_vanishing_harm_no_other(self, serve):
        _, _, address = serve()
        slow, flood, gone = (socket.create_connection(address) for _ in range(3))
        stop = threading.Event()

        def pour():
            flood.settimeout(0.2)
            while not stop.is_set():
                try:
                    flood.sendall(PING * 50 + b"\xff\xff\x01\xfe" * 50)
                except OSError:
                    continue

        flooding = threading.Thread(target=pour)
        flooding.start()
        try:
            gone.sendall(PING[:3])
            gone.setsockopt(socket.SOL_SOCKET, socket.SO_LINGER, b"\1\0\0\0\0\0\0\0")
            gone.close()
            slow.sendall(PING[:2])
            with socket.create_connection(address) as good:
                for _ in range(20):
                    good.sendall(PING)
                    assert receive(good, 6) == PONG
            # Its two bytes may be forgotten by now, as a servo forgets them; a whole packet is answered.
            slow.sendall(PING)
            assert receive(slow, 6) == PONG
        finally:
            stop.set()
            flooding.join()
            slow.close()
            flood.close()

    def test_clients_beyond_the_limit_are_turned_away_at_once_and_harm_nobody(self, serve):
        _, _, address = serve()
        crowd = [socket.create_connection(address, timeout=PATIENCE) for _ in range(MOST_CLIENTS)]
        try:
            # All of the crowd is in when its last one is answered.
            for client in (crowd[-1], crowd[0]):
                client.sendall(PING)
                assert receive(client, 6) == PONG
            with socket.create_connection(address, timeout=PATIENCE) as late:
                assert late.recv(1) == b""
            crowd[0].sendall(PING)
            assert receive(crowd[0], 6) == PONG
        finally:
            for client in crowd:
                client.close()


def test_traffic_is_shown_to_whom_it_may_concern(serve):
    seen = []
    _, link, _ = serve(watch=lambda arrow, data, now: seen.append((arrow, data)))
    with serial.Serial(str(link), 1_000_000, timeout=PATIENCE) as port:
        port.write(PING)
        port.read(6)
    assert seen[:2] == [("->", PING), ("<-", PONG)]


def test_a_change_of_the_eeprom_is_reported_once(serve):
    changes = []
    server, link, _ = serve(after_change=lambda: changes.append(server.chain.eeprom_writes))
    with patient(link) as bus:
        bus.write(1, "led", 1)
        bus.write(1, "max_torque", 500)
        bus.read(1, "max_torque")
    assert len(changes) == 1


def test_a_port_that_is_unplugged_in_mid_transfer_is_a_clear_error(tmp_path):
    link = PtyLink(tmp_path / "tty", 1_000_000)
    bus = Bus(str(tmp_path / "tty"))
    link.close()
    with pytest.raises(PortError, match="is gone"):
        bus.ping(1)
    bus.close()


def test_a_busy_port_is_a_clear_error(serve):
    _, link, _ = serve()
    with Bus(str(link)), pytest.raises(PortError, match="another program has it"):
        Bus(str(link))


@pytest.mark.parametrize("sign", ["SIGINT", "SIGTERM"])
def test_emulate_ends_cleanly_and_removes_its_link(emulate, sign):
    link = emulate("--servo", "AX-12A:1")
    process = emulate.running[0]
    process.send_signal(getattr(signal, sign))
    out, _ = process.communicate(timeout=PATIENCE)
    assert process.returncode == 0
    assert not os.path.lexists(link)
    assert "Serial port" in out


@pytest.mark.parametrize("sign", [signal.SIGINT, signal.SIGTERM, signal.SIGHUP])
def test_a_signal_as_soon_as_the_link_is_there_leaves_none_behind(tmp_path, monkeypatch, sign):
    class Hasty(PtyLink):
        def __init__(self, link, baud):
            super().__init__(link, baud)
            os.kill(os.getpid(), sign)

    monkeypatch.setattr("kinlab.dynamixel.serving.pty.PtyLink", Hasty)
    before = signal.getsignal(sign)
    with pytest.raises(SystemExit) as done:
        main(["emulate", "--servo", "AX-12A:1", "--pty", str(tmp_path / "ttyDXL")])
    assert done.value.code in (0, None)
    assert list(tmp_path.iterdir()) == []
    assert signal.getsignal(sign) == before


def test_a_second_emulate_on_the_same_link_is_refused(emulate):
    link = emulate("--servo", "AX-12A:1")
    command = [sys.executable, "-m", "kinlab", "emulate", "--servo", "AX-12A:1", "--pty", str(link)]
    done = subprocess.run(command, capture_output=True, text=True, timeout=PATIENCE)
    assert done.returncode == 1
    assert "there already" in done.stderr
    with patient(link) as bus:
        assert bus.ping(1).id == 1


def test_emulate_breaks_servos_on_purpose(emulate, eventually):
    faults = ("--fault", "1:overload", "--fault", "2:dead", "--fault", "3:baud 57600")
    with patient(emulate("--servo", "AX-12A:1-4", *faults, "--volts", "11.1")) as bus:
        assert bus.read(4, "present_voltage") == 111
        assert bus.read(1, "torque_limit") == 0
        assert bus.alarms[1] == ["overload"]
        bus.port.latency = 0.2
        eventually(lambda: [found.id for found in bus.scan(range(1, 5))] == [1, 4])


def test_emulate_keeps_its_eeprom(emulate, tmp_path):
    store = tmp_path / "eeprom.json"
    link = emulate("--servo", "AX-12A:1", "--eeprom", str(store))
    with patient(link) as bus:
        bus.write(1, "id", 42)
    emulate.running[0].terminate()
    emulate.running[0].communicate(timeout=PATIENCE)
    with patient(emulate("--servo", "AX-12A:1", "--eeprom", str(store))) as bus:
        assert bus.ping(42).id == 42
