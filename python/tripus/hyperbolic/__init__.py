"""Is a manifold hyperbolic? Answers about the manifold, with certificates that can be checked.

`tripus.Manifold.hyperbolicity` is the way in; `python -m tripus.hyperbolic INPUT` for a shell.
"""

from tripus.hyperbolic.certificate import HyperbolicityCertificate
from tripus.hyperbolic.decide import Hyperbolicity, hyperbolicity

__all__ = ["Hyperbolicity", "HyperbolicityCertificate", "hyperbolicity"]
