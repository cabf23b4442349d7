"""Declared parameters: one pydantic model per method, from which everything else is derived.

The panel of the window, the command line, the saved study, the validation and the reference page
all read :func:`describe`; nobody repeats a default or a range.
"""

from dataclasses import dataclass
from functools import cache
from typing import Any, Literal, get_args, get_origin

from pydantic import BaseModel, ConfigDict, Field, ValidationError


class ParameterError(ValueError):
    """Raised when a parameter's name or value is not allowed; says what is."""


class Params(BaseModel):
    """Base of all declared parameters: frozen, strict about names, validated on construction."""

    model_config = ConfigDict(frozen=True, extra="forbid", allow_inf_nan=False)


@dataclass(frozen=True)
class Parameter:
    """One declared parameter, as a form or a table needs it.

    Attributes
    ----------
    name : str
        Name in the params model, on the command line and in a study file.
    kind : {"float", "int", "bool", "choice", "text"}
        What a form shows for it.
    default : float, int, bool, str or None
        Value where nothing is given; None only where `optional`.
    low, high : float or None
        Smallest and largest allowed value.
    step : float or None
        Increment of a spin box.
    unit : str
        Unit of the value, empty where it has none.
    help : str
        One line that says what it does and in which direction.
    choices : tuple of str
        Allowed values of a choice.
    optional : bool
        Whether None (chosen automatically) is allowed.
    logarithmic : bool
        Whether a slider should move in powers of ten.
    """

    name: str
    kind: Literal["float", "int", "bool", "choice", "text"]
    default: Any
    low: float | None
    high: float | None
    step: float | None
    unit: str
    help: str
    choices: tuple[str, ...] = ()
    optional: bool = False
    logarithmic: bool = False

    @property
    def label(self) -> str:
        """Name as a person reads it."""
        return self.name.replace("_", " ")

    @property
    def domain(self) -> str:
        """Allowed values in words, for messages and tables."""
        if self.choices:
            return " or ".join(self.choices)
        if self.kind == "bool":
            return "true or false"
        ends = f"{self.low:g} to {self.high:g}" if self.high is not None else "any number"
        return f"{ends}{' ' + self.unit if self.unit else ''}{' or auto' if self.optional else ''}"


def value_text(value: float | int | bool | str | None) -> str:
    """Return a parameter's value in the words of its domain, as it is typed and printed.

    Parameters
    ----------
    value : float, int, bool, str or None
        The value; None is chosen automatically.

    Returns
    -------
    str
        ``auto``, ``true``, ``false``, or the value itself.

    Examples
    --------
    >>> value_text(True), value_text(None), value_text(0.5)
    ('true', 'auto', '0.5')
    """
    if value is None:
        return "auto"
    return str(value).lower() if isinstance(value, bool) else str(value)


def param(
    default: Any,
    *,
    help: str,
    low: float | None = None,
    high: float | None = None,
    step: float | None = None,
    unit: str = "",
    logarithmic: bool = False,
) -> Any:
    """Declare a parameter of a :class:`Params` model.

    Parameters
    ----------
    default : float, int, bool, str or None
        Value where nothing is given.
    help : str
        One line: what it does, and in which direction.
    low, high : float, optional
        Allowed range, both ends included.
    step : float, optional
        Increment of a spin box.
    unit : str
        Unit of the value.
    logarithmic : bool
        Whether a slider should move in powers of ten.

    Returns
    -------
    pydantic field
        To be assigned to an annotated class attribute.
    """
    extra: dict[str, Any] = {"step": step, "unit": unit, "logarithmic": logarithmic}
    return Field(default, ge=low, le=high, description=help, json_schema_extra=extra)


@cache
def describe(params: type[Params]) -> tuple[Parameter, ...]:
    """List the declared parameters of a model in their order."""
    return tuple(_parameter(name, info) for name, info in params.model_fields.items())


def _parameter(name: str, info: Any) -> Parameter:
    kind, choices, optional = _kind(info.annotation)
    bounds = {type(rule).__name__: rule for rule in info.metadata}
    extra = info.json_schema_extra or {}
    return Parameter(
        name=name,
        kind=kind,
        default=info.default,
        low=bounds["Ge"].ge if "Ge" in bounds else None,
        high=bounds["Le"].le if "Le" in bounds else None,
        step=extra.get("step"),
        unit=extra.get("unit", ""),
        help=info.description or "",
        choices=choices,
        optional=optional,
        logarithmic=extra.get("logarithmic", False),
    )


def _kind(annotation: Any) -> tuple[Any, tuple[str, ...], bool]:
    if get_origin(annotation) is Literal:
        return "choice", get_args(annotation), False
    members = [member for member in get_args(annotation) if member is not type(None)]
    if members:
        kind, choices, _ = _kind(members[0])
        return kind, choices, True
    names = {bool: "bool", int: "int", float: "float"}
    return names.get(annotation, "text"), (), False


def build_params(model: type[Params], values: dict[str, Any], owner: str = "") -> Any:
    """Validate values into a params model.

    Parameters
    ----------
    model : type of Params
        The declaration.
    values : dict
        Names and values; a string is converted, ``"auto"`` means None for optional parameters.
    owner : str
        Id of the method, for the message.

    Returns
    -------
    Params
        An instance of `model`.

    Raises
    ------
    ParameterError
        One sentence naming the parameter, the value and what is allowed.
    """
    known = {parameter.name: parameter for parameter in describe(model)}
    unknown = [name for name in values if name not in known]
    prefix = f"{owner}." if owner else ""
    if unknown:
        allowed = ", ".join(known) or "none"
        raise ParameterError(f"{prefix}{unknown[0]} is not a parameter; allowed: {allowed}.")
    plain = {
        name: None if known[name].optional and value == "auto" else value
        for name, value in values.items()
    }
    try:
        return model(**plain)
    except ValidationError as error:
        name = str(error.errors()[0]["loc"][0])
        message = f"{prefix}{name}={plain[name]} is not allowed; use {known[name].domain}."
        raise ParameterError(message) from error
