"""Persistence diagrams in pipelines of scikit-learn, which has to be there: `import flowcert.sklearn`.

    >>> from flowcert.sklearn import FlowPersistence
    >>> square = [[0, 0, 0], [2, 0, 0], [2, 2, 0], [0, 2, 0]]
    >>> FlowPersistence(homology_dimensions=1).fit_transform([square])
    [array([[1., 2.]])]
"""

from typing import Any, Dict, List, Optional, Sequence, Union

import numpy as np
from joblib import Parallel, delayed  # scikit-learn itself needs it
from numpy.typing import ArrayLike, NDArray
from sklearn.base import BaseEstimator, TransformerMixin

from ._flow_complex import FlowComplex

__all__ = ["FlowPersistence"]


class FlowPersistence(TransformerMixin, BaseEstimator):
    """The persistence diagrams of point sets, exactly: a transformer of scikit-learn, used as GUDHI's RipsPersistence.

    homology_dimensions: which diagrams; an int from 0 to 2, or several of them.
    squared: births and deaths are squared distances, as in FlowComplex.persistence(), and as GUDHI's alpha complex has
    them. False: distances, in the unit of the points.
    n_jobs: so many point sets are computed at a time, as joblib says it, each by one thread. None: one after the other,
    each by all cores.

    transform(X) takes any number of point sets, each (n, 3) and of its own size, and returns as many diagrams: arrays
    of births and deaths, (k, 2), in the order of FlowComplex.persistence(). With several homology_dimensions it is a
    list of diagrams for each point set. What lasts has the death inf, which gudhi.representations.DiagramSelector
    leaves out. There is nothing to fit.

    >>> two = [[0, 0, 0], [4, 0, 0]], [[0, 0, 0], [0, 6, 0]]
    >>> [len(components) for components, tunnels in FlowPersistence([0, 1]).fit_transform(two)]
    [2, 2]
    """

    def __init__(
        self,
        homology_dimensions: Union[int, Sequence[int]] = (0, 1, 2),
        *,
        squared: bool = True,
        n_jobs: Optional[int] = None,
    ) -> None:
        self.homology_dimensions = homology_dimensions
        self.squared = squared
        self.n_jobs = n_jobs

    def fit(self, X: Sequence[ArrayLike], y: Any = None) -> "FlowPersistence":
        """Checks the parameters, and learns nothing from X."""
        self._dimensions()
        return self

    def transform(self, X: Sequence[ArrayLike]) -> List[Union[NDArray[np.float64], List[NDArray[np.float64]]]]:
        """The diagrams of these point sets."""
        dimensions = self._dimensions()
        threads = None if self.n_jobs is None else 1
        diagrams = Parallel(n_jobs=self.n_jobs, prefer="threads")(
            delayed(self._diagrams)(points, dimensions, threads) for points in X
        )
        return [some[0] for some in diagrams] if isinstance(self.homology_dimensions, (int, np.integer)) else diagrams

    def get_feature_names_out(self, input_features: Any = None) -> NDArray[np.object_]:
        """What the diagrams of a point set are called: H0, H1 and H2."""
        return np.array([f"H{dimension}" for dimension in self._dimensions()], dtype=object)

    def _dimensions(self) -> List[int]:
        asked = self.homology_dimensions
        dimensions = [asked] if isinstance(asked, (int, np.integer)) else list(asked)
        if not all(dimension in (0, 1, 2) for dimension in dimensions):
            raise ValueError(f"homology_dimensions: not from 0 to 2, but {asked!r}")
        return dimensions

    def _diagrams(
        self, points: ArrayLike, dimensions: List[int], threads: Optional[int]
    ) -> List[NDArray[np.float64]]:
        complex = FlowComplex(points, threads=threads)
        return [complex.persistence(dimension=dimension, squared=self.squared) for dimension in dimensions]

    def __sklearn_is_fitted__(self) -> bool:
        return True

    def _more_tags(self) -> Dict[str, Any]:
        return {"X_types": ["3darray"], "stateless": True, "requires_fit": False, "no_validation": True}

    def __sklearn_tags__(self) -> Any:  # from scikit-learn 1.6 on
        tags = super().__sklearn_tags__()
        tags.input_tags.two_d_array, tags.input_tags.three_d_array = False, True
        tags.requires_fit, tags.no_validation = False, True
        return tags
