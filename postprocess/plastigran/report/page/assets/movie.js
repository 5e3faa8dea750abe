// SPDX-License-Identifier: GPL-2.0-or-later
// View of the grains of a run: frames over time, colors, and the values of the grain under the pointer.
const page = window.plastigran;
const FRAME_TIME = 150; // ms
const LARGEST = 65535;

/** Unpack the frames of a run, which `plastigran.report.page.movie` packs. */
async function unpackFrames(text) {
  const buffer = await page.unpack(text), bytes = new Uint8Array(buffer);
  let at = bytes.indexOf(10) + 1;
  const run = JSON.parse(new TextDecoder().decode(bytes.subarray(0, at)));
  const take = (count) => {
    const numbers = new Uint16Array(buffer, at, count);
    at += 2 * count;
    return numbers;
  };
  let walls = new Uint16Array(0);
  run.frames = run.frames.map(({ label, grains, corners }) => {
    const frame = { label, places: take(3 * grains), radii: take(grains), values: {} };
    for (const { name } of run.colours) frame.values[name] = take(grains);
    if (corners !== null) walls = take(3 * corners);
    return { ...frame, walls };
  });
  return run;
}

const rgb = (text) => text.match(/[0-9a-f]{2}/gi).map((part) => parseInt(part, 16) / 255);
const digits = (value) => Number(value.toPrecision(3)).toString();

class Movie {
  constructor(figure, run) {
    this.run = run;
    this.find = (name) => figure.querySelector(name);
    this.canvas = this.find("canvas");
    this.drawing = new page.Spheres(this.canvas, run.map);
    this.camera = new page.Camera(this.canvas, run.extent, run.size, () => this.later());
    this.time = this.find(".time");
    this.find(".scale-bar").style.background = `linear-gradient(to right, ${run.map.join(", ")})`;
    this.time.addEventListener("input", () => this.take());
    this.find(".colour").addEventListener("change", () => this.take());
    this.find(".walls").addEventListener("change", () => this.later());
    this.find(".view").addEventListener("change", (event) => { this.camera.look(event.target.value); this.later(); });
    this.find(".play").addEventListener("click", () => this.play(!this.timer));
    this.canvas.addEventListener("pointermove", (event) => this.point(event));
    this.canvas.addEventListener("pointerleave", () => { this.find(".tip").hidden = true; });
    new ResizeObserver(() => this.fit()).observe(this.canvas);
    document.addEventListener("lit", () => this.later());
    this.take();
  }

  get colour() { return this.run.colours.find(({ name }) => name === this.find(".colour").value); }

  fit() {
    const sharp = Math.min(window.devicePixelRatio, 2);
    this.canvas.width = Math.round(this.canvas.clientWidth * sharp);
    this.canvas.height = Math.round(this.canvas.clientHeight * sharp);
    this.draw();
  }

  /** Show the frame that the slider selects, in the chosen colors. */
  take() {
    const frame = this.frame = this.run.frames[Number(this.time.value)], colour = this.colour;
    this.drawing.show({ ...frame, values: frame.values[colour.name] });
    this.find(".now").textContent = frame.label;
    this.time.setAttribute("aria-valuetext", frame.label);
    this.find(".scale-title").textContent = `${colour.title} (${colour.unit})`;
    const beyond = colour.top > 1.01 * colour.end ? " and more" : "";
    const labels = ["0", digits(colour.end / 2), digits(colour.end) + beyond];
    [...this.find(".scale-ends").children].forEach((label, k) => { label.textContent = labels[k]; });
    this.later();
  }

  later() {
    if (this.waiting) return;
    this.waiting = requestAnimationFrame(() => { this.waiting = 0; this.draw(); });
  }

  draw() {
    if (!this.canvas.width) return;
    const { end, top } = this.colour;
    const ink = rgb(getComputedStyle(document.documentElement).getPropertyValue("--ink"));
    this.drawing.draw(this.camera.view(), {
      span: top ? end / top : 1, largest: this.run.radius, ink, walls: this.find(".walls").checked,
    });
  }

  play(on) {
    clearInterval(this.timer);
    this.timer = on ? setInterval(() => this.step(), FRAME_TIME) : 0;
    const button = this.find(".play");
    button.textContent = on ? "Pause" : "Play";
    button.setAttribute("aria-pressed", String(on));
  }

  step() {
    this.time.value = (Number(this.time.value) + 1) % this.run.frames.length;
    this.take();
  }

  /** Show the values of the front grain at the pointer. */
  point(event) {
    const tip = this.find(".tip"), box = this.canvas.getBoundingClientRect();
    const grain = event.buttons ? -1 : this.grainAt(event.clientX - box.left, event.clientY - box.top, box);
    tip.hidden = grain < 0;
    if (grain < 0) return;
    const radius = (this.frame.radii[grain] / LARGEST) * this.run.radius;
    const lines = this.run.colours.map(({ name, title, unit, top }) =>
      `${title} ${digits((this.frame.values[name][grain] / LARGEST) * top)} ${unit}`);
    tip.replaceChildren(...[...lines, `radius ${digits(1e3 * radius)} mm`].flatMap((line) => [line, document.createElement("br")]));
    const left = event.clientX - box.left;
    tip.style.left = left > box.width / 2 ? "auto" : `${left + 14}px`;
    tip.style.right = left > box.width / 2 ? `${box.width - left + 14}px` : "auto";
    tip.style.top = `${event.clientY - box.top + 10}px`;
  }

  grainAt(left, top, box) {
    const { turn, middle, size, scale } = this.camera.view(), { places, radii } = this.frame;
    const x = ((2 * left) / box.width - 1) / scale[0], y = (1 - (2 * top) / box.height) / scale[1];
    let grain = -1, nearest = -Infinity;
    for (let k = 0; k < radii.length; k++) {
      const p = [0, 1, 2].map((i) => (places[3 * k + i] / LARGEST) * size - middle[i]);
      const [dx, dy, z] = [0, 1, 2].map((i) => turn[3 * i] * p[0] + turn[3 * i + 1] * p[1] + turn[3 * i + 2] * p[2]);
      const r = (radii[k] / LARGEST) * this.run.radius;
      if ((dx - x) ** 2 + (dy - y) ** 2 < r * r && z > nearest) [grain, nearest] = [k, z];
    }
    return grain;
  }
}

page.movies = {};
page.startMovie = async (figure) => {
  const run = await unpackFrames(figure.querySelector(".frames").textContent);
  try {
    page.movies[figure.id] = new Movie(figure, run);
  } catch (error) {
    figure.querySelector(".no-view").hidden = false;
    figure.querySelector("canvas").hidden = true;
    console.warn(`${figure.id}: ${error.message}`);
  }
};
