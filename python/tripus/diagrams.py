"""Planar diagrams of knots, links and knotted graphs: pictures, exteriors, groups, tables."""

from __future__ import annotations

import json
import os
from collections.abc import Iterable, Mapping, Sequence
from typing import TYPE_CHECKING, Any

from tripus import _core
from tripus._check import as_bytes, checked, shown
from tripus._core import Diagram as CoreDiagram
from tripus._errors import FileError, InvalidInput
from tripus._limits import Progress, limits
from tripus._value import Value

if TYPE_CHECKING:
    import numpy as np
    import numpy.typing as npt

    from tripus.manifold import Manifold
else:
    from tripus._lazy import numpy as np


@checked
class Diagram(Value):
    """A planar diagram: crossings, and vertices where it is a graph. A picture in notebooks.

    source  a name of the tables ("8_19", "5_1 theta", "hk6_9", "L6a4"); a text ("PD: X[4,2,5,1]
            ...", "DT: 4 6 8 2", "Braid: 1 -2 1 -2", appcontour's and KnotPy's forms); a list of
            nodes, [4 arcs] a crossing, other numbers of arcs a vertex; the name of a file with
            one of these; a spherogram.Link, or what else has PD_code().
    name    what to call it.

    The arcs of a node are counterclockwise, those of a crossing from the incoming under-strand on,
    as in SnapPy. Cone[1,3] behind a text gives the strand of arc 1 the cone order 3.

    >>> D = Diagram("4_1")
    >>> D, D.num_crossings(), D.exterior().volume()
    (<Diagram 4_1: 4 crossings, 1 strand>, 4, 2.029883212819)
    >>> Diagram([(4, 2, 5, 1), (8, 6, 1, 5), (6, 3, 7, 4), (2, 7, 3, 8)]).exterior().volume()
    2.029883212819
    """

    __slots__ = ("_core",)
    _core: CoreDiagram

    def __init__(self, source: Any, name: str | None = None) -> None:
        core = source._core if isinstance(source, Diagram) else _core_of(source)
        self._core = core if name is None else core.renamed(os.fsencode(name))

    @classmethod
    def _wrap(cls, core: CoreDiagram) -> Diagram:
        self = object.__new__(cls)
        self._core = core
        return self

    def __reduce__(self) -> tuple[Any, ...]:
        return _restored, (self._core.text(), self._core.parts()[0], self._core.parts()[3])

    def _key(self) -> Any:
        return self._core.parts()

    def name(self) -> str:
        """From the tables, the file or the caller; may be empty."""
        return os.fsdecode(self._core.parts()[0])

    def num_crossings(self) -> int:
        """Number of crossings."""
        return self._core.crossing_count()

    def num_vertices(self) -> int:
        """Number of vertices of the graph; of a knot or link 0, but for circles without a crossing."""
        return sum(kind == "V" for kind, _ in self._core.parts()[1])

    def num_strands(self) -> int:
        """Number of edges of the graph and of components that are circles."""
        return len(self._core.wirtinger()[2])

    def PD_code(self) -> list[tuple[int, ...]]:
        """The arcs of each node; four are a crossing. As spherogram's, with vertices.

        >>> Diagram("3_1").PD_code()
        [(6, 3, 1, 4), (4, 1, 5, 2), (2, 5, 3, 6)]
        """
        return [tuple(arcs) for _, arcs in self._core.parts()[1]]

    def to_text(self) -> str:
        """ "PD: V[1,2,3] X[4,2,5,1] ... Cone[1,3]", which Diagram and Manifold take."""
        return os.fsdecode(self._core.text())

    def mirrored(self) -> Diagram:
        """The mirror image."""
        return self._wrap(self._core.mirrored())

    def exterior(
        self, *, time_limit: float | None = None, progress: Progress = None
    ) -> Manifold:
        """The outside of the knot, link or graph as a Manifold; also Manifold(diagram).

        A strand with a cone order is not drilled out: it becomes edges with that cone angle.
        """
        from tripus.manifold import Manifold

        core = self._core.exterior(limits(time_limit, 0, progress))
        made = Manifold._wrap(core)
        return made.renamed(self.name()) if self.name() else made

    def with_cone_orders(self, cone_orders: Mapping[int, Any] | None = None) -> Diagram:
        """The same with these cone orders on the strands of these arcs, in place of its own.

        A strand with a cone order is not drilled out. 1 fills it in as by a 2-handle along its
        meridian, 0 makes it parabolic. Without cone_orders every strand is drilled out.

        >>> D = Diagram("4_1").with_cone_orders({1: 4})
        >>> D.exterior().volume(), D.with_cone_orders().exterior().volume()
        (0.5074708032048, 2.029883212819)
        """
        name, nodes, _, orientation_known = self._core.parts()
        orders = {
            _whole(arc): order if type(order) is int else str(order)
            for arc, order in (cone_orders or {}).items()
        }
        data = {"diagram": [[kind, list(arcs)] for kind, arcs in nodes], "cone_orders": orders}
        return _restored(json.dumps(data).encode(), name, orientation_known)

    def drilled(
        self,
        edges: Sequence[int] | str = "singular",
        *,
        seed: int = 0,
        time_limit: float | None = None,
        progress: Progress = None,
    ) -> Manifold:
        """What is left of exterior() without neighbourhoods of these of its edge classes.

        "singular": those of all strands that have a cone order, which are then boundary again.

        >>> Diagram("4_1").with_cone_orders({1: 4}).drilled().volume()
        2.029883212819
        >>> Diagram("4_1").drilled([0]).links()[0]["euler_characteristic"]
        -2
        """
        made = self.exterior(time_limit=time_limit, progress=progress)
        if isinstance(edges, str):
            if edges != "singular":
                raise InvalidInput(f"edges are numbers of edge classes, or 'singular'; not {shown(edges)}")
            edges = list(made.cone_orders)
            if not edges:
                raise InvalidInput("drilled(): no strand of the diagram has a cone order")
        return made.drilled(edges, seed=seed, time_limit=time_limit, progress=progress)

    def wirtinger(self) -> dict[str, Any]:
        """The Wirtinger presentation of the fundamental group of the outside.

        generators  names, one for each stretch that is seen from above
        relators    words; inverses are capitals, as in FundamentalGroup
        strands     for each strand: closed, meridian, longitude (of a knot 0 in homology)

        >>> group = Diagram("3_1").wirtinger()
        >>> group["generators"], len(group["relators"]), group["strands"][0]["meridian"]
        (['a', 'b', 'c'], 3, 'a')
        """
        from tripus.groups import names_of, text_of

        count, relators, strands = self._core.wirtinger()
        names = names_of(count)
        return {
            "generators": names,
            "relators": [text_of(r, names) for r in relators],
            "strands": [
                {"closed": closed, "meridian": text_of(m, names), "longitude": text_of(l, names)}
                for closed, m, l in strands
            ],
        }

    def svg(self, size: float = 320, colours: bool = True, arcs: bool = False) -> str:
        """The picture: arcs of circles by a circle packing, strands in colours or all black.

        arcs  with the numbers of the arcs, as PD_code() has them.

        >>> Diagram("4_1").svg()[:4]
        '<svg'
        """
        return self._core.svg(size, colours, arcs)

    def polylines(self) -> list[npt.NDArray[np.float64]]:
        """The same as a drawing in space, [n x 3] each: for Manifold.from_drawing, plot.drawing."""
        drawing = json.loads(self._core.polylines())
        return [np.array(line, dtype=np.float64) for line in drawing["edges"]]

    def save(self, path: str | os.PathLike[str]) -> None:
        """Writes .svg (the picture), .json (the drawing in space) or .pd (the text)."""
        from tripus.manifold import write_whole

        name = os.fsdecode(path)
        ending = os.path.splitext(name)[1]
        makers = {".svg": self.svg, ".json": self._core.polylines, ".pd": self.to_text}
        if ending not in makers:
            raise InvalidInput(
                f"cannot save to {shown(name)}: the name must end with .svg, .json or .pd"
            )
        write_whole(name, makers[ending]().encode("utf-8", "surrogateescape"))

    def __repr__(self) -> str:
        parts = [
            _counted(self.num_crossings(), "crossing"),
            _counted(self.num_vertices(), "vertex", "vertices") if self.num_vertices() else "",
            _counted(self.num_strands(), "strand"),
        ]
        title = f"Diagram {self.name()}".strip()
        return f"<{title}: {', '.join(filter(None, parts))}>"

    def _repr_svg_(self) -> str:
        return self.svg(240)

    def _picture(self) -> str:
        return self.svg(240)

    def _rows(self) -> dict[str, str]:
        labels = self._core.parts()[2]
        return {
            "diagram": self.name(),
            "crossings": str(self.num_crossings()),
            "vertices": str(self.num_vertices() or ""),
            "strands": str(self.num_strands()),
            "cone orders": ", ".join(f"arc {arc}: {order}" for arc, order in labels.items()),
        }


def tables() -> list[str]:
    """The tables of diagrams that come with tripus.

    >>> tables()
    ['knots', 'links', 'theta-curves', 'handlebody-knots']
    """
    return _core.diagram_tables()


@checked
def table(name: str) -> list[Diagram]:
    """All diagrams of a table; tables() names them.

    >>> len(table("knots")), table("handlebody-knots")[0].name()
    (85, 'hk4_1')
    """
    if name not in tables():
        raise InvalidInput(f"there is no table {shown(name)}: {', '.join(tables())}")
    return [Diagram._wrap(core) for core in _core.diagram_table(name)]


@checked
def is_diagram(text: str) -> bool:
    """Whether a text is a diagram, or a name of the tables."""
    return _core.is_diagram(as_bytes(text))


def _core_of(source: Any) -> CoreDiagram:
    if isinstance(source, (str, os.PathLike)):
        text = os.fsdecode(source)
        if isinstance(source, os.PathLike) and not os.path.exists(source):
            raise FileError(f"there is no file {shown(text)}")
        encoded = as_bytes(text)
        return _core.load_diagram(b" ".join(encoded.split()) if b"\n" in encoded else encoded)
    if hasattr(source, "PD_code"):  # spherogram.Link
        name = getattr(source, "name", None)
        core = _core_of([list(map(int, crossing)) for crossing in source.PD_code()])
        return core.renamed(name.encode()) if isinstance(name, str) else core
    if isinstance(source, Mapping):
        try:
            return _core.load_diagram(json.dumps(dict(source)).encode())
        except (TypeError, ValueError) as error:
            if isinstance(error, InvalidInput):
                raise
            raise InvalidInput(f"this is no diagram: {error}") from None
    if isinstance(source, bytes) or not isinstance(source, Iterable):
        raise TypeError(
            "Diagram(): source is a text, a list of crossings, a file or a link, not "
            f"{shown(source)}"
        )
    return _core.load_diagram(("PD: " + _lists(source)).encode())


def _lists(nodes: Any) -> str:
    """Nodes as the text "[[4,2,5,1], ...]"."""
    texts = []
    for node in nodes:
        try:
            arcs = [_whole(arc) for arc in node]
        except TypeError:
            raise TypeError(
                f"a diagram is a list of nodes, each a list of whole numbers; not {shown(node)}"
            ) from None
        texts.append("[" + ",".join(arcs) + "]")
    return "[" + ",".join(texts) + "]"


def _whole(arc: Any) -> str:
    import operator

    return str(operator.index(arc))


def _counted(count: int, one: str, many: str = "") -> str:
    return f"{count} {one if count == 1 else many or one + 's'}"


def _restored(text: bytes, name: bytes, orientation_known: bool) -> Diagram:
    import warnings

    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        return Diagram._wrap(_core.load_diagram(text).with_name(name, orientation_known))
