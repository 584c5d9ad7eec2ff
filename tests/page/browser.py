# SPDX-License-Identifier: MIT
"""Pages in Chromium: what their tests share."""
import json
import os
import re
import struct
import unittest

from selenium import webdriver
from selenium.webdriver.chrome.service import Service
from selenium.webdriver.common.by import By
from selenium.webdriver.support.ui import WebDriverWait


def browser(*options):
    chrome = webdriver.ChromeOptions()
    for option in ('--headless=new', '--no-sandbox', '--disable-dev-shm-usage', '--use-gl=angle', '--use-angle=swiftshader',
                   '--enable-unsafe-swiftshader', '--window-size=1200,900', *options):
        chrome.add_argument(option)
    chrome.set_capability('goog:loggingPrefs', {'browser': 'ALL', 'performance': 'ALL'})
    driver = webdriver.Chrome(options=chrome, service=Service('chromedriver'))
    driver.set_script_timeout(120)
    return driver


# The triangles of the model: of each the number of its face, nine coordinates, and whether light comes through.
TRIANGLES = '''
    const {corners, colours, numbers} = app.model;
    return Array.from(numbers, (face, t) => [face, ...corners.subarray(9 * t, 9 * t + 9), Number(colours[12 * t + 3] === 0)]);'''


def triangles_of_ply(name):
    """The fans of the faces, in single precision."""
    with open(name, 'rb') as file:
        header, data = file.read().split(b'end_header\n', 1)
    vertices, faces = (int(count) for count in re.findall(rb'element \w+ (\d+)', header))
    points = list(struct.iter_unpack('<3d', data[:24 * vertices]))
    triangles, at = [], 24 * vertices
    for face in range(faces):
        loop = struct.unpack_from(f'<{data[at]}I', data, at + 1)
        at += 1 + 4 * len(loop)
        for corners in ((loop[0], loop[i], loop[i + 1]) for i in range(1, len(loop) - 1)):
            triangles.append([face, *(struct.unpack('f', struct.pack('f', x))[0] for corner in corners for x in points[corner]), 0])
    return triangles


class Page(unittest.TestCase):
    OPTIONS = ()

    @classmethod
    def setUpClass(cls):
        cls.driver = browser(*cls.OPTIONS)
        cls.addClassCleanup(cls.driver.quit)

    def open(self, file, promise):
        """Opens a page of the working folder, and waits for what it promises; scripts find it as `page`."""
        self.driver.get('about:blank')  # a new page, whatever the address names
        self.driver.get(f'file://{os.getcwd()}/{file}')
        opened = self.driver.execute_async_script(
            f'const done = arguments[0]; {promise}.then(p => {{ window.page = p; done("open"); }}, error => done(String(error)));')
        self.assertEqual(opened, 'open')

    def element(self, name):
        return self.driver.find_element(By.ID, name)

    def run_script(self, script, *arguments):
        return self.driver.execute_script(script, *arguments)

    def click(self, element):
        self.run_script('arguments[0].scrollIntoView({block: "center"})', element)
        element.click()

    def saved(self, button, name):
        """The text of the file that a button hands to the reader."""
        folder = os.path.join(os.getcwd(), 'saved')
        self.driver.execute_cdp_cmd('Page.setDownloadBehavior', {'behavior': 'allow', 'downloadPath': folder})
        file = os.path.join(folder, name)
        if os.path.exists(file):
            os.remove(file)
        self.click(self.element(button))
        WebDriverWait(self.driver, 20).until(lambda _: os.path.exists(file))
        with open(file, encoding='utf-8') as text:
            return text.read()

    def assert_quiet(self):
        """No message on the console, and nothing fetched but the page itself."""
        self.assertEqual([entry['message'] for entry in self.driver.get_log('browser')], [])
        for entry in self.driver.get_log('performance'):
            message = json.loads(entry['message'])['message']
            if message['method'] == 'Network.requestWillBeSent':
                url = message['params']['request']['url']
                self.assertTrue(url.startswith(f'file://{os.getcwd()}') or url.startswith('data:'), url)


class Flight(Page):
    """The page in which one flies: scripts find its App as `app`, and who judges as `court`."""
    OPTIONS = ('--window-size=640,480',)
    FILE = 'flight.html'

    def open(self, address='', file=None):
        self.driver.get('about:blank')
        self.driver.get(f'file://{os.getcwd()}/{file or self.FILE}{address}')
        opened = self.run_later('window.page.then(({app, court}) => { Object.assign(window, {app, court}); return "open"; })')
        self.assertEqual(opened, 'open')
        self.addCleanup(self.no_errors)

    def no_errors(self):
        self.assertEqual([entry['message'] for entry in self.driver.get_log('browser') if entry['level'] == 'SEVERE'], [])

    def run_later(self, promise):
        return self.driver.execute_async_script(
            f'const done = arguments[0]; Promise.resolve({promise}).then(done, error => done(String(error.stack)));')

    def wait_for(self, condition, seconds=100):
        WebDriverWait(self.driver, seconds).until(lambda _: self.run_script(f'return Boolean({condition})'))

    def drop(self, *names):
        self.element('files').send_keys('\n'.join(os.path.abspath(name) for name in names))

    def text(self, name):
        return self.run_script('return document.getElementById(arguments[0]).textContent', name)

    def write(self, name, text):
        with open(name, 'w', encoding='utf-8') as file:
            file.write(text)
        return name

    def drop_model(self, name):
        self.drop(name)
        self.wait_for(f'app.model.name === {json.dumps(name)} && app.frame')

    def look(self, eye, target):
        self.run_script('const [eye, target] = arguments; app.jump({eye, target});', eye, target)
        self.wait_for('!document.hidden')
        self.run_later('new Promise(done => requestAnimationFrame(() => requestAnimationFrame(done)))')

    def drawn(self):
        """The names of the objects that have a triangle in the frame."""
        return self.run_script('''
            const fates = new Uint8Array(app.model.corners.length / 9), {names, firsts} = app.model;
            app.frame.tellFates(fates);
            return names.filter((_, o) => fates.subarray(firsts[o], firsts[o + 1]).includes(0)).sort();''')

    def assert_equal_pictures(self, places):
        """With and without culling, by both methods, from these places; something is hidden, and something shows."""
        for method in 'polygons', 'objects':
            self.run_script('app.setMethod(arguments[0])', method)
            hidden = colours = 0
            for place in places:
                found = self.run_script('return app.differences(arguments[0])', place)
                self.assertEqual(found['different'], 0, (method, place))
                colours = max(colours, found['colours'])
                hidden += found['hidden']
            self.assertGreater(hidden, 1000)
            self.assertGreater(colours, 10)
