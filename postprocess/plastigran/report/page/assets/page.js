// SPDX-License-Identifier: GPL-2.0-or-later
// The page's light and its laws; charts and views are told of both by events.
const root = document.documentElement;
const page = window.plastigran = { hidden: new Set(), charts: {}, colours: {}, laws: {}, lit: "light" };

/** Text that the page carries as gzip in base64. */
page.unpack = async (text) => {
  const bytes = Uint8Array.from(atob(text.trim()), (letter) => letter.charCodeAt(0));
  const plain = new Blob([bytes]).stream().pipeThrough(new DecompressionStream("gzip"));
  return new Response(plain).arrayBuffer();
};
page.tell = (name) => document.dispatchEvent(new CustomEvent(name));

const theme = document.getElementById("theme");
const dark = matchMedia("(prefers-color-scheme: dark)");
function light(mode) {
  page.lit = mode ?? (theme.value === "auto" ? (dark.matches ? "dark" : "light") : theme.value);
  root.dataset.lit = page.lit;
  page.tell("lit");
}
function remembered(value) {
  try { // A page opened from a file may have no storage.
    if (value === undefined) return localStorage.getItem("plastigran-theme");
    localStorage.setItem("plastigran-theme", value);
  } catch { return null; }
}
theme.value = remembered() ?? "auto";
if (!theme.value) theme.value = "auto";
theme.addEventListener("change", () => { remembered(theme.value); light(); });
dark.addEventListener("change", () => light());
light();

document.getElementById("print").addEventListener("click", () => window.print());
window.addEventListener("beforeprint", () => light("light"));
window.addEventListener("afterprint", () => light());

const switches = [...document.querySelectorAll("input[data-law]")];
function applyLaws() {
  page.hidden = new Set(switches.filter((each) => !each.checked).map((each) => each.dataset.law));
  for (const row of document.querySelectorAll("[data-of-law]"))
    row.hidden = page.hidden.has(row.dataset.ofLaw);
  page.tell("laws");
}
for (const each of switches) each.addEventListener("change", applyLaws);
for (const [name, on] of [["all-laws", true], ["no-laws", false]])
  document.getElementById(name)?.addEventListener("click", () => {
    for (const each of switches) each.checked = on;
    applyLaws();
  });
