"""A headless Chromium from Debian's packages, and what the test asks of it."""
import base64
import json
import os
import pathlib
import time

from selenium import webdriver
from selenium.webdriver.chrome.options import Options
from selenium.webdriver.chrome.service import Service
from selenium.webdriver.common.by import By

AXE = pathlib.Path(__file__).with_name('axe.min.js').read_text(encoding='utf-8')
FLAGS = ['--headless=new', '--no-sandbox', '--use-angle=swiftshader', '--enable-unsafe-swiftshader', '--hide-scrollbars',
         '--disable-dev-shm-usage', '--disable-background-networking', '--no-first-run']

# The number of different colours on a canvas, a 2D or a 3D one, as the eye would see it.
COLOURS = """
const source = arguments[0], copy = document.createElement('canvas');
[copy.width, copy.height] = [source.width, source.height];
if (copy.width * copy.height === 0) return 0;
const context = copy.getContext('2d');
context.drawImage(source, 0, 0);
return new Set(new Uint32Array(context.getImageData(0, 0, copy.width, copy.height).data.buffer)).size;
"""


class Page:
    def __init__(self, file):
        options = Options()
        for flag in FLAGS:
            options.add_argument(flag)
        options.set_capability('goog:loggingPrefs', {'browser': 'ALL', 'performance': 'ALL'})
        self.driver = webdriver.Chrome(options=options, service=Service('/usr/bin/chromedriver'))
        self.address = pathlib.Path(file).resolve().as_uri()
        self.driver.execute_cdp_cmd('Browser.grantPermissions', {'permissions': ['clipboardReadWrite', 'clipboardSanitizedWrite']})
        self.look(1280)
        self.driver.get(self.address)
        self.data = self.run("return JSON.parse(document.getElementById('tribunal-data').textContent)")

    def run(self, script, *arguments):
        return self.driver.execute_script(script, *arguments)

    def look(self, width, scheme='light'):
        """The width of the window, in CSS pixels, and the colours that the user prefers."""
        self.driver.execute_cdp_cmd('Emulation.setDeviceMetricsOverride',
                                    {'width': width, 'height': 900, 'deviceScaleFactor': 1, 'mobile': False})
        self.driver.execute_cdp_cmd('Emulation.setEmulatedMedia',
                                    {'features': [{'name': 'prefers-color-scheme', 'value': scheme}]})

    def go(self, fragment):
        """To a state of the page, and until it is drawn."""
        self.run('location.hash = arguments[0]', fragment)
        self.settle()

    def settle(self):
        self.driver.execute_async_script(
            'const done = arguments[0]; requestAnimationFrame(() => requestAnimationFrame(() => setTimeout(done, 30)))')

    def find(self, selector):
        return self.driver.find_element(By.CSS_SELECTOR, selector)

    def all(self, selector):
        return self.driver.find_elements(By.CSS_SELECTOR, selector)

    def focus(self, selector):
        element = self.find(selector)
        self.run('arguments[0].focus()', element)
        return element

    def press(self, *keys):
        """Keys to what has the focus."""
        for key in keys:
            self.driver.switch_to.active_element.send_keys(key)
        self.settle()

    def fragment(self):
        return self.run('return location.hash')

    def text(self, selector):
        return self.run("return document.querySelector(arguments[0])?.textContent ?? ''", selector)

    def colours(self, canvas):
        return self.run(COLOURS, canvas)

    def copied(self, name):
        """What the button of this name puts on the clipboard."""
        self.run("document.querySelector(`[data-copy='${arguments[0]}']`).click()", name)
        for _ in range(50):
            if 'copied' in self.run("return document.querySelector(`[data-copy='${arguments[0]}'] + .state`).textContent", name):
                break
            time.sleep(0.02)
        return self.driver.execute_async_script('navigator.clipboard.readText().then(arguments[0])')

    def axe(self):
        """What axe-core, rules of WCAG 2.2 A and AA, objects to."""
        if not self.run('return window.axe !== undefined'):
            self.run(AXE + '\nwindow.axe = axe;')
        violations = self.driver.execute_async_script("""
            const done = arguments[0];
            axe.run(document, {runOnly: ['wcag2a', 'wcag2aa', 'wcag21a', 'wcag21aa', 'wcag22aa', 'best-practice'], resultTypes: ['violations']})
              .then((result) => done(result.violations.map((v) => `${v.id}: ${v.nodes.length} times, first ${v.nodes[0].html.slice(0, 200)} ${v.nodes[0].failureSummary}`)),
                    (error) => done([String(error)]))""")
        return violations

    def complaints(self):
        """Lines of the console, and addresses that were asked for beside the page itself."""
        lines = [entry['message'] for entry in self.driver.get_log('browser') if entry['level'] != 'INFO']
        events = (json.loads(entry['message'])['message'] for entry in self.driver.get_log('performance'))
        asked = [event['params']['request']['url'] for event in events if event['method'] == 'Network.requestWillBeSent']
        return lines + [url[:200] for url in asked if not url.startswith('data:') and url.split('#')[0] != self.address]

    def takes_pictures(self):
        return 'SCREENSHOTS' in os.environ

    def shot(self, name):
        """A picture of the whole page, for people, into $SCREENSHOTS if that is set."""
        if self.takes_pictures():
            width, height = self.run('return [document.documentElement.clientWidth, document.documentElement.scrollHeight]')
            picture = self.driver.execute_cdp_cmd('Page.captureScreenshot', {
                'captureBeyondViewport': True, 'clip': {'x': 0, 'y': 0, 'width': width, 'height': min(height, 2600), 'scale': 1}})
            pathlib.Path(os.environ['SCREENSHOTS'], name + '.png').write_bytes(base64.b64decode(picture['data']))

    def close(self):
        self.driver.quit()
