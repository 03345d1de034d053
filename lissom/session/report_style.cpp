#include "lissom/session/report_style.h"

#include <fmt/format.h>

#include "lissom/view/page_colors.h"

namespace lissom {

namespace {

/// Colours of the page itself: fields behind figures, and marks of verdicts. 4.5:1 for all text.
constexpr const char* kLightOnly =
    "--card:#f6f7f9;--trouble:#b3261e;--stopped:#8a5a00;--link:#005a8c;color-scheme:light;";
constexpr const char* kDarkOnly =
    "--card:#1d2229;--trouble:#ff8a80;--stopped:#f2b84b;--link:#7cc4f2;color-scheme:dark;";

constexpr const char* kRules = R"(
*{box-sizing:border-box}
html{background:var(--page);color:var(--ink);font:15px/1.5 system-ui,"Segoe UI",Roboto,"Helvetica Neue",Arial,sans-serif}
body{max-width:1112px;margin:0 auto;padding:32px 24px 64px;font-variant-numeric:tabular-nums}
h1{font-size:28px;line-height:1.2;margin:0 0 4px;font-weight:650;letter-spacing:-.01em}
h2{font-size:19px;margin:48px 0 12px;font-weight:650}
h3{font-size:15px;margin:24px 0 8px;font-weight:650}
p{margin:8px 0;max-width:72ch}
.eyebrow,.faint,figcaption,caption,nav{color:var(--faint)}
.eyebrow{margin:0 0 12px;font-size:13px}
a{color:var(--link)}
nav{font-size:13px;margin-top:20px}
nav a{margin-right:16px;white-space:nowrap}
.verdict{border-left:4px solid var(--ink);background:var(--card);padding:16px 20px;margin:24px 0}
.verdict h2{margin:0 0 4px;font-size:19px}
.verdict.stopped{border-color:var(--stopped)}.verdict.stopped h2{color:var(--stopped)}
.verdict.trouble{border-color:var(--trouble)}.verdict.trouble h2{color:var(--trouble)}
.verdict p:last-child{margin-bottom:0}
.tiles{display:grid;grid-template-columns:repeat(auto-fill,minmax(248px,1fr));gap:12px;margin:16px 0;padding:0;list-style:none}
.tiles li{border:1px solid var(--rule);border-radius:4px;padding:12px 16px}
.tiles .name{font-size:13px;color:var(--faint);overflow-wrap:anywhere}
.tiles .big{font-size:22px;font-weight:600;white-space:nowrap;line-height:1.4}
.tiles .big small{font-size:15px;font-weight:400;color:var(--faint)}
.tiles .bar{margin-top:4px}
.bar{display:block;height:6px;border-radius:1px;background:var(--series-0);min-width:1px}
.bar.before{background:var(--series-1)}
.grid{display:grid;grid-template-columns:repeat(2,minmax(0,1fr));gap:20px 24px;align-items:start}
figure{margin:0;min-width:0}
figure>svg{display:block;width:100%;height:auto;font-family:inherit}
figcaption{font-size:13px;padding:4px 0 0}
.pose{break-inside:avoid-page}
.numbers{align-self:center}
.key{margin-right:16px;white-space:nowrap}
.key i{display:inline-block;width:22px;height:0;margin-right:6px;vertical-align:middle;border-top:2px solid}
.key i.band{border-top:9px solid var(--ghost)}
.key i.before{border-color:var(--series-1)}
.key i.after{border-top-width:4px;border-color:var(--series-0)}
.scroll{overflow-x:auto}
table{border-collapse:collapse;font-size:13px;margin:8px 0 16px}
caption{text-align:left;padding-bottom:4px}
th,td{padding:4px 12px 4px 0;text-align:right;border-bottom:1px solid var(--rule);vertical-align:top}
thead th{font-weight:600;vertical-align:bottom;border-color:var(--faint)}
tbody th{font-weight:400;text-align:left;overflow-wrap:anywhere}
th.w,td.w{text-align:left}tbody th.n{text-align:right}
td.wide{width:40%;min-width:120px;vertical-align:middle}
.between{display:inline-block;position:relative;width:96px;height:14px;border-left:1px solid var(--faint);border-right:1px solid var(--faint);background:linear-gradient(var(--rule),var(--rule)) center/100% 1px no-repeat}
.between i{position:absolute;top:2px;height:10px;width:3px;margin-left:-1px;background:var(--series-1)}
.between .is{top:0;height:14px;background:var(--series-0)}
details{margin:8px 0}
summary{cursor:pointer;color:var(--link)}
:focus-visible{outline:2px solid var(--link);outline-offset:2px}
pre{background:var(--card);padding:12px 16px;overflow-x:auto;font:13px/1.5 ui-monospace,SFMono-Regular,Menlo,Consolas,"DejaVu Sans Mono",monospace}
dl{display:grid;grid-template-columns:max-content 1fr;gap:4px 20px;font-size:13px}
dt{color:var(--faint)}dd{margin:0;overflow-wrap:anywhere}
@media(max-width:820px){.grid{grid-template-columns:1fr}body{padding:20px 16px}}
@media print{*{print-color-adjust:exact;-webkit-print-color-adjust:exact}body{padding:0;max-width:none}nav{display:none}h2{margin-top:28px;break-after:avoid}h3{break-after:avoid}figure,tr,.verdict,.tiles li{break-inside:avoid}.scroll{overflow:visible}pre{white-space:pre-wrap}}
)";

std::string variables(Color PageColor::*side, const char* rest) {
  std::string text = ":root{";
  for (const PageColor& c : page_colors()) text += fmt::format("--{}:{};", c.name, hex_color(c.*side));
  return text + rest + "}";
}

}  // namespace

std::string report_style() {
  const std::string light = variables(&PageColor::light, kLightOnly), dark = variables(&PageColor::dark, kDarkOnly);
  return light + "@media screen and (prefers-color-scheme:dark){" + dark + "}" + kRules;
}

}  // namespace lissom
