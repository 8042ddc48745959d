"""Which critical points of index 2 a surface is made of, as `--select` of the commands says it."""

import re
from typing import Any, Callable, Iterable, List, Union


def asked(ask: Callable[[List[bytes]], Any], select: Union[str, Iterable[str], None]) -> Any:
    """What ask says of these expressions. An error names them as Python has them."""
    try:
        expressions = [] if select is None else [select] if isinstance(select, str) else list(select)
    except TypeError:
        raise ValueError("select must be a str, or several") from None
    if not all(isinstance(expression, str) for expression in expressions):
        raise ValueError("select must be a str, or several")
    try:
        return ask([expression.encode(errors="replace") for expression in expressions])
    except ValueError as error:
        raise ValueError(_with_place(str(error), isinstance(select, str))) from None


def _with_place(message: str, is_one: bool) -> str:
    """Places of expressions are those of Python's list, where the program has those of its options."""
    return re.sub(r"^--select:(\d+):", lambda k: "select:" if is_one else f"select[{int(k[1]) - 1}]:", message)
