"""Groups: first homology, fundamental group, isometry group."""

from __future__ import annotations

import operator
import re
from collections import Counter
from collections.abc import Iterator, Sequence
from typing import TYPE_CHECKING, Any, Union

from tripus import _core
from tripus._check import checked, shown
from tripus._errors import InvalidInput, NoMetric, Undecided

from tripus._value import Value

if TYPE_CHECKING:
    import numpy as np
    import numpy.typing as npt

    from tripus.manifold import Manifold
else:
    from tripus._lazy import numpy as np

#: A word: text such as "abA", or a list of letters, g + 1 for generator g and -(g + 1) for its inverse.
Word = Union[str, Sequence[int]]


@checked
class AbelianGroup(Value):
    """A finitely generated abelian group.

    >>> group = AbelianGroup(2, [3])
    >>> group
    Z/3 + Z + Z
    >>> group.betti_number(), group.elementary_divisors(), group.order()
    (2, [3, 0, 0], 'infinite')
    >>> format(group, "regina")
    '2 Z + Z_3'
    """

    __slots__ = ("_rank", "_factors")

    def __init__(self, rank: int, factors: Sequence[int] = ()) -> None:
        self._rank = rank
        self._factors = tuple(int(f) for f in factors)

    def betti_number(self) -> int:
        """Rank of the free part."""
        return self._rank

    def elementary_divisors(self) -> list[int]:
        """Orders of cyclic factors, each dividing the next; 0 for infinite ones. As in SnapPy."""
        return [*self._factors, *([0] * self._rank)]

    def rank(self) -> int:
        """Number of cyclic factors, finite and infinite, as in SnapPy."""
        return len(self)

    def order(self) -> int | str:
        """Number of elements, or "infinite"."""
        if self._rank:
            return "infinite"
        order = 1
        for factor in self._factors:
            order *= factor
        return order

    def __len__(self) -> int:
        return len(self._factors) + self._rank

    def __bool__(self) -> bool:
        return len(self) > 0

    def __getitem__(self, i: int) -> int:
        return self.elementary_divisors()[i]

    def __iter__(self) -> Iterator[int]:
        return iter(self.elementary_divisors())

    def _key(self) -> Any:
        return self._rank, self._factors

    def _rows(self) -> dict[str, str]:
        return {"group": repr(self), "order": str(self.order())}

    def __reduce__(self) -> tuple[Any, ...]:
        return AbelianGroup, (self._rank, self._factors)

    def __repr__(self) -> str:
        parts = [f"Z/{f}" for f in self._factors] + ["Z"] * self._rank
        return " + ".join(parts) or "0"

    def __format__(self, spec: str) -> str:
        """ "" as SnapPy writes it, "regina" as Regina and the program do."""
        if spec != "regina":
            return format(repr(self), spec)
        counted = [("Z", self._rank)] if self._rank else []
        counted += [(f"Z_{f}", n) for f, n in Counter(self._factors).items()]
        return " + ".join(name if n == 1 else f"{n} {name}" for name, n in counted) or "0"


def names_of(count: int) -> list[str]:
    if count <= 26:
        return [chr(ord("a") + i) for i in range(count)]
    return [f"x{i + 1}" for i in range(count)]


def text_of(letters: Sequence[int], names: Sequence[str]) -> str:
    """The text of a word; inverses are capitals, and more than 26 names have a * between them."""
    texts = [names[x - 1] if x > 0 else names[-x - 1].upper() for x in letters]
    return ("*" if len(names) > 26 else "").join(texts)


@checked
class FundamentalGroup(Value):
    """A presentation of the fundamental group whose generators are crossings of faces.

    Up to 26 generators are a, b, ..., their inverses A, B, ...; more are x1, x2, ..., with inverses
    X1, X2, ... and a * between letters.

    >>> import tripus
    >>> group = tripus.Manifold("cPcbbbihq").fundamental_group()
    >>> group
    Generators:
       a,b,c
    Relators:
       bAcBAbcAC
    >>> group.original_generators()
    ['a', 'b', 'c']
    >>> group.faces()["a"] in group.original().faces().values()
    True
    """

    def __init__(self, manifold: Manifold, simplify: bool = True) -> None:
        self._manifold = manifold
        full, self._letters, small, kept, solved = manifold._core.fundamental_group()
        self._simplified = simplify
        self._original_count = full[0]
        count, relators = small if simplify else full
        self._relators = [list(r) for r in relators]
        self._kept = list(kept) if simplify else list(range(full[0]))
        self._generators = names_of(count)
        # Every original generator as a word in those kept: the last one solved knows only these.
        self._words: dict[int, list[int]] = {g: [i + 1] for i, g in enumerate(self._kept)}
        if simplify:
            for generator, word in reversed(solved):
                self._words[generator] = self._substituted(word)

    def __reduce__(self) -> tuple[Any, ...]:
        return FundamentalGroup, (self._manifold, self._simplified)

    def _key(self) -> Any:
        return self._manifold, self._simplified, self._generators, self._relators, self._letters

    def _rows(self) -> dict[str, str]:
        def some(words: list[str]) -> str:
            more = f", ... ({len(words)})" if len(words) > 12 else ""
            return (", ".join(words[:12]) + more) or "none"

        return {
            "generators": some(self.generators()),
            "relators": some([w if len(w) <= 60 else w[:57] + "..." for w in self.relators()]),
        }

    def _substituted(self, word: Sequence[int]) -> list[int]:
        out: list[int] = []
        for letter in word:
            part = self._words[abs(letter) - 1]
            for x in part if letter > 0 else [-y for y in reversed(part)]:
                if out and out[-1] == -x:
                    out.pop()
                else:
                    out.append(x)
        return out

    def num_generators(self) -> int:
        """Number of generators."""
        return len(self._generators)

    def num_relators(self) -> int:
        """Number of relators."""
        return len(self._relators)

    def generators(self) -> list[str]:
        """Names of the generators."""
        return list(self._generators)

    def relators(self, as_int_list: bool = False) -> list[Any]:
        """The relators as text, or as lists of letters."""
        if as_int_list:
            return [list(r) for r in self._relators]
        return [self.word(r) for r in self._relators]

    def word(self, letters: Sequence[int]) -> str:
        """The text of a word."""
        for x in letters:
            self._require_letter(x)
        return text_of(letters, self._generators)

    def _require_letter(self, letter: int) -> None:
        if letter == 0 or abs(letter) > len(self._generators):
            raise InvalidInput(
                f"{letter} is no letter: they are 1 to {len(self._generators)} and their negatives"
            )

    def letters(self, word: Word) -> list[int]:
        """The letters of a word; InvalidInput for one that is none."""
        if isinstance(word, str):
            number = {name: i + 1 for i, name in enumerate(self._generators)}
            number.update({name.upper(): -n for name, n in number.items()})
            parts = re.findall(r"[A-Za-z]\d*", word)
            if re.sub(r"[*\s]", "", word) != "".join(parts) or not all(p in number for p in parts):
                raise InvalidInput(
                    f"{word!r} is no word in {','.join(self._generators)} and their inverses "
                    f"{','.join(self._generators).upper()}"
                )
            return [number[p] for p in parts]
        try:
            letters = [operator.index(x) for x in word]
        except TypeError:
            raise TypeError(
                f"a word is a text or a list of whole numbers, not {shown(word)}"
            ) from None
        for x in letters:
            self._require_letter(x)
        return letters

    def original(self) -> FundamentalGroup:
        """The presentation as the triangulation gives it: a relator an edge class."""
        return FundamentalGroup(self._manifold, simplify=False)

    def _extended(self, images: Sequence[Sequence[int]]) -> Sequence[Sequence[int]]:
        """Permutations for the generators of original(), if they are given for these."""
        if len(images) != len(self._generators) or len(images) == self._original_count:
            return images
        degree = len(images[0]) if images else 1
        if any(sorted(image) != list(range(degree)) for image in images):
            raise InvalidInput(f"the images are no permutations of 0 to {degree - 1}")
        inverses = [[list(image).index(i) for i in range(degree)] for image in images]
        extended = []
        for g in range(self._original_count):
            places = list(range(degree))
            for x in self._words[g]:
                image = images[x - 1] if x > 0 else inverses[-x - 1]
                places = [image[i] for i in places]
            extended.append(places)
        return extended

    def original_generators(self) -> list[str]:
        """The generators of `original()` as words in these."""
        return [self.word(self._words[g]) for g in range(self._original_count)]

    def faces(self) -> dict[str, tuple[int, int]]:
        """Which face each generator crosses: {name: (tetrahedron, face)}."""
        return {
            name: tuple(int(i) for i in np.argwhere(self._letters == g + 1)[0])  # type: ignore[misc]
            for name, g in zip(self._generators, self._kept)
        }

    def face_words(self) -> list[list[str]]:
        """[T][4] what crossing each face of each tetrahedron counts, as words."""
        return [
            [self.word(self._substituted([int(x)] if x else [])) for x in four]
            for four in self._letters
        ]

    def O31(self, word: Word) -> npt.NDArray[np.float64]:
        """[4 x 4] the isometry of a word, in the frame of tetrahedron 0, time last.

        It carries the fundamental domain across the face; NoMetric if there is no metric.

        >>> import tripus
        >>> group = tripus.Manifold("cPcbbbihq").fundamental_group()
        >>> matrix = group.O31("a")
        >>> J = np.diag([1, 1, 1, -1])
        >>> bool(abs(matrix.T @ J @ matrix - J).max() < 1e-9)
        True
        """
        return self._isometry(word)[0]

    def SL2C(self, word: Word) -> npt.NDArray[np.complex128]:
        """[2 x 2] the matrix of a word, up to sign; determinant 1.

        Only where the word keeps the orientation: NoMetric or InvalidInput otherwise.

        >>> import tripus
        >>> group = tripus.Manifold("cPcbbbihq").fundamental_group()
        >>> relator = group.SL2C("bAcBAbcAC")
        >>> bool(abs(relator[0, 1]) < 1e-9), bool(abs(abs(relator[0, 0]) - 1) < 1e-9)
        (True, True)
        """
        _, result, reverses = self._isometry(word)
        if reverses:
            raise InvalidInput(
                f"{word!r} reverses the orientation, so it is no element of PSL(2,C); use O31"
            )
        return result

    def _isometry(
        self, word: Word
    ) -> tuple[npt.NDArray[np.float64], npt.NDArray[np.complex128], bool]:
        letters = [
            (1 if x > 0 else -1) * (int(self._kept[abs(x) - 1]) + 1) for x in self.letters(word)
        ]
        return self._manifold.metric.isometry_of_word(letters)

    def __repr__(self) -> str:
        relators = "\n   ".join(self.relators()) or "(none)"
        generators = ",".join(self._generators) or "(none)"
        return f"Generators:\n   {generators}\nRelators:\n   {relators}"


class IsometryGroup(Value):
    """The isometry group of a hyperbolic manifold, from its canonical decomposition.

    >>> import tripus
    >>> group = tripus.Manifold("cPcbbbihq").symmetry_group()
    >>> group, group.order(), group.is_amphicheiral()
    (D3, 6, False)
    """

    def __init__(self, fields: dict[str, Any]) -> None:
        self._fields = fields

    def _key(self) -> Any:
        return self._fields

    def _rows(self) -> dict[str, str]:
        return {
            "isometry group": repr(self),
            "order": str(self.order()),
            "keep the orientation": str(self.orientation_preserving_order() or ""),
        }

    def order(self) -> int:
        """Number of isometries."""
        return int(self._fields["order"])

    def orientation_preserving_order(self) -> int:
        """Isometries that keep the orientation; 0 if the manifold has none."""
        return int(self._fields["orientation_preserving"])

    def is_amphicheiral(self) -> bool:
        """Whether the manifold is orientable and some isometry reverses the orientation."""
        return bool(self._fields["is_amphicheiral"])

    def is_full_group(self) -> bool:
        """True: it is never a part of the group, as SnapPy's may be."""
        return True

    def is_abelian(self) -> bool:
        """Whether the group is abelian; Undecided for more than 1000 elements, which are not named."""
        if self.order() > 1000:
            raise Undecided("groups with more than 1000 elements are not looked into", self)
        return self.name() == "trivial" or bool(re.match(r"cyclic|Z_\d+( \+ Z_\d+)*$", self.name()))

    def name(self) -> str:
        """ "trivial", "cyclic of order 6", "Z_2 + Z_4", "dihedral of order 6", ..."""
        return str(self._fields["name"])

    def element_orders(self) -> dict[int, int]:
        """{order: number of elements}; empty for more than 1000 elements."""
        return dict(self._fields["element_orders"])

    def generators_on_boundary(self) -> list[list[int]]:
        """How generators permute the vertex classes."""
        return [list(p) for p in self._fields["generators_on_boundary"]]

    def __repr__(self) -> str:
        """As SnapPy: Z/2 + Z/4, D3 (of order 6), S4."""
        name = self.name()
        if not name:
            return f"group of order {self.order()}"
        if name == "trivial":
            return "0"
        name = re.sub(r"^cyclic of order (\d+)$", r"Z/\1", name)
        name = re.sub(r"dihedral of order (\d+)", lambda m: f"D{int(m[1]) // 2}", name)
        name = re.sub(r"(symmetric|alternating) ([SA])_(\d)", r"\2\3", name)
        return re.sub(r"Z_(\d+)", r"Z/\1", name).replace("non-abelian", "nonabelian group")
