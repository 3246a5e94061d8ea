// SPDX-License-Identifier: GPL-3.0-or-later
#include "identification/report/page.h"

namespace sinew::diagnosis {
namespace {

// Orange is the model before, blue the model after, everywhere; both differ for people who cannot
// tell red from green, and dashes say the same again.
constexpr const char* kColours = R"(
:root {
  color-scheme: light dark;
  --paper: #f6f5f1; --card: #ffffff; --ink: #1c1f24; --soft: #565d67; --rule: #dbd8d0;
  --grid: #e9e7e1; --axis: #a9a69e; --measured: #8a8f98; --noise: #6c7480;
  --before: #ad4908; --after: #0b5fb8; --extra-1: #5b4bb3; --extra-2: #0f7a5f; --extra-3: #a12a5e;
  --note: #fdf3dc; --note-rule: #d9a53c; --next: #e9f1fb; --next-rule: #0b5fb8;
}
@media (prefers-color-scheme: dark) {
  :root {
    --paper: #121417; --card: #1b1e23; --ink: #e9e7e2; --soft: #a9afb9; --rule: #343940;
    --grid: #2a2e34; --axis: #5d646e; --measured: #8d94a0; --noise: #a0a7b2;
    --before: #ff9d57; --after: #6cb2ff; --extra-1: #b3a5ff; --extra-2: #5fd0ac;
    --extra-3: #ff8fbd;
    --note: #2e2614; --note-rule: #b58a35; --next: #16253a; --next-rule: #6cb2ff;
  }
}
)";

constexpr const char* kText = R"(
* { box-sizing: border-box; }
html { -webkit-text-size-adjust: 100%; text-size-adjust: 100%; }
body {
  margin: 0; background: var(--paper); color: var(--ink);
  font: 1rem/1.55 ui-sans-serif, system-ui, -apple-system, "Segoe UI", Roboto, "Helvetica Neue",
    "Noto Sans", "Liberation Sans", Arial, sans-serif;
  overflow-wrap: break-word;
}
main { max-width: 72rem; margin: 0 auto; padding: clamp(1rem, 3vw, 2.5rem) clamp(1rem, 4vw, 2.5rem) 4rem; }
h1 {
  font-size: clamp(1.5rem, 1.1rem + 1.7vw, 2.1rem); line-height: 1.18; letter-spacing: -0.018em;
  font-weight: 680; margin: 0.25rem 0 1.2rem; max-width: 32em; text-wrap: balance;
}
h1.long { font-size: clamp(1.15rem, 1rem + 0.8vw, 1.45rem); line-height: 1.3; letter-spacing: -0.01em; max-width: none; text-wrap: pretty; }
h2 {
  font-size: 1.3rem; line-height: 1.25; letter-spacing: -0.01em; margin: 0 0 0.8rem;
  padding-top: 1.1rem; border-top: 2px solid var(--ink);
}
h3 { font-size: 1.08rem; line-height: 1.3; margin: 0 0 0.3rem; }
h4 { font-size: 0.95rem; line-height: 1.35; margin: 0 0 0.2rem; }
p { margin: 0 0 0.8rem; max-width: 44em; }
section { margin-top: 3rem; }
a { color: var(--after); text-underline-offset: 0.15em; }
a:focus-visible, summary:focus-visible, .math:focus-visible { outline: 2px solid var(--after); outline-offset: 2px; }
code, .mono { font-family: ui-monospace, "SF Mono", Menlo, Consolas, "Liberation Mono", monospace; font-size: 0.875em; overflow-wrap: anywhere; }
ul { margin: 0 0 0.8rem; padding-left: 1.2rem; }
li { margin: 0.2rem 0; overflow-wrap: anywhere; }
.soft { color: var(--soft); }
.small { font-size: 0.875rem; line-height: 1.45; }
.kicker { color: var(--soft); font-size: 0.9rem; margin: 0; max-width: none; }
.kicker b { color: var(--ink); font-weight: 620; }
.label { display: block; font-size: 0.82rem; color: var(--soft); margin: 0 0 0.15rem; font-weight: 500; }
.before { color: var(--before); } .after { color: var(--after); }
)";

constexpr const char* kFirst = R"(
.card { background: var(--card); border: 1px solid var(--rule); border-radius: 10px; padding: 1rem 1.2rem; min-width: 0; }
.pair { display: grid; gap: 1rem; grid-template-columns: 1fr; }
.cards { display: grid; gap: 1rem; grid-template-columns: 1fr; margin-top: 1rem; }
.card > :last-child, .inside > :last-child { margin-bottom: 0; }
.change { font-size: clamp(1.7rem, 1.4rem + 1.2vw, 2.2rem); font-weight: 680; letter-spacing: -0.02em; line-height: 1.15; margin: 0 0 0.5rem; font-variant-numeric: tabular-nums; }
.change .arrow { color: var(--soft); font-weight: 400; padding: 0 0.15em; }
.next { background: var(--next); border-color: var(--next-rule); }
.next p { font-size: 1.05rem; }
.next p.small { font-size: 0.9rem; color: var(--soft); }
.next .label { color: var(--ink); font-weight: 640; }
.note { background: var(--note); border: 1px solid var(--note-rule); border-radius: 10px; padding: 0.7rem 1rem; margin-top: 1rem; max-width: none; overflow-wrap: anywhere; }
.cause h3 { font-size: 1.22rem; letter-spacing: -0.01em; }
.cause .place { color: var(--soft); font-weight: 400; }
.facts { display: grid; grid-template-columns: repeat(auto-fit, minmax(8.5rem, 1fr)); gap: 0.7rem 1.5rem; margin: 0.7rem 0; }
.facts > div { display: flex; flex-direction: column; justify-content: flex-end; }
.facts dt { font-size: 0.82rem; color: var(--soft); }
.facts dd { margin: 0; font-variant-numeric: tabular-nums; }
.facts .soft { white-space: nowrap; }
.facts dd b { font-size: 1.15rem; font-weight: 650; }
.bar { display: block; position: relative; height: 8px; border-radius: 4px; background: var(--grid); margin: 0.3rem 0; overflow: hidden; }
.bar > span { display: block; height: 100%; border-radius: 4px; }
.bar.interval { overflow: visible; }
.interval .band { position: absolute; top: 0; background: var(--after); opacity: 0.4; border-radius: 4px; }
.interval .mark { position: absolute; top: -3px; width: 3px; height: 14px; margin-left: -1px; background: var(--after); border-radius: 2px; }
.settle { border-left: 4px solid var(--note-rule); padding-left: 0.8rem; }
.toc { display: flex; flex-wrap: wrap; gap: 0.4rem 1.2rem; margin: 1.6rem 0 0; padding: 0; list-style: none; font-size: 0.92rem; }
)";

constexpr const char* kBody = R"(
table { border-collapse: collapse; width: 100%; font-size: 0.92rem; margin: 0 0 1rem; font-variant-numeric: tabular-nums; }
caption { text-align: left; color: var(--soft); padding-bottom: 0.4rem; font-size: 0.9rem; }
th, td { text-align: left; vertical-align: top; padding: 0.5rem 0.9rem 0.5rem 0; border-bottom: 1px solid var(--rule); font-weight: 400; overflow-wrap: break-word; }
thead th { color: var(--soft); font-size: 0.82rem; line-height: 1.3; vertical-align: bottom; border-bottom: 1px solid var(--axis); }
tbody th { font-weight: 600; }
th.number, td.number { text-align: right; white-space: nowrap; }
table.narrow { width: auto; min-width: min(100%, 22rem); }
table.narrow .number + * { padding-left: 1.2rem; }
thead th.number { white-space: normal; }
th:last-child, td:last-child { padding-right: 0; }
.figures { display: grid; gap: 1.2rem; grid-template-columns: 1fr; margin: 1rem 0 1.6rem; }
figure { margin: 0; min-width: 0; }
figure svg { display: block; width: 100%; height: auto; color: var(--ink); fill: currentColor; font-family: inherit; margin: 0.3rem 0; }
.cloud { stroke-width: 2.4; stroke-linecap: round; opacity: 0.55; fill: none; }
figcaption { font-size: 0.9rem; line-height: 1.45; }
.key { display: flex; flex-wrap: wrap; gap: 0.2rem 1.1rem; list-style: none; padding: 0; margin: 0.4rem 0 0; font-size: 0.82rem; color: var(--soft); }
.key li { display: flex; align-items: center; gap: 0.45rem; margin: 0; }
.key i { display: inline-block; width: 1.6rem; border-top: 2.5px solid; }
.key i.dashed { border-top-style: dashed; } .key i.dotted { border-top-style: dotted; }
.key i.points { width: 0.55rem; height: 0.55rem; border: 0; border-radius: 50%; background: currentColor; }
.absent { border: 1px dashed var(--axis); border-radius: 8px; padding: 2rem 1rem; color: var(--soft); text-align: center; }
.math { overflow-x: auto; overflow-y: hidden; padding: 0.6rem 0; margin: 0.4rem 0; font-size: 1.15rem; }
.math math { display: block math; width: max-content; max-width: none; margin: 0; }
math { font-family: "STIX Two Math", "Latin Modern Math", "Cambria Math", "Libertinus Math", "TeX Gyre Termes Math", "DejaVu Math TeX Gyre", "Noto Sans Math", math; }
details { border: 1px solid var(--rule); border-radius: 10px; background: var(--card); margin: 0 0 0.8rem; }
summary { cursor: pointer; padding: 0.75rem 1.1rem; font-weight: 600; }
.inside { padding: 0.2rem 1.1rem 1.1rem; }
.term { margin-bottom: 1.2rem; }
footer { margin-top: 3.5rem; padding-top: 1rem; border-top: 1px solid var(--rule); color: var(--soft); font-size: 0.85rem; }
)";

constexpr const char* kWidths = R"(
@media (min-width: 44rem) {
  .pair, .cards { grid-template-columns: 1fr 1fr; }
  .pair > :only-child, .cards > .alone { grid-column: 1 / -1; }
  .figures { grid-template-columns: 1fr 1fr; gap: 0 2rem; }
  figure { display: grid; grid-template-rows: subgrid; grid-row: span 3; margin-bottom: 2rem; }
  .sides { display: grid; grid-template-columns: auto minmax(18rem, 1fr); gap: 2.5rem; }
}
@media (max-width: 43.99rem) {
  thead { position: absolute; width: 1px; height: 1px; overflow: hidden; clip-path: inset(50%); }
  table, tbody, tr, th, td, caption { display: block; }
  tbody tr { border-top: 1px solid var(--axis); padding: 0.6rem 0; }
  tbody th, tbody td { border: 0; padding: 0.15rem 0; }
  tbody td { display: grid; grid-template-columns: minmax(6rem, 38%) 1fr; gap: 0.8rem; }
  tbody td::before { content: attr(data-label); color: var(--soft); font-size: 0.85rem; }
  tbody td > div { min-width: 0; }
  tbody th { font-size: 1rem; padding-bottom: 0.3rem; }
  th.number, td.number { text-align: left; white-space: normal; }
}
@media print {
  :root {
    --paper: #ffffff; --card: #ffffff; --ink: #000000; --soft: #444444; --rule: #bbbbbb;
    --grid: #e6e6e6; --axis: #999999; --measured: #888888; --noise: #666666; --before: #a84300;
    --after: #004f9e; --note: #ffffff; --next: #ffffff;
  }
  body { font-size: 10pt; }
  main { max-width: none; padding: 0; }
  .toc { display: none; }
  details::details-content { content-visibility: visible; display: block; block-size: auto; }
  .card, figure, tr, .term { break-inside: avoid; }
  h2, h3, h4 { break-after: avoid; }
  * { print-color-adjust: exact; -webkit-print-color-adjust: exact; }
}
)";

}  // namespace

std::string page_style() {
  return std::string(kColours) + kText + kFirst + kBody + kWidths;
}

}  // namespace sinew::diagnosis
