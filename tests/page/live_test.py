#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Walks in the page of `occlude inspect`: live.html, made with a path, and free.html, in the working folder."""
import json
import os
import time
import unittest

from selenium.webdriver import ActionChains
from selenium.webdriver.common.actions.wheel_input import ScrollOrigin
from selenium.webdriver.support.ui import WebDriverWait

import browser


class Live(browser.Page):
    def open(self, file='live.html'):
        super().open(file, 'livePage')
        self.wait_for('page.steps > 0')

    def wait_for(self, condition, seconds=60):
        WebDriverWait(self.driver, seconds).until(lambda _: self.run_script(f'return Boolean({condition})'))

    def press(self, key):
        ActionChains(self.driver).key_down(key).perform()

    def release(self, key):
        ActionChains(self.driver).key_up(key).perform()

    def eye(self):
        return self.run_script('return page.walk.eye')

    def counts(self):
        return self.run_script('return page.frame.counts')

    def picture(self):
        return self.run_script('page.viewer.see(); page.viewer.draw(); return page.viewer.canvas.toDataURL();')

    def choose(self, slider, value):
        self.run_script('const [id, value] = arguments, slider = document.getElementById(id); slider.value = value; '
                        'slider.dispatchEvent(new Event("input"));', slider, value)
        self.settle()

    def choose_method(self, method):
        self.click(self.driver.find_element('css selector', f'input[value={method}]'))
        self.settle()

    def settle(self):
        self.wait_for('page.request === null')

    def test_the_way_is_saved(self):
        self.open('free.html')
        start = self.eye()
        self.press('w')
        self.wait_for('page.way.length > 5', 300)
        self.release('w')
        self.settle()
        path = json.loads(self.saved('save', 'path.json'))
        self.assertEqual(path['model'], 'city.ply')
        self.assertEqual(path['frames'], len(path['keyframes']))
        self.assertEqual(path['keyframes'][0]['eye'], start)
        self.assertEqual(path['keyframes'][-1]['eye'], self.eye())
        self.click(self.element('start'))
        self.settle()
        self.assertEqual(self.run_script('return page.way.length'), 1)

    def test_a_hundred_steps_are_culled_live(self):
        for file in ('live.html', 'free.html'):
            self.open(file)
            model = self.run_script('return page.culler.model.polygons')
            for method in ('frusta', 'cover'):
                self.choose_method(method)
                before, steps = self.eye(), self.run_script('return page.steps')
                self.press('w')
                self.wait_for(f'page.steps >= {steps} + 100', 300)
                self.release('w')
                self.settle()
                self.assertNotEqual(self.eye(), before)
                counts = self.counts()
                self.assertEqual(sum(counts.values()), model)
                self.assertEqual(self.element('drawn').text, f'{counts["drawn"]:,}')
                self.assertGreater(float(self.element('ms').text), 0)
                self.press('s')
                self.wait_for(f'page.steps >= {steps} + 200', 300)
                self.release('s')
            self.assert_quiet()

    def test_what_is_culled_has_no_pixel(self):
        """The picture of what is drawn is the picture of the whole model, on frames of the path."""
        self.open()
        for method in ('frusta', 'cover'):
            self.choose_method(method)
            culled = 0
            for frame in (0, 200, 1000):
                self.run_script('page.walk.place(...page.placeOfPath(arguments[0])); page.cull()', frame)
                culled += self.counts()['culled']
                drawn = self.picture()
                self.run_script('page.viewer.models.fates.set(new Uint16Array(page.culler.model.leaves))')
                self.assertEqual(self.picture(), drawn)
            self.assertGreater(culled, 0)

    def test_options_change_the_culling(self):
        self.open()
        self.run_script('page.walk.place(...page.placeOfPath(200)); page.wake()')
        self.settle()
        eight = self.counts()
        self.assertGreater(eight['culled'], 0)
        self.choose('occluders', 0)
        self.assertEqual(self.counts()['culled'], 0)
        self.choose('occluders', 64)
        many = self.counts()
        self.assertGreaterEqual(many['culled'], eight['culled'])
        self.choose('margin', 12)
        self.assertLess(self.counts()['culled'], many['culled'])
        self.choose('margin', 1)
        self.choose_method('cover')
        everything = self.counts()
        self.assertGreater(everything['culled'], 0)
        self.choose('budget', 0)
        self.assertLess(self.counts()['culled'], everything['culled'])

    def test_the_mouse_looks_around_and_the_wheel_changes_the_speed(self):
        self.open()
        canvas = self.element('picture')
        self.run_script('arguments[0].scrollIntoView({block: "center"})', canvas)
        target, eye, speed = self.run_script('return [page.walk.target, page.walk.eye, page.walk.speed]')
        ActionChains(self.driver).move_to_element(canvas).click_and_hold().move_by_offset(90, 10).release().perform()
        self.settle()
        self.assertEqual(self.eye(), eye)
        self.assertNotEqual(self.run_script('return page.walk.target'), target)
        ActionChains(self.driver).scroll_from_origin(ScrollOrigin.from_element(canvas), 0, -200).perform()
        self.assertGreater(self.run_script('return page.walk.speed'), speed)

    def test_from_outside_the_culling_stays(self):
        self.open()
        self.run_script('page.walk.place(...page.placeOfPath(200)); page.wake()')
        self.settle()
        self.click(self.element('outside'))
        steps, whole = self.run_script('return page.steps'), self.picture()
        canvas = self.element('picture')
        self.run_script('arguments[0].scrollIntoView({block: "center"})', canvas)
        ActionChains(self.driver).move_to_element(canvas).click_and_hold().move_by_offset(90, 10).release().perform()
        self.assertNotEqual(self.picture(), whole)
        self.assertEqual(self.run_script('return page.steps'), steps)
        self.click(self.element('behind'))
        self.assertEqual(self.picture(), whole)
        self.click(self.element('eye'))
        self.wait_for(f'page.steps > {steps}')

    def test_it_flies_along_the_path(self):
        self.open()
        self.click(self.element('play'))
        self.wait_for('page.frameOfPath > 5')
        self.click(self.element('play'))
        self.settle()
        self.assertEqual(self.eye(), self.run_script('return page.start.eyes[page.frameOfPath]'))
        self.click(self.element('start'))
        self.settle()
        self.assertEqual(self.eye(), self.run_script('return page.start.eyes[0]'))

    def test_the_address_names_the_place(self):
        self.open()
        self.press('w')
        self.wait_for('page.steps > 10')
        self.release('w')
        WebDriverWait(self.driver, 10).until(lambda _: '#eye=' in self.driver.current_url)
        self.settle()
        time.sleep(0.5)  # until the address is that of the last step
        eye, address = self.eye(), self.driver.current_url
        self.driver.get('about:blank')
        self.driver.get(address)
        self.run_script('return 0')
        self.driver.execute_async_script('const done = arguments[0]; livePage.then(p => { window.page = p; done(); })')
        for now, then in zip(self.eye(), eye):
            self.assertAlmostEqual(now, then, delta=1e-6)
        self.driver.get('about:blank')
        self.driver.get(f'file://{os.getcwd()}/live.html#frame=7')
        self.driver.execute_async_script('const done = arguments[0]; livePage.then(p => { window.page = p; done(); })')
        self.assertEqual(self.eye(), self.run_script('return page.start.eyes[7]'))

    def test_on_a_phone_nothing_is_wider_than_the_page(self):
        self.driver.execute_cdp_cmd('Emulation.setDeviceMetricsOverride',
                                    {'width': 390, 'height': 844, 'deviceScaleFactor': 2, 'mobile': True})
        self.addCleanup(self.driver.execute_cdp_cmd, 'Emulation.clearDeviceMetricsOverride', {})
        self.open()
        self.assertLessEqual(self.run_script('return document.documentElement.scrollWidth'), 390)


class WithoutWebGL(browser.Page):
    OPTIONS = ('--disable-3d-apis',)

    def test_it_says_why_nothing_is_drawn(self):
        self.driver.get(f'file://{os.getcwd()}/live.html')
        WebDriverWait(self.driver, 60).until(lambda _: 'no WebGL2' in self.element('reason').text)


if __name__ == '__main__':
    unittest.main(verbosity=2)
