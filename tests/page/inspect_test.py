#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Flies through models that `occlude inspect` has put into the page: path.html, free.html, far.html and coloured.html, in the
working folder."""
import json
import os
import unittest

from selenium.webdriver.support.ui import WebDriverWait

import browser

class Inspect(browser.Flight):
    FILE = 'path.html'

    def path(self):
        with open('city.json', encoding='utf-8') as file:
            return json.load(file)

    def test_it_flies_along_the_path_and_culls(self):
        self.open()
        self.wait_for('app.isFlying && app.share > 0 && app.frame && app.frame.counts.hidden > 1000')
        counts, triangles = self.run_script('return [app.frame.counts, app.model.corners.length / 9]')
        self.assertEqual(sum(counts.values()), triangles)
        self.assertEqual([self.text('scene-name'), self.driver.title], ['city.ply', 'occlude: city.ply'])
        places, seconds, eye = self.run_script(
            'const {places, seconds} = app.model.flight; return [places.length, seconds, places[0].eye]')
        path = self.path()
        self.assertEqual(places, path['frames'])
        self.assertAlmostEqual(seconds, (path['frames'] - 1) / 30)
        self.assertEqual(eye, path['keyframes'][0]['eye'])
        self.assert_quiet()

    def test_the_model_is_that_of_the_file(self):
        self.open()
        self.assertEqual(sorted(self.run_script(browser.TRIANGLES)), sorted(browser.triangles_of_ply('city.ply')))

    def test_pictures_with_and_without_culling_are_equal(self):
        self.open()
        self.assert_equal_pictures(self.run_script('return app.model.flight.places.filter((_, i) => i % 400 === 100)'))

    def test_without_a_path_it_flies_round_the_model(self):
        self.open(file='free.html')
        self.wait_for('app.isFlying && app.share > 0')
        low, high, eye = self.run_script('return [app.model.box.low, app.model.box.high, app.model.flight.places[0].eye]')
        self.assertFalse(all(a <= x <= b for a, x, b in zip(low, eye, high)))

    def test_a_model_far_from_0_keeps_its_place_and_the_numbers_of_its_faces(self):
        self.open(file='far.html')
        origin = self.run_script('return app.model.origin')
        self.assertGreater(min(origin[:2]), 400000)
        near = [[x + o for x, o in zip(box, origin)] for box in self.run_script('return [app.model.box.low, app.model.box.high]')]
        for found, known in zip(near[0] + near[1], [3000000.25, 500000.5, 10.1, 3000004.25, 500003.5, 14.3]):
            self.assertAlmostEqual(found, known, delta=1e-6)
        self.assertEqual(sorted((t[0], t[-1]) for t in self.run_script(browser.TRIANGLES)), [(0, 0), (0, 0), (1, 0), (1, 0), (2, 1)])
        self.look([1, 2, 30], [1, 2, 0])
        why = self.run_script('return app.why(app.model.numbers.indexOf(2)).text')
        self.assertRegex(why, '^Polygon 2 of “far.obj” is drawn')

    def looks_red(self):
        """Whether the middle of the camera's view does."""
        red, green, blue = self.run_script('''
            const {x, y, width, height} = app.views.eye, gl = app.canvas.getContext("webgl2"), bytes = new Uint8Array(4);
            gl.readPixels(x + width / 2, y + height / 2, 1, 1, gl.RGBA, gl.UNSIGNED_BYTE, bytes);
            return Array.from(bytes.subarray(0, 3));''')
        return red > 2 * green and red > 4 * blue

    def test_the_model_has_its_colours_or_is_in_clay(self):
        self.open(file='coloured.html')
        colours = self.run_script('''
            const {colours, numbers} = app.model, corner = at => Array.from(colours.subarray(at, at + 4));
            return Array.from(numbers, (face, t) => [face, ...[0, 4, 8].map(k => corner(12 * t + k))]);''')
        white, red, glass = [255, 255, 255, 255], [255, 51, 0, 255], [0, 0, 255, 0]
        self.assertEqual(sorted(colours), [[0, *3 * [white]]] * 2 + [[1, *3 * [red]]] * 2 + [[2, *3 * [glass]]])
        self.look([11, 1, 9], [11, 1, 0])
        self.assertTrue(self.looks_red())
        self.element('more').click()
        self.element('clay').click()
        self.look([11, 1, 9], [11, 1, 0])
        self.assertFalse(self.looks_red())
        self.assertIn('&clay=1', self.run_script('return app.address()'))

    def test_a_model_without_colours_has_no_choice(self):
        self.open()
        self.element('more').click()
        self.assertTrue(self.element('settings').is_displayed())
        self.assertFalse(self.element('clay').is_displayed())
        self.assertFalse(self.element('model-settings').is_displayed())

    def test_links_and_paths_are_in_the_coordinates_of_the_file(self):
        self.open('#eye=3000001,500001,30&target=3000001,500002,10', 'far.html')
        origin, eye, link = self.run_script('return [app.model.origin, app.walker.place.eye, app.address()]')
        self.assertEqual([x + o for x, o in zip(eye, origin)], [3000001, 500001, 30])
        self.assertIn('#scene=inside&eye=3000001,500001,30&target=', link)
        self.element('record').click()
        self.wait_for('app.recorder.seconds > 0.1')
        path = json.loads(self.saved('record', 'path.json'))
        self.assertEqual([path['model'], path['keyframes'][0]['eye']], ['far.obj', [3000001, 500001, 30]])

    def test_the_address_names_a_frame_of_the_path(self):
        self.open('#frame=7')
        place, seventh = self.run_script('return [app.walker.place.eye, app.model.flight.places[7].eye]')
        self.assertEqual(place, seventh)
        self.assertFalse(self.run_script('return app.isFlying'))

    def test_a_recorded_path_has_the_lens_of_the_path(self):
        self.open()
        self.element('record').click()
        self.wait_for('app.recorder.seconds > 0.5')
        path, given = json.loads(self.saved('record', 'path.json')), self.path()
        self.assertEqual([path['model'], path['up']], ['city.ply', [0, 0, 1]])
        self.assertEqual([path['fov_y_deg'], path['near']], [given.get('fov_y_deg', 60), given.get('near', 0.1)])

    def test_other_models_are_opened_and_this_one_again(self):
        self.open()
        choose = ('const select = document.getElementById("scene"); select.value = arguments[0]; '
                  'select.dispatchEvent(new Event("change"));')
        for key, name in ('town', 'Town'), ('inside', 'city.ply'):
            self.run_script(choose, key)
            self.wait_for(f'app.model.name === "{name}" && app.frame')

    def test_on_a_phone_nothing_is_wider_than_the_page(self):
        self.driver.execute_cdp_cmd('Emulation.setDeviceMetricsOverride',
                                    {'width': 390, 'height': 844, 'deviceScaleFactor': 2, 'mobile': True})
        self.addCleanup(self.driver.execute_cdp_cmd, 'Emulation.clearDeviceMetricsOverride', {})
        self.open()
        self.assertLessEqual(self.run_script('return document.documentElement.scrollWidth'), 390)


class WithoutWebGL(browser.Page):
    OPTIONS = ('--disable-3d-apis',)

    def test_it_says_why_nothing_is_drawn(self):
        self.driver.get(f'file://{os.getcwd()}/path.html')
        WebDriverWait(self.driver, 60).until(lambda _: 'draws nothing by WebGL 2' in self.element('toast').text)


if __name__ == '__main__':
    unittest.main(verbosity=2)
