#include "report/html_parts.hpp"

namespace myo::report {

// Colours are variables, redefined for dark screens and for print. No external fonts or images: the page is
// self-contained.
// Figures keep white paper in dark mode; tables scroll sideways on narrow screens.
std::string_view html_style() {
    return R"css(
:root { color-scheme: light dark; --paper: #ffffff; --ink: #1b1f24; --quiet: #57606a; --rule: #d8dee4; --soft: #f6f8fa;
  --accent: #0072b2; --warn-ink: #7a3b00; --warn-paper: #fff6ea; --warn-rule: #e0872f; }
@media (prefers-color-scheme: dark) {
  :root { --paper: #14181d; --ink: #e4e8ec; --quiet: #9aa4af; --rule: #323a43; --soft: #1c2229;
    --accent: #5cb3e6; --warn-ink: #ffd3a1; --warn-paper: #33230f; --warn-rule: #c9752a; }
}
* { box-sizing: border-box; }
html { -webkit-text-size-adjust: 100%; }
body { margin: 0; background: var(--paper); color: var(--ink);
  font: 16px/1.55 system-ui, -apple-system, "Segoe UI", Inter, Roboto, "Helvetica Neue", "DejaVu Sans", sans-serif; }
main { max-width: 54rem; margin: 0 auto; padding: 3rem 1.5rem 4rem; }
header { border-bottom: 1px solid var(--rule); padding-bottom: 1.5rem; margin-bottom: 2rem; }
h1 { font-size: 1.9rem; line-height: 1.2; letter-spacing: -0.015em; margin: 0 0 .6rem; overflow-wrap: anywhere; }
h2 { font-size: 1.25rem; line-height: 1.3; margin: 2.8rem 0 .8rem; }
p { margin: .6rem 0; max-width: 44rem; overflow-wrap: break-word; }
header p { color: var(--quiet); margin: .2rem 0; }
ul { padding-left: 1.2rem; max-width: 43rem; }
.figures { display: grid; grid-template-columns: repeat(auto-fit, minmax(11rem, 1fr)); gap: .8rem; margin: 1.6rem 0 0; }
.figures div { background: var(--soft); border: 1px solid var(--rule); border-radius: 8px; padding: .8rem 1rem; }
.figures dt { color: var(--quiet); font-size: .84rem; }
.figures dd { margin: .1rem 0 0; font-size: 1.45rem; font-weight: 600; letter-spacing: -0.01em;
  font-variant-numeric: tabular-nums; }
.figures .unit { font-size: .95rem; font-weight: 400; color: var(--quiet); }
.figures .note { display: block; font-size: .84rem; font-weight: 400; letter-spacing: 0; color: var(--quiet); }
.warn { background: var(--warn-paper); color: var(--warn-ink); border-left: 4px solid var(--warn-rule);
  border-radius: 0 6px 6px 0; padding: .7rem 1rem; margin: 1.4rem 0; }
.warn strong { display: block; }
.warn ul { margin: .2rem 0; }
.table { overflow-x: auto; margin: 1.4rem 0; }
table { border-collapse: collapse; font-size: .92rem; min-width: 60%; }
caption { caption-side: top; text-align: left; font-weight: 600; padding-bottom: .5rem; }
th, td { text-align: left; vertical-align: baseline; padding: .38rem 1.1rem .38rem 0;
  border-bottom: 1px solid var(--rule); }
thead th { border-bottom: 2px solid var(--quiet); font-weight: 600; line-height: 1.3; vertical-align: bottom; }
th .unit { font-weight: 400; color: var(--quiet); display: block; font-size: .84em; }
.n { text-align: right; font-variant-numeric: tabular-nums; white-space: nowrap; padding-left: 1.1rem; }
figure { margin: 1.6rem 0; }
figure > svg { display: block; width: 100%; height: auto; border: 1px solid var(--rule); border-radius: 8px;
  background: #fff; padding: 6px; }
figcaption { color: var(--quiet); font-size: .9rem; margin-top: .5rem; max-width: 44rem; }
details { border: 1px solid var(--rule); border-radius: 8px; padding: .2rem 1rem; margin: 1.2rem 0; }
summary { cursor: pointer; font-weight: 600; padding: .45rem 0; }
summary:hover { color: var(--accent); }
summary:focus-visible { outline: 2px solid var(--accent); outline-offset: 3px; border-radius: 4px; }
pre { background: var(--soft); border: 1px solid var(--rule); border-radius: 6px; padding: .8rem 1rem; overflow-x: auto;
  font: .85rem/1.5 ui-monospace, "SF Mono", Consolas, "DejaVu Sans Mono", monospace; }
footer { margin-top: 3.5rem; padding-top: 1rem; border-top: 1px solid var(--rule);
  color: var(--quiet); font-size: .84rem; }
@media print {
  :root { --paper: #fff; --ink: #000; --quiet: #444; --rule: #bbb; --soft: #fff; --warn-ink: #000; --warn-paper: #fff; }
  @page { margin: 18mm 16mm; }
  body { font-size: 10.5pt; }
  main { max-width: none; padding: 0; }
  h2, caption, summary { break-after: avoid; }
  figure, tr, .warn, .figures div { break-inside: avoid; }
  .table { overflow: visible; }
  thead { display: table-header-group; }
  details { border: 0; padding: 0; }
  details::details-content { content-visibility: visible; block-size: auto; }
}
)css";
}

}  // namespace myo::report
