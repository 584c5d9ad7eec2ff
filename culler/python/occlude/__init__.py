# SPDX-License-Identifier: MIT
"""The occlusion culler that is never wrong: scenes that change, models, and the kernel's questions in bulk."""
from __future__ import annotations

import enum
import typing

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ._occlude import (
    Camera,
    Culler,
    DrawOrder,
    EyeRegion,
    Fate,
    HeldCull,
    HeldFrame,
    HeldSceneCull,
    MatrixCamera,
    ModelFrame,
    OccluderMesh,
    Scene,
    SceneFrame,
    ShadowFrustum,
    SimplifiedOccluders,
    View,
    __version__,
    ahead,
    is_fan,
    margin_for,
    simplified_occluders,
    triangulate,
)

__all__ = [
    "Camera",
    "CulledBy",
    "Culler",
    "DrawOrder",
    "EyeRegion",
    "Fate",
    "HeldCull",
    "HeldFrame",
    "HeldSceneCull",
    "MatrixCamera",
    "ModelFrame",
    "ObjectId",
    "OccluderId",
    "OccluderMesh",
    "Reason",
    "Relation",
    "Scene",
    "SceneFrame",
    "ShadowFrustum",
    "SimplifiedOccluders",
    "Stage",
    "View",
    "Visibility",
    "__version__",
    "ahead",
    "is_fan",
    "margin_for",
    "simplified_occluders",
    "slot",
    "triangulate",
]

# What an id names, its generation and its scene are in the number. Arrays of ids are of numpy.uint64.
ObjectId = typing.NewType("ObjectId", np.uint64)
OccluderId = typing.NewType("OccluderId", np.uint64)


class Visibility(enum.IntEnum):
    """Of a box in the last frame of a view."""

    VISIBLE = 0  # neither of the other two could be proved
    OCCLUDED = 1  # all of it is hidden
    OUT_OF_VIEW = 2  # all of it is beyond one plane of the view


class Reason(enum.IntEnum):
    """What became of an object in a frame of a scene."""

    DRAWN = 0
    ALWAYS_DRAWN = 1
    OUT_OF_VIEW = 2
    HIDDEN = 3
    TOO_SMALL = 4
    IN_NO_LAYER = 5
    NOT_IN_SCENE = 6


class CulledBy(enum.IntEnum):
    """Why polygons of a model are not drawn."""

    VIEW = 0
    SHADOW = 1
    COVER = 2


class Relation(enum.IntEnum):
    """Of a box to a shadow."""

    INSIDE = 0
    PARTIAL = 1
    OUTSIDE = 2


class Stage(enum.IntEnum):
    """Of certified arithmetic: which decided. Both are equally right."""

    FILTER = 0
    EXACT = 1


def slot(ids: ArrayLike) -> NDArray[np.intp]:
    """Small numbers that objects, or occluders, have to themselves while they are in a scene: indices for arrays of one's
    own. Takes an id or an array of them."""
    return (np.asarray(ids, np.uint64) & np.uint64(0xFFFFFFF)).astype(np.intp)
