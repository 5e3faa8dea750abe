// SPDX-License-Identifier: GPL-2.0-or-later
// What the page carries is unpacked once it is shown.
const page = window.plastigran;
const carried = (name) => document.getElementById(name).textContent;

async function start() {
  const numbers = JSON.parse(new TextDecoder().decode(await page.unpack(carried("numbers"))));
  Object.assign(page, numbers);
  for (const figure of document.querySelectorAll("[data-movie]")) await page.startMovie(figure);
  if (carried("plotly")) {
    const script = document.createElement("script");
    script.textContent = new TextDecoder().decode(await page.unpack(carried("plotly")));
    document.head.append(script);
    page.startCharts();
  }
  document.documentElement.dataset.ready = "";
}
start();
