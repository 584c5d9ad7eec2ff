# SPDX-License-Identifier: MIT
"""Scenes that change, against rays."""
import unittest

import numpy as np

import brute
import occlude
from occlude import Reason, Visibility


def camera_towards(rng):
    eye = rng.uniform(-4, 4, 3)
    return eye, occlude.Camera(eye, eye + rng.normal(size=3) + [1, 0, 0], aspect=1.5)


class World:
    """A scene, and the same in plain arrays."""

    def __init__(self, rng):
        self.rng, self.scene = rng, occlude.Scene()
        self.boxes, self.walls = {}, {}
        low, high = np.array([-0.5, -4, -2]), np.array([0.5, 3, 3.5])
        vertices, polygons = brute.cube(low, high)
        self.mesh = occlude.OccluderMesh(vertices.astype("f4"), polygons.astype("u2"))
        self.triangles = np.concatenate([brute.fan(vertices, polygon) for polygon in polygons])

    def random_boxes(self, count):
        low = self.rng.uniform(-40, 40, (count, 3))
        return np.hstack([low, low + self.rng.uniform(0.1, 2, (count, 3))])

    def add(self, count, **options):
        boxes = self.random_boxes(count)
        ids = self.scene.add_objects(boxes, **options)
        self.boxes.update(zip(ids.tolist(), boxes))
        return ids

    def random_placement(self):
        placement = np.eye(4)
        placement[:3, :3] += self.rng.normal(size=(3, 3)) / 4
        far = self.rng.normal(size=3)
        placement[:3, 3] = far / np.linalg.norm(far) * self.rng.uniform(12, 25)
        return placement

    def add_wall(self, **options):
        placement = self.random_placement()
        self.walls[self.scene.add_occluder(self.mesh, placement, **options)] = placement

    def all_triangles(self):
        placed = [self.triangles @ p[:3, :3].T + p[:3, 3] for p in self.walls.values()]
        return np.concatenate(placed) if placed else np.empty((0, 3, 3))


class Scenes(unittest.TestCase):
    def check_frame(self, world, view):
        eye, camera = camera_towards(world.rng)
        frame = world.scene.cull(camera, view)
        drawn = set(frame.drawn["id"].tolist())
        self.assertEqual(len(drawn), len(frame.drawn))
        self.assertLessEqual(drawn, set(world.boxes))
        triangles, counts = world.all_triangles(), {"hidden": 0, "out_of_view": 0}
        for id, box in world.boxes.items():
            if id in drawn:
                continue
            points = brute.points_of(box, world.rng, 24)
            if any(np.all(points @ plane[:3] + plane[3] < 0) for plane in frame.planes):
                counts["out_of_view"] += 1
                continue
            counts["hidden"] += 1
            self.assertTrue(np.all(brute.is_hidden(eye, points, triangles)), f"object {id} is seen: {box}")
        statistics = frame.statistics
        self.assertEqual(statistics["drawn"], len(drawn))
        for name, count in counts.items():
            self.assertEqual(statistics[name], count, name)
        sample = list(world.boxes)[:50]
        seen = view.visibility([world.boxes[id] for id in sample])
        for id, visibility in zip(sample, seen):
            self.assertEqual(id in drawn, visibility == Visibility.VISIBLE)
        return counts["hidden"]

    def test_changes(self):
        rng = brute.random()
        world, view, hidden = World(rng), occlude.View(), 0
        world.add(300)
        moving = world.add(100, moves=True)
        for i in range(25):
            world.add_wall(moves=i % 2 == 0)
        for _ in range(20):
            boxes = world.random_boxes(len(moving))
            world.scene.move_objects(moving, boxes)
            world.boxes.update(zip(moving.tolist(), boxes))
            gone = rng.choice(sorted(set(world.boxes) - set(moving.tolist())), 20, replace=False)
            world.scene.remove_objects(gone.astype("u8"))
            for id in gone.tolist():
                self.assertFalse(world.scene.has_object(id))
                del world.boxes[id]
            world.add(20)
            wall = rng.choice(list(world.walls)).item()
            world.scene.remove_occluders([wall])
            del world.walls[wall]
            world.add_wall()
            other = rng.choice(list(world.walls)).item()
            world.walls[other] = world.random_placement()
            world.scene.move_occluder(other, world.walls[other][:3])
            world.scene.update()
            self.assertEqual(world.scene.objects, len(world.boxes))
            self.assertEqual(world.scene.occluders, len(world.walls))
            hidden += self.check_frame(world, view)
        self.assertGreater(hidden, 50)

    def test_layers_order_and_size(self):
        rng = brute.random()
        world = World(rng)
        near, far = world.add(200, mask=1), world.add(200, mask=2)
        world.scene.update()
        camera = occlude.Camera([-60, 0, 0], [0, 0, 0])
        self.assertLessEqual(set(world.scene.cull(camera, mask=1).drawn["id"]), set(near))
        frame = world.scene.cull(camera, front_to_back=True)
        self.assertTrue(np.all(np.diff(frame.drawn["distance"]) >= 0))
        self.assertFalse(np.all(np.diff(world.scene.cull(camera).drawn["distance"]) >= 0))
        small = world.scene.cull(camera, least_size=0.05)
        kept = frame.drawn[frame.drawn["size"] >= np.float32(0.05)]["id"]
        self.assertEqual(set(small.drawn["id"]), set(kept))
        self.assertEqual(small.statistics["too_small"], len(frame.drawn) - len(kept))
        world.scene.enable_objects(near, False)
        world.scene.mask_objects(far, 4)
        world.scene.update()
        self.assertEqual(len(world.scene.cull(camera, mask=3).drawn), 0)
        self.assertEqual(set(world.scene.cull(camera).drawn["id"]), set(far) & set(frame.drawn["id"]))

    def test_threads_change_nothing(self):
        world = World(brute.random())
        boxes = world.random_boxes(20000)
        camera, frames = occlude.Camera([0, 0, 0], [1, 0, 0]), []
        for threads in (1, 2, 7):
            scene = occlude.Scene()
            scene.add_objects(boxes)
            scene.add_occluder(world.mesh, np.hstack([np.eye(3), [[12], [0], [0]]]))
            scene.update(threads=threads)
            frames.append(scene.cull(camera, threads=threads))
            self.assertGreater(frames[-1].statistics["hidden"], 100)
            np.testing.assert_array_equal(occlude.slot(frames[-1].drawn["id"]), occlude.slot(frames[0].drawn["id"]))
            np.testing.assert_array_equal(frames[-1].drawn[["size", "distance"]], frames[0].drawn[["size", "distance"]])
            self.assertEqual(frames[-1].statistics, frames[0].statistics)

    def test_welds(self):
        scene, left = occlude.Scene(), np.array([[10, -5, -5], [10, 0, -5], [10, 0, 5], [10, -5, 5]], float)
        behind = scene.add_object([20, -1, -1, 21, 1, 1])
        mesh, beside = occlude.OccluderMesh(left, [[0, 1, 2, 3]]), np.eye(4)
        beside[1, 3] = 5
        camera, view = occlude.Camera([0, 0, 0], [1, 0, 0]), occlude.View()
        for weld in (0, 7):
            with self.subTest(weld=weld):
                walls = [scene.add_occluder(mesh, weld=weld), *scene.add_occluders(mesh, [beside], weld=weld)]
                scene.update()
                hidden = behind not in scene.cull(camera, view).drawn["id"]
                self.assertEqual(hidden, weld != 0, "without a seam, or with one")
                if hidden:
                    self.assertEqual({by[0] for by in scene.why([behind], view)[0].by}, set(walls))
                scene.remove_occluders(walls)

    def test_occluders(self):
        scene, square = occlude.Scene(), np.array([[10, -5, -5], [10, 5, -5], [10, 5, 5], [10, -5, 5]], "f4")
        behind = scene.add_object([20, -1, -1, 21, 1, 1])
        wall_object = scene.add_object([[10, -5, -5], [10, 5, 5]])
        camera = occlude.Camera([0, 0, 0], [1, 0, 0])
        whole, turned = occlude.OccluderMesh(square, [[0, 1, 2, 3]]), occlude.OccluderMesh(square, [[3, 2, 1, 0]])
        half = occlude.OccluderMesh(square, [0, 1, 2], sizes=[3])
        self.assertEqual((len(whole), len(half)), (1, 1))
        wall = scene.add_occluder(whole, object=wall_object, is_one_sided=True)

        def hides():
            scene.update()
            return behind not in scene.cull(camera).drawn["id"]

        self.assertFalse(hides())
        scene.replace_occluder(wall, turned)
        self.assertTrue(hides())
        scene.replace_occluder(wall, half)
        self.assertFalse(hides())
        scene.replace_occluder(wall, turned)
        scene.enable_objects([wall_object], False)
        self.assertFalse(hides())
        scene.enable_objects([wall_object], True)
        scene.enable_occluders([wall], False)
        self.assertFalse(hides())
        scene.enable_occluders([wall], True)
        self.assertTrue(hides())
        self.assertEqual(list(scene.cull(camera).idle_occluders), [])
        scene.enable_objects([behind], False)
        scene.update()
        self.assertEqual(list(scene.cull(camera).idle_occluders), [wall])
        scene.enable_objects([behind], True)
        scene.mask_occluders([wall], 0)
        self.assertFalse(hides())
        self.assertTrue(scene.has_occluder(wall))
        scene.remove_occluders([wall])
        self.assertFalse(scene.has_occluder(wall))
        self.assertEqual(occlude.slot(behind), 0)
        self.assertEqual(occlude.slot(np.array([wall_object], "u8"))[0], 1)

    def test_matrix_cameras(self):
        rng = brute.random()
        world, view = World(rng), occlude.View()
        world.add(1500)
        for _ in range(40):
            world.add_wall()
        world.scene.update()
        axes = np.linalg.qr(rng.normal(size=(3, 3)))[0]
        axes[0] *= np.linalg.det(axes)  # not mirrored
        eye = np.array([1.0, 2, 3])
        model = np.eye(4)
        model[:3, :3], model[:3, 3] = axes, -axes @ eye
        projection = np.array([[1, 0, 0, 0], [0, 1.5, 0, 0], [0, 0, -1, -0.2], [0, 0, -1, 0]])
        camera = occlude.MatrixCamera(projection @ model, "minus_w_to_w")
        np.testing.assert_allclose(camera.eye, eye)
        same = occlude.Camera(eye, eye - axes[2], axes[1], fov_y_deg=np.degrees(2 * np.arctan(1 / 1.5)), aspect=1.5)
        frame = world.scene.cull(camera, view)
        other = world.scene.cull(same)
        self.assertLess(len(set(frame.drawn["id"]) ^ set(other.drawn["id"])), 10)
        fates = world.scene.why(list(world.boxes), view)
        drawn = set(frame.drawn["id"].tolist())
        reasons = dict(zip(world.boxes, fates))
        for id, fate in reasons.items():
            self.assertEqual(id in drawn, fate.reason == Reason.DRAWN)
            points = brute.points_of(world.boxes[id], rng, 24)
            if fate.reason == Reason.HIDDEN:
                corners = [c[[0, i, i + 1]] for _, _, c in fate.by for i in range(1, len(c) - 1)]
                self.assertTrue(np.all(brute.is_hidden(camera.eye, points, corners)))
                self.assertTrue(all(occluder in world.walls for occluder, _, _ in fate.by))
            elif fate.reason == Reason.OUT_OF_VIEW:
                plane = frame.planes[fate.plane]
                self.assertTrue(np.all(points @ plane[:3] + plane[3] < 0))
        self.assertEqual(frame.statistics["hidden"], sum(f.reason == Reason.HIDDEN for f in fates))
        self.assertGreater(frame.statistics["hidden"], 10)
        several = world.scene.cull(occlude.MatrixCamera(projection @ model, "minus_w_to_w", eyes=occlude.EyeRegion.ball(2)))
        self.assertLessEqual(drawn, set(several.drawn["id"].tolist()))
        self.assertLess(len(drawn), len(several.drawn))
        parallel = np.diag([0.02, 0.02, -0.02, 1]) @ model
        self.assertGreater(len(world.scene.cull(occlude.MatrixCamera(parallel, "zero_to_w", "less")).drawn), 0)
        for text, arguments in (
            ("matrix must have shape", (np.eye(3), "zero_to_w")),
            ("depth is 'z', must be 'minus_w_to_w' or 'zero_to_w'", (parallel, "z")),
            ("nearer is 'more', must be 'less' or 'greater'", (parallel, "zero_to_w", "more")),
            ("near", (parallel, "zero_to_w")),
            (".", (np.zeros((4, 4)), "zero_to_w", "less")),
        ):
            with self.assertRaisesRegex(ValueError, text):
                occlude.MatrixCamera(*arguments)
        with self.assertRaisesRegex(ValueError, "the view has no frame of a scene"):
            world.scene.why([1], occlude.View())
        made = occlude.MatrixCamera.from_camera(same, "zero_to_w", nearer="greater")  # reversed and infinite
        frame = world.scene.cull(made, margin=occlude.margin_for(1080))
        self.assertLess(len(set(frame.drawn["id"]) ^ set(other.drawn["id"])), 10)
        clip = made.matrix @ [*(eye - 0.1 * axes[2]), 1]
        np.testing.assert_allclose(clip / clip[3], [0, 0, 1, 1], atol=1e-12)
        self.assertEqual(occlude.margin_for(1080), 1 / 128 / 1080)
        self.assertEqual(occlude.margin_for(1080, pixels=0.5), 0.5 / 1080)
        with self.assertRaisesRegex(ValueError, "a picture has more than 0 rows"):
            occlude.margin_for(0)
        with self.assertRaisesRegex(ValueError, "parallel rays without a far plane have no matrix"):
            occlude.MatrixCamera.from_camera(occlude.Camera(eye, eye + 1, projection="orthographic"), "zero_to_w", "less")

    def refuses(self, scene, text, ids, occluders):
        """Everything that takes an id of an object refuses `ids`, and that of an occluder `occluders`: arrays of one."""
        mesh = occlude.OccluderMesh(np.empty((0, 3)), [])
        view, good = occlude.View(), scene.add_object([0, 0, 0, 1, 1, 1])
        scene.cull(occlude.Camera([0, 0, 0], [1, 0, 0]), view)
        self.assertFalse(scene.has_object(ids[0]))
        self.assertFalse(scene.has_occluder(occluders[0]))
        both, counts = np.append(ids, good), (scene.objects, scene.occluders)
        for call in (
            lambda: scene.remove_objects(both),
            lambda: scene.move_objects(both, np.zeros((2, 6))),
            lambda: scene.enable_objects(both, False),
            lambda: scene.mask_objects(both, 0),
            lambda: scene.add_occluder(mesh, object=ids[0]),
            lambda: scene.add_occluders(mesh, [np.eye(4)], object=ids[0]),
            lambda: scene.why(both, view),
            lambda: scene.remove_occluders(occluders),
            lambda: scene.move_occluder(occluders[0], None),
            lambda: scene.move_occluders(occluders, [np.eye(4)]),
            lambda: scene.replace_occluder(occluders[0], mesh),
            lambda: scene.enable_occluders(occluders, False),
            lambda: scene.mask_occluders(occluders, 0),
        ):
            with self.assertRaisesRegex(ValueError, text):
                call()
        self.assertEqual(counts, (scene.objects, scene.occluders))
        scene.remove_objects([good])

    def test_ids_are_refused_where_they_name_nothing(self):
        scene, other = occlude.Scene(), occlude.Scene()
        mesh = occlude.OccluderMesh(np.empty((0, 3)), [])
        things, walls = scene.add_objects([[0, 0, 0, 1, 1, 1]] * 3), scene.add_occluders(mesh, [np.eye(4)] * 3)
        there, standing = other.add_objects([[0, 0, 0, 1, 1, 1]]), other.add_occluders(mesh, [np.eye(4)])
        self.assertEqual(occlude.slot(things).tolist(), occlude.slot(walls).tolist())
        self.refuses(scene, "the id is that of an? (object|occluder), not of an? (object|occluder)", walls[:1], things[:1])
        self.refuses(scene, "the id is that of another scene", there, standing)
        self.refuses(scene, "the scene has no such (object|occluder)", things[:1] + np.uint64(99), walls[:1] + np.uint64(99))
        scene.remove_objects(things[:1])
        scene.remove_occluders(walls[:1])
        self.refuses(scene, "the scene has no such (object|occluder)", things[:1], walls[:1])
        anew, again = scene.add_object([0, 0, 0, 1, 1, 1]), scene.add_occluder(mesh)
        self.assertEqual((occlude.slot(anew), occlude.slot(again)), (occlude.slot(things[0]), occlude.slot(walls[0])))
        self.refuses(scene, "the scene has no such (object|occluder)", things[:1], walls[:1])
        # Scalars are those of NumPy, so that they go into arrays with others.
        self.assertTrue(isinstance(anew, np.uint64) and isinstance(again, np.uint64))
        scene.remove_objects([anew, things[1], anew, things[1]])
        scene.remove_occluders([again, again])
        self.assertEqual((scene.objects, scene.occluders), (1, 2))
        del other
        self.refuses(scene, "the id is that of another scene", there, standing)

    def test_many_occluders(self):
        world = World(brute.random())
        at = np.stack([world.random_placement() for _ in range(20)])
        world.add(300)
        walls = world.scene.add_occluders(world.mesh, at[:, :3], moves=True)
        self.assertEqual((walls.dtype, len(walls), world.scene.occluders), (np.uint64, 20, 20))
        world.walls.update(zip(walls, at))
        world.scene.update()
        view = occlude.View()
        hidden = sum(self.check_frame(world, view) for _ in range(6))
        at = at[::-1].copy()
        at[:, :3, 3] *= 0.9
        world.scene.move_occluders(walls, at)
        world.walls.update(zip(walls, at))
        world.scene.update()
        hidden += sum(self.check_frame(world, view) for _ in range(6))
        self.assertGreater(hidden, 20)
        at[1, 0, 3] = np.nan
        for call in (lambda: world.scene.add_occluders(world.mesh, at), lambda: world.scene.move_occluders(walls, at)):
            with self.assertRaisesRegex(ValueError, "placement 1: an occluder's placement is not finite"):
                call()
        self.assertEqual(world.scene.occluders, 20)
        self.assertEqual(world.scene.add_occluders(world.mesh, np.empty((0, 4, 4))).shape, (0,))

    def test_refusals(self):
        scene = occlude.Scene()
        ids = scene.add_objects([[0, 0, 0, 1, 1, 1], [5, 0, 0, 6, 1, 1]])
        mesh = occlude.OccluderMesh(np.empty((0, 3)), [])
        self.assertEqual(len(mesh), 0)
        wall = scene.add_occluder(mesh)
        skew = np.eye(4)
        skew[3] = [0, 0, 1, 1]
        for text, call in (
            ("box has a number that is NaN", lambda: scene.add_object([np.nan, 0, 0, 1, 1, 1])),
            ("object 1: box has min > max", lambda: scene.add_objects([[0, 0, 0, 1, 1, 1], [1, 0, 0, 0, 1, 1]])),
            ("object 1: box has min > max", lambda: scene.move_objects(ids, [[0, 0, 0, 1, 1, 1], [1, 0, 0, 0, 1, 1]])),
            ("as many ids as boxes", lambda: scene.move_objects(ids, [[0, 0, 0, 1, 1, 1]])),
            ("ids are not whole numbers", lambda: scene.remove_objects([0.5])),
            ("ids has a number below 0", lambda: scene.remove_objects([-1])),
            ("the matrix of a placement is not affine", lambda: scene.move_occluder(wall, skew)),
            (r"placement has shape \(3, 3\), must be \(3, 4\) or \(4, 4\)", lambda: scene.move_occluder(wall, np.eye(3))),
            (r"placements has shape \(4, 4\), must be \(n, 3, 4\)", lambda: scene.add_occluders(mesh, skew)),
            ("as many ids as placements", lambda: scene.move_occluders([wall], np.empty((0, 4, 4)))),
            ("placement is not finite", lambda: scene.move_occluder(wall, np.full((3, 4), np.nan))),
            ("vertex 0: number is not finite", lambda: occlude.OccluderMesh([[np.inf, 0, 0]] * 3, [[0, 1, 2]])),
            ("corner 2 is vertex 3 of 3", lambda: occlude.OccluderMesh(np.eye(3), [[0, 1, 3]])),
            ("fewer than 3 corners", lambda: occlude.OccluderMesh(np.eye(3), [[0, 1]])),
            ("polygons are not whole numbers", lambda: occlude.OccluderMesh(np.eye(3), [[0, 1, 1.5]])),
            ("polygons has a number above", lambda: occlude.OccluderMesh(np.eye(3), [[0, 1, 2**32]])),
            ("corners are not among the indices", lambda: occlude.OccluderMesh(np.eye(3), [0, 1, 2], sizes=[4])),
            ("indices after its last polygon", lambda: occlude.OccluderMesh(np.eye(3), [0, 1, 2, 0], sizes=[3])),
            ("eye", lambda: occlude.Camera([0, 0, 0], [0, 0, 0])),
            ("projection is 'wide'", lambda: occlude.Camera([0, 0, 0], [1, 0, 0], projection="wide")),
            ("threads must be 1 to 65536", lambda: scene.update(threads=0)),
            ("threads must be 1 to 65536", lambda: scene.cull(occlude.Camera([0, 0, 0], [1, 0, 0]), threads=65537)),
            ("box 0: box has min > max", lambda: occlude.View().visibility([[1, 0, 0, 0, 1, 1]])),
        ):
            with self.assertRaisesRegex(ValueError, text):
                call()
        with self.assertRaises(TypeError):
            scene.add_occluder(None)
        self.assertEqual((scene.objects, scene.occluders), (2, 1))


if __name__ == "__main__":
    unittest.main()
