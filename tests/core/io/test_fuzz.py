"""Thousands of broken files: each gives a mesh or one sentence, soon and in bounded memory.

The files are made of a square in every format, so that every byte of them matters.
"""

import random
import struct

import pytest

# VTK's formats are read in a process of their own, which takes longer: test_fuzz_vtk.py.
NAMES = ["text.ply", "little.ply", "big.ply", "text.obj", "text.off", "binary.off"]
NAMES += ["text.stl", "binary.stl", "binary.glb", "archive.3mf"]
TEXTS = [name for name in NAMES if name.startswith("text")]
BINARIES = [name for name in NAMES if not name.startswith("text")]
WORDS = [
    *("nan", "inf", "-inf", "-1", "0", "1e400", "-0", "4000000000", "99999999999999999999", "1_0"),
    *("9" * 5000, "#", "/", "\\", "\0", "ü", "", "1 1", "\n", "v", "f", "list", "3 0 1 2"),
    *("-9223372036854775808", "9223372036854775807", "0x10", "1e3", "½", "+1", "--1", "1."),
]
NUMBERS = [
    *(b"\xff" * 4, b"\x00" * 4, b"\xff\xff\xff\x7f", b"\x7f\xff\xff\xff", b"\x00\x00\xc0\x7f"),
    *(b"\x7f\xc0\x00\x00", b"\x00\x00\x80\xff", b"\x80\x00\x00\x00", b"\x00\x00\x00\x80"),
    struct.pack("<I", 4_000_000_000),
]


@pytest.mark.parametrize("name", NAMES)
def test_cut_short_anywhere(name, squares, attempt):
    content = squares[name]
    for length in range(1, len(content), max(1, len(content) // 150)):
        attempt(name, content[:length])


@pytest.mark.parametrize("name", NAMES)
def test_without_any_piece(name, squares, attempt):
    content, rng = squares[name], random.Random(f"cut {name}")
    for _ in range(100):
        start = rng.randrange(len(content))
        attempt(name, content[:start] + content[start + rng.choice([1, 4, 12, 60]) :])


@pytest.mark.parametrize("name", NAMES)
def test_with_flipped_bytes(name, squares, attempt):
    rng = random.Random(f"flip {name}")
    for _ in range(150):
        content = bytearray(squares[name])
        for _ in range(rng.choice([1, 1, 1, 2, 8, 64])):
            content[rng.randrange(len(content))] ^= 1 << rng.randrange(8)
        attempt(name, bytes(content))


@pytest.mark.parametrize("name", NAMES)
def test_with_pieces_doubled_or_moved(name, squares, attempt):
    rng = random.Random(f"move {name}")
    for _ in range(100):
        content = squares[name]
        start, length, to = (rng.randrange(len(content)) for _ in range(3))
        piece = content[start : start + length % 64] * rng.choice([1, 1, 2, 200])
        attempt(name, content[:to] + piece + content[to:])


@pytest.mark.parametrize("name", TEXTS)
def test_every_word_of_a_text_may_be_any_other(name, squares, attempt):
    words, rng = squares[name].decode().split(" "), random.Random(f"words {name}")
    for place in range(len(words)):
        for word in rng.sample(WORDS, 8):
            changed = [*words[:place], word, *words[place + 1 :]]
            attempt(name, " ".join(changed).encode())


@pytest.mark.parametrize("name", BINARIES)
def test_every_number_of_a_binary_file_may_be_any_other(name, squares, attempt):
    content, rng = squares[name], random.Random(f"numbers {name}")
    for place in range(0, len(content) - 4, max(1, len(content) // 150)):
        number = rng.choice(NUMBERS)
        attempt(name, content[:place] + number + content[place + 4 :])


@pytest.mark.parametrize("name", NAMES)
@pytest.mark.parametrize("other", NAMES)
def test_a_wrong_extension_is_told(name, other, squares, attempt):
    suffix = name.partition(".")[2]
    is_right = suffix == other.partition(".")[2]
    assert bool(attempt(f"renamed.{suffix}", squares[other])) != is_right
