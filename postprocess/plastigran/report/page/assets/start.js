// SPDX-License-Identifier: GPL-2.0-or-later
// Unpacks the data of the page after the browser has shown it.
const page = window.plastigran;
const packed = (name) => document.getElementById(name).textContent;

async function start() {
  const numbers = JSON.parse(new TextDecoder().decode(await page.unpack(packed("numbers"))));
  Object.assign(page, numbers);
  for (const figure of document.querySelectorAll("[data-movie]")) await page.startMovie(figure);
  if (packed("plotly")) {
    const script = document.createElement("script");
    script.textContent = new TextDecoder().decode(await page.unpack(packed("plotly")));
    document.head.append(script);
    page.startCharts();
  }
  document.documentElement.dataset.ready = "";
}
start();
