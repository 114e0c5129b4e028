// SPDX-License-Identifier: Apache-2.0
"use strict";
for (const film of document.querySelectorAll(".film")) {
  const { frames, times } = JSON.parse(film.querySelector("script").textContent);
  const [image, button, slider, output] = ["img", "button", "input", "output"].map(name => film.querySelector(name));
  const pause = 120, last = frames.length - 1;  // [ms] a picture
  let timer = null;
  const show = k => {
    const frame = Math.max(0, Math.min(last, k));
    slider.value = frame;
    image.src = frames[frame];
    output.textContent = times[frame];
    slider.setAttribute("aria-valuetext", times[frame]);
  };
  const now = () => Number(slider.value);
  const stop = () => {
    clearInterval(timer);
    timer = null;
    button.textContent = "Play";
  };
  const play = () => {
    if (now() === last) show(0);
    button.textContent = "Pause";
    timer = setInterval(() => now() < last ? show(now() + 1) : stop(), pause);
  };
  const toggle = () => timer === null ? play() : stop();
  button.addEventListener("click", toggle);
  slider.addEventListener("input", () => { stop(); show(now()); });
  film.addEventListener("keydown", event => {
    const steps = { ArrowLeft: now() - 1, ArrowRight: now() + 1, Home: 0, End: last };
    if (event.key === " " && event.target !== button) toggle();
    else if (event.key in steps) { stop(); show(steps[event.key]); }
    else return;
    event.preventDefault();
  });
}
