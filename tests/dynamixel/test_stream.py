"""The stream parser finds every packet, however the bytes arrive."""

import random
import tracemalloc
from itertools import pairwise

import pytest
from hypothesis import assume, given
from hypothesis import strategies as st

from kinlab.dynamixel.codec.packets import Packet, encode
from kinlab.dynamixel.codec.stream import LONGEST, StreamParser

PROTOCOLS = pytest.mark.parametrize("protocol", [1, 2])
# Parameters full of what could be taken for headers and short lengths.
NASTY = st.lists(st.sampled_from([0xFF, 0xFD, 0x00, 0x01, 0x02, 0x03, 0x55]), max_size=60).map(bytes)


def frames(protocol):
    return st.lists(
        st.builds(
            lambda i, c, p: encode(Packet(protocol, i, c, p)), st.integers(0, 252), st.integers(1, 9), NASTY
        ),
        max_size=8,
    )


def chunks(data, cuts):
    edges = [0, *sorted(cut % (len(data) + 1) for cut in cuts), len(data)]
    return [data[a:b] for a, b in pairwise(edges)]


@PROTOCOLS
@given(data=st.data(), cuts=st.lists(st.integers(0, 10_000), max_size=30))
def test_whole_packets_arrive_whole_however_they_are_cut(protocol, data, cuts):
    sent = data.draw(frames(protocol))
    parser = StreamParser(protocol)
    got = [frame for chunk in chunks(b"".join(sent), cuts) for frame in parser.feed(chunk)]
    assert got == sent
    assert not parser.pending


@PROTOCOLS
@given(data=st.data(), noise=st.binary(max_size=40))
def test_a_good_packet_behind_any_noise_is_found(protocol, data, noise):
    good = data.draw(frames(protocol))
    parser = StreamParser(protocol)
    got = parser.feed(noise) + parser.feed(b"".join(good)) + parser.abandon()
    # Noise may hold a packet of its own, or pull the beginning of the first good one to itself.
    assert got[-len(good) :] == good if good else True


@PROTOCOLS
@given(data=st.data(), place=st.integers(0, 10_000), bit=st.integers(0, 7))
def test_a_bad_packet_takes_no_good_one_with_it(protocol, data, place, bit):
    first, *rest = data.draw(frames(protocol).filter(lambda found: len(found) > 1))
    bad = bytearray(first)
    bad[place % len(bad)] ^= 1 << bit
    parser = StreamParser(protocol)
    got = parser.feed(bytes(bad) + b"".join(rest)) + parser.abandon()
    assume(all(frame in rest for frame in got))  # else the damage has made another packet that is sound
    assert [frame for frame in got if frame in rest][-len(rest) :] == rest


def test_surplus_header_bytes_of_protocol_1_are_skipped():
    ping = encode(Packet(1, 1, 1))
    assert StreamParser(1).feed(b"\xff\xff\xff" + ping) == [ping]


def test_a_crc_that_looks_like_a_header_does_not_split_the_packet():
    raw = bytes.fromhex("FF FF FD 00 01 09 00 03 74 00 60 00 FF FF FD 89")
    assert StreamParser(2).feed(raw + raw) == [raw, raw]


def test_lengths_that_cannot_be_hold_nothing_up():
    good = encode(Packet(2, 1, 1))
    too_long = bytes.fromhex("FF FF FD 00 01") + (LONGEST + 1).to_bytes(2, "little")
    assert StreamParser(2).feed(too_long + good) == [good]
    assert StreamParser(2).feed(bytes.fromhex("FF FF FD 00 01 02 00") + good) == [good]
    assert StreamParser(1).feed(bytes.fromhex("FF FF 01 01") + encode(Packet(1, 1, 1))) == [
        encode(Packet(1, 1, 1))
    ]


@PROTOCOLS
def test_ten_million_random_bytes_neither_raise_nor_stay(protocol):
    source = random.Random(3)
    parser = StreamParser(protocol)
    good = encode(Packet(protocol, 7, 2, b"\x24\x00\x02\x00"))
    parser.feed(source.randbytes(100_000))
    tracemalloc.start()
    before = tracemalloc.get_traced_memory()[0]
    for _ in range(100):
        parser.feed(source.randbytes(100_000))
    grown = tracemalloc.get_traced_memory()[0] - before
    tracemalloc.stop()
    assert grown < 300_000
    parser.abandon()
    assert parser.feed(good) == [good]
