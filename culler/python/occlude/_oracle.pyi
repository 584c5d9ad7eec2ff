# SPDX-License-Identifier: MIT
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

def relations(
    viewpoint: ArrayLike,
    is_direction: bool,
    vertices: ArrayLike,
    faces: Any,
    near: str,
    support_plane: Any,
    boxes: ArrayLike,
) -> NDArray[np.uint8]: ...
