# SPDX-License-Identifier: MIT
"""Threads: no mixture of calls crashes, long calls let other threads run, and frames stay right."""
import threading
import time
import unittest

import numpy as np

import brute
import occlude


def run(*works):
    """Runs them together, and raises what one of them raised."""
    raised = []

    def guarded(work):
        try:
            work()
        except BaseException as e:
            raised.append(e)

    threads = [threading.Thread(target=guarded, args=(work,)) for work in works]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    if raised:
        raise raised[0]


class Threads(unittest.TestCase):
    def test_a_scene_that_changes_while_it_is_culled(self):
        rng = brute.random()
        scene = occlude.Scene()
        low = rng.uniform(10, 60, (2000, 3))
        still = scene.add_objects(np.hstack([low, low + 1]))
        moving = scene.add_objects(np.hstack([low, low + 1]), moves=True)
        mesh = occlude.OccluderMesh(*brute.cube([5, -4, -4], [6, 30, 30]))
        wall = scene.add_occluder(mesh)
        scene.update()
        camera, shared, stop = occlude.Camera([0, 0, 0], [1, 0.3, 0.3]), occlude.View(), threading.Event()
        known = set(still.tolist()) | set(moving.tolist())

        def cull(view):
            while not stop.is_set():
                frame = scene.cull(camera, view)
                statistics = frame.statistics
                self.assertEqual(sum(statistics[n] for n in ("drawn", "hidden", "out_of_view", "too_small")), 4000)
                self.assertEqual(len(frame.drawn), statistics["drawn"])
                self.assertLessEqual(set(frame.drawn["id"].tolist()), known)
                (view or shared).visibility([[20, 5, 5, 21, 6, 6]])

        def change():
            try:
                for i in range(60):
                    at = low + i % 7
                    scene.move_objects(moving, np.hstack([at, at + 1]))
                    scene.move_occluder(wall, np.eye(4))
                    scene.update()
            finally:
                stop.set()

        run(change, lambda: cull(occlude.View()), lambda: cull(shared), lambda: cull(shared), lambda: cull(None))

    def test_long_calls_let_others_run(self):
        rng = brute.random()
        vertices = rng.uniform(0, 100, (120000, 3))
        polygons = np.arange(120000).reshape(-1, 3)
        ticks, stop = [], threading.Event()

        def tick():
            while not stop.is_set():
                ticks.append(time.perf_counter())
                time.sleep(0.001)

        def work():
            try:
                begin = time.perf_counter()
                mesh = occlude.OccluderMesh(vertices, polygons)
                self.assertEqual(len(mesh), 40000)
                self.taken = (begin, time.perf_counter())
            finally:
                stop.set()

        run(tick, work)
        begin, end = self.taken
        during = [t for t in ticks if begin < t < end]
        # With the interpreter held there would be ticks before the call and after it alone.
        self.assertGreater(len(during), 5)


if __name__ == "__main__":
    unittest.main()
