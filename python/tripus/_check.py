"""Arguments of public functions, checked by their annotations.

What is of the wrong type is a TypeError, what is out of range an InvalidInput (a ValueError); both name
the function, the argument and the value. Numbers of numpy become Python's, which is what the
extension takes.
"""

from __future__ import annotations

import functools
import math
import operator
import os
from collections.abc import Callable, Iterable, Mapping, Sequence
from typing import TYPE_CHECKING, Any, TypeVar

from tripus._errors import InvalidInput

if TYPE_CHECKING:
    import numpy as np
    import numpy.typing as npt
else:
    from tripus._lazy import numpy as np

_Anything = TypeVar("_Anything")
_Check = Callable[[Any], Any]

#: Integers are counts, indices and sizes, but for seeds.
MOST = 2**31 - 1
MOST_SEED = 2**64 - 1


class _Wrong(Exception):
    """What an argument should have been; `kind` is the exception to raise."""

    def __init__(self, wanted: str, kind: type[Exception] = TypeError) -> None:
        super().__init__(wanted)
        self.kind = kind


def shown(value: object) -> str:
    """A value for a message: short, and without characters that cannot be written."""
    try:
        text = repr(value)
    except Exception:
        text = f"a {type(value).__name__}"
    text = text.encode("ascii", "backslashreplace").decode()
    return text if len(text) <= 60 else text[:57] + "..."


def _bool(value: Any) -> bool:
    if isinstance(value, bool) or type(value).__module__ == "numpy" and value.dtype == bool:
        return bool(value)
    if isinstance(value, int) and value in (0, 1):
        return bool(value)
    raise _Wrong("True or False")


def _whole(value: Any) -> int:
    if isinstance(value, bool) or not hasattr(value, "__index__"):
        raise _Wrong("a whole number")
    try:
        return operator.index(value)
    except TypeError:  # an array, say
        raise _Wrong("a whole number") from None


def _int(value: Any, most: int = MOST) -> int:
    number = _whole(value)
    if not 0 <= number <= most:
        raise _Wrong(f"from 0 to {most}", InvalidInput)
    return number


def _seed(value: Any) -> int:
    return _int(value, MOST_SEED)


def _float(value: Any) -> float:
    if isinstance(value, (str, bytes, bytearray, bool)) or not (
        hasattr(value, "__float__") or hasattr(value, "__index__")
    ):
        raise _Wrong("a number")
    try:
        number = float(value)
    except OverflowError:
        raise _Wrong("a number that a double can hold", InvalidInput) from None
    except (TypeError, ValueError):
        raise _Wrong("a number") from None
    if math.isnan(number):
        raise _Wrong("a number", InvalidInput)
    return number


def _text(value: Any) -> str:
    """Text that can be written; single bytes of file names may stand in it as Python has them."""
    if not isinstance(value, str):
        raise _Wrong("a text")
    try:
        value.encode("utf-8", "surrogateescape")
    except UnicodeEncodeError:
        raise _Wrong("a text without halves of surrogate pairs", InvalidInput) from None
    return value


def _word(value: Any) -> str:
    """Text that names something: a method, a model, a format."""
    text = _text(value)
    try:
        text.encode("utf-8")
    except UnicodeEncodeError:
        raise _Wrong("a text without bytes that are no UTF-8", InvalidInput) from None
    return text


def _path(value: Any) -> Any:
    if not isinstance(value, (str, os.PathLike)):
        raise _Wrong("the name of a file, a str or a Path")
    _text(os.fsdecode(os.fspath(value)))
    return value


def _callable_or_bool(value: Any) -> Any:
    if value is None or isinstance(value, bool) or callable(value):
        return value
    raise _Wrong("a function of (activity, count), True or None")


def _many(value: Any, wanted: str) -> list[Any]:
    if isinstance(value, (str, bytes, Mapping)) or not isinstance(value, Iterable):
        raise _Wrong(wanted)
    try:
        return list(value)
    except TypeError:  # an array without dimensions
        raise _Wrong(wanted) from None


def _list_of(check: _Check, wanted: str) -> _Check:
    def checked_list(value: Any) -> list[Any]:
        try:
            return [check(x) for x in _many(value, wanted)]
        except _Wrong as wrong:
            raise _Wrong(wanted, wrong.kind) from None

    return checked_list


def _mapping(value: Any) -> dict[int, Any]:
    wanted = "a dict {edge class: number}"
    if not isinstance(value, Mapping):
        raise _Wrong(wanted)
    try:
        return {_int(key): number for key, number in value.items()}
    except _Wrong as wrong:
        raise _Wrong(wanted, wrong.kind) from None


def _manifold(value: Any) -> Any:
    from tripus.interop import package_of
    from tripus.manifold import Manifold

    if not isinstance(value, Manifold) and package_of(value):
        return Manifold(value)
    if not isinstance(value, Manifold):
        raise _Wrong("a tripus.Manifold, or a triangulation of SnapPy or Regina")
    return value


def _words(value: Any) -> Any:
    return _word(value) if isinstance(value, str) else _list_of(_word, "a list of texts")(value)


_CHECKS: dict[str, _Check] = {
    "bool": _bool,
    "int": _int,
    "float": _float,
    "str": _word,
    "str | os.PathLike[str]": _path,
    "Manifold": _manifold,
    "Progress": _callable_or_bool,
    "Sequence[int]": _list_of(_whole, "a list of whole numbers"),
    "Sequence[str]": _list_of(_word, "a list of texts"),
    "Sequence[Sequence[int]]": _list_of(
        _list_of(_int, ""), "a list of permutations, each a list of whole numbers from 0"
    ),
    "str | Sequence[str]": _words,
    "bool | float": lambda value: value if isinstance(value, bool) else _float(value),
    "Sequence[float] | npt.NDArray[np.float64]": _list_of(_float, "a list of numbers"),
    "Mapping[int, Any]": _mapping,
    "Mapping[int, float]": _mapping,
    "tuple[float, float]": _list_of(_float, "a pair of numbers"),
}
_NAMES = ("name", "text")  # which may hold any bytes that file names may hold


def _check_of(name: str, annotation: Any) -> _Check | None:
    """The check of an annotation; None where the function itself looks at the argument."""
    text = annotation if isinstance(annotation, str) else ""
    may_be_none = text.endswith(" | None")
    text = text.removesuffix(" | None")
    check = _CHECKS.get(text)
    if text == "int" and name == "seed":
        check = _seed
    if text == "str" and name in _NAMES:
        check = _text
    if check is None or not may_be_none:
        return check
    some = check
    return lambda value: None if value is None else some(value)


_FUNCTION = type(shown)


def checked(thing: _Anything) -> _Anything:
    """A function whose arguments are checked; or a class, all of whose public functions are."""
    if not isinstance(thing, type):
        return _checked_function(thing, "")  # type: ignore[no-any-return]
    for name, member in list(vars(thing).items()):
        if name.startswith("_") and name != "__init__":
            continue
        called = thing.__name__ if name == "__init__" else f"{thing.__name__}.{name}"
        if isinstance(member, (classmethod, staticmethod)):
            setattr(thing, name, type(member)(_checked_function(member.__func__, called)))
        elif isinstance(member, _FUNCTION):
            setattr(thing, name, _checked_function(member, called))
    return thing


def _checked_function(function: Any, called: str) -> Any:
    called = called or function.__name__
    code = function.__code__
    names = list(code.co_varnames[: code.co_argcount + code.co_kwonlyargcount])
    checks = [_check_of(n, function.__annotations__.get(n)) for n in names]
    by_name = {n: c for n, c in zip(names, checks) if c is not None}
    if not by_name:
        return function

    def verified(name: str, check: _Check, value: Any) -> Any:
        try:
            return check(value)
        except _Wrong as wrong:
            raise wrong.kind(f"{called}(): {name} is {wrong}, not {shown(value)}") from None

    @functools.wraps(function)
    def wrapper(*given: Any, **named: Any) -> Any:
        if len(given) > 1 or (given and checks[0] is not None):
            given = tuple(
                value if check is None else verified(name, check, value)
                for name, check, value in zip(names, checks, given)
            ) + given[len(names) :]
        for name in named:
            check = by_name.get(name)
            if check is not None:
                named[name] = verified(name, check, named[name])
        return function(*given, **named)

    return wrapper


def as_bytes(text: Any) -> bytes:
    """A text or the name of a file as bytes, for the extension; InvalidInput if it has none."""
    try:
        return os.fsencode(text)
    except UnicodeEncodeError:
        raise InvalidInput(f"{shown(text)} has halves of surrogate pairs") from None


def one_of(function: str, name: str, value: str, values: Sequence[str]) -> None:
    """InvalidInput unless the value is one of these."""
    if value not in values:
        words = ", ".join(map(repr, values[:-1])) + f" or {values[-1]!r}"
        raise InvalidInput(f"{function}(): {name} is {words}, not {shown(value)}")


# Arrays

def real_array(name: str, value: Any) -> npt.NDArray[np.float64]:
    """An array of finite doubles."""
    try:
        array = np.asarray(value)
    except ValueError:  # rows of different lengths
        raise InvalidInput(f"{name}: rows of different lengths") from None
    if array.dtype.kind == "O" and array.size:
        try:
            array = array.astype(np.float64)
        except (TypeError, ValueError):
            raise TypeError(f"{name} are numbers, not {shown(value)}") from None
    if array.size and array.dtype.kind not in "iuf":
        raise TypeError(f"{name} are real numbers, not an array of {array.dtype}")
    numbers: npt.NDArray[np.float64] = np.ascontiguousarray(array, dtype=np.float64)
    if numbers.size and not np.isfinite(numbers).all():
        place = np.argwhere(~np.isfinite(numbers))[0].tolist()
        raise InvalidInput(f"{name}: the number at {place} is not finite")
    return numbers


def whole_array(name: str, value: Any, most: int, dtype: Any) -> npt.NDArray[Any]:
    """An array of whole numbers from 0 to `most`, as `dtype`; nothing is rounded or wrapped."""
    try:
        array = np.asarray(value)
    except ValueError:
        raise InvalidInput(f"{name}: rows of different lengths") from None
    except OverflowError:
        raise InvalidInput(f"{name} are from 0 to {most}") from None
    if array.size and array.dtype.kind not in "iu":
        raise TypeError(f"{name} are whole numbers, not an array of {array.dtype}")
    if array.size and (array.min() < 0 or array.max() > most):
        wrong = array[(array < 0) | (array > most)].flat[0]
        raise InvalidInput(f"{name} are from 0 to {most}, not {wrong}")
    return np.ascontiguousarray(array, dtype=dtype)
