#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""The page of scripts/report in a browser without a screen, at the width of a desk and of a phone: its pictures load, nothing is
cut off, the film plays, and nothing is asked of the network. Needs BRUNT, BRUNT_RUN (scripts/run) in the environment; exit code 77
(skipped) without a browser, which scripts/setup --browser installs."""
import http.server
import json
import os
import shutil
import subprocess
import sys
import threading
import unittest

import report_test
import scenes
from run_test import PATIENCE, Program

NAMES = ("chromium-headless-shell", "chromium", "chromium-browser", "google-chrome")
BROWSER = next((found for found in map(shutil.which, NAMES) if found), None)
WIDTHS = (1280, 390)  # [pixels] a desk, a phone
# Before anything of the page: faults are noted. At its end: the film is used as a reader would, and what happened is written down.
NOTE_FAULTS = "<script>const faults = []; window.addEventListener('error', e => faults.push(String(e.message || e.target.src).slice(0, 200)), true);</script>"
USE_FILM = """<script>
window.addEventListener('load', async () => {
  const film = document.querySelector('.film'), told = {faults};
  const [image, button, slider, output] = ['img', 'button', 'input', 'output'].map(name => film.querySelector(name));
  const wait = milliseconds => new Promise(done => setTimeout(done, milliseconds));
  const look = name => told[name] = [Number(slider.value), image.src.length, output.textContent, button.textContent];
  const press = key => film.dispatchEvent(new KeyboardEvent('keydown', {key, bubbles: true, cancelable: true}));
  look('first');
  for (const key of ['Home', 'ArrowRight', 'ArrowRight', 'ArrowLeft']) press(key);
  look('keys');
  press('End'); press('ArrowRight');
  look('end');
  button.click();
  look('play');
  await wait(700);
  press(' ');
  look('paused');
  await wait(300);
  look('still');
  slider.value = 2; slider.dispatchEvent(new Event('input'));
  look('slid');
  told.images = [...document.images].filter(i => !i.complete || i.naturalWidth < 100).length;
  told.scroll = document.documentElement.scrollWidth;
  told.width = window.innerWidth;
  told.wide = [...document.querySelectorAll('main *')].filter(e => !e.closest('.scroll, pre') && e.getBoundingClientRect().right > window.innerWidth + 1)
    .map(e => e.tagName + '.' + e.className);
  told.high = Math.max(...[...document.querySelectorAll('.film img, figure img')].map(i => i.getBoundingClientRect().height));
  const sign = document.createElement('pre');
  sign.id = 'told';
  sign.textContent = JSON.stringify(told);
  document.body.appendChild(sign);
});
</script>"""


class Requests(http.server.SimpleHTTPRequestHandler):
    """Gives files of the folder and notes what is asked for."""
    asked = []

    def log_message(self, form, *arguments):
        self.asked.append(self.path)


class Browser(Program):
    def setUp(self):
        super().setUp()
        self.write("rod.yaml", scenes.ROD + report_test.PROBES)
        self.run_scene(1, "rod.yaml", "--out", "out", "--set", "run.steps=20")
        done = subprocess.run([os.path.join(report_test.SCRIPTS, "report"), "out"], cwd=self.folder, capture_output=True, text=True,
                              timeout=2 * PATIENCE, check=False)
        self.assertEqual(done.returncode, 0, done.stderr)

    def browse(self, url, width, *options):
        command = [BROWSER, "--headless", "--no-sandbox", "--disable-gpu", "--disable-dev-shm-usage", f"--window-size={width},900",
                   "--virtual-time-budget=20000", f"--user-data-dir={self.folder}/profile{width}", *options, url]
        return subprocess.run(command, cwd=self.folder, capture_output=True, text=True, timeout=4 * PATIENCE, check=False)

    def serve(self):
        """The folder over HTTP, so that every request of the page is seen."""
        Requests.asked.clear()
        server = http.server.ThreadingHTTPServer(("127.0.0.1", 0), lambda *a: Requests(*a, directory=self.folder))
        threading.Thread(target=server.serve_forever, daemon=True).start()
        self.addCleanup(server.server_close)
        self.addCleanup(server.shutdown)
        return f"http://127.0.0.1:{server.server_address[1]}"

    def test_the_page_in_a_browser(self):
        text = self.text("out", "report.html")
        self.write("out/used.html", text.replace("<head>", "<head>" + NOTE_FAULTS, 1).replace("</body>", USE_FILM + "</body>", 1))
        for width in WIDTHS:
            with self.subTest(width=width):
                done = self.browse(f"{self.serve()}/out/used.html", width, "--dump-dom")
                self.assertIn('<pre id="told">', done.stdout, done.stderr[-2000:])
                told = json.loads(report_test.Page(done.stdout).all("pre", id="told")[0][2])
                self.assertEqual((told["faults"], told["images"], told["wide"]), ([], 0, []))
                self.assertLessEqual(told["scroll"], told["width"])
                self.assertLess(told["high"], 900)
                self.check_film(told)
                self.assertEqual(set(Requests.asked) - {"/favicon.ico"}, {"/out/used.html"})

    def check_film(self, told):
        last, words = told["first"][0], {name: entry[2] for name, entry in told.items() if isinstance(entry, list) and len(entry) == 4}
        self.assertGreaterEqual(last, 4)
        self.assertEqual(told["keys"][0], 1)
        self.assertEqual(told["end"][:3], told["first"][:3])
        self.assertEqual((told["play"][0], told["play"][3]), (0, "Pause"))  # from the end it plays anew
        self.assertGreater(told["paused"][0], 0)
        self.assertEqual((told["paused"][3], told["still"][0]), ("Play", told["paused"][0]))
        self.assertEqual(told["slid"][0], 2)
        self.assertEqual(len({words["first"], words["keys"], words["slid"]}), 3, words)

    def test_it_opens_as_a_file_and_prints(self):
        for option, name, size in (("--screenshot={}", "page.png", 20_000), ("--print-to-pdf={}", "page.pdf", 20_000)):
            path = os.path.join(self.folder, name)
            done = self.browse(f"file://{self.folder}/out/report.html", 1280, option.format(path))
            self.assertTrue(os.path.isfile(path), done.stderr[-2000:])
            self.assertGreater(os.path.getsize(path), size)


if __name__ == "__main__":
    if BROWSER is None:
        print(f"no browser: none of {', '.join(NAMES)} is there (scripts/setup --browser installs one)")
        sys.exit(77)
    unittest.main()
