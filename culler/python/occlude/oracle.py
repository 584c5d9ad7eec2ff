# SPDX-License-Identifier: MIT
"""The kernel's question, answered in exact arithmetic by code that shares nothing with the kernel. There only where the
oracle was built. It uses parts of CGAL under the LGPL."""
from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import ShadowFrustum, _oracle


def relations(frustum: ShadowFrustum, boxes: ArrayLike) -> NDArray[np.uint8]:
    """The relation of each box to a ShadowFrustum: what frustum.relations(boxes) must be."""
    return _oracle.relations(
        frustum.viewpoint,
        frustum.is_direction,
        frustum.vertices,
        frustum.faces,
        frustum.near,
        frustum.support_plane,
        boxes,
    )
