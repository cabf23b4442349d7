"""The Skeleton tab on a torus."""

import pytest

from app.scene.colours import LIGHT
from app.session import Session
from app.ui.skeleton_tab import SkeletonTab
from app.ui.tasks import Poster
from core.io import save_mesh
from core.mesh import primitives
from core.study import MethodChoice, Study

LONG = 60_000


@pytest.fixture
def torus_session(qtbot, tmp_path):
    path = tmp_path / "torus.ply"
    save_mesh(primitives.torus(40, 20), path)
    session = Session(Poster())
    methods = (MethodChoice(method="mean", iterations=1),)
    session.apply(Study(model=str(path), methods=methods), "Open")
    qtbot.waitUntil(lambda: session.meshes is not None and session.activity is None, timeout=LONG)
    yield session
    session.close()


@pytest.fixture
def hidden_tab(qtbot, torus_session):
    tab = SkeletonTab(torus_session, LIGHT)
    qtbot.addWidget(tab, before_close_func=SkeletonTab.close_graphics)
    tab.resize(1100, 750)
    return tab


@pytest.fixture
def settle(qtbot, hidden_tab):
    """Wait until the graphs are drawn and the viewport shows them."""

    def settle():
        tab = hidden_tab
        qtbot.waitUntil(
            lambda: (
                tab.session.activity is None
                and tab.views.is_settled
                and not tab._redraw_timer.isActive()
            ),
            timeout=LONG,
        )

    return settle


@pytest.fixture
def tab(qtbot, hidden_tab, settle):
    hidden_tab.show()
    with qtbot.waitExposed(hidden_tab):
        pass
    settle()
    return hidden_tab
