# SPDX-License-Identifier: MIT
"""Culls that hold for the frames between them: nothing that is seen is left out, whoever culls the regions, and when."""
import concurrent.futures
import gc
import subprocess
import sys
import threading
import unittest
import weakref

import numpy as np

import brute
import occlude

SQUARE = np.array([[10, -5, -5], [10, 5, -5], [10, 5, 5], [10, -5, 5]], float)
WALL = occlude.OccluderMesh(SQUARE, [[0, 1, 2, 3]])
BEHIND, BEFORE = [20, -1, -1, 21, 1, 1], [8, -1, -1, 9, 1, 1]


def wall_and_things():
    """A scene, the object behind its wall, the one before it, and the wall."""
    scene = occlude.Scene()
    things = scene.add_objects([BEHIND, BEFORE])
    wall = scene.add_occluder(WALL)
    scene.update()
    return scene, things[0], things[1], wall


def camera_at(x, y=0.0):
    return occlude.Camera([x, y, 0], [x + 1, y, 0])


def matrix_of(camera):
    return occlude.MatrixCamera.from_camera(camera, "zero_to_w", "greater")


def walk(held, frames=60):
    """The frames of a second, every other one of a matrix."""
    for i in range(frames):
        camera = camera_at(i / frames)
        yield held.cull(matrix_of(camera) if i % 2 else camera, i / frames)


class Town:
    """Houses that hide things, some of which move; and the same in plain arrays."""

    def __init__(self, rng):
        self.rng, self.scene = rng, occlude.Scene()
        mesh, polygons = brute.cube([-4, -4, 0], [4, 4, 8])
        houses = [[x, y, 0] for x in range(-40, 41, 10) for y in (-16, -6, 6, 16)]
        placements = np.tile(np.eye(4), (len(houses), 1, 1))
        placements[:, :3, 3] = houses
        self.scene.add_occluders(occlude.OccluderMesh(mesh, polygons), placements)
        cube = np.concatenate([brute.fan(mesh, polygon) for polygon in polygons])
        self.triangles = np.concatenate([cube + at for at in houses])
        self.boxes = dict(zip(self.scene.add_objects(self.random_boxes(200), moves=True).tolist(), self.random_boxes(200)))
        self.change()

    def random_boxes(self, count):
        low = self.rng.uniform([-50, -30, 0], [50, 30, 3], (count, 3))
        return np.hstack([low, low + self.rng.uniform(0.1, 1, (count, 3))])

    def change(self):
        moved = self.rng.choice(list(self.boxes), 50, replace=False)
        boxes = self.random_boxes(50)
        self.boxes.update(zip(moved.tolist(), boxes))
        ids = list(self.boxes)
        self.scene.move_objects(ids, np.array([self.boxes[id] for id in ids]))
        self.scene.update()

    def camera(self, seconds):
        return occlude.Camera([-30 + 3 * seconds, 0.2 * np.sin(seconds), 1.7], [0, np.sin(seconds), 1.7], near=0.05)

    def eye(self, seconds):
        return np.array([-30 + 3 * seconds, 0.2 * np.sin(seconds), 1.7])


class HeldScenes(unittest.TestCase):
    def test_nothing_that_is_seen_is_left_out(self):
        rng = brute.random()
        with concurrent.futures.ThreadPoolExecutor(1) as pool:
            for later, repeatable in ((None, False), (pool.submit, False), (lambda task: task(), True)):
                town, hidden = Town(rng), 0
                held = occlude.HeldSceneCull(town.scene, later=later, repeatable=repeatable)
                for i in range(90):
                    town.change()
                    frame = held.cull(town.camera(i / 60), i / 60)
                    drawn = set(frame.drawn["id"].tolist())
                    self.assertEqual(frame.statistics["cover_triangles"] == 0, not held.is_of_point)
                    if i % 3 != 0:
                        continue
                    points = np.concatenate([brute.points_of(box, rng, 4) for id, box in town.boxes.items() if id not in drawn])
                    points = points[brute.is_in_view(frame.planes, points)]
                    self.assertTrue(np.all(brute.is_hidden(town.eye(i / 60), points, town.triangles)))
                    hidden += len(points)
                statistics = held.statistics
                self.assertEqual(statistics["frames"], 90)
                self.assertGreater(statistics["regions"], 0)
                self.assertGreater(hidden, 3000)
                if repeatable:  # else it depends on the clock
                    self.assertLess(statistics["of_point"], 45)

    def test_frames_are_held_by_themselves(self):
        scene, behind, before, wall = wall_and_things()
        held = occlude.HeldSceneCull(scene, repeatable=True)
        self.assertEqual(repr(held), "<occlude.HeldSceneCull: 0 frames, 0 of point, 0 regions>")
        for frame in walk(held):
            self.assertEqual(frame.drawn["id"].tolist(), [before])
            self.assertEqual(frame.statistics["hidden"], 1)
        statistics = held.statistics
        self.assertLess(statistics["of_point"], 30)
        self.assertEqual(statistics["around"], 0)
        text = f"<occlude.HeldSceneCull: 60 frames, {statistics['of_point']} of point, {statistics['regions']} region"
        self.assertIn(text, repr(held))
        self.assertFalse(held.is_of_point)
        # A wall that is gone hides nothing, in the next frame already.
        scene.remove_occluders([wall])
        scene.update()
        self.assertEqual(set(held.cull(camera_at(1), 1).drawn["id"]), {behind, before})
        self.assertTrue(held.is_of_point)

    def test_options(self):
        scene, behind, before, _ = wall_and_things()
        scene.mask_objects([before], 2)
        scene.update()
        held = occlude.HeldSceneCull(scene, repeatable=True, mask=1, threads=2)
        self.assertTrue(all(len(frame.drawn) == 0 for frame in walk(held)))
        self.assertTrue(all(len(f.drawn) == 1 for f in walk(occlude.HeldSceneCull(scene, least_size=0.2))))
        self.assertTrue(all(len(f.drawn) == 0 for f in walk(occlude.HeldSceneCull(scene, least_size=0.9))))
        regions = []
        for aside in (0.01, 2):
            held = occlude.HeldSceneCull(scene, repeatable=True, aside=aside)
            for i in range(60):
                held.cull(camera_at(0, 0.5 if i % 2 else -0.5), i / 60)
            regions.append(held.statistics["regions"])
        self.assertGreater(regions[0], regions[1])

    def test_parts(self):
        scene, behind, before, wall = wall_and_things()
        region, view = occlude.View(), occlude.View()
        self.assertFalse(region.holds_for(camera_at(0)))
        for camera in (camera_at(0), matrix_of(camera_at(0))):
            way = occlude.ahead(camera, [1, 0, 0], 2)
            self.assertIn("occlude.EyeRegion.box(", repr(way))
            scene.cull(way, region)
            for x, holds in ((0.01, True), (1.99, True), (2.01, False), (-0.01, False)):
                self.assertEqual(region.holds_for(camera_at(x)), holds)
                self.assertEqual(region.holds_for(matrix_of(camera_at(x))), holds)
        self.assertFalse(region.holds_for(occlude.Camera([1, 0, 0], [2, 0.08, 0])))
        scene.cull(occlude.ahead(camera_at(0), [1, 0, 0], 2, turn_degrees=5, aside=0.5), region)
        self.assertTrue(region.holds_for(occlude.Camera([1, 0.45, 0], [2, 0.53, 0])))

        self.assertFalse(scene.holds(region, camera_at(1)))  # it was not to be held
        scene.cull(way, region, to_be_held=True)
        self.assertTrue(scene.holds(region, camera_at(1)) and scene.holds(region, matrix_of(camera_at(1))))
        self.assertFalse(scene.holds(region, camera_at(1), mask=1) or scene.holds(region, camera_at(1), least_size=0.1))
        frame = scene.cull(camera_at(1), view, held=region)
        self.assertEqual(frame.drawn["id"].tolist(), [before])
        self.assertEqual((frame.statistics["hidden"], frame.statistics["cover_triangles"]), (1, 0))
        self.assertEqual(scene.cull(matrix_of(camera_at(1)), held=region, threads=2).drawn["id"].tolist(), [before])
        scene.move_objects([behind, before], [BEFORE, BEHIND])
        scene.update()
        self.assertEqual(scene.cull(camera_at(1), held=region).drawn["id"].tolist(), [behind])
        for text, call in (
            ("the view's last frame is not of this scene", lambda: scene.why([behind], view)),
            ("the held frame does not hold", lambda: scene.cull(camera_at(3), held=region)),
            ("a frame cannot be held against its own view", lambda: scene.cull(camera_at(1), region, held=region)),
            ("the camera must turn by 0 degrees or more", lambda: occlude.ahead(camera_at(0), [1, 0, 0], 1, turn_degrees=-1)),
            ("velocity has shape", lambda: occlude.ahead(camera_at(0), [1, 0], 1)),
        ):
            with self.assertRaisesRegex(ValueError, text):
                call()
        # Of a view whose last frame is that of a model.
        model = occlude.Culler(SQUARE, [[0, 1, 2, 3]])
        model.cull(way, region, method="cover")
        self.assertTrue(region.holds_for(camera_at(1)))
        self.assertFalse(scene.holds(region, camera_at(1)))
        with self.assertRaisesRegex(ValueError, "the held frame is of a model"):
            scene.cull(camera_at(1), held=region)
        scene.cull(way, region, to_be_held=True)
        self.assertTrue(scene.holds(region, camera_at(1)))
        scene.remove_occluders([wall])
        scene.update()
        self.assertFalse(scene.holds(region, camera_at(1)))


class Regions(unittest.TestCase):
    """Where regions are culled."""

    def test_the_function_may_do_anything(self):
        scene, _, before, _ = wall_and_things()
        tasks = []

        def later(task):
            scene.update()  # which waits for all that cull
            self.assertGreaterEqual(held.statistics["frames"], 1)
            repr(held)
            tasks.append(task)
            task()
            task()  # once more does nothing

        held = occlude.HeldSceneCull(scene, later=later, repeatable=True)
        self.assertTrue(all(frame.drawn["id"].tolist() == [before] for frame in walk(held)))
        self.assertEqual(len(tasks), held.statistics["regions"])
        self.assertGreater(len(tasks), 0)

    def test_who_culls_them_changes_nothing(self):
        scene, _, _, _ = wall_and_things()

        def count(later):
            held = occlude.HeldSceneCull(scene, later=later, repeatable=True)
            self.assertEqual(len(list(walk(held))), 60)
            return held.statistics

        with concurrent.futures.ThreadPoolExecutor(2) as pool:
            expected = count(lambda task: task())
            for later in (None, pool.submit, lambda task: None):
                self.assertEqual(count(later), expected)

    def test_what_it_raises_is_raised_and_it_is_asked_again(self):
        scene, _, before, _ = wall_and_things()
        tasks, is_closed = [], True

        def later(task):
            if is_closed:
                raise KeyError("closed")
            tasks.append(task)

        held = occlude.HeldSceneCull(scene, later=later)
        for i in range(3):
            with self.assertRaisesRegex(KeyError, "closed"):
                held.cull(camera_at(i / 60), i / 60)
        self.assertEqual(held.statistics["regions"], 1)
        is_closed = False
        self.assertEqual(held.cull(camera_at(0.05), 0.05).drawn["id"].tolist(), [before])
        self.assertEqual(len(tasks), 1)
        tasks[0]()
        held.cull(camera_at(0.06), 0.06)
        self.assertFalse(held.is_of_point)

    def test_tasks_of_what_is_gone_do_nothing(self):
        scene, _, _, _ = wall_and_things()
        tasks = []
        held = occlude.HeldSceneCull(scene, later=tasks.append)
        held.cull(camera_at(0), 0)
        self.assertEqual(len(tasks), 1)
        del held
        tasks[0]()
        # What is running ends first: threads of the module, and of others.
        with concurrent.futures.ThreadPoolExecutor(1) as pool:
            for later in (None, pool.submit):
                for _ in range(20):
                    occlude.HeldSceneCull(scene, later=later).cull(camera_at(0), 0)

    def test_what_is_culled_is_kept(self):
        held = occlude.HeldSceneCull(wall_and_things()[0])
        walking = occlude.HeldCull(occlude.Culler(SQUARE, [[0, 1, 2, 3]]))
        gc.collect()
        self.assertEqual(len(list(walk(held))[0].drawn), 1)
        self.assertEqual(len(list(walk(walking))[0].polygons), 1)

        def later(task):
            task()

        known = weakref.ref(later)
        held = occlude.HeldSceneCull(wall_and_things()[0], later=later)
        del later
        list(walk(held))
        del held
        self.assertIsNone(known())

    def test_programs_may_end_while_a_region_is_culled(self):
        program = """
import concurrent.futures
import numpy as np
import occlude
scene, pool = occlude.Scene(), concurrent.futures.ThreadPoolExecutor(1)
low = np.random.default_rng(1).uniform([0, -50, -50], [100, 50, 50], (20000, 3))
scene.add_objects(np.hstack([low, low + 1]))
scene.update()
for_ever = [occlude.HeldSceneCull(scene, later=later) for later in (None, pool.submit)]
for_ever.append(for_ever)  # a cycle: nothing destroys it
held = occlude.HeldSceneCull(scene)
for cull in (held, *for_ever[:2]):
    cull.cull(occlude.Camera([0, 0, 0], [1, 0, 0]), 0)
"""
        self.assertEqual(subprocess.run([sys.executable, "-c", program]).returncode, 0)

    def test_threads(self):
        town = Town(brute.random())
        known = set(town.boxes)
        held, raised = occlude.HeldSceneCull(town.scene), []

        def use():
            try:
                for i in range(60):
                    self.assertLessEqual(set(held.cull(town.camera(i / 60), i / 60).drawn["id"].tolist()), known)
            except BaseException as e:
                raised.append(e)

        threads = [threading.Thread(target=use) for _ in range(3)]
        for thread in threads:
            thread.start()
        for _ in range(20):
            town.change()
        for thread in threads:
            thread.join()
        self.assertEqual(raised, [])
        self.assertEqual(held.statistics["frames"], 180)


class HeldModels(unittest.TestCase):
    def test_models(self):
        far = np.vstack([SQUARE, SQUARE * [2, 0.5, 0.5], SQUARE * [-1, 1, 1]])
        culler = occlude.Culler(far, np.arange(12).reshape(3, 4), leaf_size=1)
        order = occlude.DrawOrder(culler, materials=[3, 8, 9])
        for options in ({}, {"method": "frusta", "occluders": 4}):
            held = occlude.HeldCull(culler, repeatable=True, **options)
            self.assertEqual(repr(held), "<occlude.HeldCull: 0 frames, 0 of point, 0 regions>")
            of_point = 0
            for frame in walk(held):
                of_point += frame.is_of_point
                self.assertEqual(frame.polygons.tolist(), [0])
                first, count = frame.drawn[0]
                self.assertEqual(culler.order[first : first + count].tolist(), [0])
                self.assertEqual(order.ranges(frame).tolist(), [(3, 0, 1)])
                self.assertEqual(repr(frame), "<occlude.HeldFrame: 1 polygon drawn>")
            self.assertEqual(held.statistics["of_point"], of_point)
            self.assertLess(of_point, 30)

    def test_a_head_that_turns_fast_has_regions_around(self):
        culler = occlude.Culler(SQUARE, [[0, 1, 2, 3]], leaf_size=1)
        held = occlude.HeldCull(culler, repeatable=True)
        for i in range(120):
            angle = np.pi * i / 60
            held.cull(occlude.Camera([0, 0, 0], [np.cos(angle), np.sin(angle), 0]), i / 60)
        self.assertGreater(held.statistics["around"], 0)

    def test_refusals(self):
        scene, culler = wall_and_things()[0], occlude.Culler(SQUARE, [[0, 1, 2, 3]])
        for of, kind in ((scene, occlude.HeldSceneCull), (culler, occlude.HeldCull)):
            for text, options in (
                ("the camera must turn by 0 degrees or more", {"turn_degrees": -1}),
                ("the way ahead", {"aside": np.nan}),
            ):
                with self.assertRaisesRegex(ValueError, text):
                    kind(of, **options)
            with self.assertRaisesRegex(TypeError, "later is no function"):
                kind(of, later=7)
            with self.assertRaises(TypeError):
                kind(None)
            held = kind(of)
            with self.assertRaisesRegex(ValueError, "the time of the frame is not finite"):
                held.cull(camera_at(0), np.inf)
            with self.assertRaises(TypeError):
                held.cull("camera", 0)
        with self.assertRaisesRegex(ValueError, "threads must be 1 to 65536"):
            occlude.HeldSceneCull(scene, threads=0)
        with self.assertRaisesRegex(ValueError, "method is 'both'"):
            occlude.HeldCull(culler, method="both")
        with self.assertRaisesRegex(ValueError, "margin is below 0"):
            occlude.HeldCull(culler, margin=-1)


if __name__ == "__main__":
    unittest.main()
