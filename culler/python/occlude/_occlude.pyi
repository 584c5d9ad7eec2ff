# SPDX-License-Identifier: MIT
from typing import Any, Callable, Literal, Sequence, Union

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import ObjectId, OccluderId

__version__: str

AnyCamera = Union[Camera, MatrixCamera]
AnyFrame = Union[ModelFrame, HeldFrame]
AnyPolygons = Union[ArrayLike, Sequence[ArrayLike]]

class EyeRegion:
    @staticmethod
    def ball(radius: float) -> EyeRegion: ...
    @staticmethod
    def box(a: ArrayLike, b: ArrayLike = [0.0, 0.0, 0.0], c: ArrayLike = [0.0, 0.0, 0.0]) -> EyeRegion: ...

class Camera:
    def __init__(
        self,
        eye: ArrayLike,
        target: ArrayLike,
        up: ArrayLike = [0.0, 0.0, 1.0],
        projection: Literal["perspective", "orthographic"] = "perspective",
        fov_y_deg: float = 60.0,
        height: float = 100.0,
        aspect: float = ...,
        near: float = 0.1,
        far: float = ...,
        eyes: EyeRegion = ...,
    ) -> None: ...

class MatrixCamera:
    def __init__(
        self,
        matrix: ArrayLike,
        depth: Literal["minus_w_to_w", "zero_to_w"],
        nearer: Literal["less", "greater", None] = None,
        eyes: EyeRegion = ...,
    ) -> None: ...
    @staticmethod
    def from_camera(
        camera: Camera, depth: Literal["minus_w_to_w", "zero_to_w"], nearer: Literal["less", "greater"]
    ) -> MatrixCamera: ...
    @property
    def matrix(self) -> NDArray[np.float64]: ...
    @property
    def eye(self) -> NDArray[np.float64]: ...

def margin_for(rows: float, pixels: float = 0.0078125) -> float: ...

def ahead(
    camera: AnyCamera,
    velocity: ArrayLike,
    seconds: float,
    *,
    aside: float = 0.1,
    up: float = 0.05,
    turn_degrees: float = 0.0,
) -> Camera: ...

class View:
    def __init__(self) -> None: ...
    def holds_for(self, camera: AnyCamera) -> bool: ...
    def visibility(self, boxes: ArrayLike) -> NDArray[np.uint8]: ...

class OccluderMesh:
    def __init__(
        self,
        vertices: ArrayLike,
        polygons: AnyPolygons,
        sizes: Union[ArrayLike, None] = None,
        see_through: Union[ArrayLike, None] = None,
    ) -> None: ...
    def __len__(self) -> int: ...

class SceneFrame:
    @property
    def drawn(self) -> NDArray[np.void]: ...
    @property
    def planes(self) -> NDArray[np.float64]: ...
    @property
    def statistics(self) -> dict[str, int]: ...
    @property
    def idle_occluders(self) -> NDArray[np.uint64]: ...

class Fate:
    @property
    def reason(self) -> int: ...
    @property
    def plane(self) -> int: ...
    @property
    def by(self) -> list[tuple[OccluderId, int, NDArray[np.float64]]]: ...

class Scene:
    def __init__(self) -> None: ...
    def add_object(
        self, box: ArrayLike, *, moves: bool = False, is_always_drawn: bool = False, mask: int = 0xFFFFFFFF
    ) -> ObjectId: ...
    def add_objects(
        self, boxes: ArrayLike, *, moves: bool = False, is_always_drawn: bool = False, mask: int = 0xFFFFFFFF
    ) -> NDArray[np.uint64]: ...
    def move_objects(self, ids: ArrayLike, boxes: ArrayLike) -> None: ...
    def remove_objects(self, ids: ArrayLike) -> None: ...
    def enable_objects(self, ids: ArrayLike, is_enabled: bool) -> None: ...
    def mask_objects(self, ids: ArrayLike, mask: int) -> None: ...
    def has_object(self, id: ObjectId) -> bool: ...
    def add_occluder(
        self,
        mesh: OccluderMesh,
        placement: Union[ArrayLike, None] = None,
        *,
        moves: bool = False,
        is_one_sided: bool = False,
        mask: int = 0xFFFFFFFF,
        object: Union[ObjectId, None] = None,
        weld: int = 0,
    ) -> OccluderId: ...
    def add_occluders(
        self,
        mesh: OccluderMesh,
        placements: ArrayLike,
        *,
        moves: bool = False,
        is_one_sided: bool = False,
        mask: int = 0xFFFFFFFF,
        object: Union[ObjectId, None] = None,
        weld: int = 0,
    ) -> NDArray[np.uint64]: ...
    def move_occluder(self, id: OccluderId, placement: Union[ArrayLike, None]) -> None: ...
    def replace_occluder(self, id: OccluderId, mesh: OccluderMesh) -> None: ...
    def move_occluders(self, ids: ArrayLike, placements: ArrayLike) -> None: ...
    def remove_occluders(self, ids: ArrayLike) -> None: ...
    def enable_occluders(self, ids: ArrayLike, is_enabled: bool) -> None: ...
    def mask_occluders(self, ids: ArrayLike, mask: int) -> None: ...
    def has_occluder(self, id: OccluderId) -> bool: ...
    def update(self, *, threads: int = 1) -> None: ...
    def cull(
        self,
        camera: AnyCamera,
        view: Union[View, None] = None,
        *,
        cover_size: tuple[int, int] = (576, 360),
        cover_work: Union[int, None] = None,
        cover_ms: Union[float, None] = None,
        margin: float = 0.0,
        mask: int = 0xFFFFFFFF,
        least_size: float = 0.0,
        front_to_back: bool = False,
        adaptive: bool = True,
        to_be_held: bool = False,
        held: Union[View, None] = None,
        threads: int = 1,
    ) -> SceneFrame: ...
    def holds(self, held: View, camera: AnyCamera, *, mask: int = 0xFFFFFFFF, least_size: float = 0.0) -> bool: ...
    def why(self, ids: ArrayLike, view: View) -> list[Fate]: ...
    @property
    def objects(self) -> int: ...
    @property
    def occluders(self) -> int: ...

class ModelFrame:
    @property
    def drawn(self) -> NDArray[np.void]: ...
    @property
    def polygons(self) -> NDArray[np.uint32]: ...
    @property
    def culled(self) -> NDArray[np.void]: ...
    @property
    def planes(self) -> NDArray[np.float64]: ...
    @property
    def statistics(self) -> dict[str, int]: ...

class Culler:
    def __init__(
        self,
        vertices: ArrayLike,
        polygons: AnyPolygons,
        sizes: Union[ArrayLike, None] = None,
        *,
        see_through: Union[ArrayLike, None] = None,
        leaf_size: int = 4,
        bounds: Literal["aabb", "obb"] = "aabb",
    ) -> None: ...
    def prepare(self, method: Literal["automatic", "frusta", "cover"] = "automatic") -> None: ...
    def cull(
        self,
        camera: AnyCamera,
        view: Union[View, None] = None,
        *,
        method: Literal["automatic", "frusta", "cover"] = "automatic",
        occluders: int = 8,
        probes: int = 8,
        near: Literal["surface", "farthest"] = "surface",
        arithmetic: Literal["certified", "plain"] = "certified",
        test: Literal["conservative", "overlap"] = "conservative",
        margin: float = 0.0,
        unions: bool = False,
        cover_size: tuple[int, int] = (576, 360),
        cover_work: Union[int, None] = None,
        cover_ms: Union[float, None] = None,
    ) -> ModelFrame: ...
    def __len__(self) -> int: ...
    @property
    def order(self) -> NDArray[np.uint32]: ...

class HeldFrame:
    @property
    def drawn(self) -> NDArray[np.void]: ...
    @property
    def polygons(self) -> NDArray[np.uint32]: ...
    @property
    def is_of_point(self) -> bool: ...

class HeldCull:
    def __init__(
        self,
        culler: Culler,
        *,
        aside: float = 0.1,
        up: float = 0.05,
        turn_degrees: float = 2.0,
        later: Union[Callable[[Callable[[], None]], object], None] = None,
        repeatable: bool = False,
        method: Literal["automatic", "frusta", "cover"] = "automatic",
        occluders: int = 8,
        probes: int = 8,
        near: Literal["surface", "farthest"] = "surface",
        arithmetic: Literal["certified", "plain"] = "certified",
        test: Literal["conservative", "overlap"] = "conservative",
        margin: float = 0.0,
        unions: bool = False,
        cover_size: tuple[int, int] = (576, 360),
        cover_work: Union[int, None] = None,
        cover_ms: Union[float, None] = None,
    ) -> None: ...
    def cull(self, camera: AnyCamera, seconds: float) -> HeldFrame: ...
    @property
    def statistics(self) -> dict[str, int]: ...

class HeldSceneCull:
    def __init__(
        self,
        scene: Scene,
        *,
        aside: float = 0.1,
        up: float = 0.05,
        turn_degrees: float = 2.0,
        later: Union[Callable[[Callable[[], None]], object], None] = None,
        repeatable: bool = False,
        cover_size: tuple[int, int] = (576, 360),
        cover_work: Union[int, None] = None,
        cover_ms: Union[float, None] = None,
        margin: float = 0.0,
        mask: int = 0xFFFFFFFF,
        least_size: float = 0.0,
        front_to_back: bool = False,
        threads: int = 1,
    ) -> None: ...
    def cull(self, camera: AnyCamera, seconds: float) -> SceneFrame: ...
    @property
    def is_of_point(self) -> bool: ...
    @property
    def statistics(self) -> dict[str, int]: ...

class DrawOrder:
    def __init__(self, culler: Culler, materials: ArrayLike) -> None: ...
    @property
    def polygons(self) -> NDArray[np.uint32]: ...
    @property
    def materials(self) -> NDArray[np.void]: ...
    def ranges(self, frame: AnyFrame) -> NDArray[np.void]: ...

class ShadowFrustum:
    def __init__(
        self,
        vertices: ArrayLike,
        faces: Union[AnyPolygons, None] = None,
        *,
        eye: Union[ArrayLike, None] = None,
        direction: Union[ArrayLike, None] = None,
        near: Literal["surface", "farthest"] = "surface",
    ) -> None: ...
    def relations(
        self,
        boxes: ArrayLike,
        *,
        arithmetic: Literal["certified", "plain"] = "certified",
        test: Literal["overlap", "conservative"] = "overlap",
        near_boundary: Literal["closed", "open"] = "closed",
    ) -> NDArray[np.uint8]: ...
    def stages(
        self,
        boxes: ArrayLike,
        *,
        test: Literal["overlap", "conservative"] = "overlap",
        near_boundary: Literal["closed", "open"] = "closed",
    ) -> NDArray[np.uint8]: ...
    @property
    def vertices(self) -> NDArray[np.float64]: ...
    @property
    def faces(self) -> Any: ...
    @property
    def near(self) -> str: ...
    @property
    def viewpoint(self) -> NDArray[np.float64]: ...
    @property
    def is_direction(self) -> bool: ...
    @property
    def support_plane(self) -> Union[tuple[NDArray[np.float64], NDArray[np.float64]], None]: ...

class SimplifiedOccluders:
    @property
    def vertices(self) -> NDArray[np.float64]: ...
    @property
    def triangles(self) -> NDArray[np.uint32]: ...
    @property
    def polygons(self) -> NDArray[np.uint32]: ...
    @property
    def box(self) -> NDArray[np.int64]: ...
    @property
    def boxes(self) -> NDArray[np.float64]: ...
    @property
    def drawn_triangles(self) -> int: ...
    @property
    def flat_triangles(self) -> int: ...
    def __len__(self) -> int: ...

def simplified_occluders(
    vertices: ArrayLike,
    polygons: AnyPolygons,
    sizes: Union[ArrayLike, None] = None,
    *,
    see_through: Union[ArrayLike, None] = None,
    triangles: int = 10000,
    views: list[Camera] = [],
    boxes: int = 0,
    cells: int = 16,
    inset: float = 0.0,
) -> SimplifiedOccluders: ...
def is_fan(vertices: ArrayLike, loop: ArrayLike) -> bool: ...
def triangulate(vertices: ArrayLike, loop: ArrayLike) -> NDArray[np.uint32]: ...
