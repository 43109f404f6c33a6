// The look of the demo's page.
#pragma once

namespace tribunal {

inline constexpr const char* page_style = R"css(
:root { --ink: #1d2430; --faint: #5c6675; --line: #dfe3e9; --bad: #b5330f; --good: #00694a; --seg: #b5330f; --tri: #0064a3 }
* { box-sizing: border-box }
body { margin: 0; color: var(--ink); background: #fff; font: 17px/1.6 system-ui, -apple-system, "Segoe UI", "DejaVu Sans", sans-serif }
main, header > div, footer > div { max-width: 1080px; margin: 0 auto; padding: 0 24px }
header { background: #151c28; color: #fff; padding: 56px 0 44px }
header h1 { font-size: 44px; line-height: 1.15; margin: 0 0 14px; letter-spacing: -.01em }
header p { max-width: 47em; margin: 0 0 10px; color: #d5dbe5; font-size: 19px }
h2 { font-size: 28px; line-height: 1.25; margin: 60px 0 10px; letter-spacing: -.01em }
h3 { font-size: 18px; margin: 0 0 6px }
p { max-width: 47em; margin: 0 0 14px }
a { color: #0064a3 }
code, pre, td.number { font-family: ui-monospace, "SFMono-Regular", Menlo, "DejaVu Sans Mono", monospace }
code { font-size: .88em; background: #f1f3f6; padding: 1px 5px; border-radius: 4px; overflow-wrap: anywhere }
pre { background: #151c28; color: #e6eaf0; padding: 14px 18px; border-radius: 8px; overflow-x: auto; font-size: 14px; line-height: 1.55; margin: 0 0 18px }
.cards, .pair { display: grid; grid-template-columns: 1fr 1fr; gap: 22px; margin: 22px 0 }
.card { border: 1px solid var(--line); border-top: 6px solid; border-radius: 10px; padding: 20px 24px }
.card.bad { border-top-color: var(--bad) } .card.good { border-top-color: var(--good) }
.card .verdict { font-size: 30px; font-weight: 700; line-height: 1.2; margin: 2px 0 10px }
.bad .verdict { color: var(--bad) } .good .verdict { color: var(--good) }
.card ul { margin: 0; padding-left: 19px } .card li { margin-bottom: 7px }
.families { columns: 2; column-gap: 36px; padding-left: 19px; font-size: 15px } .families li { break-inside: avoid }
.wide { overflow-x: auto }
table { border-collapse: collapse; margin: 8px 0 18px; font-size: 15px }
th { text-align: left; font-weight: 600; color: var(--faint) }
th, td { padding: 6px 18px 6px 0; border-bottom: 1px solid var(--line); vertical-align: top }
td.number { text-align: right; white-space: nowrap; font-size: 14px }
td:first-child code { white-space: nowrap }
td.share { min-width: 200px } .share div { background: var(--bad); height: 10px; border-radius: 2px; margin-top: 8px }
figure { margin: 0 0 26px } figure img { width: 100%; height: auto; display: block; border-radius: 6px }
figure.chart img { border: 1px solid var(--line); padding: 8px }
figcaption { color: var(--faint); font-size: 15px; line-height: 1.5; margin-top: 9px; max-width: 54em }
.pictures { display: grid; grid-template-columns: repeat(3, 1fr); gap: 16px; margin: 18px 0 6px }
.pictures img, .crop { image-rendering: pixelated }
.crop { width: 100%; aspect-ratio: 4 / 3; overflow: hidden; position: relative; border-radius: 6px }
.crop img { position: absolute; max-width: none; border-radius: 0; height: auto }
svg { width: 100%; height: auto; background: #f6f8fa; border-radius: 8px }
svg polygon { fill: #0064a322; stroke: var(--tri); stroke-width: 2 } svg line { stroke: var(--seg); stroke-width: 2.5 }
svg .tri { fill: var(--tri) } svg .seg { fill: var(--seg) } svg text { font: 600 15px system-ui, "DejaVu Sans", sans-serif }
.answer { font-weight: 700 } .answer.bad { color: var(--bad) } .answer.good { color: var(--good) }
footer { border-top: 1px solid var(--line); margin-top: 64px; padding: 22px 0 44px; color: var(--faint); font-size: 14px }
footer dl { display: grid; grid-template-columns: max-content 1fr; gap: 2px 16px; margin: 0 } footer dd { margin: 0; overflow-wrap: anywhere }
@media (max-width: 760px) {
  .cards, .pair { grid-template-columns: 1fr } .pictures { grid-template-columns: 1fr }
  header { padding: 36px 0 28px } header h1 { font-size: 34px } h2 { margin-top: 44px; font-size: 24px }
  .families { columns: 1 }
  figure.chart { overflow-x: auto } figure.chart img { min-width: 720px } td:first-child code { white-space: nowrap }
td.share { min-width: 90px }
}
)css";

}  // namespace tribunal
