"""What test_apart.py lets another process do; like all such files it imports nothing of ours."""

import ctypes
import os
import sys
import time

import numpy as np


def squares(numbers):
    for number in numbers:
        yield np.full(3, number**2)


def prints():
    sys.stdout.write("noise")
    os.write(1, b"noise")
    sys.stdout.flush()
    yield "said"


def keeps_the_lock():
    """Sleep in C code that keeps the interpreter lock."""
    yield os.getpid()
    ctypes.PyDLL(None).sleep(600)


def refuses():
    yield 1
    raise ValueError("This cannot be done.")


def breaks():
    yield 1
    raise KeyError("a fault")


def has_too_little_memory():
    raise MemoryError("too large")
    yield


def crashes():
    yield 1
    os.abort()


def dawdles(seconds):
    time.sleep(seconds)
    yield "done"
