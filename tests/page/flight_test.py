#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Flies through built-in scenes and dropped models: flight.html and city.ply, in the working folder."""
import json
import os
import unittest

from selenium.webdriver import ActionChains

import browser
import gltf

GREY = [0.5, 0.5, 0.5, 1]
# A wall, what it hides, what glass does not hide, and what is beside both.
ROOM = [('Wall', [-2, -2, -10], [4, 4, 0.2], [1, 1, 1, 1]), ('Behind it', [-0.5, -0.5, -15], [1, 1, 1], [1, 0, 0, 1]),
        ('Glass', [3, -2, -10], [4, 4, 0.2], [0.5, 0.5, 1, 0.3]), ('Behind glass', [6, -0.5, -15], [1, 1, 1], GREY)]


class Flight(browser.Flight):
    def test_it_flies_and_culls_when_opened(self):
        self.open()
        self.wait_for('app.isFlying && app.share > 0 && app.frame && app.frame.counts.hidden > 1000')
        self.assertEqual(self.text('scene-name'), 'Town')
        self.assertNotEqual(self.text('hidden'), '–')

    def test_interiors_are_cut_open_and_nothing_else_is(self):
        cut = []
        for scene in 'town', 'rooms', 'forest':
            self.open(f'#scene={scene}')
            cut.append(self.run_script('return [app.shows.cut, document.getElementById("cut").checked]'))
        self.assertEqual(cut, [[False, False], [True, True], [False, False]])

    def test_what_the_camera_sees_is_outlined_before_the_sky_too(self):
        self.open('#scene=rooms')
        self.drop_model(self.write('room.gltf', gltf.of_boxes(ROOM, [0, 0, 0])))
        self.look([0, 0, 90], [0, 0, 100])
        outlined = '''
            const {x, y, width, height} = app.views.outside, gl = app.canvas.getContext("webgl2"), bytes = new Uint8Array(4 * width * height);
            gl.readPixels(x, y, width, height, gl.RGBA, gl.UNSIGNED_BYTE, bytes);
            return bytes.filter((byte, i) => i % 4 === 0 && byte === 0x5b && bytes[i + 1] === 0x8c && bytes[i + 2] === 0xff).length;'''
        self.assertGreater(self.run_script(outlined), 100)

    def test_a_dropped_gltf_is_culled_by_both_methods(self):
        self.open('#scene=rooms')
        self.drop_model(self.write('room.gltf', gltf.of_boxes(ROOM, [0, 0, 0])))
        self.assertEqual(self.run_script('return [app.model.up, app.model.cameras.map(c => c.name), app.model.names.length]'),
                         [[0, 1, 0], ['Door'], 4])
        # The wall is white but for its texture.
        colours = self.run_script('''
            const {corners, colours, firsts, names} = app.model, first = 3 * firsts[names.indexOf("Wall")], of = {};
            for (let c = first; c < first + 36; ++c) (of[corners[3 * c]] ??= new Set()).add(colours.slice(4 * c, 4 * c + 4).join());
            return Object.entries(of).map(([x, found]) => [Number(x), ...found]).sort((a, b) => a[0] - b[0]);''')
        self.assertEqual(colours, [[-2, '255,0,0,255'], [2, '0,255,0,255']])
        for method in 'polygons', 'objects':
            self.run_script('app.setMethod(arguments[0])', method)
            self.look([0, 0, 0], [0, 0, -1])
            self.assertEqual(self.drawn(), ['Behind glass', 'Glass', 'Wall'], method)
            self.look([0, 9, 0], [0, 0, -15])
            self.assertEqual(self.drawn(), ['Behind glass', 'Behind it', 'Glass', 'Wall'], method)
        self.element('culling').click()
        self.wait_for('app.frame === undefined')
        self.assertEqual([self.text('drawn'), self.text('hidden')], ['48', '–'])

    def test_why_is_told_in_words(self):
        self.open('#scene=rooms')
        self.drop_model(self.write('room.gltf', gltf.of_boxes(ROOM, [0, 0, 0])))
        self.look([0, 0, 0], [0, 0, -1])
        # From the middle of the page to that of the camera's view.
        offset = self.run_script('''
            const {eye, ratio} = app.views;
            return [eye.width / ratio - innerWidth, eye.height / ratio - innerHeight].map(x => Math.round(x / 2));''')
        ActionChains(self.driver).move_to_element_with_offset(self.element('picture'), *offset).click().perform()
        self.wait_for('document.getElementById("toast").textContent.includes("is drawn")')
        self.assertIn('“Wall”', self.text('toast'))
        why = self.run_script('return app.why(app.model.firsts[app.model.names.indexOf("Behind it")]).text')
        self.assertRegex(why, '“Behind it” is hidden: every ray from the eye to its box meets .*“Wall”.* first')

    def test_ply_and_obj_are_read_and_what_is_no_model_is_refused(self):
        self.open('#scene=rooms')
        self.drop_model('city.ply')
        self.assertEqual(self.run_script('return [app.model.up, app.model.isColoured]'), [[0, 0, 1], False])
        self.assertEqual(sorted(self.run_script(browser.TRIANGLES)), sorted(browser.triangles_of_ply('city.ply')))
        self.drop(self.write('bad.obj', 'v 0 0 0\n'))
        self.wait_for('document.getElementById("toast").textContent === "bad.obj: no triangles"')
        self.assertEqual(self.run_script('return app.model.name'), 'city.ply')
        self.drop_model(self.write('two.obj', 'o Two\nv 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 2 3\nf 1 2 4\n'))
        self.assertEqual(self.run_script('return [app.model.corners.length, app.model.names]'), [18, ['Two']])

    def test_pictures_with_and_without_culling_are_equal(self):
        self.open('#scene=rooms')
        self.drop_model('city.ply')
        with open('city.json', encoding='utf-8') as file:
            places = json.load(file)['keyframes']
        self.assert_equal_pictures(places[::max(1, len(places) // 6)])

    def test_rivals_are_caught_and_the_package_never(self):
        wrong = {}
        for scene in 'town', 'park':
            self.open(f'#scene={scene}&method=objects')
            self.run_script('app.setFlying(false)')
            scores = self.run_later(
                '(async () => { const scores = court.scoresOf("test"); await app.judgeFlight(0.2, 8, scores); '
                'await app.judgeFlight(0.6, 8, scores); '
                'return Object.fromEntries(Object.entries(scores).map(([key, score]) => [key, [score.frames, score.wrongFrames]])); })()')
            self.assertEqual(scores['occlude'], [16, 0])
            for key in 'rays', 'pyramid', 'last':
                wrong[key] = wrong.get(key, 0) + scores[key][1]
        print(wrong)
        self.assertTrue(all(wrong.values()), wrong)

    def test_a_catch_stops_the_flight_and_its_link_shows_it_again(self):
        self.open('#scene=park')
        self.element('catch').click()
        self.wait_for('app.caught')
        self.assertFalse(self.run_script('return app.isFlying'))
        self.wait_for('!document.getElementById("card").hidden && !document.getElementById("mark").hidden')
        accused, triangle, link = self.run_script('return [app.caught.accused, app.caught.proof.triangle, app.addressOf(app.caught)]')
        self.assertNotEqual(accused, 'occlude')
        self.open(link)
        self.wait_for('app.caught')
        self.assertEqual(self.run_script('return [app.caught.accused, app.caught.proof.triangle]'), [accused, triangle])
        self.element('card-on').click()
        self.wait_for('app.isFlying && !app.caught && document.getElementById("card").hidden')

    def test_a_recorded_path_is_saved(self):
        self.open('#scene=rooms')
        self.drop_model('city.ply')
        self.element('record').click()
        self.run_script('app.setFlying(true)')
        self.wait_for('app.recorder.seconds > 0.5')
        path = json.loads(self.saved('record', 'path.json'))
        self.assertEqual([path['model'], path['frames'], path['up']], ['city.ply', len(path['keyframes']), [0, 0, 1]])
        self.assertGreater(path['frames'], 10)


if __name__ == '__main__':
    unittest.main(verbosity=2)
