// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace quadrat::report {

// How a page looks: on a screen by day and by night, and on paper, where it is always day.
inline constexpr const char* kPageStyle = R"(
:root { color-scheme: light dark; --paper: #fff; --ink: #1c2126; --quiet: #626c76; --rule: #d9dee3;
        --mark: #3060a0; --pale: #b9cbe3; --growing: #e8f0e0; --breach: #b3261e; }
@media screen and (prefers-color-scheme: dark) {
  :root { --paper: #14171a; --ink: #e3e7ea; --quiet: #98a2ac; --rule: #333a41;
          --mark: #7ba8e0; --pale: #36496a; --growing: #27331f; --breach: #ff8a80; }
}
body { margin: 0; background: var(--paper); color: var(--ink); font: 15px/1.45 system-ui, sans-serif; }
main { max-width: 62rem; margin: 0 auto; padding: 2rem 1.25rem; }
h1 { margin: 0 0 1rem; font-size: 1.7rem; font-weight: 600; }
h2 { margin: 2.2rem 0 .3rem; font-size: 1.2rem; font-weight: 600; break-after: avoid; }
p { margin: 0 0 .6rem; max-width: 46rem; color: var(--quiet); break-inside: avoid; break-after: avoid; }
dl { display: grid; grid-template-columns: max-content 1fr; gap: .15rem 1.2rem; margin: 0; }
dt { color: var(--quiet); }
dd { margin: 0; }
dd ul { margin: 0; padding: 0; list-style: none; }
code { font-family: ui-monospace, monospace; font-size: .92em; }
.wide { overflow-x: auto; }
table { border-collapse: collapse; width: 100%; font-variant-numeric: tabular-nums; }
th, td { padding: .22rem .9rem .22rem 0; text-align: left; vertical-align: baseline; border-top: 1px solid var(--rule); }
th:last-child, td:last-child { padding-right: 0; }
tr { break-inside: avoid; }
thead th { color: var(--quiet); font-weight: 400; font-size: .87em; border-top: 0; vertical-align: bottom; }
tbody th { font-weight: 400; }
.figures { table-layout: fixed; min-width: 46rem; }
.figures col:nth-child(1) { width: 32%; }
.figures col:nth-child(2) { width: 9%; }
.figures col:nth-child(3) { width: 17%; }
.figures col:nth-child(4) { width: 8%; }
.figures tbody th { overflow-wrap: anywhere; }
.n { text-align: right; }
.value { font-weight: 600; }
.rivals { margin: 0; padding: 0; list-style: none; }
.rivals li { display: flex; align-items: baseline; gap: .7em; }
.bar { flex: none; width: 6rem; height: .55em; }
.solid { fill: var(--mark); }
.pale { fill: var(--pale); }
.rivals li:nth-child(n + 2) .solid { fill: var(--quiet); }
.rivals li:nth-child(n + 2) .pale { fill: var(--rule); }
.shaders { font-size: .9em; }
.shaders tbody { break-inside: avoid; }
.shaders tbody tr + tr td { border-top: 0; }
.shaders .chip { padding-left: 1.2rem; }
.shaders thead .chip { text-align: left; }
.shaders thead .chip.n { text-align: right; }
.shaders thead tr + tr th { padding-right: .9rem; }
.shaders .bar { width: 4rem; margin-left: .5em; }
.breach { color: var(--breach); font-weight: 700; text-decoration: underline; }
figure { margin: 1rem 0 0; break-inside: avoid; }
figure > svg { display: block; width: 100%; height: auto; }
figure text { font-size: 15px; }
figure .paper { fill: var(--paper); }
figure .growing { fill: var(--growing); }
figure .took { stroke: var(--mark); }
figure .rule { stroke: var(--rule); }
figure .line { fill: none; stroke: var(--mark); stroke-width: 2; }
figure .band { stroke: var(--mark); stroke-width: 1.5; opacity: .55; }
figure .dot { fill: var(--mark); }
figure .breach { fill: var(--breach); }
figure .label { fill: var(--quiet); font-size: 12px; font-weight: 400; text-decoration: none; }
figcaption { color: var(--quiet); font-size: .87em; margin-top: .3rem; }
.cards { display: grid; grid-template-columns: repeat(auto-fit, minmax(9.5rem, 1fr)); gap: .9rem; margin: 0 0 .8rem;
         padding: 0; list-style: none; }
.cards li { border-top: 3px solid var(--mark); padding-top: .35rem; break-inside: avoid; }
.cards b { display: block; font-size: 1.55rem; font-weight: 600; font-variant-numeric: tabular-nums; }
.cards span { color: var(--quiet); font-size: .87em; }
.key { display: inline-block; width: .8em; height: .8em; margin: 0 .35em 0 .9em; vertical-align: -.05em; }
.key:first-child { margin-left: 0; }
.key.done { background: var(--mark); }
.key.other { background: var(--pale); }
details { margin: .6rem 0 0; }
summary { color: var(--quiet); cursor: pointer; font-size: .87em; }
a { color: var(--mark); }
:focus-visible { outline: 3px solid var(--mark); outline-offset: 2px; }
@media print {
  @page { margin: 15mm; }
  body { font-size: 9.5pt; }
  main { max-width: none; padding: 0; }
  .wide { overflow: visible; }
  .figures { min-width: 0; }
  .figures th code { font-size: .82em; }
  .rivals .bar { width: 4.5rem; }
}
)";

}  // namespace quadrat::report
