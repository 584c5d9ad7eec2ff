#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""A picture of the viewer in the page of a walk, from outside.

Usage: picture.py REPORT FRAME PNG
"""
import os
import sys

from selenium.webdriver.common.by import By

import browser

REPORT, FRAME, PNG = sys.argv[1:]
driver = browser.browser('--hide-scrollbars')
driver.set_window_size(1200, 2000)  # all of the viewer is in sight
driver.get(f'file://{os.path.abspath(REPORT)}#frame={FRAME}')
driver.execute_async_script('const done = arguments[0]; walkPage.then(() => setTimeout(done, 1000));')
driver.find_element(By.ID, 'outside').click()
driver.execute_async_script('setTimeout(arguments[0], 1000)')  # until it is known what was drawn in vain
driver.find_element(By.CLASS_NAME, 'stage').screenshot(PNG)
driver.quit()
