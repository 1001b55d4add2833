#include "app/cli/batch/batch_tables.h"

#include "app/messages/messages.h"
#include "core/support/format_number.h"

#include <cmath>

namespace angiopose::app {
namespace {

std::string quoted(const std::string& text)
{
    std::string result = "\"";
    for (const char c : text) {
        result += c == '"' ? std::string("\"\"") : c == '\n' ? std::string(" ") : std::string(1, c);
    }
    return result + "\"";
}

std::string milliseconds(double value)
{
    return std::isfinite(value) ? "," + core::fixedText(value, 1) : ",";
}

}   // namespace

std::string summaryHeader()
{
    std::string header = "row,name,case,status,method,views";
    for (const std::string_view name : figureNames()) {
        header += "," + std::string(name);
    }
    return header + ",message\n";
}

std::string summaryRow(const io::BatchEntry& entry, const BatchOutcome* outcome)
{
    std::string row = std::to_string(entry.row) + "," + quoted(entry.name) + "," +
                      quoted(entry.caseCell.empty() ? entry.angiogramCell : entry.caseCell) + "," +
                      (outcome ? outcome->status : "missing") + "," + (outcome ? outcome->method : entry.method) + ",";
    row += outcome && outcome->hasResult() ? std::to_string(outcome->viewCount) : "";
    for (std::size_t i = 0; i < figureNames().size(); ++i) {
        const bool isKnown = outcome && i < outcome->figures.size();
        row += "," + (isKnown ? core::plainText(outcome->figures[i]) : std::string());
    }
    return row + "," + quoted(outcome ? outcome->message : messages::batchRowMissing().text()) + "\n";
}

std::string timesHeader()
{
    return "row,name,read_ms,trace_ms,register_ms,write_ms,finished\n";
}

std::string timesRow(const io::BatchEntry& entry, const BatchOutcome& outcome)
{
    const BatchTimes& times = outcome.times;
    return std::to_string(entry.row) + "," + quoted(entry.name) + milliseconds(times.readMs) +
           milliseconds(times.traceMs) + milliseconds(times.registerMs) + milliseconds(times.writeMs) + "," +
           times.finished + "\n";
}

}   // namespace angiopose::app
