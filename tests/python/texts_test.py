# SPDX-License-Identifier: MIT
"""What repr() says of things."""
import math
import unittest

import numpy as np

import occlude

SQUARE = np.array([[2, -1, -1], [2, 1, -1], [2, 1, 1], [2, -1, 1]], float)


class Texts(unittest.TestCase):
    def test_scenes(self):
        scene, mesh, view = occlude.Scene(), occlude.OccluderMesh(SQUARE, [[0, 1, 2, 3]]), occlude.View()
        self.assertEqual(repr(scene), "<occlude.Scene: 0 objects, 0 occluders>")
        self.assertEqual(repr(mesh), "<occlude.OccluderMesh: 1 polygon>")
        self.assertEqual(repr(view), "<occlude.View: no frame>")
        ids = scene.add_objects([[4, 0, 0, 5, 0.1, 0.1], [-5, 0, 0, -4, 1, 1], [1, 0, 0, 1.5, 0.1, 0.1]])
        scene.add_occluder(mesh)
        scene.update()
        frame = scene.cull(occlude.Camera([0, 0, 0], [1, 0, 0]), view)
        self.assertEqual(repr(scene), "<occlude.Scene: 3 objects, 1 occluder>")
        self.assertEqual(repr(frame), "<occlude.SceneFrame: 1 object drawn, 1 hidden, 1 out of view, 0 too small>")
        self.assertEqual(repr(view), "<occlude.View: of a scene, 1 object drawn>")
        hidden, away, drawn = scene.why(ids, view)
        self.assertEqual(repr(hidden), "<occlude.Fate: hidden by 1 polygon>")
        self.assertEqual(repr(away), f"<occlude.Fate: out of view by plane {away.plane}>")
        self.assertEqual(repr(drawn), "<occlude.Fate: drawn>")

    def test_models_and_shadows(self):
        culler, view = occlude.Culler(np.vstack([SQUARE, 2 * SQUARE]), [[0, 1, 2, 3], [4, 5, 6, 7]]), occlude.View()
        frame = culler.cull(occlude.Camera([0, 0, 0], [-1, 0, 0]), view)
        self.assertEqual(repr(culler), "<occlude.Culler: 2 polygons>")
        self.assertEqual(repr(frame), "<occlude.ModelFrame: 0 polygons drawn>")
        self.assertEqual(repr(view), "<occlude.View: of a model, 0 polygons drawn>")
        shadow = occlude.ShadowFrustum(SQUARE, direction=[1, 0, 0.5])
        self.assertEqual(repr(shadow), "<occlude.ShadowFrustum: 4 vertices, direction (1.0, 0.0, 0.5)>")
        self.assertIn("eye (0.0, 0.5, 0.0)", repr(occlude.ShadowFrustum(SQUARE, eye=[0, 0.5, 0])))

    def test_cameras_are_what_makes_them(self):
        matrix = np.array([[0, -1, 0, 0], [0, 0, 1.5, 0], [1, 0, 0, -0.2], [1, 0, 0, 0]])
        for camera in (
            occlude.Camera([0, 0, 0], [1, 0.1, 0], fov_y_deg=1 / 3),
            occlude.Camera([0, 0, 0], [0, 1, 0], projection="orthographic", height=7, far=100),
            occlude.MatrixCamera(matrix, "minus_w_to_w", eyes=occlude.EyeRegion.ball(0.03)),
            occlude.MatrixCamera(np.diag([0.02, 0.02, -0.02, 1]), "zero_to_w", "less"),
        ):
            same = eval(repr(camera), {"occlude": occlude, "inf": math.inf})
            self.assertEqual(repr(same), repr(camera))


if __name__ == "__main__":
    unittest.main()
