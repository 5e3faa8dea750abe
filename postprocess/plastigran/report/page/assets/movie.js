// SPDX-License-Identifier: GPL-2.0-or-later
// The view of a run's grains: frames in time, what colours them, and the values of the one pointed at.
const page = window.plastigran;
const RATE = 150; // ms a frame
const DEEPEST = 65535;

/** The frames of a run, as `plastigran.report.page.movie` packs them. */
async function unpackFrames(text) {
  const buffer = await page.unpack(text), bytes = new Uint8Array(buffer);
  let at = bytes.indexOf(10) + 1;
  const run = JSON.parse(new TextDecoder().decode(bytes.subarray(0, at)));
  const take = (count) => {
    const found = new Uint16Array(buffer, at, count);
    at += 2 * count;
    return found;
  };
  let walls = new Uint16Array(0);
  run.frames = run.frames.map(({ said, grains, corners }) => {
    const frame = { said, places: take(3 * grains), radii: take(grains), values: {} };
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

  /** Show the frame of the slider in the chosen colours. */
  take() {
    const frame = this.frame = this.run.frames[Number(this.time.value)], colour = this.colour;
    this.drawing.show({ ...frame, values: frame.values[colour.name] });
    this.find(".now").textContent = frame.said;
    this.time.setAttribute("aria-valuetext", frame.said);
    this.find(".scale-title").textContent = `${colour.said} (${colour.unit})`;
    const beyond = colour.top > 1.01 * colour.spanned ? " and more" : "";
    const ends = ["0", digits(colour.spanned / 2), digits(colour.spanned) + beyond];
    [...this.find(".scale-ends").children].forEach((end, k) => { end.textContent = ends[k]; });
    this.later();
  }

  later() {
    if (this.waiting) return;
    this.waiting = requestAnimationFrame(() => { this.waiting = 0; this.draw(); });
  }

  draw() {
    if (!this.canvas.width) return;
    const { spanned, top } = this.colour;
    const ink = rgb(getComputedStyle(document.documentElement).getPropertyValue("--ink"));
    this.drawing.draw(this.camera.view(), {
      span: top ? spanned / top : 1, largest: this.run.radius, ink, walls: this.find(".walls").checked,
    });
  }

  play(on) {
    clearInterval(this.timer);
    this.timer = on ? setInterval(() => this.step(), RATE) : 0;
    const button = this.find(".play");
    button.textContent = on ? "Pause" : "Play";
    button.setAttribute("aria-pressed", String(on));
  }

  step() {
    this.time.value = (Number(this.time.value) + 1) % this.run.frames.length;
    this.take();
  }

  /** Say the values of the grain in front at the pointer. */
  point(event) {
    const tip = this.find(".tip"), box = this.canvas.getBoundingClientRect();
    const found = event.buttons ? -1 : this.grainAt(event.clientX - box.left, event.clientY - box.top, box);
    tip.hidden = found < 0;
    if (found < 0) return;
    const radius = (this.frame.radii[found] / DEEPEST) * this.run.radius;
    const said = this.run.colours.map(({ name, said, unit, top }) =>
      `${said} ${digits((this.frame.values[name][found] / DEEPEST) * top)} ${unit}`);
    tip.replaceChildren(...[...said, `radius ${digits(1e3 * radius)} mm`].flatMap((line) => [line, document.createElement("br")]));
    const left = event.clientX - box.left;
    tip.style.left = left > box.width / 2 ? "auto" : `${left + 14}px`;
    tip.style.right = left > box.width / 2 ? `${box.width - left + 14}px` : "auto";
    tip.style.top = `${event.clientY - box.top + 10}px`;
  }

  grainAt(left, top, box) {
    const { turn, middle, size, scale } = this.camera.view(), { places, radii } = this.frame;
    const x = ((2 * left) / box.width - 1) / scale[0], y = (1 - (2 * top) / box.height) / scale[1];
    let found = -1, nearest = -Infinity;
    for (let k = 0; k < radii.length; k++) {
      const p = [0, 1, 2].map((i) => (places[3 * k + i] / DEEPEST) * size - middle[i]);
      const [dx, dy, z] = [0, 1, 2].map((i) => turn[3 * i] * p[0] + turn[3 * i + 1] * p[1] + turn[3 * i + 2] * p[2]);
      const r = (radii[k] / DEEPEST) * this.run.radius;
      if ((dx - x) ** 2 + (dy - y) ** 2 < r * r && z > nearest) [found, nearest] = [k, z];
    }
    return found;
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
