"""A real browser without a window, for the pages: headless Chromium, driven by Selenium."""

import json
import os
import re
import shutil
from pathlib import Path

import pytest

NAMES = ("chromium", "chromium-browser", "google-chrome")
DRIVERS = ("chromedriver",)
DESKTOP, LAPTOP, PHONE = (1920, 1080), (1280, 800), (390, 844)
"""Sizes of windows: width and height in CSS pixels."""
AXE = Path(__file__).parents[2] / "web" / "node_modules" / "axe-core" / "axe.min.js"
"""What `Browser.violations` runs; ``npm ci`` in web/ installs it, as .ci/run does."""
READY = "document.body.dataset.ready === 'true'"
"""What the script of a page says when it is ready."""


def data_of(page):
    found = re.search(r'id="data">(.*?)</script>', page.read_text(encoding="utf-8"))
    assert found
    return json.loads(found[1])


class Browser:
    """A browser with one tab; `errors` returns what its console reported as an error."""

    def __init__(self, driver):
        self.driver = driver

    def open(self, page, size=LAPTOP):
        """Open a file and wait until its script says that it is ready."""
        self.resize(*size)
        self.driver.get(page.absolute().as_uri())
        self.wait(READY)

    def reload(self):
        self.driver.refresh()
        self.wait(READY)

    def resize(self, width, height):
        """Set the size of the page. Windows cannot be narrower than 500 pixels; pages can."""
        metrics = {"width": width, "height": height, "deviceScaleFactor": 1, "mobile": width < 500}
        self.driver.execute_cdp_cmd("Emulation.setDeviceMetricsOverride", metrics)

    def prefer(self, **features):
        """Set media features, such as ``prefers_color_scheme="dark"``."""
        named = [{"name": n.replace("_", "-"), "value": v} for n, v in features.items()]
        self.driver.execute_cdp_cmd("Emulation.setEmulatedMedia", {"features": named})

    def js(self, expression, *args):
        return self.driver.execute_script(f"return {expression}", *args)

    def wait(self, expression, seconds=20.0):
        from selenium.webdriver.support.wait import WebDriverWait

        condition = f"{expression} in {seconds} s; console: "
        try:
            return WebDriverWait(self.driver, seconds, 0.05).until(lambda _: self.js(expression))
        except Exception as error:
            raise AssertionError(condition + str(self.errors())) from error

    def press(self, *keys):
        from selenium.webdriver import ActionChains

        for key in keys:
            ActionChains(self.driver, duration=0).send_keys(key).perform()

    def drag(self, *points):
        """Press the pointer at a point of the window and let it go at the last one."""
        from selenium.webdriver import ActionChains

        mouse = ActionChains(self.driver, duration=20)
        for number, (x, y) in enumerate(points):
            mouse.w3c_actions.pointer_action.move_to_location(round(x), round(y))
            if number == 0:
                mouse.w3c_actions.pointer_action.pointer_down()
        mouse.w3c_actions.pointer_action.pointer_up()
        mouse.perform()

    def click(self, selector):
        from selenium.webdriver.common.by import By

        self.driver.find_element(By.CSS_SELECTOR, selector).click()

    def errors(self):
        """Return the errors and warnings in the console since the last call."""
        found = self.driver.get_log("browser")
        return [each["message"] for each in found if each["level"] in ("SEVERE", "WARNING")]

    def violations(self):
        """Return what hinders readers with disabilities, as axe-core finds it: rule and element."""
        if not AXE.exists():
            pytest.skip("expected axe-core in web/node_modules (npm ci in web/), found none")
        self.driver.execute_script(AXE.read_text(encoding="utf-8"))
        return self.driver.execute_async_script(
            """const done = arguments[0];
            axe.run(document, {resultTypes: ["violations"]}).then(({ violations }) => done(
              violations.flatMap(({ id, nodes }) => nodes.map(({ html }) => `${id}: ${html}`))));"""
        )

    def hindrances(self, page, *dialogs):
        """Return the violations of a page and of the dialogs that scripts open.

        Light on a laptop and dark on a phone; by width, scheme and script.
        """
        found = {}
        for (width, height), scheme in ((LAPTOP, "light"), (PHONE, "dark")):
            self.prefer(prefers_color_scheme=scheme, prefers_reduced_motion="reduce")
            for script in ("", *dialogs):
                self.open(page, (width, height))
                self.driver.execute_script(script)
                found[str(width), scheme, script] = self.violations()
        self.prefer()
        return {where: violations for where, violations in found.items() if violations}


def chromium():
    """Start Chromium with a profile of its own; a test is skipped where there is none."""
    webdriver = pytest.importorskip("selenium.webdriver")
    program, driver = (next(filter(None, map(shutil.which, n)), None) for n in (NAMES, DRIVERS))
    if program is None or driver is None:
        pytest.skip("expected the programs chromium and chromedriver, found none")
    options = webdriver.ChromeOptions()
    options.binary_location = program
    options.set_capability("goog:loggingPrefs", {"browser": "ALL"})
    for argument in ("headless=new", "disable-gpu", "hide-scrollbars", "disable-dev-shm-usage"):
        options.add_argument(f"--{argument}")
    # Tests change the address more often than the 200 times in 10 s that a page may.
    options.add_argument("--disable-ipc-flooding-protection")
    # The sandbox does not start for the administrator, who runs tests in containers.
    if hasattr(os, "geteuid") and os.geteuid() == 0:
        options.add_argument("--no-sandbox")
    return Browser(webdriver.Chrome(options=options, service=webdriver.ChromeService(driver)))


def _started():
    started = chromium()
    try:
        yield started
    finally:
        started.driver.quit()


browser = pytest.fixture(scope="module", name="browser")(_started)
"""A browser for the tests of one file, which are skipped where there is none."""
friend = pytest.fixture(scope="module", name="friend")(_started)
"""Another one: what somebody sees who opens a link on another machine."""
