// HTML written by hand: Debian has no template library that escapes what it is given, as this has to.
#include "cli/conformance_page.h"

#include <fmt/format.h>

#include <ostream>
#include <string_view>
#include <utility>
#include <vector>

#include "cli/command.h"
#include "cli/conformance_report.h"
#include "cli/reason_table.h"
#include "cli/shortened_numbers.h"
#include "cli/table.h"
#include "cli/xml_text.h"

namespace flowcert::cli {

namespace {

constexpr const char* kStyle = R"(
:root { color-scheme: light dark; --ink: #1b1f24; --paper: #fff; --line: #d0d7de; --soft: #57606a; --bad: #a33100;
  --good: #00674a; --band: #f6f8fa; }
@media (prefers-color-scheme: dark) {
  :root { --ink: #e6edf3; --paper: #0d1117; --line: #3d444d; --soft: #9198a1; --bad: #ffa657; --good: #56d364;
    --band: #161b22; }
}
body { font: 16px/1.5 system-ui, sans-serif; color: var(--ink); background: var(--paper); max-width: 72rem;
  margin: 2rem auto; padding: 0 1rem; }
h1 { font-size: 1.6rem; } h2 { font-size: 1.2rem; margin-top: 2.5rem; }
.verdict { font-weight: 700; } .bad { color: var(--bad); } .good { color: var(--good); } .soft { color: var(--soft); }
.wide { overflow-x: auto; }
table { border-collapse: collapse; } th, td { padding: .25rem .75rem; text-align: right; vertical-align: top; }
th:first-child, td:first-child, td.text, th.text { text-align: left; }
thead th { border-bottom: 2px solid var(--line); } tbody tr { border-bottom: 1px solid var(--line); }
tbody tr:nth-child(even) { background: var(--band); }
code, pre { font: .9em/1.4 ui-monospace, monospace; overflow-wrap: anywhere; white-space: pre-wrap; }
details { border-bottom: 1px solid var(--line); padding: .4rem 0; } summary { cursor: pointer; }
li { margin: .5rem 0; } a { color: inherit; }
)";

// The characters that HTML gives a meaning, and control characters, are those of XML.
std::string text_of(const Json& value) {
  if (value.is_string()) return xml_text(with_short_numbers(value.get<std::string>()));
  return xml_text(value.dump());
}

// A path as a link: every byte that means something else in one is written as %20 and the like.
std::string link_to(const std::string& path) {
  constexpr std::string_view kPlain = "/-_.~";
  std::string link;
  for (const char c : path) {
    const bool is_plain = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') ||
                          kPlain.find(c) != std::string_view::npos;
    link += is_plain ? std::string(1, c) : fmt::format("%{:02X}", static_cast<unsigned char>(c));
  }
  return link;
}

void write_tallies(std::ostream& out, const char* key, const Json& rows) {
  std::vector<std::string> columns = tally_outcomes();
  columns.insert(columns.begin(), "cases");
  out << fmt::format("<div class=\"wide\"><table>\n<thead><tr><th scope=\"col\">{}</th>", key);
  for (const std::string& column : columns) out << fmt::format("<th scope=\"col\">{}</th>", outcome_title(column));
  out << "</tr></thead>\n<tbody>\n";
  for (const Json& row : rows) {
    out << fmt::format("<tr><th scope=\"row\">{}</th>", text_of(row.at(key)));
    for (const std::string& column : columns) {
      const auto count = row.at(outcome_key(column)).get<std::size_t>();
      out << (count == 0 ? "<td class=\"soft\">0</td>" : fmt::format("<td>{}</td>", with_commas(count)));
    }
    out << "</tr>\n";
  }
  out << "</tbody></table></div>\n";
}

void write_reasons(std::ostream& out, const Json& reasons) {
  if (reasons.empty()) return;
  out << "<h2>Reasons</h2>\n<div class=\"wide\"><table>\n<thead><tr><th scope=\"col\">reason</th>"
         "<th scope=\"col\">cases</th><th scope=\"col\" class=\"text\">smallest example</th></tr></thead>\n<tbody>\n";
  for (const Json& row : reasons) {
    const std::string example = text_of(row.at("smallest"));
    out << fmt::format(
        "<tr><th scope=\"row\">{}</th><td>{}</td><td class=\"text\"><a href=\"#case-{}\">{}</a></td></tr>\n",
        text_of(row.at("reason")), text_of(row.at("cases")), example, example);
  }
  out << "</tbody></table></div>\n";
}

void write_finding(std::ostream& out, const Json& finding) {
  const bool is_variation = finding.at("permitted").get<bool>();
  out << fmt::format(
      "<li><span class=\"{}\">{}</span>, level {}, {}<br>claimed: <code>{}</code><br>true: "
      "<code>{}</code></li>\n",
      is_variation ? "soft" : "bad", text_of(finding.at("reason")), text_of(finding.at("level")),
      text_of(finding.at("clause")), text_of(finding.at("claimed")), text_of(finding.at("truth")));
}

void write_difference(std::ostream& out, const std::string& what, const Json& finding) {
  out << fmt::format("<li>{}<br>claimed: <code>{}</code><br>true: <code>{}</code></li>\n", what,
                     text_of(finding.at("claimed")), text_of(finding.at("truth")));
}

void write_case(std::ostream& out, const Json& one, const ConformancePageContext& context) {
  const std::string id = text_of(one.at("id"));
  out << fmt::format("<details id=\"case-{}\"><summary><code>{}</code>: <span class=\"bad\">{}</span></summary>\n", id,
                     id, text_of(one.at("outcome")));
  const std::string name = one.at("id");
  if (!context.kept_folder.empty() && context.is_kept(name)) {
    const std::string folder = link_to(context.kept_folder + '/' + name);
    out << "<p>";
    if (context.is_kept(name + "/page.html")) out << fmt::format("<a href=\"{}/page.html\">See it</a>, ", folder);
    out << fmt::format("<a href=\"{}/\">all files</a></p>\n", folder);
  }
  out << fmt::format("<p>{}</p>\n<ul>\n", text_of(one.at("message")));
  for (const Json& finding : one.at("findings")) write_finding(out, finding);
  for (const Json& finding : one.at("orbit_findings")) {
    write_difference(out, "orbit from <code>" + text_of(finding.at("start")) + "</code>", finding);
  }
  for (const Json& finding : one.at("persistence_findings")) {
    write_difference(out, "persistence, " + text_of(finding.at("reason")), finding);
  }
  out << "</ul>\n";
  if (const auto left_out = one.at("findings_left_out").get<std::size_t>(); left_out > 0) {
    out << fmt::format("<p class=\"soft\">and {} more findings</p>\n", with_commas(left_out));
  }
  out << "</details>\n";
}

void write_head(std::ostream& out, const Json& report) {
  const bool is_right = report.at("verdict") != "fails";
  out << "<!doctype html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
         "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n"
         "<meta http-equiv=\"Content-Security-Policy\" content=\"default-src 'none'; script-src 'unsafe-inline'; "
         "style-src 'unsafe-inline'\">\n"
         "<title>Flowcert conformance report</title>\n<style>"
      << kStyle << "</style>\n</head>\n<body>\n<h1>Conformance report</h1>\n";
  out << fmt::format("<p class=\"verdict {}\">{}</p>\n<p>Command: <code>{}</code></p>\n", is_right ? "good" : "bad",
                     text_of(report.at("verdict")), xml_text(report.at("command").get<std::string>()));
  if (const Json& statement = report.at("profile").at("statement"); !statement.is_null()) {
    out << fmt::format("<p>{}</p>\n", xml_text(statement.get<std::string>()));
  }
  for (const auto& [key, what] : {std::pair("orbit_command", "Orbits"), std::pair("persistence_command", "Pairs")}) {
    if (report.at(key).is_null()) continue;
    out << fmt::format("<p>{}: <code>{}</code></p>\n", what, xml_text(report.at(key).get<std::string>()));
  }
  out << fmt::format("<p class=\"soft\">{} cases in {}; levels 1 to {}; tolerance {}; flowcert {} (commit {})</p>\n",
                     report.at("cases").size(), seconds_text(report.at("seconds").get<double>()),
                     text_of(report.at("highest_level")), text_of(report.at("tolerance")),
                     text_of(report.at("version")), text_of(report.at("commit")));
}

}  // namespace

void write_conformance_page(std::ostream& out, const Json& report, const ConformancePageContext& context) {
  write_head(out, report);
  write_reasons(out, report.at("reasons"));
  out << "<h2>By flag</h2>\n";
  write_tallies(out, "flag", report.at("flags"));
  out << "<h2>By group</h2>\n";
  write_tallies(out, "group", report.at("groups"));
  out << "<h2>Negative cases</h2>\n";
  std::size_t count = 0;
  for (const Json& one : report.at("cases")) {
    if (!one.at("negative").get<bool>()) continue;
    ++count;
    write_case(out, one, context);
  }
  if (count == 0) out << "<p class=\"good\">There are none.</p>\n";
  // A link to a case opens it.
  out << "<script>const show = () => { const at = document.getElementById(location.hash.slice(1)); "
         "if (at) at.open = true; }; addEventListener('hashchange', show); show();</script>\n</body>\n</html>\n";
}

}  // namespace flowcert::cli
