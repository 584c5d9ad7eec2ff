# SPDX-License-Identifier: MIT
"""Pages in Chromium: what their tests share."""
import json
import os
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
