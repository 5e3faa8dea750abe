// SPDX-License-Identifier: GPL-2.0-or-later
// Light or dark mode, and the switches of laws. Charts and views receive changes as events.
const root = document.documentElement;
const page = window.plastigran = { hidden: new Set(), charts: {}, colours: {}, laws: {}, lit: "light" };

/** Unpack content that the page holds as gzip in base64. */
page.unpack = async (text) => {
  const bytes = Uint8Array.from(atob(text.trim()), (letter) => letter.charCodeAt(0));
  const plain = new Blob([bytes]).stream().pipeThrough(new DecompressionStream("gzip"));
  return new Response(plain).arrayBuffer();
};
page.emit = (name) => document.dispatchEvent(new CustomEvent(name));

const theme = document.getElementById("theme");
const dark = matchMedia("(prefers-color-scheme: dark)");
function light(mode) {
  page.lit = mode ?? (theme.value === "auto" ? (dark.matches ? "dark" : "light") : theme.value);
  root.dataset.lit = page.lit;
  page.emit("lit");
}
function storedTheme(value) {
  try { // A page that is opened from a file may have no access to the storage of the browser.
    if (value === undefined) return localStorage.getItem("plastigran-theme");
    localStorage.setItem("plastigran-theme", value);
  } catch { return null; }
}
theme.value = storedTheme() ?? "auto";
if (!theme.value) theme.value = "auto";
theme.addEventListener("change", () => { storedTheme(theme.value); light(); });
dark.addEventListener("change", () => light());
light();

document.getElementById("print").addEventListener("click", () => window.print());
window.addEventListener("beforeprint", () => light("light"));
window.addEventListener("afterprint", () => light());

const switches = [...document.querySelectorAll("input[data-law]")];
function applyLaws() {
  page.hidden = new Set(switches.filter(({ checked }) => !checked).map(({ dataset }) => dataset.law));
  for (const row of document.querySelectorAll("[data-of-law]"))
    row.hidden = page.hidden.has(row.dataset.ofLaw);
  page.emit("laws");
}
for (const box of switches) box.addEventListener("change", applyLaws);
for (const [name, on] of [["all-laws", true], ["no-laws", false]])
  document.getElementById(name)?.addEventListener("click", () => {
    for (const box of switches) box.checked = on;
    applyLaws();
  });
