"""The live page in headless Chromium: the machine's published hashes, read back from its canvases,
and what sliders, keys, pointer and links change. Usage: page_test.py PAGE GOLDENS [OUTPUT-FOLDER]

Debian's chromium, chromium-driver and python3-selenium are needed; without one of them, or without
the page (tools/page builds it), the test is skipped: exit 77 and a line that says why.
"""
import base64
import os
import re
import sys
import time


def skip(why):
    print("left out: " + why)
    sys.exit(77)


try:
    from selenium import webdriver
    from selenium.webdriver.chrome.options import Options
    from selenium.webdriver.chrome.service import Service
    from selenium.webdriver.common.action_chains import ActionChains
    from selenium.webdriver.common.keys import Keys
except ImportError:
    skip("the page is not tried in a browser (missing: python3-selenium)")
for program, package in (("/usr/bin/chromium", "chromium"),
                         ("/usr/bin/chromedriver", "chromium-driver")):
    if not os.path.exists(program):
        skip(f"the page is not tried in a browser (missing: {package})")
if not os.path.exists(sys.argv[1]):
    skip(f"the page is not tried in a browser (there is no {sys.argv[1]}; tools/page builds it)")

page = "file://" + os.path.abspath(sys.argv[1])
goldens = dict(line.split() for line in open(sys.argv[2]))
output = sys.argv[3] if len(sys.argv) > 3 else "."
failures = 0


def check(holds, what):
    global failures
    if not holds:
        failures += 1
        print("FAILED: " + what)


def equal(actual, expected, what):
    check(actual == expected, f"{what}: {actual!r}, expected {expected!r}")


def fnv1a64(data):
    """Of 8-bit values; its format is tools/io/buffers.hpp's."""
    value = 0xcbf29ce484222325
    for byte in data:
        value = (value ^ byte) * 0x100000001b3 & 0xffffffffffffffff
    return f"{value:016x}"


class Page:
    def __init__(self):
        options = Options()
        for argument in ("--headless=new", "--no-sandbox", "--disable-gpu", "--hide-scrollbars",
                         "--window-size=1400,1000"):
            options.add_argument(argument)
        options.set_capability("goog:loggingPrefs", {"browser": "ALL"})
        self.driver = webdriver.Chrome(service=Service("/usr/bin/chromedriver"), options=options)
        self.driver.set_script_timeout(20)

    def js(self, script, *arguments):
        return self.driver.execute_script(script, *arguments)

    def open(self, address=""):
        self.driver.get("about:blank")
        self.driver.get(page + address)
        self.settle()

    def settle(self):
        """Waits until what was asked for last is drawn, compared and hashed."""
        end = time.time() + 30
        while time.time() < end:
            if self.js("return document.documentElement.dataset.settled"):
                return
            time.sleep(0.03)
        raise SystemExit("FAILED: the page did not come to rest in 30 s: " + self.text("problem"))

    def find(self, css):
        return self.driver.find_element("css selector", css)

    def click(self, css):
        self.find(css).click()
        self.settle()

    def text(self, name):
        return self.js("return document.getElementById(arguments[0]).textContent", name)

    def put(self, css, value, event):
        """Moves a control as its user would: the value, then the event."""
        self.js("const c = document.querySelector(arguments[0]); c.value = arguments[1];"
                "c.dispatchEvent(new Event(arguments[2], {bubbles: true}))", css, value, event)
        self.settle()

    def canvas(self, css):
        """The red bytes of a canvas, which is grey."""
        return base64.b64decode(self.js(
            "const c = document.querySelector(arguments[0]);"
            "const d = c.getContext('2d').getImageData(0, 0, c.width, c.height).data;"
            "let s = ''; for (let k = 0; k < d.length; k += 4) s += String.fromCharCode(d[k]);"
            "return btoa(s)", css))

    def address(self):
        return self.js("return decodeURIComponent(location.hash)")

    def rate(self, name):
        found = re.match(r"([0-9.]+)", self.text("gauge-" + name))
        return float(found.group(1)) if found else None


def presets(p):
    names = {"1": "intensity", "2": "light_z", "3": "mask3", "4": "mask4", "5": "filtered5",
             "6": "picture6", "7a": "fig7a", "7b": "fig7b", "8": "fig8"}
    for figure, golden in names.items():
        p.click(f"#figures button[data-name='figure {figure}']")
        equal(p.text("stage-hash"), goldens[golden], f"figure {figure}: the buffer's hash")
        check(golden in p.text("stage-golden"), f"figure {figure} is not said to be {golden}")
        if golden != "light_z":  # whose canvas shows 16 bits as grey
            equal(fnv1a64(p.canvas("#stage")), goldens[golden].split(":")[-1],
                  f"figure {figure}: the canvas's own hash")
        if figure in ("7b", "8"):
            check("facets" in p.text("why-no-truth"), f"figure {figure}'s truth is not its facets'")
            check(0 < p.rate("false_shadow") < 10 and 0 < p.rate("false_light") < 20,
                  f"figure {figure}'s errors: " + p.text("gauge-false_shadow"))
            check(not p.js("return document.querySelector('[data-view=error]')"
                           ".classList.contains('absent')"), f"figure {figure} has no error map")
    p.put("#gallery", "teapot", "change")
    equal(p.text("stage-hash"), goldens["teapot"], "the teapot's hash")


def settings(p):
    p.click("#figures button[data-name='figure 3']")
    equal(p.text("gauge-false_shadow"), "23.87 %", "figure 3's false shadow")
    equal(p.text("gauge-false_light"), "2.26 %", "figure 3's false light")
    equal(p.text("gauge-isolated"), "2263", "figure 3's isolated pixels")
    equal(p.text("gauge-flatness"), "0.36", "figure 3's flatness")
    p.put("#set-bias", "300", "input")
    check("bias=300" in p.address(), "the address has no bias=300: " + p.address())
    check(p.rate("false_shadow") < 20, "more bias leaves false shadow " +
          p.text("gauge-false_shadow"))
    equal(p.text("stage-golden"), "", "with another bias the mask is said to be a golden")
    units = [p.js("return arguments[0].value", each)
             for each in p.driver.find_elements("css selector", ".bias .unit input")]
    equal([round(float(each), 8) for each in units],
          [300, 300 / 128, round(300 / 128 / 128, 8)],
          "300 quanta in quanta, texels and world units")
    p.put(".bias .unit:nth-of-type(2) input", "0.5", "change")
    equal(p.text("stage-hash"), goldens["mask3"], "0.5 texel is figure 3's bias")
    p.put("#set-lookup", "bilinear", "change")
    equal(p.text("gauge-false_shadow"), "0.25 %", "bilinear lookup at figure 3's bias")
    p.put("#set-xy_bits", "7", "change")
    equal(p.js("return document.getElementById('stage').width"), 128, "7 bits of X and Y")
    p.click("#reset-all")
    p.put("#profile", "ap120b", "change")
    check("profile=ap120b" in p.address(), "no machine of the time in " + p.address())
    p.click("#figures button[data-name='figure 3']")
    for key, value in ("bias_unit", "texels"), ("bias", "0.5"):
        p.js("location.hash += `&${arguments[0]}=${arguments[1]}`", key, value)
    p.put("#profile", "d16_unorm", "change")
    equal(p.js("return document.getElementById('stage').width"), 2048, "today's map")
    equal(p.text("gauge-false_shadow"), "23.69 %", "the stripes of today's 16 bits")


def links(p):
    other = "other=scene%3Dfigures.toml%26lookup%3Dnearest%26bias%3D64%26dither%3Dnone"
    p.open("#scene=figures.toml&dequantize=0&low_pass=0&show=mask&wipe=0.25&" + other)
    equal(p.text("stage-hash"), goldens["mask4"], "a link's picture")
    check(p.find("#stage-other").is_displayed(), "a link's other settings are not shown")
    equal(fnv1a64(p.canvas("#stage-other")), goldens["mask3"].split(":")[-1],
          "the canvas on the left of the wipe")
    check("75%" in p.find("#stage-other").get_attribute("style"), "the wipe is not at a quarter")
    p.js("delete document.documentElement.dataset.settled; location.hash += '&bias=64'")
    p.settle()
    check(p.rate("false_shadow") > 3, "an address that is edited is not followed: " +
          p.text("gauge-false_shadow"))
    p.click("#drop-other")
    check("other" not in p.address(), "the comparison is still in " + p.address())


def pointer(p):
    p.click("#figures button[data-name='figure 6']")
    stage = p.find("#stage")
    ActionChains(p.driver).drag_and_drop_by_offset(stage, 60, 0).perform()
    p.settle()
    turned = re.search(r"light.azimuth=(-?[0-9.]+)", p.address())
    check(turned and float(turned.group(1)) > -95, "a drag leaves the light at " + p.address())
    check(p.text("stage-hash") != goldens["picture6"], "a turned light draws the same picture")
    p.find("input[value=observer]").click()
    stage.send_keys(Keys.ARROW_LEFT)
    p.settle()
    check("observer.azimuth=1" in p.address(), "an arrow key leaves " + p.address())


def pixels(p):
    p.open("#scene=figures.toml&lookup=nearest&bias=64&dither=none&dequantize=0&low_pass=0"
           "&show=mask&pixel=80,180")
    equal(p.text("pixel-summary"), "in shadow, cycles 169706 to 169718", "pixel 80,180")
    words = p.text("words")
    check("12415" in words and "307f" in words, "the pixel's code is not among its words")
    equal(p.js("return [...document.querySelectorAll('.texel.fetched')].map(t => t.textContent)"),
          ["12393"], "the texel that was fetched")
    p.find("#step").click()
    equal(p.text("cycle-now"), "cycle 169707", "a step of the pipeline")
    p.js("document.getElementById('play').click()")
    time.sleep(0.8)
    check(int(p.text("cycle-now").split()[1]) > 169707, "the pipeline does not play")
    p.js("scrollTo(0, 0)")
    p.find("#stage").click()
    p.settle()
    check("pixel=256,256" in p.address() or "pixel=255,255" in p.address(),
          "a click in the middle follows " + p.address())


def pasted(p):
    p.find("#paste").click()
    p.js("document.getElementById('paste-text').value = arguments[0]", "[observer\n")
    p.find("#paste-draw").click()
    time.sleep(0.5)
    check(p.text("problem").startswith("pasted.toml:1: this is not valid TOML"),
          "a wrong scene: " + p.text("problem"))
    p.find("#paste").click()
    p.js("document.getElementById('paste-text').value = arguments[0]",
         "[light]\nazimuth = 40\nelevation = 30\n[[sphere]]\ncentre = [0, 0, 0]\nradius = 1\n")
    p.find("#paste-draw").click()
    p.settle()
    equal(p.text("problem"), "", "a right scene")
    check(p.rate("false_light") is not None, "a pasted sphere has no truth")


def never_blocks(p):
    """Frames of the browser go on while the worker draws the robot."""
    p.open("#scene=robot.toml")
    p.js("window.seen = 0; const count = () => { window.seen++; requestAnimationFrame(count); };"
         "count()")
    before = p.js("return window.seen")
    p.put("#set-z_bits", "15", "change")
    check(p.js("return window.seen") - before > 5, "the page stood still while a robot was drawn")


def report_speed(p):
    """Not checked, for it is the computer's: the least that the worker takes for a frame."""
    def least(prepare, change):
        times = []
        for n in range(8):
            prepare(n)
            change(n)
            p.settle()
            times.append(p.rate("host"))
        return min(times)

    def nothing(n):
        pass

    def arrow(mode):
        p.find(f"input[value={mode}]").click()
        keys = [Keys.ARROW_RIGHT, Keys.ARROW_LEFT]
        return lambda n: p.find("#stage").send_keys(keys[n % 2])

    p.open()
    times = {
        "the bias moved": least(nothing, lambda n: p.put("#set-bias", str(64 + n), "input")),
        "the light turned": least(nothing, arrow("light")),
        "the observer turned": least(nothing, arrow("observer")),
        "all of it new": least(lambda n: p.put("#gallery", "teapot", "change"),
                               lambda n: p.click("button[data-name='figure 3']")),
    }
    for what, ms in times.items():
        print(f"a frame of the figures' scene, {what}: least {ms} ms")


def main():
    size = os.path.getsize(sys.argv[1])
    check(size < 1500000, f"the page has {size} bytes, more than 1.5 MB")
    text = open(sys.argv[1]).read()
    check(not re.search(r"(src|href)=[\"']?(https?:)?//", text), "the page loads from elsewhere")
    p = Page()
    try:
        p.open()
        for part in (presets, settings, links, pointer, pixels, pasted, never_blocks,
                     report_speed):
            part(p)
        p.driver.save_screenshot(os.path.join(output, "page.png"))
        for line in p.driver.get_log("browser"):
            check(line["level"] != "SEVERE", line["message"])
    finally:
        p.driver.quit()
    print("the page: " + (f"{failures} failures" if failures else "passed"))
    return 1 if failures else 0


sys.exit(main())
