#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Uses the pages of four walks as a reader does: frusta, cover, held and undrawn, in the working folder.

Usage: page_test.py PATH_OF_OCCLUDE. page_test.sh makes the walks.
"""
import json
import os
import random
import re
import subprocess
import sys
import unittest

from selenium import webdriver
from selenium.webdriver import ActionChains, Keys
from selenium.webdriver.common.by import By
from selenium.webdriver.support.ui import WebDriverWait

import browser

OCCLUDE = sys.argv.pop(1)
WALK = ['city.ply', '--path', 'city.json', '--frames', '0:400:20', '--size', '320x180']
OPTIONS = {'frusta': ['--unions'], 'cover': ['--method', 'cover'], 'held': ['--method', 'cover', '--hold', '40']}
SIZE = (320, 180)


def why(walk, frame, *which):
    done = subprocess.run([OCCLUDE, 'why', *WALK, *OPTIONS[walk], '--frame', str(frame), *which, '--json'], capture_output=True)
    return json.loads(done.stdout) if done.returncode == 0 else None


class Page(browser.Page):
    def open(self, walk):
        super().open(f'{walk}/report.html', 'walkPage')

    def number(self):
        return int(self.element('number').text)

    def picture(self):
        """The viewer's picture as it is now."""
        return self.run_script('page.viewer.see(); page.viewer.draw(); return page.viewer.canvas.toDataURL();')

    def look(self, from_outside):
        self.click(self.element('outside' if from_outside else 'eye'))


class Reading(Page):
    def test_it_is_quiet(self):
        for walk in ('frusta', 'cover', 'held', 'undrawn'):
            self.open(walk)
            for from_outside in (True, False):
                self.look(from_outside)
                self.picture()
            self.assert_quiet()

    def test_slider_keys_and_links_move_the_one_cursor(self):
        self.open('frusta')
        self.run_script('page.setIndex(0)')
        slider = self.element('slider')
        slider.send_keys(Keys.ARROW_RIGHT)
        self.assertEqual(self.number(), 20)
        body = self.driver.find_element(By.TAG_NAME, 'body')
        body.send_keys(Keys.ARROW_RIGHT)
        self.assertEqual(self.number(), 40)
        body.send_keys(Keys.ARROW_LEFT)
        self.assertEqual(self.number(), 20)
        self.assertIn('Frame 20:', self.element('told').text)
        link = self.element('worst').find_elements(By.TAG_NAME, 'a')[3]
        frame = int(link.text)
        self.click(link)
        WebDriverWait(self.driver, 10).until(lambda _: self.number() == frame)
        self.assertEqual(self.run_script('return page.columns.frame[page.index]'), frame)
        cursors = self.run_script('return [...document.querySelectorAll(".cursor")].map(line => line.style.left)')
        self.assertEqual(len(cursors), 3)
        for chart, left in enumerate(cursors):
            expected = self.run_script('return page.charts.charts[arguments[0]].chart.toDomXCoord(arguments[1])', chart, frame)
            self.assertAlmostEqual(float(left[:-2]), expected, places=1)

    def test_a_link_leads_to_its_frame_while_the_address_waits(self):
        self.open('frusta')
        self.driver.get(f'file://{os.getcwd()}/frusta/report.html#frame=40')
        WebDriverWait(self.driver, 10).until(lambda _: self.number() == 40)
        # In one script, so that the address still names frame 40 when its link is followed from frame 60.
        self.run_script('''
            page.setIndex(3);
            const link = document.createElement('a');
            link.href = '#frame=40';
            document.body.append(link);
            link.click();''')
        WebDriverWait(self.driver, 10).until(lambda _: self.number() == 40)
        self.assertTrue(self.driver.current_url.endswith('#frame=40'))

    def test_space_plays(self):
        self.open('frusta')
        body = self.driver.find_element(By.TAG_NAME, 'body')
        self.run_script('page.setIndex(0)')
        body.send_keys(' ')
        WebDriverWait(self.driver, 20).until(lambda _: self.number() > 0)
        self.assertEqual(self.element('play').get_attribute('aria-label'), 'Pause')
        body.send_keys(' ')
        at = self.number()
        self.assertEqual(self.element('play').get_attribute('aria-label'), 'Play')
        self.assertEqual(self.number(), at)

    def test_it_plays_in_the_time_of_the_path(self):
        self.open('frusta')
        self.run_script('''
            const times = [], {setIndex} = page;
            page.setIndex = function(index) { times.push(performance.now()); setIndex.call(this, index); };
            page.setIndex(0);
            page.play(true);
            window.times = times;''')
        WebDriverWait(self.driver, 60).until(lambda _: self.run_script('return times.length >= 4'))
        # Frames are a twentieth of those of the path, which has 30 a second: the third comes after 2 seconds, in its middle after 1.7.
        first, *times = self.run_script('page.play(false); return times')
        for i, time in enumerate(times[:3], 1):
            self.assertGreaterEqual(time - first, 1000 * (20 * i - 10) / 30 - 20)

    def test_it_opens_on_the_frame_that_hides_most_and_the_legend_counts(self):
        for walk in ('frusta', 'cover', 'undrawn'):
            self.open(walk)
            columns, index = self.run_script('return [page.columns, page.index]')
            hidden = [in_view - drawn for in_view, drawn in zip(columns['in_view'], columns['drawn'])]
            self.assertEqual(index, hidden.index(max(hidden)))
            counts = [self.run_script('return document.getElementById(arguments[0]).textContent', f'count-{name}')
                      for name in ('drawn', 'hidden', 'away', 'wrong')]
            wrong = f'{columns["drawn"][index] - columns["visible"][index]:,}' if walk != 'undrawn' else ''
            self.assertEqual(counts, [*(f'{columns[name][index]:,}' for name in ('drawn', 'culled', 'out_of_view')), wrong])

    def test_the_viewer_comes_first_and_fills_the_window(self):
        self.open('frusta')
        top, bottom, height = self.run_script('''
            const {top, bottom} = document.getElementById("picture").getBoundingClientRect();
            return [top, bottom, innerHeight];''')
        self.assertLess(top, 0.25 * height)
        self.assertLess(bottom, height)

    def test_the_path_is_saved_as_it_was_walked(self):
        for walk in ('frusta', 'tilted'):
            self.open(walk)
            with open(f'{walk}/path.json', encoding='utf-8') as path:
                self.assertEqual(self.saved('save', 'path.json'), path.read())
            self.assert_quiet()

    def test_a_camera_may_be_tilted(self):
        self.open('tilted')
        self.run_script('page.setIndex(0)')
        self.look(from_outside=False)
        self.assertEqual(self.run_script('return page.viewer.camera.up'), [0, 0, 1])
        upright = self.picture()
        self.run_script('page.setIndex(1)')
        self.assertEqual(self.run_script('return page.viewer.camera.up'), [0, 1, 0])
        self.assertNotEqual(self.picture(), upright)

    def test_an_address_names_a_frame(self):
        self.open('frusta')
        self.driver.get(f'file://{os.getcwd()}/frusta/report.html#frame=60')
        WebDriverWait(self.driver, 10).until(lambda _: self.number() == 60)
        self.driver.find_element(By.TAG_NAME, 'body').send_keys(Keys.ARROW_RIGHT)
        WebDriverWait(self.driver, 10).until(lambda _: self.driver.current_url.endswith('#frame=80'))

    def test_hover_tells_the_figures_of_a_frame(self):
        self.open('frusta')
        chart = self.driver.find_element(By.CSS_SELECTOR, '#polygons .drawing')
        legend = self.driver.find_element(By.CSS_SELECTOR, '#polygons .legend')
        self.run_script('arguments[0].scrollIntoView({block: "center"})', chart)
        at_cursor = legend.text
        ActionChains(self.driver).move_to_element(chart).perform()
        self.assertNotEqual(legend.text, at_cursor)
        row = self.run_script('return page.charts.charts[1].chart.getSelection()')
        drawn, name = self.run_script('return [page.columns.drawn[arguments[0]], page.walk.name]', row)
        self.assertIn(f'{name} {drawn:,}', legend.text)
        ActionChains(self.driver).click().perform()
        self.assertEqual(self.run_script('return page.index'), row)

    def test_charts_zoom_together(self):
        self.open('frusta')
        chart = self.driver.find_element(By.CSS_SELECTOR, '#times .drawing')
        self.run_script('arguments[0].scrollIntoView({block: "center"})', chart)
        ranges = 'return page.charts.charts.map(({chart}) => chart.xAxisRange())'
        whole = self.run_script(ranges)
        ActionChains(self.driver).move_to_element(chart).click_and_hold().move_by_offset(200, 0).release().perform()
        zoomed = self.run_script(ranges)
        self.assertLess(zoomed[0][1] - zoomed[0][0], 0.7 * (whole[0][1] - whole[0][0]))
        self.assertEqual(zoomed[0], zoomed[1])
        self.assertEqual(zoomed[0], zoomed[2])
        self.click(self.driver.find_element(By.CSS_SELECTOR, '#times .unzoom'))
        self.assertEqual(self.run_script(ranges), whole)

    def test_reasons_add_up_to_what_is_drawn_in_vain(self):
        for walk in ('frusta', 'cover', 'held'):
            self.open(walk)
            columns, reasons = self.run_script('return [page.columns, page.walk.reasons]')
            self.assertGreaterEqual(len(reasons), 2)
            for i, drawn in enumerate(columns['drawn']):
                self.assertEqual(sum(columns[name][i] for name in reasons), drawn - columns['visible'][i])
            self.assertIn('were drawn though they are hidden', self.element('told').text)
            names = self.run_script('return page.charts.charts[2].series.map(s => s.name)')
            for reason in reasons.values():
                self.assertIn(f'hidden, but drawn: {reason}', names)

    def test_without_pictures_it_says_so(self):
        self.open('undrawn')
        text = self.driver.find_element(By.TAG_NAME, 'body').text
        self.assertIn('Nothing was drawn', text)
        self.assertIn('Time to cull', text)
        self.assertNotIn('NaN', text)
        self.assertNotIn('undefined', text)

    def test_on_a_phone_nothing_is_wider_than_the_page(self):
        self.driver.execute_cdp_cmd('Emulation.setDeviceMetricsOverride',
                                    {'width': 390, 'height': 844, 'deviceScaleFactor': 2, 'mobile': True})
        self.addCleanup(self.driver.execute_cdp_cmd, 'Emulation.clearDeviceMetricsOverride', {})
        for walk in ('frusta', 'cover', 'held', 'undrawn'):
            self.open(walk)
            self.assertLessEqual(self.run_script('return document.documentElement.scrollWidth'), 390)
            self.assertGreaterEqual(self.run_script('return page.viewer.canvas.clientWidth'), 340)

    def test_in_the_dark_it_is_dark(self):
        colour = 'return getComputedStyle(document.body).backgroundColor'
        self.open('frusta')
        light, light_picture = self.run_script(colour), self.picture()
        self.driver.execute_cdp_cmd('Emulation.setEmulatedMedia', {'features': [{'name': 'prefers-color-scheme', 'value': 'dark'}]})
        self.addCleanup(self.driver.execute_cdp_cmd, 'Emulation.setEmulatedMedia', {'features': []})
        self.assertNotEqual(self.run_script(colour), light)
        self.assertNotEqual(self.picture(), light_picture)


class Methods(Page):
    NAMES = ['automatic', 'shadow frusta', 'joined shadows']

    def choices(self):
        return self.driver.find_elements(By.CSS_SELECTOR, '#methodOfView label')

    def choose(self, method):
        self.click(self.choices()[method])
        WebDriverWait(self.driver, 20).until(lambda _: self.run_script('return page.method') == method)

    def test_one_is_not_asked_where_there_is_one(self):
        self.open('cover')
        self.assertFalse(self.element('methodOfView').is_displayed())

    def test_each_has_its_figures_of_the_frame(self):
        for walk in ('methods', 'undrawn'):
            self.open(walk)
            walks, index = self.run_script('return [page.walks, page.index]')
            self.assertEqual([w['walk']['name'] for w in walks], self.NAMES)
            for choice, of, name in zip(self.choices(), walks, self.NAMES, strict=True):
                drawn, ms = (of['columns'][c][index] for c in ('drawn', 'cull_ms'))
                self.assertEqual(choice.text.split('\n'), [name, f'{drawn:,} · {ms:.2f} ms'])

    def test_averages_say_of_which_method_they_are(self):
        for walk, by in (('methods', 'automatic'), ('frusta', 'shadow frusta'), ('held', 'joined shadows, for regions of eyes')):
            self.open(walk)
            self.assertIn(f'Averages below are by {by}', self.element('methods').text)

    def test_figures_keep_to_their_lines(self):
        """However wide they are: in the table, and beside the names of the methods."""
        self.open('methods')
        self.run_script('''
            for (const cell of document.querySelectorAll('#methods td:not(:first-child)')) cell.innerHTML = '<span>100.0 %</span>';
            for (const label of document.querySelectorAll('#methodOfView b')) label.textContent = '129,170 · 52.84 ms';''')
        lines = self.run_script('return [...document.querySelectorAll("#methods td span")].map(s => s.getClientRects().length)')
        self.assertEqual(lines, 55 * [1])
        self.assertLess(max(choice.size['height'] for choice in self.choices()), 40)

    def test_the_map_is_no_higher_than_wide(self):
        self.open('methods')
        width, height = self.run_script('const {width, height} = document.getElementById("map"); return [width, height]')
        self.assertLessEqual(height, width)

    def test_all_are_in_the_charts(self):
        self.open('methods')
        times, polygons = self.run_script('return page.charts.charts.slice(0, 2).map(c => c.series.map(s => [s.name, s.values]))')
        walks = self.run_script('return page.walks')
        for of, name in zip(walks, self.NAMES, strict=True):
            self.assertIn([name, of['columns']['drawn']], polygons)
            self.assertIn([f'{name}: culling alone', of['columns']['cull_ms']], times)
            self.assertIn([f'{name}, processor time', of['columns']['frame_processor_ms']], times)
        legend = self.driver.find_element(By.CSS_SELECTOR, '#times .legend')
        self.assertNotIn('processor time', legend.text)
        self.click(self.driver.find_element(By.CSS_SELECTOR, '[data-series="processor time"]'))
        self.assertEqual(legend.text.count('processor time'), 7)

    def test_another_is_shown(self):
        self.open('methods')
        seen = {}
        for method in (1, 2, 0):
            self.choose(method)
            drawn, of_leaves, columns, kind = self.run_script("""
                const {frame, model} = page, isDrawn = (_, leaf) => frame.fates[leaf] === 0;
                const leaves = Array.from({length: model.leaves}, (_, leaf) => model.firstPolygon[leaf + 1] - model.firstPolygon[leaf]);
                return [page.columns.drawn[page.index], leaves.filter(isDrawn).reduce((a, b) => a + b, 0), page.columns, page.walk.kind];""")
            self.assertEqual(drawn, of_leaves)
            self.assertEqual(self.element('count-drawn').text, f'{drawn:,}')
            self.assertIn(f'{drawn:,} polygons drawn', self.element('told').text)
            self.assertEqual(self.element('hiddenBy').text, {'cover': 'culled by cover', 'frusta': 'culled by shadow'}[kind])
            self.assertIn({'cover': 'pieces were used', 'frusta': 'occluders were chosen'}[kind], self.element('occluders').text)
            fates = self.run_script('return page.charts.charts.map(c => c.series.find(s => s.name.startsWith("culled"))?.values).filter(v => v)')
            self.assertEqual(fates, [columns['culled']])
            seen[method] = self.picture(), self.run_script('return document.getElementById("map").toDataURL()')
        for i in range(2):
            self.assertNotEqual(seen[0][i], seen[1][i])
        self.assert_quiet()

    def test_the_command_is_for_the_method(self):
        for walk, method in (('methods', 'frusta'), ('frusta', 'automatic')):
            self.open(walk)
            self.choose(1)
            command = self.run_script('return page.commandFor(page.model.polygonsIn(page.frame.fates.indexOf(0))[0])')
            self.assertIn(f' --method {method} --frame ', command)
            words = command.split()
            said = json.loads(subprocess.run([OCCLUDE, *words[1:], '--json'], capture_output=True, check=True).stdout)
            self.assertEqual(said['fate'], 'drawn')


class Viewing(Page):
    def test_every_layer_shows_something(self):
        self.open('frusta')
        self.run_script('page.setIndex(page.columns.culled.indexOf(Math.max(...page.columns.culled)))')
        self.run_script('page.viewer.depth /= 10')  # so that there is something to cut off
        for box in self.driver.find_elements(By.CSS_SELECTOR, 'label:not([hidden]) > input[data-layer]'):
            whole = self.picture()
            self.click(box)
            self.assertNotEqual(self.picture(), whole, box.get_attribute('data-layer'))
            self.click(box)
            self.assertEqual(self.picture(), whole, box.get_attribute('data-layer'))

    def test_a_room_is_cut_open_so_that_one_sees_the_camera(self):
        self.open('room')
        between = """
            const {viewer} = page, outside = viewer.outside(), {eye} = viewer.camera;
            const way = eye.map((c, i) => c - outside.eye[i]);
            const seen = cut => {
              const [number] = viewer.numbersIn({...outside, target: eye, fovY: 1, aspect: 1}, {...viewer.layers, cut}, 1, 1);
              return number !== 0 && viewer.shareOf(outside.eye, way, number - 1) < 0.999;
            };
            viewer.see();
            return [seen(false), seen(true)];"""
        were_between = 0
        for index in range(3):
            self.run_script('page.setIndex(arguments[0])', index)
            for turn in range(4):
                whole, cut = self.run_script(between)
                self.assertFalse(cut, f'frame {index}, turn {turn}')
                were_between += whole
                self.run_script('page.orbit.move(orbit => orbit.turn(1.5, 0))')
        self.assertGreater(were_between, 3)

    def test_boxes_end_at_the_culled_subtrees_and_the_drawn_leaves(self):
        for walk in ('frusta', 'cover', 'held'):
            self.open(walk)
            boxes, culled, drawn, holds = self.run_script('''
                const {viewer, model, frame} = page, boxes = viewer.treeBoxes();
                const isIn = (point, {low, high}) => point.every((c, axis) => low[axis] <= c && c <= high[axis]);
                const holds = frame.culled.every(({first, end}, i) => {
                  for (let p = model.firstPolygon[first]; p < model.firstPolygon[end]; ++p) if (!isIn(model.cornerOf(p), boxes[i])) return false;
                  return true;
                });
                return [boxes.length, frame.culled.length, frame.fates.filter(fate => fate === 0).length, holds];''')
            self.assertEqual(boxes, culled + drawn)
            self.assertTrue(holds)

    def test_heat_is_of_what_was_drawn_in_vain(self):
        for walk in ('frusta', 'cover', 'held'):
            self.open(walk)
            vain = self.run_script('return page.model.vain.reduce((sum, n) => sum + n, 0)')
            columns = self.run_script('return page.columns')
            self.assertEqual(vain, sum(columns['drawn']) - sum(columns['visible']))
            self.assertEqual(self.run_script('return page.scene.drawn_frames'), len(columns['drawn']))
        self.open('undrawn')
        self.assertFalse(self.element('vain').is_displayed())

    def test_a_frame_that_is_held_tells_of_its_region(self):
        self.open('held')
        regions, of_frames = self.run_script('return [page.walk.regions, page.columns.region]')
        self.assertGreater(len(regions), 1)
        self.assertGreater(len(of_frames), len(set(of_frames)))
        for i, number in enumerate(of_frames):
            self.run_script('page.setIndex(arguments[0])', i)
            self.assertIn(f'held by region {number} of {len(regions)}', self.element('told').text)
            # The eye is in the box that the viewer draws.
            region, eye = self.run_script('return [page.viewer.region, page.eyes[page.index]]')
            self.assertEqual(region, regions[number - 1])
            for edge in region['halfEdges']:
                away = sum(e * (x - c) for e, x, c in zip(edge, eye, region['centre']))
                self.assertLessEqual(abs(away), 1.001 * sum(e * e for e in edge))
        rows = self.run_script('return [...document.querySelectorAll("#regions details tbody tr")].map(row => [...row.cells].map(cell => cell.textContent))')
        self.assertEqual(len(rows), len(set(of_frames)))
        self.assertEqual(sum(int(row[1]) for row in rows), len(of_frames))
        without = self.picture()
        self.click(self.driver.find_element(By.CSS_SELECTOR, '[data-layer=region]'))
        self.assertNotEqual(self.picture(), without)
        self.open('cover')
        for part in ('region', 'marks'):
            self.assertFalse(self.element(part).is_displayed())
        self.assertFalse(self.element('regions').is_displayed())

    def test_a_table_names_who_hid_what(self):
        for walk, word in (('frusta', 'occluders were chosen'), ('cover', 'pieces were used')):
            self.open(walk)
            self.assertIn(word, self.element('occluders').text)
            rows = self.element('occluders').find_elements(By.CSS_SELECTOR, 'tbody tr')
            self.assertGreater(len(rows), 5)
            self.assertIn('polygon', rows[0].text)
        hidden, culled = self.run_script("""const best = page.scene.pieces.best, most = best[0];
            return [most.best_hidden, page.columns.culled[most.best_frame]]""")
        self.assertGreater(hidden, 0)
        self.assertLessEqual(hidden, culled)

    def test_dragging_turns_and_the_wheel_zooms(self):
        self.open('frusta')
        canvas = self.element('picture')
        self.run_script('arguments[0].scrollIntoView({block: "center"})', canvas)
        whole = self.picture()
        ActionChains(self.driver).move_to_element(canvas).click_and_hold().move_by_offset(90, 10).release().perform()
        turned = self.picture()
        self.assertNotEqual(turned, whole)
        before = self.run_script('return page.viewer.orbit.distance')
        ActionChains(self.driver).scroll_from_origin(
            webdriver.common.actions.wheel_input.ScrollOrigin.from_element(canvas), 0, -200).perform()
        self.assertLess(self.run_script('return page.viewer.orbit.distance'), before)
        self.click(self.element('behind'))
        self.assertEqual(self.picture(), whole)

    def test_fates_add_up_to_the_figures_of_each_frame(self):
        for walk in ('frusta', 'cover', 'held'):
            self.open(walk)
            counts = self.run_script('''return page.columns.frame.map((_, i) => {
                const {fates} = page.frames.at(i), first = page.model.firstPolygon, sums = [0, 0, 0];
                fates.forEach((fate, leaf) => sums[Math.min(fate, 2)] += first[leaf + 1] - first[leaf]);
                return sums;
            })''')
            columns = self.run_script('return page.columns')
            for i, count in enumerate(counts):
                self.assertEqual(count, [columns['drawn'][i], columns['out_of_view'][i], columns['culled'][i]])

    def click_picture(self, x, y):
        """Clicks a point, shares of the size; returns the polygon and what the page says of it."""
        self.run_script('''const canvas = page.viewer.canvas, box = canvas.getBoundingClientRect();
            const at = {clientX: box.left + arguments[0] * box.width, clientY: box.top + arguments[1] * box.height, pointerId: 1, bubbles: true};
            canvas.setPointerCapture = () => {};
            canvas.dispatchEvent(new PointerEvent('pointerdown', at));
            canvas.dispatchEvent(new PointerEvent('pointerup', at));''', x, y)
        polygon = self.run_script('return page.viewer.picked === null ? null : page.model.numbers[page.viewer.picked]')
        return polygon, self.element('picked').text

    def test_a_click_finds_the_polygon_that_why_finds(self):
        random.seed(1)
        for walk in ('frusta', 'cover', 'held'):
            self.open(walk)
            self.look(False)
            same = tried = 0
            while tried < 14:
                frame = self.run_script('page.setIndex(arguments[0]); return page.columns.frame[page.index]', random.randrange(20))
                x, y = random.randrange(SIZE[0]), random.randrange(SIZE[1])
                said = why(walk, frame, '--pixel', f'{x},{y}')
                polygon, _ = self.click_picture((x + 0.5) / SIZE[0], (y + 0.5) / SIZE[1])
                if said is None:  # the sky
                    continue
                tried += 1
                same += polygon == said['polygon']
            self.assertEqual(same, tried, walk)

    def test_what_is_behind_glass_is_seen_and_so_is_the_glass(self):
        self.open('glass')
        seen = self.run_script('''page.viewer.see();
            const {numbers, firstTriangle} = page.viewer.model, marks = page.viewer.models.marks.texels;
            return Array.from(numbers).map((number, p) => [number, marks[firstTriangle[p]] & 1]);''')
        self.assertEqual(dict(seen)[0], 1, 'the pane')
        self.assertEqual(dict(seen)[1], 1, 'the wall behind it')

    def test_a_click_tells_the_fate_that_why_tells(self):
        random.seed(2)
        words = {'drawn': 'drawn', 'out_of_view': 'out of view', 'in_shadow': 'culled, '}
        for walk in ('frusta', 'cover', 'held'):
            self.open(walk)
            fates = set()
            for _ in range(16):
                frame = self.run_script('page.setIndex(arguments[0]); return page.columns.frame[page.index]', random.randrange(20))
                polygon, text = self.click_picture(random.random(), random.uniform(0.3, 1))
                if polygon is None:
                    continue
                said = why(walk, frame, '--polygon', str(polygon))
                fates.add(said['fate'])
                self.assertIn(f'Polygon {polygon}: ', text)
                command = f'occlude why {" ".join(WALK + OPTIONS[walk])} --frame {frame} --polygon {polygon}'
                self.assertEqual(text.splitlines()[1], command)
                self.assertIn(words[said['fate']], text)
                if said['fate'] == 'in_shadow' and walk == 'cover':
                    self.assertIn('several polygons', text)
                self.assert_same_distances(said, text)
                self.assert_same_reason(said, text)
            self.assertGreaterEqual(len(fates), 2)

    def assert_same_distances(self, said, text):
        if said['fate'] == 'out_of_view':
            self.assertIn(f"beyond the {said['plane']['name']} plane by", text)
            expected = [said['plane']['distance']]
        else:
            expected = [shadow['distance'] for shadow in said['shadows']] if said['fate'] == 'in_shadow' else []
        told = re.findall(r'(sticks out of its shadow by|inside its shadow by|plane by) ([0-9.e+-]+[0-9])', text)
        self.assertEqual(len(told), len(expected), text)
        for (words, number), distance in zip(told, expected):
            self.assertAlmostEqual(float(number) / abs(distance), 1, places=5)
            self.assertEqual('sticks out' in words, distance < 0)
        for shadow in said['shadows'] if said['fate'] == 'in_shadow' else []:
            self.assertIn(str(shadow['occluder']['polygons'][0]), text)
            if shadow['plane'] == 'near':
                self.assertIn('its near side', text)
            else:
                edges = [[float(x) for x in re.findall(r'[0-9.e+-]*[0-9]', edge)]
                         for edge in re.findall(r'through its edge (\(.*?\) – \(.*?\))', text)]
                edge = [x for corner in shadow['edge'] for x in corner]
                self.assertTrue(any(all(abs(x - y) < 1e-2 for x, y in zip(told, edge)) for told in edges), f'{text} {edge}')

    def assert_same_reason(self, said, text):
        self.assertEqual(said['missed'] is not None, 'though it is hidden: ' in text, text)
        if said['missed'] is None:
            return
        self.assertIn(self.reason_in_words(said['missed']['reason']), text)
        if said['missed']['occluder']:
            self.assertIn(str(min(said['missed']['occluder']['polygons'])), text)

    def reason_in_words(self, name):
        return self.run_script('return page.walk.reasons[`missed_${arguments[0]}`]', name)

    def test_every_hidden_polygon_that_was_drawn_has_its_reason(self):
        for walk in ('frusta', 'cover', 'held'):
            self.open(walk)
            counts = self.run_script('''return page.columns.frame.map((_, i) => {
                const counts = {};
                for (const {reason} of page.details.at(i).missed.values()) {
                  const words = page.scene.reasons[reason];
                  counts[words] = (counts[words] ?? 0) + 1;
                }
                return counts;
            })''')
            columns, reasons = self.run_script('return [page.columns, page.walk.reasons]')
            for i, count in enumerate(counts):
                self.assertEqual({words: n for words, n in count.items()},
                                 {words: columns[name][i] for name, words in reasons.items() if columns[name][i] > 0})
            name, words = next(iter(reasons.items()))
            frame = max(range(len(counts)), key=lambda i: columns[name][i])
            place = self.run_script('''page.setIndex(arguments[0]);
                const {missed} = page.details.at(arguments[0]);
                for (const [place, {reason}] of missed) if (page.scene.reasons[reason] === arguments[1]) return place;''', frame, words)
            text = self.run_script('return page.accountOf(arguments[0])', place)
            said = why(walk, columns['frame'][frame], '--polygon', str(self.run_script('return page.model.numbers[arguments[0]]', place)))
            self.assertEqual(said['fate'], 'drawn')
            self.assertEqual(said['pixels'], 0)
            self.assert_same_reason(said, text)


class WithoutWebGL(Page):
    OPTIONS = ('--disable-3d-apis',)

    def test_pictures_stand_in_for_the_viewer(self):
        self.open('frusta')
        self.assertIn('no WebGL2', self.element('reason').text)
        pictures = self.driver.find_elements(By.CSS_SELECTOR, '.fallback img')
        self.assertEqual(len(pictures), 2)
        for picture in pictures:
            self.assertTrue(picture.is_displayed())
            self.assertGreater(self.run_script('return arguments[0].naturalWidth', picture), 0)


if __name__ == '__main__':
    unittest.main(verbosity=2)
