"""ROBOTIS's own dynamixel-sdk, unmodified, takes the emulated chain for hardware."""

import time
from collections.abc import Callable, Iterator
from pathlib import Path

import dynamixel_sdk as sdk
import pytest

OK = sdk.COMM_SUCCESS
SINGLE = A, B, C, D, E = 3, 6, 9, 12, 15  # XL430 of the hexapod; most others are axes of 2XL430
TORQUE, LED, GOAL_VELOCITY, PROFILE, GOAL, POSITION = 64, 65, 104, 112, 116, 132


class Port(sdk.PortHandler):  # type: ignore[misc]
    """The SDK's port, that waits longer for an answer where it is told to: a busy machine may not keep its 34 ms."""

    more_ms = 0.0

    def setPacketTimeout(self, packet_length: int) -> None:  # noqa: N802
        super().setPacketTimeout(packet_length)
        self.packet_timeout += self.more_ms


class Client:
    """A port and packet handler of the SDK."""

    def __init__(self, link: Path, protocol: float, baud: int) -> None:
        self.port = Port(str(link))
        assert self.port.openPort()
        assert self.port.setBaudRate(baud)
        self.packets = sdk.PacketHandler(protocol)

    def __getattr__(self, name: str) -> Callable[..., object]:
        """A call that waits for its answer: to be repeated, most orders would have to be carried out twice."""

        def call(*arguments: object) -> object:
            self.port.more_ms = 60_000.0
            try:
                return getattr(self.packets, name)(self.port, *arguments)
            finally:
                self.port.more_ms = 0.0

        return call

    def hears_nothing_of(self, servo: int) -> bool:
        return self.packets.ping(self.port, servo)[1] == sdk.COMM_RX_TIMEOUT

    def comes_back(self, servo: int) -> None:
        """Ping, without patience, until it answers."""
        until(lambda: self.packets.ping(self.port, servo)[1], OK.__eq__)


@pytest.fixture(params=[57600, 1_000_000, 4_000_000])
def x(emulate: Callable[..., Path], request: pytest.FixtureRequest) -> Iterator[Client]:
    """The hexapod's chain, as the README starts it, at different speeds."""
    client = Client(emulate("xl430-hexapod", "--baud", str(request.param)), 2.0, request.param)
    yield client
    client.port.closePort()


@pytest.fixture(params=[57600, 1_000_000])
def ax(emulate: Callable[..., Path], request: pytest.FixtureRequest) -> Iterator[Client]:
    """Three AX-12A at different speeds."""
    link = emulate("--servo", "AX-12A:1-3", "--baud", str(request.param))
    client = Client(link, 1.0, request.param)
    yield client
    client.port.closePort()


def until(read: Callable[[], object], wanted: Callable[[object], bool]) -> object:
    """Read until the value is as wanted."""
    end = time.monotonic() + 60
    while not wanted(value := read()):
        assert time.monotonic() < end, value
    return value


def test_protocol_2_whole_session(x: Client) -> None:
    # Ping, one and all.
    assert x.ping(A) == (1060, OK, 0)
    assert x.hears_nothing_of(99)
    found, result = x.broadcastPing()
    assert result == OK
    assert found == {i: [1090 if i % 3 else 1060, 46] for i in range(1, 19)}

    # Write and read 1, 2 and 4 bytes.
    assert x.write1ByteTxRx(A, LED, 1) == (OK, 0)
    assert x.read1ByteTxRx(A, LED) == (1, OK, 0)
    assert x.write2ByteTxRx(A, 84, 800) == (OK, 0)
    assert x.read2ByteTxRx(A, 84) == (800, OK, 0)
    assert x.write4ByteTxRx(A, PROFILE, 300) == (OK, 0)
    assert x.read4ByteTxRx(A, PROFILE) == (300, OK, 0)

    # Errors come as errors.
    assert x.write4ByteTxRx(A, GOAL, 5000) == (OK, 6)
    assert x.write1ByteTxRx(A, POSITION, 5) == (OK, 7)

    # It moves.
    for servo in SINGLE:
        assert x.write1ByteTxRx(servo, TORQUE, 1) == (OK, 0)
    assert x.write4ByteTxRx(B, GOAL, 2300) == (OK, 0)
    until(lambda: x.read4ByteTxRx(B, POSITION)[0], lambda ticks: abs(int(str(ticks)) - 2300) < 10)

    # Sync write and sync read, plain and fast.
    write = sdk.GroupSyncWrite(x.port, x.packets, PROFILE, 4)
    for servo in SINGLE:
        assert write.addParam(servo, (servo * 10).to_bytes(4, "little"))
    assert write.txPacket() == OK
    read = sdk.GroupSyncRead(x.port, x.packets, PROFILE, 4)
    for servo in SINGLE:
        assert read.addParam(servo)
    until(read.txRxPacket, OK.__eq__)
    assert [read.getData(servo, PROFILE, 4) for servo in SINGLE] == [30, 60, 90, 120, 150]
    until(read.fastSyncRead, OK.__eq__)
    assert [read.getData(servo, PROFILE, 4) for servo in SINGLE] == [30, 60, 90, 120, 150]

    # Bulk write and bulk read, plain and fast.
    bulk_write = sdk.GroupBulkWrite(x.port, x.packets)
    assert bulk_write.addParam(A, LED, 1, [0])
    assert bulk_write.addParam(B, PROFILE, 4, list((77).to_bytes(4, "little")))
    assert bulk_write.txPacket() == OK
    bulk = sdk.GroupBulkRead(x.port, x.packets)
    assert bulk.addParam(A, LED, 1)
    assert bulk.addParam(B, PROFILE, 4)
    for transfer in (bulk.txRxPacket, bulk.fastBulkRead):
        until(transfer, OK.__eq__)
        assert (bulk.getData(A, LED, 1), bulk.getData(B, PROFILE, 4)) == (0, 77)

    # Registered write waits for the action.
    assert x.regWriteTxRx(C, LED, 1, [1]) == (OK, 0)
    assert x.read1ByteTxRx(C, 69) == (1, OK, 0)
    assert x.read1ByteTxRx(C, LED) == (0, OK, 0)
    assert x.action(sdk.BROADCAST_ID) == OK
    assert x.read1ByteTxRx(C, LED) == (1, OK, 0)

    # Reboot: deaf for a moment, then the RAM is as at power-on.
    assert x.reboot(B) == (OK, 0)
    x.comes_back(B)
    assert x.read4ByteTxRx(B, PROFILE) == (0, OK, 0)
    assert x.read1ByteTxRx(B, TORQUE) == (0, OK, 0)
    assert x.clearMultiTurn(B) == (OK, 0)

    # Factory reset that keeps id and baud rate.
    assert x.write1ByteTxRx(E, TORQUE, 0) == (OK, 0)
    assert x.write1ByteTxRx(E, 11, 1) == (OK, 0)
    assert x.factoryReset(E, 2) == (OK, 0)
    x.comes_back(E)
    assert x.read1ByteTxRx(E, 11) == (3, OK, 0)


def test_a_factory_reset_that_keeps_nothing(emulate: Callable[..., Path]) -> None:
    client = Client(emulate("--servo", "XL430-W250:7"), 2.0, 1_000_000)
    assert client.factoryReset(7, 0xFF) == (OK, 0)
    assert client.port.setBaudRate(57600)
    client.comes_back(1)
    assert client.ping(1) == (1060, OK, 0)


def test_the_id_and_the_baud_rate_change_after_the_answer(x: Client) -> None:
    assert x.write1ByteTxRx(D, 7, 40) == (OK, 0)
    assert x.ping(40) == (1060, OK, 0)
    assert x.hears_nothing_of(D)
    assert x.write1ByteTxRx(40, 8, 4) == (OK, 0)
    assert x.hears_nothing_of(40)
    assert x.port.setBaudRate(2_000_000)
    assert x.ping(40) == (1060, OK, 0)


def test_protocol_1_whole_session(ax: Client) -> None:
    assert ax.ping(1) == (12, OK, 0)
    assert ax.hears_nothing_of(99)
    assert ax.write1ByteTxRx(1, 25, 1) == (OK, 0)
    assert ax.read1ByteTxRx(1, 25) == (1, OK, 0)
    assert ax.write2ByteTxRx(1, 30, 700) == (OK, 0)
    assert ax.read2ByteTxRx(1, 30) == (700, OK, 0)
    until(lambda: ax.read2ByteTxRx(1, 36)[0], lambda ticks: abs(int(str(ticks)) - 700) < 10)
    assert ax.read4ByteTxRx(1, 30)[1:] == (OK, 0)
    assert ax.write2ByteTxRx(1, 30, 2000)[1] == sdk.ERRBIT_RANGE

    write = sdk.GroupSyncWrite(ax.port, ax.packets, 30, 2)
    for servo in (1, 2, 3):
        assert write.addParam(servo, (500 + servo).to_bytes(2, "little"))
    assert write.txPacket() == OK
    assert [ax.read2ByteTxRx(servo, 30)[0] for servo in (1, 2, 3)] == [501, 502, 503]

    assert ax.regWriteTxRx(2, 30, 2, [100, 0]) == (OK, 0)
    assert ax.read2ByteTxRx(2, 30)[0] == 502
    assert ax.action(sdk.BROADCAST_ID) == OK
    assert ax.read2ByteTxRx(2, 30)[0] == 100

    assert ax.factoryReset(3) == (OK, 0)
    assert ax.port.setBaudRate(1_000_000)
    # Reset, servo 3 has the id 1 and 1 Mbps.
    assert ax.hears_nothing_of(3)


def test_another_speed_is_silence(emulate: Callable[..., Path]) -> None:
    client = Client(emulate("--servo", "XL430-W250:1", "--baud", "1000000"), 2.0, 57600)
    assert client.hears_nothing_of(1)
    assert client.port.setBaudRate(1_000_000)
    assert client.ping(1) == (1060, OK, 0)


def test_a_chain_with_both_protocols(emulate: Callable[..., Path]) -> None:
    link = emulate("--servo", "AX-12A:1", "--servo", "2XL430-W250:2,3")
    old, new = Client(link, 1.0, 1_000_000), Client(link, 2.0, 1_000_000)
    assert old.ping(1) == (12, OK, 0)
    assert new.ping(2) == (1090, OK, 0)
    assert new.ping(3) == (1090, OK, 0)
    assert old.hears_nothing_of(2)


@pytest.mark.parametrize("value", [-131073, -1, 0x00FDFFFF])
def test_data_that_look_like_a_header_arrive(emulate: Callable[..., Path], value: int) -> None:
    """The SDK for Python sends FF FF FD without stuffing; a length-driven parser takes it all the same."""
    client = Client(emulate("--servo", "XL430-W250:1"), 2.0, 1_000_000)
    assert client.write1ByteTxRx(1, 11, 4) == (OK, 0)
    assert client.write4ByteTxRx(1, 20, 0) == (OK, 0)
    raw = value & 0xFFFFFFFF
    expected = 0 if abs(value) < 1048576 else 4
    assert client.write4ByteTxRx(1, GOAL, raw) == (OK, expected)
    if not expected:
        assert client.read4ByteTxRx(1, GOAL) == (raw, OK, 0)
