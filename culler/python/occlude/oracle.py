# SPDX-License-Identifier: MIT
"""The kernel's question, answered in exact arithmetic by code that shares nothing with the kernel. There only where the
oracle was built. It uses parts of CGAL under the LGPL."""
from . import _oracle


def relations(frustum, boxes):
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
