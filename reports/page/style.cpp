#include "reports/page/style.hpp"

namespace crawford::reports::page {

const char* const style = R"css(
:root {
  color-scheme: light dark;
  --paper: #ffffff; --panel: #f6f7f9; --line: #d5dae0; --ink: #1c2127; --soft: #5b6570;
  --accent: #0b5fa5; --pass: #1a7a3a; --fail: #c0261f; --open: #8a6100; --fail-panel: #fdecea;
}
@media (prefers-color-scheme: dark) {
  :root {
    --paper: #14171b; --panel: #1c2126; --line: #363d45; --ink: #e4e8ec; --soft: #9aa5b0;
    --accent: #6cb3f2; --pass: #58c878; --fail: #ff7b72; --open: #e0b040; --fail-panel: #3a1d1c;
  }
}
* { box-sizing: border-box; }
body { margin: 0; background: var(--paper); color: var(--ink);
  font: 15px/1.5 system-ui, -apple-system, "Segoe UI", "DejaVu Sans", sans-serif; }
main { max-width: 76rem; margin: 0 auto; padding: 1.5rem; }
h1 { font-size: 1.7rem; margin: 0 0 .3rem; }
h2 { font-size: 1.25rem; margin: 2.2rem 0 .5rem; }
h3 { font-size: 1.05rem; margin: 1.6rem 0 .2rem; }
h4 { font-size: .95rem; margin: 0 0 .3rem; overflow-wrap: anywhere; }
p { margin: .4rem 0; max-width: 48rem; }
a { color: var(--accent); text-decoration: none; }
a:hover { text-decoration: underline; }
code, pre { font-family: ui-monospace, "DejaVu Sans Mono", monospace; font-size: .88em; }
pre { overflow-x: auto; padding: .5rem; background: var(--panel); }
table { border-collapse: collapse; font-variant-numeric: tabular-nums; }
th, td { padding: .15rem .6rem; text-align: left; vertical-align: top; }
th { font-weight: 600; }
.entry { border-top: 1px solid var(--line); margin-top: 2rem; }
.facts, .demand, .reason { color: var(--soft); }
.facts { font-size: .85rem; overflow-wrap: anywhere; max-width: none; margin: .1rem 0; }
.count-of-all { font-size: 1.1rem; }
.mark { padding: .05rem .45rem; border-radius: .3rem; font-size: .8em; white-space: nowrap;
  border: 1px solid currentColor; }
.pass { color: var(--pass); } .fail { color: var(--fail); } .open { color: var(--open); }
.shortcomings { padding-left: 1.1rem; }
.shortcomings li { overflow-wrap: anywhere; }
.studies tr { border-bottom: 1px solid var(--line); }
.studies td:first-child { white-space: nowrap; }
.studies .fail a { color: var(--fail); }
.studies th { white-space: nowrap; }
.studies .count { text-align: right; white-space: nowrap; }
.manifest th { color: var(--soft); white-space: nowrap; }
.manifest td { overflow-wrap: anywhere; }
.wide { overflow-x: auto; }
.coverage { font-size: .8rem; }
.coverage tbody tr, .coverage > tr { border-top: 1px solid var(--line); }
.coverage td { text-align: center; padding: .1rem .25rem; border-left: 1px solid var(--line); }
.coverage th { font-weight: normal; white-space: nowrap; vertical-align: bottom; }
.coverage .upright { writing-mode: vertical-rl; transform: rotate(180deg); padding: .25rem .1rem; }
.coverage tr.aside { color: var(--soft); }
.coverage tr.fail { background: var(--fail-panel); }
.gates { display: grid; grid-template-columns: repeat(auto-fill, minmax(min(34rem, 100%), 1fr));
  gap: .8rem; margin-top: .6rem; }
.gate { color: var(--ink); background: var(--panel); border: 1px solid var(--line);
  border-left: .25rem solid var(--pass); border-radius: .3rem; padding: .6rem .8rem;
  font-size: .86rem; }
.gate.fail { color: var(--ink); border-left-color: var(--fail); background: var(--fail-panel); }
.gate.open { color: var(--ink); border-left-color: var(--open); }
.gate p { margin: .2rem 0; overflow-wrap: anywhere; }
.demand { font-weight: normal; }
.evidence { display: flex; flex-wrap: wrap; gap: .6rem; align-items: flex-start;
  justify-content: space-between; margin-top: .3rem; }
.numbers { font-size: .92em; }
.numbers th { color: var(--soft); font-weight: normal; }
.numbers th, .numbers td { text-align: right; padding: .05rem .5rem; white-space: nowrap; }
.numbers .aside { color: var(--soft); }
svg { max-width: 100%; height: auto; }
svg text { fill: var(--soft); font-size: 12px; }
svg .axis { stroke: var(--soft); stroke-width: 1; }
svg .grid { stroke: var(--line); stroke-width: 1; }
svg .expected { stroke: var(--soft); stroke-width: 1.2; stroke-dasharray: 5 3; }
svg polyline.measured { fill: none; stroke: var(--accent); stroke-width: 1.8; }
svg circle.measured { fill: var(--accent); stroke: var(--accent); stroke-width: 1.4; }
svg circle.hollow { fill: var(--panel); }
svg circle.outside { fill: var(--fail); stroke: var(--fail); }
svg .allowed { fill: var(--pass); opacity: .25; }
nav { font-size: .9rem; margin-bottom: 1rem; }
figure { margin: 0; }
figcaption { font-size: .9rem; }
img, video { max-width: 100%; height: auto; background: #ffffff; }
.pictures { margin: 1rem 0; }
.several { display: grid; gap: 1rem;
  grid-template-columns: repeat(auto-fit, minmax(min(30rem, 100%), 1fr)); }
.gallery td { vertical-align: middle; }
.thumbnail { width: 15rem; max-width: none; max-height: 12rem; object-fit: contain; display: block; }
main > ul { max-width: 48rem; }
.columns { columns: 24rem; column-gap: 2rem; }
.columns section { break-inside: avoid; padding-bottom: 1.2rem; }
.columns h3 { margin-top: 0; }
.columns ul { margin: .2rem 0; padding-left: 1.1rem; }
summary { cursor: pointer; }
.grounds tr, .ledger tr { border-bottom: 1px solid var(--line); }
.grounds .count, .grounds td + td { font-variant-numeric: tabular-nums; }
.grounds .count { text-align: right; }
.grounds .aside { color: var(--soft); }
.grounds td:first-child { min-width: 11rem; }
.grounds td + td .facts, .ledger td:nth-child(2) { white-space: nowrap; }
.chosen { background: var(--panel); }
.ledger { width: 100%; }
.ledger td:last-child { min-width: 14rem; }
.ledger tr:target { background: var(--panel); outline: 2px solid var(--accent); }
@media screen and (max-width: 52rem) {
  .ledger thead { display: none; }
  .ledger tr { display: block; padding: .5rem 0; }
  .ledger td { display: grid; grid-template-columns: 4.5rem 1fr; padding: .1rem 0; }
  .ledger td::before { content: attr(data-label); color: var(--soft); font-size: .85rem; }
  .thumbnail { width: 8rem; }
}
@media print {
  :root {
    --paper: #ffffff; --panel: #ffffff; --line: #c4cad0; --ink: #000000; --soft: #444c55;
    --accent: #0b5fa5; --pass: #1a7a3a; --fail: #b01f18; --open: #755200; --fail-panel: #fdecea;
  }
  @page { margin: 14mm; }
  html { font-size: 11px; }
  body { font-size: 1rem; }
  main { max-width: none; padding: 0 1px; }
  .gates { grid-template-columns: 1fr 1fr; gap: .4rem; }
  .gate, #coverage, .studies tr, .ledger tr, .grounds tr, figure { break-inside: avoid; }
  h2, h3 { break-after: avoid; }
  a { color: inherit; }
  nav { display: none; }
  figure img { max-height: 200mm; }
  svg { width: 165px; }
  .evidence { flex-wrap: nowrap; gap: .2rem; }
  .numbers th, .numbers td { padding: 0 .3rem; }
  .coverage { font-size: .75rem; }
  .wide { overflow: visible; }
}
)css";

}  // namespace crawford::reports::page
