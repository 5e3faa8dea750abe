// SPDX-License-Identifier: GPL-2.0-or-later
// Camera that looks at a box. Gravity stays down; dragging turns the box, pinching zooms.
const VIEWS = { corner: [0.5, 0.35], front: [0, 0], side: [Math.PI / 2, 0], top: [0, Math.PI / 2] };
const clamp = (value, low, high) => Math.min(Math.max(value, low), high);

window.plastigran.Camera = class {
  /** `extent` holds the sides of the box; `changed` is called after every move. */
  constructor(canvas, extent, size, changed) {
    Object.assign(this, { canvas, extent, size, changed, zoom: 1, pointers: new Map() });
    this.look("corner");
    canvas.addEventListener("pointerdown", (event) => {
      canvas.setPointerCapture(event.pointerId);
      this.pointers.set(event.pointerId, event);
    });
    for (const end of ["pointerup", "pointercancel"])
      canvas.addEventListener(end, (event) => this.pointers.delete(event.pointerId));
    canvas.addEventListener("pointermove", (event) => this.drag(event));
    canvas.addEventListener("dblclick", () => { this.look("corner"); changed(); });
    canvas.addEventListener("wheel", (event) => {
      if (!event.ctrlKey) return;
      event.preventDefault();
      this.zoomBy(Math.exp(-event.deltaY / 200));
    }, { passive: false });
    canvas.addEventListener("keydown", (event) => this.key(event));
  }

  look(name) {
    [this.azimuth, this.elevation] = VIEWS[name];
    this.zoom = 1;
  }

  zoomBy(factor) {
    this.zoom = clamp(this.zoom * factor, 0.3, 20);
    this.changed();
  }

  turn(across, up) {
    this.azimuth -= across;
    this.elevation = clamp(this.elevation + up, -Math.PI / 2, Math.PI / 2);
    this.changed();
  }

  drag(event) {
    const before = this.pointers.get(event.pointerId);
    if (!before) return;
    const others = [...this.pointers.values()].filter(({ pointerId }) => pointerId !== event.pointerId);
    if (others.length) {
      const distance = ({ clientX, clientY }) => Math.hypot(clientX - others[0].clientX, clientY - others[0].clientY);
      this.zoomBy(distance(event) / Math.max(distance(before), 1));
    } else this.turn((event.clientX - before.clientX) / 150, (event.clientY - before.clientY) / 150);
    this.pointers.set(event.pointerId, event);
  }

  key(event) {
    const moves = {
      ArrowLeft: () => this.turn(-0.1, 0), ArrowRight: () => this.turn(0.1, 0), ArrowUp: () => this.turn(0, -0.1),
      ArrowDown: () => this.turn(0, 0.1), "+": () => this.zoomBy(1.2), "-": () => this.zoomBy(1 / 1.2),
    };
    if (!moves[event.key]) return;
    event.preventDefault();
    moves[event.key]();
  }

  /** Return rotation, middle and scales for the shaders. The box fits the canvas at any azimuth. */
  view() {
    const [a, e] = [this.azimuth, this.elevation], [x, y, z] = this.extent;
    const [ca, sa, ce, se] = [Math.cos(a), Math.sin(a), Math.cos(e), Math.sin(e)];
    const wide = Math.hypot(x, y) / 2, high = (z / 2) * Math.abs(ce) + wide * Math.abs(se);
    const { width, height } = this.canvas;
    const unit = (this.zoom * 0.92) / Math.max(wide / width, high / height);
    return {
      turn: [ca, sa, 0, sa * -se, ca * se, ce, sa * ce, -ca * ce, se],
      middle: [x / 2, y / 2, z / 2], size: this.size, scale: [unit / width, unit / height],
      reach: 1.1 * Math.hypot(x, y, z),
    };
  }
};
