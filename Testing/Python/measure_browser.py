# SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
# SPDX-License-Identifier: BSD-3-Clause
"""Measures the page of python -m vtkterrain in headless Chromium, 1000 x 700: measure_browser.py FILE

Prints seconds from the address to the first picture, and pictures a second while the pointer turns the
terrain for some seconds. Only times: nothing fails.
"""
import shutil
import signal
import statistics
import subprocess
import sys
import time

from playwright.sync_api import sync_playwright

_SECONDS = 6.0
# Counts what the page shows: each picture is another address of its <img>.
_COUNT = """
() => {
  window.shown = [];
  window.observer?.disconnect();
  window.observer = new MutationObserver(() => window.shown.push(performance.now()));
  window.observer.observe(document.querySelector('img'), {attributes: true, attributeFilter: ['src']});
}
"""


def turn(page):
    """Pictures a second while the pointer goes to and fro."""
    page.evaluate(_COUNT)
    page.mouse.move(400, 350)
    page.mouse.down()
    begin = time.monotonic()
    step = 0
    while time.monotonic() - begin < _SECONDS:
        step += 1
        page.mouse.move(400 + abs(step % 200 - 100) * 3, 350)
        time.sleep(0.008)
    shown = page.evaluate("window.shown")
    page.mouse.up()
    gaps = [later - sooner for sooner, later in zip(shown, shown[1:])]
    return len(gaps) / (shown[-1] - shown[0]) * 1e3, statistics.median(gaps), max(gaps)


def main():
    server = subprocess.Popen([sys.executable, "-m", "vtkterrain", "--no-browser", sys.argv[1]],
                              stdout=subprocess.PIPE, text=True)
    try:
        address = server.stdout.readline().strip()
        with sync_playwright() as play:
            browser = play.chromium.launch(executable_path=shutil.which("chromium"),
                                           args=["--no-sandbox", "--disable-gpu"])
            page = browser.new_page(viewport={"width": 1000, "height": 700})
            begin = time.monotonic()
            page.goto(address)
            page.wait_for_selector("img[src]", timeout=60_000)
            print(f"First picture after {time.monotonic() - begin:.2f} s")
            time.sleep(1.0)
            for _ in range(3):
                rate, median, largest = turn(page)
                print(f"{rate:.1f} pictures a second, {median:.0f} ms between two (median), {largest:.0f} at most")
            browser.close()
    finally:
        server.send_signal(signal.SIGINT)
        server.wait(20)


if __name__ == "__main__":
    main()
