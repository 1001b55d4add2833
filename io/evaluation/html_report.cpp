#include "io/evaluation/html_report.h"

#include "io/plot/svg_plot.h"

namespace angiopose::io {
namespace {

constexpr const char* reportStyle = R"(
body { font: 15px/1.5 Inter, system-ui, sans-serif; color: #1d2126; max-width: 76rem; margin: 2.5rem auto; padding: 0 1.5rem; }
h1 { font-size: 1.6rem; } h2 { font-size: 1.15rem; margin-top: 2.5rem; }
.table { overflow-x: auto; }
table { border-collapse: collapse; font-variant-numeric: tabular-nums; }
th, td { padding: 0.3rem 0.8rem; text-align: right; border-bottom: 1px solid #dde1e6; white-space: nowrap; }
th { border-bottom: 2px solid #8a929b; font-weight: 600; } th:first-child, td:first-child { text-align: left; }
tr.published td { font-style: italic; color: #5b636c; }
.note, footer { color: #5b636c; font-size: 0.87rem; max-width: 60rem; }
.plots { display: flex; flex-wrap: wrap; gap: 1.5rem; } .plots svg { max-width: 100%; height: auto; }
@media print { body { margin: 0; max-width: none; } table, svg { break-inside: avoid; } }
)";

std::string escapedHtml(const std::string& text)
{
    std::string result;
    for (const char c : text) {
        result += c == '&' ? "&amp;" : c == '<' ? "&lt;" : c == '>' ? "&gt;" : c == '"' ? "&quot;" : std::string(1, c);
    }
    return result;
}

std::string htmlRow(const std::vector<std::string>& cells, const std::string& cell, const std::string& rowClass)
{
    std::string text = rowClass.empty() ? "<tr>" : "<tr class=\"" + rowClass + "\">";
    for (const std::string& content : cells) {
        text += "<" + cell + ">" + escapedHtml(content) + "</" + cell + ">";
    }
    return text + "</tr>\n";
}

std::string htmlTable(const core::ResultTable& table)
{
    std::string text = "<h2 id=\"" + escapedHtml(table.id) + "\">" + escapedHtml(table.title) +
                       "</h2>\n<div class=\"table\"><table>\n<thead>" + htmlRow(table.columns, "th", "") +
                       "</thead>\n<tbody>\n";
    for (const core::ResultTable::Row& row : table.rows) {
        text += htmlRow(row.cells, "td", row.isPublished ? "published" : "");
    }
    text += "</tbody></table></div>\n";
    for (const std::string& note : table.notes) {
        text += "<p class=\"note\">" + escapedHtml(note) + "</p>\n";
    }
    return text;
}

/// Returns the SVG drawing without the XML header of a separate file.
std::string inlineSvg(const core::Plot& plot)
{
    const std::string svg = toSvg(plot);
    return svg.substr(svg.find("<svg"));
}

}   // namespace

std::string htmlReport(const std::string& title, const std::vector<core::ResultTable>& tables,
                       const std::vector<core::Plot>& plots)
{
    std::string text =
        "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
        "<meta name=\"viewport\" content=\"width=device-width\">\n<title>" +
        escapedHtml(title) + "</title>\n<style>" + reportStyle + "</style>\n</head>\n<body>\n<h1>" +
        escapedHtml(title) + "</h1>\n";
    for (const core::ResultTable& table : tables) {
        text += htmlTable(table);
    }
    if (!plots.empty()) {
        text += "<h2>Plots</h2>\n<div class=\"plots\">\n";
        for (const core::Plot& plot : plots) {
            text += "<figure>" + inlineSvg(plot) + "</figure>\n";
        }
        text += "</div>\n";
    }
    return text + "<footer>AngioPose " ANGIOPOSE_VERSION ". Not for clinical use.</footer>\n</body>\n</html>\n";
}

}   // namespace angiopose::io
