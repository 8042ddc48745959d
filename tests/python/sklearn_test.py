"""FlowPersistence is a transformer of scikit-learn: its own checks, clones, pipelines, and GUDHI's diagrams."""

import pickle
import warnings

import flowcert
import gudhi
import numpy as np
import pytest
from conftest import CUBE, sphere_sample

try:
    from flowcert.sklearn import FlowPersistence
    from sklearn.utils import estimator_checks
except ImportError:  # without scikit-learn, which the tests say below

    class FlowPersistence:
        pass

    estimator_checks = None

SQUARE = np.array([[0.0, 0, 0], [2, 0, 0], [2, 2, 0], [0, 2, 0]])
pytestmark = pytest.mark.skipif(estimator_checks is None, reason="no scikit-learn: python3-sklearn has it")

# These transform a table of numbers. Each of its rows would be a point set, and a row of numbers is none.
OF_A_TABLE = {
    "check_dict_unchanged", "check_estimators_dtypes", "check_estimators_pickle", "check_f_contiguous_array_estimator",
    "check_fit_idempotent", "check_fit_score_takes_y", "check_methods_sample_order_invariance",
    "check_methods_subset_invariance", "check_pipeline_consistency", "check_transformer_general",
    "check_transformer_preserve_dtypes", "check_transformers_unfitted_stateless",
}  # fmt: skip


class Diagrams(FlowPersistence):
    """The same. Otherwise scikit-learn makes no checks of what takes no tables."""

    def _more_tags(self):
        return {**super()._more_tags(), "X_types": ["2darray"]}


class OfTables(Diagrams):
    """Each row of a table as points on a line, and numbers of its diagrams as a row of a table."""

    def transform(self, X):
        sets = [np.column_stack([row, np.zeros((len(row), 2))]) for row in np.asarray(X, dtype=np.float64)]
        deaths = [[np.unique(diagram[:, 1]) for diagram in diagrams] for diagrams in super().transform(sets)]
        return np.array([[values[np.isfinite(values)].sum() for values in row] for row in deaths])


def checks(estimator):
    if estimator_checks is None:
        return []
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        made = list(estimator_checks.check_estimator(estimator(), generate_only=True))
    return [pytest.param(*some, id=estimator_checks._get_check_estimator_ids(some[1])) for some in made]


@pytest.mark.filterwarnings("ignore")
@pytest.mark.parametrize("estimator, check", checks(Diagrams))
def test_checks_of_scikit_learn(estimator, check, request):
    if request.node.callspec.id.split("(")[0] not in OF_A_TABLE:
        check(estimator)
        return
    with pytest.raises(ValueError, match=r"points must have the shape \(n, 3\), not"):
        check(estimator)


@pytest.mark.filterwarnings("ignore")
@pytest.mark.parametrize("estimator, check", checks(OfTables))
def test_checks_of_scikit_learn_with_tables(estimator, check, request):
    if request.node.callspec.id.split("(")[0] in OF_A_TABLE:
        check(estimator)


def test_diagrams_are_those_of_the_complex():
    sets = [SQUARE, CUBE, sphere_sample(30), np.empty((0, 3))]
    for squared in (True, False):
        several = FlowPersistence([0, 1, 2], squared=squared).fit_transform(sets)
        single = FlowPersistence(np.int64(1), squared=squared, n_jobs=2).fit(sets).transform(sets)
        assert len(several) == len(single) == len(sets)
        for points, diagrams, tunnels in zip(sets, several, single):
            fc = flowcert.FlowComplex(points)
            for k, diagram in enumerate(diagrams):
                assert (diagram == fc.persistence(dimension=k, squared=squared)).all() and diagram.shape[1] == 2
            assert (tunnels == diagrams[1]).all()


def test_diagrams_are_those_of_gudhi():
    points = sphere_sample(40)
    tree = gudhi.AlphaComplex(points=points).create_simplex_tree()
    tree.compute_persistence()
    ours = FlowPersistence([0, 1, 2]).fit_transform([points])[0]
    for k, diagram in enumerate(ours):
        theirs = tree.persistence_intervals_in_dimension(k)
        order = lambda rows: rows[np.lexsort(rows.T)]
        assert order(diagram) == pytest.approx(order(np.asarray(theirs).reshape(-1, 2)))


def test_it_is_used_as_gudhis_rips_persistence():
    rips = pytest.importorskip("gudhi.sklearn.rips_persistence", reason="no RipsPersistence: GUDHI 3.11 has it")
    sets = [sphere_sample(12, seed) for seed in (1, 2)]
    for dimensions in (0, [0, 1]):
        ours, theirs = (
            some.fit_transform(sets)
            for some in (FlowPersistence(dimensions, squared=False), rips.RipsPersistence(dimensions))
        )
        components = [[each if dimensions == 0 else each[0] for each in some] for some in (ours, theirs)]
        for some, same in zip(*components):  # an edge of length d is in balls of radius d / 2
            assert 2 * np.sort(some[:, 1]) == pytest.approx(np.sort(same[:, 1]))


def test_clones_and_parameters():
    from sklearn.base import clone

    made = FlowPersistence([1, 2], squared=False, n_jobs=2)
    assert made.get_params() == {"homology_dimensions": [1, 2], "squared": False, "n_jobs": 2}
    again = clone(made).set_params(squared=True)
    assert again.get_params() == {"homology_dimensions": [1, 2], "squared": True, "n_jobs": 2}
    assert repr(pickle.loads(pickle.dumps(made))) == repr(made)
    assert made.get_feature_names_out().tolist() == ["H1", "H2"]
    assert FlowPersistence(2).get_feature_names_out().tolist() == ["H2"]


def test_a_pipeline_tells_spheres_from_balls():
    from sklearn.linear_model import LogisticRegression
    from sklearn.model_selection import GridSearchCV
    from sklearn.pipeline import make_pipeline
    from sklearn.preprocessing import FunctionTransformer

    numbers = np.random.default_rng(1)
    sets, labels = [], []
    for k in range(8):
        sphere = sphere_sample(40, k)
        sets += [sphere, sphere * np.cbrt(numbers.random((40, 1)))]
        labels += [1, 0]
    longest = FunctionTransformer(lambda diagrams: [[max(np.diff(some), default=[0])[0]] for some in diagrams])
    pipeline = make_pipeline(FlowPersistence(homology_dimensions=2), longest, LogisticRegression(C=1000))
    search = GridSearchCV(pipeline, {"flowpersistence__squared": [True, False]}, cv=2)
    assert search.fit(sets, labels).score(sets, labels) == 1


def test_gudhis_vectors_take_the_diagrams():
    representations = pytest.importorskip("gudhi.representations")
    from sklearn.pipeline import make_pipeline

    sets = [sphere_sample(20, seed) for seed in (1, 2)]
    finite = make_pipeline(FlowPersistence(0), representations.DiagramSelector(use=True), representations.Entropy())
    images = make_pipeline(FlowPersistence(homology_dimensions=1), representations.PersistenceImage())
    assert np.isfinite(finite.fit_transform(sets)).all() and images.fit_transform(sets).shape == (2, 400)


@pytest.mark.parametrize("dimensions", [3, [0, 3], -1, "x"])
def test_dimensions_that_there_are_not(dimensions):
    with pytest.raises(ValueError, match="homology_dimensions: not from 0 to 2, but"):
        FlowPersistence(dimensions).fit([CUBE])


def test_its_docstrings():
    import doctest

    import flowcert.sklearn

    found = doctest.testmod(flowcert.sklearn)
    assert found.attempted >= 4 and found.failed == 0
    assert set(flowcert.sklearn.__all__) == {"FlowPersistence"}
