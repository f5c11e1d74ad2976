// SPDX-License-Identifier: Apache-2.0
#include "scenarios/results/report_style.h"

namespace horopter::scenarios {

std::string_view ReportStyle() {
  return R"(
:root{color-scheme:light dark;--page:#f4f5f7;--card:#fff;--ink:#1d2228;--soft:#5b6570;--line:#dde1e6;
--pass:#1a7f37;--fail:#c4271b;--warn:#8a5a00;--skip:#5b6570;--pass-bg:#e3f4e7;--fail-bg:#fde7e4;
--warn-bg:#fdf1d8;--skip-bg:#eceff2;--one:#0b62c4;--two:#b35900;--code:#eef0f3}
@media (prefers-color-scheme:dark){:root{--page:#0f1216;--card:#171b20;--ink:#e6e9ee;--soft:#9aa4b0;
--line:#2c333b;--pass:#56d374;--fail:#ff7b72;--warn:#e3b341;--skip:#9aa4b0;--pass-bg:#12301b;
--fail-bg:#3d1513;--warn-bg:#33270b;--skip-bg:#252b32;--one:#5aa7ff;--two:#f0a04b;--code:#22272e}}
@media print{:root{color-scheme:light;--page:#fff;--card:#fff;--ink:#000;--soft:#444;--line:#bbb;
--pass:#1a7f37;--fail:#c4271b;--warn:#8a5a00;--skip:#444;--pass-bg:#fff;--fail-bg:#fff;
--warn-bg:#fff;--skip-bg:#fff;--one:#0b62c4;--two:#b35900;--code:#fff}}
*{box-sizing:border-box}
body{margin:0;background:var(--page);color:var(--ink);font:15px/1.5 system-ui,-apple-system,
"Segoe UI",Roboto,"DejaVu Sans",sans-serif;overflow-wrap:break-word}
main{max-width:1360px;margin:0 auto;padding:20px}
h1{font-size:25px;line-height:1.25;margin:0;font-weight:650}
h2{font-size:18px;margin:0 0 12px;font-weight:650}
h3{font-size:13px;margin:14px 0 6px;font-weight:600;color:var(--soft);letter-spacing:.02em}
p{margin:0 0 10px}a{color:var(--one)}
header{display:flex;gap:16px;align-items:flex-start;flex-wrap:wrap;margin:4px 0 18px}
header>div{flex:1 1 320px}
.lead{color:var(--soft);margin:4px 0 0;max-width:80ch}
.facts{display:flex;flex-wrap:wrap;gap:4px 22px;margin:10px 0 0;padding:0;list-style:none}
.facts b{font-weight:600}.facts span{color:var(--soft)}
.badge{display:inline-block;font-weight:650;white-space:nowrap;border-radius:6px;padding:1px 9px;
border:1px solid currentColor}
header .badge{font-size:18px;padding:5px 14px}
.passed{color:var(--pass);background:var(--pass-bg)}.failed,.error{color:var(--fail);
background:var(--fail-bg)}.incomplete{color:var(--warn);background:var(--warn-bg)}
.not_applicable{color:var(--skip);background:var(--skip-bg)}
.card{background:var(--card);border:1px solid var(--line);border-radius:10px;padding:18px;
margin:0 0 18px}
.notice{border-left:5px solid currentColor;border-radius:6px;padding:10px 14px;margin:0 0 18px}
.notice>*{color:var(--ink)}.notice p:last-child,.notice ul:last-child{margin-bottom:0}
.notice ul{margin:4px 0 0;padding-left:20px}
.columns{display:grid;gap:18px;grid-template-columns:minmax(0,10fr) minmax(0,9fr)}
.columns>.card,.columns>div>.card:last-child{margin-bottom:0}.halves{grid-template-columns:minmax(0,1fr) minmax(0,1fr)}
.columns{margin:0 0 18px}
svg{max-width:100%;height:auto;display:block}svg.plan{margin:0 auto;width:100%}
.plan a.on .mark{r:7px;stroke-width:2.5}
table{border-collapse:collapse;width:100%;font-variant-numeric:tabular-nums}
th,td{text-align:left;padding:6px 8px;border-bottom:1px solid var(--line);vertical-align:top}
th{font-weight:600;color:var(--soft);font-size:13px;border-bottom-color:var(--soft)}
td.number,th.number{text-align:right;white-space:nowrap}tr:last-child td{border-bottom:0}
td .badge{white-space:normal}td small{color:var(--soft);display:block}.scroll{overflow-x:auto}
.bar{height:9px;border-radius:2px;background:var(--one);min-width:1px}
.bar+.bar{background:var(--two);opacity:.55;margin-top:2px}
.keys{display:grid;grid-template-columns:max-content minmax(0,1fr);gap:3px 18px;margin:0}
.keys dt{color:var(--soft)}.keys dd{margin:0}
code{overflow-wrap:anywhere}code,pre{font-family:ui-monospace,"SF Mono","DejaVu Sans Mono",monospace;font-size:13px}
pre{background:var(--code);border:1px solid var(--line);border-radius:6px;padding:10px 12px;
margin:0 0 12px;overflow-x:auto;white-space:pre-wrap}
details summary{cursor:pointer;color:var(--soft);margin:8px 0}
.frame{border-top:1px solid var(--line);padding-top:12px;margin-top:14px}
.frame[hidden]{display:none}
.frame-title{font-weight:600;margin:0}.frame-title span{font-weight:400;color:var(--soft)}
.pictures{display:grid;gap:12px;grid-template-columns:repeat(4,minmax(0,1fr))}
.verdict{margin:0;color:var(--soft);font-size:13px}
.verdict div{display:flex;flex-direction:column-reverse;margin:0 0 12px}.verdict dd{margin:0;
font-size:22px;line-height:1.25;font-weight:650;color:var(--ink);font-variant-numeric:tabular-nums}
figure{margin:0;min-width:0}figure img{width:100%;height:auto;display:block;border-radius:4px;
background:#333;image-rendering:auto}
figcaption{font-size:13px;margin-top:4px}
.legend{display:grid;grid-template-columns:1fr auto;gap:1px 8px;color:var(--soft);font-size:12px;
margin-top:3px}
.legend i{display:block;height:9px;border-radius:2px;-webkit-print-color-adjust:exact;
print-color-adjust:exact}
.legend i.none{width:34px;background:repeating-linear-gradient(135deg,#323438 0 3px,#56585c 3px 5px)}
.legend div{display:flex;justify-content:space-between}
.slider{display:flex;gap:10px;align-items:center;margin:0 0 4px}
.slider input{flex:1;min-width:0}.slider button{font:inherit;padding:3px 12px;border-radius:6px;
border:1px solid var(--line);background:var(--code);color:var(--ink);cursor:pointer}
.chart{width:100%;font:12px system-ui,sans-serif;margin:0 0 6px}
.chart text{fill:var(--ink)}.chart .soft{fill:var(--soft)}.chart .title{font-size:14px;
font-weight:600}
.chart .grid{stroke:var(--line)}.chart .step{stroke:var(--soft);stroke-dasharray:2 3}
.chart .limit-name{paint-order:stroke;stroke:var(--card);stroke-width:4px;stroke-linejoin:round}
.chart .limit{stroke:var(--fail);stroke-dasharray:7 4}.chart .limit-name{fill:var(--fail)}
.chart .line1,.chart .line2{fill:none;stroke:var(--one);stroke-width:2;stroke-linejoin:round}
.chart .line2{stroke:var(--two);stroke-width:1.5}.chart .dot1{fill:var(--one)}
.chart .dot2{fill:var(--two)}
.empty{color:var(--soft);font-style:italic}
footer{color:var(--soft);font-size:13px;margin:6px 0 24px}
@media (max-width:860px){.columns,.halves{grid-template-columns:minmax(0,1fr)}}
@media (max-width:1000px){.pictures{grid-template-columns:repeat(2,minmax(0,1fr))}}
@media (max-width:520px){main{padding:12px}.card{padding:13px}
.pictures{grid-template-columns:minmax(0,1fr)}.keys{grid-template-columns:minmax(0,1fr)}
.keys dd{margin-bottom:6px}th,td{padding:6px 5px}}
@media print{body{font-size:11px}main{max-width:none;padding:0}.card{border:0;padding:0}
.slider{display:none}.frame,.frame[hidden]{display:block;break-inside:avoid}
.columns{grid-template-columns:minmax(0,3fr) minmax(0,2fr)}.chart,table,svg{break-inside:avoid}}
)";
}

std::string_view FrameSliderScript() {
  return R"(
(() => {
  const frames = [...document.querySelectorAll('.frame')];
  if (frames.length < 2) return;
  const bar = document.createElement('div');
  bar.className = 'slider';
  const button = (text, label, step) => {
    const b = document.createElement('button');
    b.textContent = text;
    b.setAttribute('aria-label', label);
    b.onclick = () => show(Number(range.value) + step);
    return b;
  };
  const range = document.createElement('input');
  Object.assign(range, {type: 'range', min: 0, max: frames.length - 1, value: 0});
  range.setAttribute('aria-label', 'frame');
  range.oninput = () => show(Number(range.value));
  bar.append(button('\u2190', 'earlier frame', -1), range, button('\u2192', 'later frame', 1));
  frames[0].before(bar);
  const show = (wanted) => {
    const n = Math.max(0, Math.min(frames.length - 1, wanted));
    range.value = n;
    frames.forEach((f, i) => { f.hidden = i !== n; });
    document.querySelectorAll('.plan a').forEach((a) => {
      a.classList.toggle('on', a.getAttribute('href') === '#' + frames[n].id);
    });
  };
  const fromLink = () => {
    const n = frames.findIndex((f) => '#' + f.id === location.hash);
    if (n < 0) return false;
    show(n);
    frames[n].scrollIntoView({block: 'nearest'});
    return true;
  };
  addEventListener('hashchange', fromLink);
  if (!fromLink()) show(Math.floor(frames.length / 2));
})();
)";
}

}  // namespace horopter::scenarios
