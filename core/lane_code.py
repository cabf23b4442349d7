"""What :mod:`core.lanes` is compiled to: LLVM's vectors of four double precision numbers.

Kernels whose machine code is on disk do not notice a change in this file: delete it then.
"""

import operator
from collections.abc import Callable
from typing import Any, TypeVar, cast

from llvmlite import ir
from numba import types
from numba.core import cgutils
from numba.extending import intrinsic, lower_builtin, models, register_model, type_callable

F = TypeVar("F", bound=Callable[..., Any])

_VECTOR = ir.VectorType(ir.DoubleType(), 4)
_FLAGS = ir.VectorType(ir.IntType(1), 4)
_PLACE = ir.IntType(32)
_UNDEFINED = ir.Constant(_VECTOR, ir.Undefined)
_BYTES = 8


class LanesType(types.Type):  # type: ignore[misc]
    """Type of :class:`core.lanes.Lanes` in a kernel."""


class _LanesModel(models.PrimitiveModel):  # type: ignore[misc]
    def __init__(self, manager: Any, kind: types.Type) -> None:
        super().__init__(manager, kind, _VECTOR)


register_model(LanesType)(_LanesModel)
_LANES = LanesType("Lanes")


def _declare(symbol: Callable[..., Any], instruction: str) -> None:
    """Let an operator between lanes be one instruction."""

    def types_of(context: Any) -> Callable[..., Any]:
        return lambda a, b: _LANES if a == b == _LANES else None

    def code(context: Any, builder: Any, signature: Any, arguments: Any) -> Any:
        return getattr(builder, instruction)(*arguments)

    type_callable(symbol)(types_of)
    lower_builtin(symbol, LanesType, LanesType)(code)


_declare(operator.add, "fadd")
_declare(operator.sub, "fsub")
_declare(operator.mul, "fmul")


def _lane_function(function: F) -> F:
    """Let kernels call what a function gives: its types, and how its code is built."""
    return cast("F", intrinsic(function))


def _is_table(array: Any) -> bool:
    """Whether it is an array of numbers whose rows lie one after the other."""
    is_array = isinstance(array, types.Array) and array.dtype == types.float64
    return is_array and (array.ndim, array.layout) == (2, "C")


def _address(context: Any, builder: Any, signature: Any, arguments: Any, width: int) -> Any:
    """Where row i of an array of `width` columns begins."""
    table = context.make_array(signature.args[0])(context, builder, arguments[0])
    first = builder.mul(arguments[1], ir.IntType(64)(width))
    return builder.bitcast(builder.gep(table.data, [first]), _VECTOR.as_pointer())


@_lane_function
def row(typing: Any, rows: Any, i: Any) -> Any:
    """See :data:`core.lanes.row`."""

    def code(context: Any, builder: Any, signature: Any, arguments: Any) -> Any:
        vector = builder.load(_address(context, builder, signature, arguments, 4))
        vector.align = _BYTES
        return vector

    return (_LANES(rows, types.uint64), code) if _is_table(rows) else None


@_lane_function
def xyz(typing: Any, points: Any, i: Any) -> Any:
    """See :data:`core.lanes.xyz`. Nothing may be read behind the last row, so there is a mask."""

    def code(context: Any, builder: Any, signature: Any, arguments: Any) -> Any:
        address = _address(context, builder, signature, arguments, 3)
        kind = ir.FunctionType(_VECTOR, [address.type, _PLACE, _FLAGS, _VECTOR])
        name = "llvm.masked.load.v4f64.p0"
        load = cgutils.get_or_insert_function(builder.module, kind, name)
        mask, zeros = _FLAGS([1, 1, 1, 0]), _VECTOR([0.0] * 4)
        return builder.call(load, [address, _PLACE(_BYTES), mask, zeros])

    return (_LANES(points, types.uint64), code) if _is_table(points) else None


@_lane_function
def set_row(typing: Any, rows: Any, i: Any, lanes: Any) -> Any:
    """See :data:`core.lanes.set_row`."""

    def code(context: Any, builder: Any, signature: Any, arguments: Any) -> Any:
        address = _address(context, builder, signature, arguments, 4)
        builder.store(arguments[2], address).align = _BYTES
        return context.get_dummy_value()

    return (types.void(rows, types.uint64, _LANES), code) if _is_table(rows) else None


@_lane_function
def every(typing: Any, number: Any) -> Any:
    """See :data:`core.lanes.every`."""

    def code(context: Any, builder: Any, signature: Any, arguments: Any) -> Any:
        first = builder.insert_element(_UNDEFINED, arguments[0], _PLACE(0))
        return _shuffled(builder, first, (0, 0, 0, 0))

    return _LANES(types.float64), code


@_lane_function
def with_fourth(typing: Any, lanes: Any, number: Any) -> Any:
    """See :data:`core.lanes.with_fourth`."""

    def code(context: Any, builder: Any, signature: Any, arguments: Any) -> Any:
        return builder.insert_element(*arguments, _PLACE(3))

    return _LANES(_LANES, types.float64), code


@_lane_function
def turned(typing: Any, lanes: Any) -> Any:
    """See :data:`core.lanes.turned`."""

    def code(context: Any, builder: Any, signature: Any, arguments: Any) -> Any:
        return _shuffled(builder, arguments[0], (1, 2, 0, 3))

    return _LANES(_LANES), code


@_lane_function
def numbers(typing: Any, lanes: Any) -> Any:
    """See :data:`core.lanes.numbers`."""

    def code(context: Any, builder: Any, signature: Any, arguments: Any) -> Any:
        elements = [builder.extract_element(arguments[0], _PLACE(k)) for k in range(4)]
        return cgutils.pack_array(builder, elements)

    return types.UniTuple(types.float64, 4)(_LANES), code


def _shuffled(builder: Any, vector: Any, order: tuple[int, ...]) -> Any:
    places = ir.Constant(ir.VectorType(_PLACE, 4), list(order))
    return builder.shuffle_vector(vector, _UNDEFINED, places)
