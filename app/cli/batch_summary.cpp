#include "app/cli/batch_summary.h"

#include "core/support/format_number.h"

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

std::string joined(const core::Messages& messages)
{
    std::string text;
    for (const core::Message& message : messages) {
        text += (text.empty() ? "" : " ") + message.text();
    }
    return text;
}

std::string figures(const core::RegistrationResult& result)
{
    const core::DistanceMetrics& metrics = result.metrics;
    std::string text;
    for (const double value :
         {metrics.medianPx, metrics.medianMm, metrics.p95Px, metrics.coverage, result.uncertainty.inPlaneMm,
          result.uncertainty.depthMm, result.uncertainty.rotationDeg.maxCoeff(), result.time.totalMs}) {
        text += "," + core::plainText(value);
    }
    return text;
}

}   // namespace

std::string BatchOutcome::status() const
{
    if (!result) {
        return problem && problem->isStop() ? "stopped" : "failed";
    }
    if (result->stopReason == core::StopReason::StoppedByUser) {
        return "stopped";
    }
    return result->trustworthy ? "done" : "not trustworthy";
}

std::string summaryHeader()
{
    return "row,name,case,status,method,median_px,median_mm,p95_px,coverage,in_plane_std_mm,depth_std_mm,"
           "rotation_std_deg,time_ms,message\n";
}

std::string summaryRow(const BatchOutcome& outcome)
{
    const std::string message = outcome.result ? joined(outcome.result->warnings) : outcome.problem->message.text();
    return std::to_string(outcome.entry.row) + "," + quoted(outcome.entry.name) + "," + quoted(outcome.entry.casePath) +
           "," + outcome.status() + "," +
           (outcome.result ? outcome.result->method + figures(*outcome.result) : outcome.entry.method + ",,,,,,,,") +
           "," + quoted(message) + "\n";
}

}   // namespace angiopose::app