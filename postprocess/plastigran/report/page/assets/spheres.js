// SPDX-License-Identifier: GPL-2.0-or-later
// Draws spheres and translucent walls with WebGL 2. Each sphere is a square that faces the viewer. The
// fragment shader computes the sphere's exact surface, depth and light at any size.
const VIEW = `
uniform mat3 turn; uniform vec3 middle; uniform float size; uniform vec2 scale; uniform float reach;
vec3 eye(vec3 place) { return turn * (place * size - middle); }
vec4 shown(vec3 at) { return vec4(at.xy * scale, -at.z / reach, 1.0); }`;
const SPHERE_VERTEX = `#version 300 es
in vec2 corner; in vec3 place; in float radius; in float value;
uniform float largest; uniform float span;
out vec2 at; out vec3 centre; flat out float r; flat out float share;
${VIEW}
void main() {
  r = radius * largest; at = corner * 1.05; share = clamp(value / span, 0.0, 1.0);
  centre = eye(place);
  gl_Position = shown(centre + vec3(at * r, 0.0));
}`;
const SPHERE_FRAGMENT = `#version 300 es
precision highp float;
in vec2 at; in vec3 centre; flat in float r; flat in float share;
uniform sampler2D map; uniform float reach;
out vec4 colour;
void main() {
  float d = length(at), soft = fwidth(d);
  float cover = 1.0 - smoothstep(1.0 - soft, 1.0 + soft, d);
  if (cover <= 0.0) discard;
  vec3 normal = vec3(at, sqrt(max(1.0 - d * d, 0.0)));
  gl_FragDepth = clamp(0.5 - 0.5 * (centre.z + r * normal.z) / reach, 0.0, 1.0);
  float lit = 0.42 + 0.62 * max(dot(normal, normalize(vec3(-0.45, 0.6, 0.75))), 0.0);
  float glint = 0.16 * pow(max(dot(normal, normalize(vec3(-0.27, 0.36, 0.9))), 0.0), 30.0);
  vec3 shade = texture(map, vec2((share * 255.0 + 0.5) / 256.0, 0.5)).rgb;
  colour = vec4(shade * lit * smoothstep(-0.15, 0.5, normal.z) + glint, cover);
}`;
const WALL_VERTEX = `#version 300 es
in vec3 place; out vec3 at;
${VIEW}
void main() { at = eye(place); gl_Position = shown(at); }`;
const WALL_FRAGMENT = `#version 300 es
precision highp float;
in vec3 at; uniform vec3 ink; out vec4 colour;
void main() {
  vec3 normal = normalize(cross(dFdx(at), dFdy(at)));
  float edge = 1.0 - abs(normal.z);
  colour = vec4(ink, 0.05 + 0.22 * edge * edge * edge);
}`;

function program(gl, vertex, fragment) {
  const shaders = gl.createProgram();
  for (const [kind, text] of [[gl.VERTEX_SHADER, vertex], [gl.FRAGMENT_SHADER, fragment]]) {
    const shader = gl.createShader(kind);
    gl.shaderSource(shader, text);
    gl.compileShader(shader);
    gl.attachShader(shaders, shader);
  }
  gl.linkProgram(shaders);
  if (!gl.getProgramParameter(shaders, gl.LINK_STATUS)) throw new Error(gl.getProgramInfoLog(shaders));
  return shaders;
}

/** Canvas that shows one frame at a time. */
window.plastigran.Spheres = class {
  /** Throws an error in a browser without WebGL 2. `map` is a list of evenly spaced colors. */
  constructor(canvas, map) {
    const gl = this.gl = canvas.getContext("webgl2", { antialias: true, preserveDrawingBuffer: true });
    if (!gl) throw new Error("no WebGL 2");
    this.canvas = canvas;
    this.spheres = program(gl, SPHERE_VERTEX, SPHERE_FRAGMENT);
    this.walls = program(gl, WALL_VERTEX, WALL_FRAGMENT);
    this.buffers = Object.fromEntries(["corner", "place", "radius", "value", "wall"].map((n) => [n, gl.createBuffer()]));
    this.fill("corner", new Float32Array([-1, -1, 1, -1, -1, 1, 1, 1]));
    this.colours(map);
  }

  fill(name, numbers) {
    this.gl.bindBuffer(this.gl.ARRAY_BUFFER, this.buffers[name]);
    this.gl.bufferData(this.gl.ARRAY_BUFFER, numbers, this.gl.STATIC_DRAW);
  }

  colours(map) {
    const gl = this.gl, strip = document.createElement("canvas"), pen = strip.getContext("2d");
    [strip.width, strip.height] = [256, 1];
    const shades = pen.createLinearGradient(0, 0, 256, 0);
    map.forEach((shade, k) => shades.addColorStop(k / (map.length - 1), shade));
    pen.fillStyle = shades;
    pen.fillRect(0, 0, 256, 1);
    gl.bindTexture(gl.TEXTURE_2D, gl.createTexture());
    gl.texImage2D(gl.TEXTURE_2D, 0, gl.RGBA, gl.RGBA, gl.UNSIGNED_BYTE, strip);
    for (const name of ["MIN_FILTER", "MAG_FILTER"]) gl.texParameteri(gl.TEXTURE_2D, gl["TEXTURE_" + name], gl.LINEAR);
    for (const name of ["WRAP_S", "WRAP_T"]) gl.texParameteri(gl.TEXTURE_2D, gl["TEXTURE_" + name], gl.CLAMP_TO_EDGE);
  }

  /** Load a frame. Its 16-bit numbers are fractions of the size of the run or of its largest values. */
  show({ places, radii, values, walls }) {
    this.count = radii.length;
    this.corners = walls.length / 3;
    this.fill("place", places);
    this.fill("radius", radii);
    this.fill("value", values);
    this.fill("wall", walls);
  }

  attribute(shaders, name, size, kind, divisor) {
    const gl = this.gl, place = gl.getAttribLocation(shaders, name);
    gl.bindBuffer(gl.ARRAY_BUFFER, this.buffers[name === "place" && shaders === this.walls ? "wall" : name]);
    gl.enableVertexAttribArray(place);
    gl.vertexAttribPointer(place, size, kind, kind !== gl.FLOAT, 0, 0);
    gl.vertexAttribDivisor(place, divisor);
  }

  use(shaders, view) {
    const gl = this.gl, at = (name) => gl.getUniformLocation(shaders, name);
    gl.useProgram(shaders);
    gl.bindVertexArray(shaders.array ??= gl.createVertexArray());
    gl.uniformMatrix3fv(at("turn"), true, view.turn);
    gl.uniform3fv(at("middle"), view.middle);
    gl.uniform1f(at("size"), view.size);
    gl.uniform2fv(at("scale"), view.scale);
    gl.uniform1f(at("reach"), view.reach);
    return at;
  }

  /** Draw the frame. `view` comes from the camera; `look` has span, largest, ink and walls (shown or not). */
  draw(view, look) {
    const gl = this.gl;
    gl.viewport(0, 0, this.canvas.width, this.canvas.height);
    gl.clearColor(0, 0, 0, 0);
    gl.enable(gl.DEPTH_TEST);
    gl.depthMask(true);
    gl.clear(gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT);
    gl.disable(gl.BLEND);
    gl.enable(gl.SAMPLE_ALPHA_TO_COVERAGE);
    let at = this.use(this.spheres, view);
    gl.uniform1f(at("largest"), look.largest);
    gl.uniform1f(at("span"), look.span);
    this.attribute(this.spheres, "corner", 2, gl.FLOAT, 0);
    this.attribute(this.spheres, "place", 3, gl.UNSIGNED_SHORT, 1);
    this.attribute(this.spheres, "radius", 1, gl.UNSIGNED_SHORT, 1);
    this.attribute(this.spheres, "value", 1, gl.UNSIGNED_SHORT, 1);
    gl.drawArraysInstanced(gl.TRIANGLE_STRIP, 0, 4, this.count);
    gl.disable(gl.SAMPLE_ALPHA_TO_COVERAGE);
    if (!look.walls || !this.corners) return;
    gl.enable(gl.BLEND);
    gl.blendFuncSeparate(gl.SRC_ALPHA, gl.ONE_MINUS_SRC_ALPHA, gl.ONE, gl.ONE_MINUS_SRC_ALPHA);
    gl.depthMask(false);
    at = this.use(this.walls, view);
    gl.uniform3fv(at("ink"), look.ink);
    this.attribute(this.walls, "place", 3, gl.UNSIGNED_SHORT, 0);
    gl.drawArrays(gl.TRIANGLES, 0, this.corners);
  }
};
