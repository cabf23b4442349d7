"""What :mod:`core.lanes` is compiled to: a number, or LLVM's vector of eight.

Kernels whose machine code is on disk do not notice a change in this file: delete it then.
"""

import operator
from collections.abc import Callable
from typing import Any, TypeVar, cast

from llvmlite import ir
from numba import types
from numba.core import cgutils
from numba.core.typeconv import Conversion
from numba.extending import (
    intrinsic,
    lower_builtin,
    lower_cast,
    models,
    register_model,
    type_callable,
)

from core.lanes import WIDTH

F = TypeVar("F", bound=Callable[..., Any])

_VECTOR = ir.VectorType(ir.DoubleType(), WIDTH)
_PLACE = ir.IntType(32)
_UNDEFINED = ir.Constant(_VECTOR, ir.Undefined)
_BYTES = 8


class LanesType(types.Type):  # type: ignore[misc]
    """Type of eight numbers in a kernel; one number becomes eight equal ones where it has to."""

    def can_convert_from(self, context: Any, other: types.Type) -> Any:
        """Tell the compiler that a number can stand for eight."""
        return Conversion.safe if other == types.float64 else None


class _LanesModel(models.PrimitiveModel):  # type: ignore[misc]
    def __init__(self, manager: Any, kind: types.Type) -> None:
        super().__init__(manager, kind, _VECTOR)


register_model(LanesType)(_LanesModel)
_LANES = LanesType("Lanes")


@lower_cast(types.Float, LanesType)  # type: ignore[untyped-decorator]
def _repeated(context: Any, builder: Any, number: Any, lanes: Any, value: Any) -> Any:
    first = builder.insert_element(_UNDEFINED, value, _PLACE(0))
    places = ir.Constant(ir.VectorType(_PLACE, WIDTH), [0] * WIDTH)
    return builder.shuffle_vector(first, _UNDEFINED, places)


def _declare(symbol: Callable[..., Any], instruction: str) -> None:
    """Let an operator between lanes, or between them and a number, be one instruction."""

    def types_of(context: Any) -> Callable[..., Any]:
        def lanes(a: types.Type, b: types.Type) -> Any:
            known = {a, b} <= {_LANES, types.float64} and _LANES in (a, b)
            return _LANES(_LANES, _LANES) if known else None

        return lanes

    def code(context: Any, builder: Any, signature: Any, arguments: Any) -> Any:
        return getattr(builder, instruction)(*arguments)

    type_callable(symbol)(types_of)
    lower_builtin(symbol, LanesType, LanesType)(code)


_declare(operator.add, "fadd")
_declare(operator.sub, "fsub")
_declare(operator.mul, "fmul")
_declare(operator.truediv, "fdiv")


def _lane_function(function: F) -> F:
    """Let kernels call what a function gives: its types, and how its code is built."""
    return cast("F", intrinsic(function))


def _kind(array: Any, dimensions: int) -> types.Type | None:
    """What an array holds of one mesh, which has so many dimensions, or of eight; else None."""
    if not isinstance(array, types.Array) or (array.dtype, array.layout) != (types.float64, "C"):
        return None
    return {dimensions: types.float64, dimensions + 1: _LANES}.get(array.ndim)


def _address(context: Any, builder: Any, array: Any, value: Any, kind: Any, place: Any) -> Any:
    """Where the number or the eight at some place of an array are."""
    data = context.make_array(array)(context, builder, value).data
    if kind == types.float64:
        return builder.gep(data, [place])
    first = builder.gep(data, [builder.mul(place, ir.IntType(64)(WIDTH))])
    return builder.bitcast(first, _VECTOR.as_pointer())


def _load(builder: Any, address: Any) -> Any:
    value = builder.load(address)
    value.align = _BYTES
    return value


@_lane_function
def row(typing: Any, rows: Any, i: Any) -> Any:
    """See :data:`core.lanes.row`."""
    kind = _kind(rows, 1)

    def code(context: Any, builder: Any, signature: Any, arguments: Any) -> Any:
        return _load(builder, _address(context, builder, rows, arguments[0], kind, arguments[1]))

    return (kind(rows, types.uint64), code) if kind else None


@_lane_function
def xyz(typing: Any, positions: Any, i: Any) -> Any:
    """See :data:`core.lanes.xyz`."""
    kind = _kind(positions, 2)

    def code(context: Any, builder: Any, signature: Any, arguments: Any) -> Any:
        first = builder.mul(arguments[1], ir.IntType(64)(3))
        places = [builder.add(first, ir.IntType(64)(x)) for x in range(3)]
        parts = [
            _load(builder, _address(context, builder, positions, arguments[0], kind, place))
            for place in places
        ]
        return cgutils.pack_array(builder, parts)

    return (types.UniTuple(kind, 3)(positions, types.uint64), code) if kind else None


@_lane_function
def set_row(typing: Any, rows: Any, i: Any, number: Any) -> Any:
    """See :data:`core.lanes.set_row`."""
    kind = _kind(rows, 1)

    def code(context: Any, builder: Any, signature: Any, arguments: Any) -> Any:
        address = _address(context, builder, rows, arguments[0], kind, arguments[1])
        builder.store(arguments[2], address).align = _BYTES
        return context.get_dummy_value()

    return (types.void(rows, types.uint64, kind), code) if kind else None
