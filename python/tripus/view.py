"""Pictures in notebooks and browsers."""

from __future__ import annotations

import html
import os
import struct
import tempfile
import zlib
from typing import TYPE_CHECKING, Any

from tripus._check import checked
from tripus._value import Value

if TYPE_CHECKING:
    import numpy as np
    import numpy.typing as npt

    from tripus.manifold import Manifold
else:
    from tripus._lazy import numpy as np

#: Tables in notebooks have a picture for manifolds up to this size.
MOST_TETRAHEDRA_FOR_PICTURE = 200
#: The homology of large covers takes long.
MOST_TETRAHEDRA_FOR_HOMOLOGY = 1000


@checked
class Page(Value):
    """A page in a notebook: live, and kept in the saved notebook."""

    def __init__(self, text: str, height: int = 520) -> None:
        self.text = text
        self.height = height

    def _key(self) -> Any:
        return self.text, self.height

    def _repr_html_(self) -> str:
        # The page is in the document itself, apart from it, and may run its own scripts only.
        return (
            f'<iframe srcdoc="{html.escape(self.text, quote=True)}" sandbox="allow-scripts" '
            f'style="width:100%;height:{self.height}px;border:0" loading="lazy" '
            'title="tripus"></iframe>'
        )

    def __repr__(self) -> str:
        return f"<Page of {len(self.text)} characters; save(path) writes it>"

    def save(self, path: str | os.PathLike[str]) -> None:
        """Writes the page, whole or not at all."""
        from tripus.manifold import write_whole

        write_whole(os.fspath(path), self.text.encode())

    def open(self) -> str:
        """Shows the page in a browser; the name of the file, which stays."""
        import webbrowser

        handle, path = tempfile.mkstemp(prefix="tripus-", suffix=".html")
        with os.fdopen(handle, "w", encoding="utf-8") as file:
            file.write(self.text)
        webbrowser.open("file://" + path)
        return path


def in_notebook() -> bool:
    """Whether IPython shows results as HTML here."""
    import sys

    if "IPython" not in sys.modules:
        return False
    shell = sys.modules["IPython"].get_ipython()
    return shell is not None and "IPKernelApp" in shell.config


def view(
    manifold: Manifold,
    cells: int = 20,
    model: str = "ball",
    height: int = 520,
    *,
    discs: bool | float = False,
    inside: bool = False,
) -> Page:
    """The page of a manifold; outside of notebooks it opens in a browser."""
    page = Page(manifold.page(cells, model, discs=discs, inside=inside), height)
    if not in_notebook():
        page.open()
    return page


def png(pixels: npt.NDArray[np.uint8]) -> bytes:
    """A PNG file of pixels [height x width x 4].

    >>> png(np.zeros((2, 3, 4), dtype=np.uint8))[:8]
    b'\\x89PNG\\r\\n\\x1a\\n'
    """
    height, width, _ = pixels.shape
    rows = np.zeros((height, 4 * width + 1), dtype=np.uint8)
    rows[:, 1:] = pixels.reshape(height, 4 * width)

    def chunk(kind: bytes, data: bytes) -> bytes:
        body = kind + data
        return struct.pack(">I", len(data)) + body + struct.pack(">I", zlib.crc32(body))

    header = struct.pack(">IIBBBBB", width, height, 8, 6, 0, 0, 0)
    return (
        b"\x89PNG\r\n\x1a\n"
        + chunk(b"IHDR", header)
        + chunk(b"IDAT", zlib.compress(rows.tobytes(), 9))
        + chunk(b"IEND", b"")
    )


def rows_of(manifold: Manifold) -> dict[str, str]:
    """What a notebook shows of a manifold."""
    from tripus._errors import TripusError

    rows = {
        "manifold": str(manifold),
        "tetrahedra": str(manifold.num_tetrahedra()),
        "boundary": ", ".join(_boundary(link) for link in manifold.links()),
        "cone orders": ", ".join(f"edge {e}: {k}" for e, k in manifold.cone_orders.items()),
    }
    try:
        if manifold.num_tetrahedra() <= MOST_TETRAHEDRA_FOR_HOMOLOGY:
            rows["H1"] = str(manifold.homology())
        verdict = manifold.verdict()
        rows["volume" if verdict else "outcome"] = (
            f"{verdict.volume:.12g}" if verdict else f"{verdict.outcome}: {verdict.message}"
        )
    except TripusError as error:
        rows.setdefault("note", str(error))
    return rows


def picture_of(manifold: Manifold) -> str:
    """The view from inside as HTML; empty where there is none, or it would take long."""
    import base64

    from tripus._errors import TripusError

    try:
        if manifold.num_tetrahedra() > MOST_TETRAHEDRA_FOR_PICTURE or not manifold.verdict():
            return ""
        data = base64.b64encode(png(manifold.picture(160, 120))).decode()
    except TripusError:  # cusps and cone angles are not placed in space so far
        return ""
    return f'<img alt="inside" src="data:image/png;base64,{data}">'


def _boundary(link: dict[str, Any]) -> str:
    chi = link["euler_characteristic"]
    if link["kind"] == "finite":
        return "finite vertex"
    if link["kind"] == "cusp":
        return "cusp" if link["orientable"] else "cusp (Klein bottle)"
    surface = f"genus {(2 - chi) // 2}" if link["orientable"] else f"Euler characteristic {chi}"
    points = link["cone_points"]
    return surface + (f" with {points} cone point{'s'[: points != 1]}" if points else "")
