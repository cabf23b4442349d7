"""Declared parameters: description, validation, messages."""

from typing import Literal

import pytest

from core.parameters import ParameterError, Params, build_params, describe, param, value_text


class Example(Params):
    width: float = param(2.0, low=0.5, high=4.0, step=0.5, unit="ℓ̄", help="Wider is softer.")
    count: int = param(3, low=1, help="How many.")
    form: Literal["round", "flat"] = param("round", help="Its form.")
    limit: float | None = param(None, low=0.0, high=1.0, help="Automatic if not given.")
    on: bool = param(True, help="A switch.")


def test_describe_tells_a_form_all_it_needs():
    width, count, form, limit, on = describe(Example)
    assert (width.kind, width.low, width.high, width.step, width.unit) == (
        "float", 0.5, 4.0, 0.5, "ℓ̄",
    )  # fmt: skip
    assert (count.kind, count.low, count.high) == ("int", 1, None)
    assert (form.kind, form.choices) == ("choice", ("round", "flat"))
    assert (limit.kind, limit.optional, limit.default) == ("float", True, None)
    assert on.kind == "bool"


@pytest.mark.parametrize("parameter", describe(Example), ids=lambda parameter: parameter.name)
def test_a_default_is_written_as_it_is_typed(parameter):
    text = value_text(parameter.default)
    assert build_params(Example, {parameter.name: text}) == Example()
    if parameter.kind in {"bool", "choice"}:
        assert text in parameter.domain.split(" or ")


def test_strings_from_a_command_line_are_converted():
    made = build_params(Example, {"width": "1.5", "on": "false", "limit": "auto"})
    assert (made.width, made.on, made.limit) == (1.5, False, None)


@pytest.mark.parametrize(
    ("values", "message"),
    [
        ({"width": 9}, r"x.width=9 is not allowed; use 0.5 to 4 ℓ̄\."),
        ({"form": "square"}, "use round or flat"),
        ({"on": "perhaps"}, "use true or false"),
        ({"limit": 3}, "use 0 to 1 or auto"),
        ({"depth": 1}, "x.depth is not a parameter; allowed: width, count, form, limit, on"),
    ],
)
def test_messages_name_parameter_value_and_what_is_allowed(values, message):
    with pytest.raises(ParameterError, match=message):
        build_params(Example, values, "x")
