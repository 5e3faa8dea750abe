// SPDX-License-Identifier: GPL-2.0-or-later
// Charts drawn by plotly, with the colors of the page and the laws that are switched on.
const page = window.plastigran;
const css = (name) => getComputedStyle(document.documentElement).getPropertyValue(name).trim();
const config = { displayModeBar: false, responsive: true, doubleClick: "reset" };

/** Return axes, fonts and hover boxes in the colors of the page. */
function template() {
  const [ink, muted, line, raised] = ["--ink", "--muted", "--line", "--raised"].map(css);
  const axis = {
    gridcolor: line, linecolor: muted, zerolinecolor: line, ticks: "outside", tickcolor: muted, ticklen: 4,
    automargin: true, title: { standoff: 8 }, exponentformat: "power",
  };
  return { layout: {
    font: { family: getComputedStyle(document.body).fontFamily, size: 13, color: ink },
    paper_bgcolor: "rgba(0,0,0,0)", plot_bgcolor: "rgba(0,0,0,0)", xaxis: axis, yaxis: axis,
    hoverlabel: { bgcolor: raised, bordercolor: line, font: { color: ink, size: 13 }, align: "left", namelength: -1 },
    margin: { l: 8, r: 12, t: 12, b: 8 }, legend: { orientation: "h", y: 1.02, yanchor: "bottom", x: 0 },
    hovermode: "closest",
  } };
}

function coloured(trace) {
  const { law, colour = page.laws[law] } = trace.meta ?? {};
  const shade = colour >= 0 ? page.colours[page.lit][colour] : css("--ink");
  const drawn = { ...trace, visible: !page.hidden.has(law) };
  drawn.line = { ...trace.line, color: shade };
  if (trace.mode?.includes("markers"))
    drawn.marker = { ...trace.marker, color: css("--ground"), line: { ...trace.marker?.line, color: shade } };
  if (trace.stackgroup) drawn.fillcolor = shade + "b0";
  return drawn;
}

/** Width of an A4 page within its margins [px]. When printing starts, the page is still wider. */
const PAPER = 680;

async function draw(element, printing = false) {
  const view = page.charts[element.id].views[element.dataset.view];
  const laws = view.data.some((trace) => trace.meta?.law !== undefined);
  const layout = { ...structuredClone(view.layout), template: template() };
  layout.showlegend = !laws && view.data.length > 1;
  const whole = document.getElementById("content").clientWidth;
  if (printing && whole > PAPER) layout.width = (element.clientWidth * PAPER) / whole;
  await Plotly.react(element, view.data.map(coloured), layout, config);
  element.dataset.drawn = page.lit;
}

const all = () => [...document.querySelectorAll(".plot")];
/** Draw charts near the visible part of the page first, all other charts when the browser is idle. */
const near = new IntersectionObserver((seen) => {
  for (const { isIntersecting, target } of seen)
    if (isIntersecting) { near.unobserve(target); draw(target); }
}, { rootMargin: "600px" });
const rest = window.requestIdleCallback ?? ((then) => setTimeout(then, 50));
function drawNext() {
  const next = all().find((element) => !element.dataset.drawn);
  if (next) draw(next).then(() => rest(drawNext));
}

page.startCharts = () => {
  for (const element of all()) near.observe(element);
  rest(drawNext);
  for (const choice of document.querySelectorAll("select[data-chart]"))
    choice.addEventListener("change", () => {
      const element = document.getElementById(choice.dataset.chart);
      element.dataset.view = choice.value;
      draw(element);
    });
  const again = () => all().filter(({ dataset }) => dataset.drawn).forEach((element) => draw(element));
  document.addEventListener("lit", again);
  document.addEventListener("laws", again);
  window.addEventListener("beforeprint", () => all().forEach((element) => draw(element, true)));
};
