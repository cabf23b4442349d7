"""Kernels wait for their first call; until then numba is not even imported."""

import subprocess
import sys

import numpy as np

from core.kernels import kernel, parallel_kernel, prange


@kernel
def square(number):
    """Multiply a number by itself."""
    return number * number


@parallel_kernel
def sum_of_squares(numbers):
    total = 0.0
    for i in prange(len(numbers)):
        total += square(numbers[i])
    return total


def test_a_kernel_is_compiled_with_those_that_it_calls():
    assert "dispatcher" not in vars(sum_of_squares)
    assert sum_of_squares(np.array([1.0, 2.0, 3.0])) == 14
    assert sum_of_squares.dispatcher.signatures
    assert sum_of_squares.dispatcher.targetoptions["parallel"]


def test_a_kernel_keeps_its_name_and_its_docstring():
    assert (square.__name__, square.__doc__) == ("square", "Multiply a number by itself.")


def test_nothing_is_compiled_where_the_mathematics_is_only_imported():
    code = "import core, sys; sys.exit('numba' in sys.modules or 'scipy.sparse' in sys.modules)"
    assert subprocess.run([sys.executable, "-c", code], check=False).returncode == 0
