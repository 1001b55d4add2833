#include "app/cli/batch/batch_outcome.h"

#include "io/support/atomic_file.h"
#include "io/support/input_bytes.h"

#include <algorithm>
#include <cmath>
#include <exception>
#include <filesystem>
#include <nlohmann/json.hpp>

namespace angiopose::app {
namespace {

namespace fs = std::filesystem;
using OutcomeJson = nlohmann::ordered_json;

constexpr const char* outcomeFileName = "outcome.json";

std::string joinedTexts(const core::Messages& messages)
{
    std::string text;
    for (const core::Message& message : messages) {
        text += (text.empty() ? "" : " ") + message.text();
    }
    return text;
}

/// Converts a figure to JSON. NaN and infinity become strings, since JSON numbers cannot represent them.
OutcomeJson figureJson(double value)
{
    return std::isfinite(value) ? OutcomeJson(value)
                                : OutcomeJson(std::isnan(value) ? "nan"
                                              : value > 0.0     ? "inf"
                                                                : "-inf");
}

double figureFrom(const OutcomeJson& json)
{
    return json.is_number() ? json.get<double>() : std::stod(json.get<std::string>());
}

OutcomeJson figuresJson(const BatchOutcome& outcome)
{
    OutcomeJson json = OutcomeJson::object();
    for (std::size_t i = 0; i < outcome.figures.size(); ++i) {
        json[std::string(figureNames()[i])] = figureJson(outcome.figures[i]);
    }
    return json;
}

std::vector<double> figuresFrom(const OutcomeJson& json)
{
    std::vector<double> figures;
    for (const std::string_view name : figureNames()) {
        if (const auto found = json.find(name); found != json.end()) {
            figures.push_back(figureFrom(*found));
        }
    }
    return figures;
}

OutcomeJson inputJson(const io::InputFingerprint& input)
{
    OutcomeJson json{{"path", input.path}};
    if (input.isPresent) {
        json.update({{"size", input.size}, {"modified", input.modificationTime}});
    }
    if (!input.sha256.empty()) {
        json["sha256"] = input.sha256;
    }
    return json;
}

io::InputFingerprint inputFrom(const OutcomeJson& json)
{
    io::InputFingerprint input;
    input.path = json.at("path");
    input.isPresent = json.contains("size");
    input.size = json.value("size", std::uint64_t{0});
    input.modificationTime = json.value("modified", std::numeric_limits<std::int64_t>::min());
    input.sha256 = json.value("sha256", "");
    return input;
}

OutcomeJson timesJson(const BatchTimes& times)
{
    return {{"readMs", figureJson(times.readMs)},
            {"traceMs", figureJson(times.traceMs)},
            {"registerMs", figureJson(times.registerMs)},
            {"writeMs", figureJson(times.writeMs)},
            {"finished", times.finished}};
}

OutcomeJson outcomeJson(const BatchOutcome& outcome)
{
    OutcomeJson json{{"format", "angiopose-batch-outcome"},
                     {"version", 1},
                     {"name", outcome.name},
                     {"status", outcome.status},
                     {"method", outcome.method},
                     {"views", outcome.viewCount},
                     {"figures", figuresJson(outcome)},
                     {"message", outcome.message},
                     {"notes", outcome.notes},
                     {"asked", OutcomeJson::parse(outcome.request)}};
    json["inputs"] = OutcomeJson::array();
    for (const io::InputFingerprint& input : outcome.inputs) {
        json["inputs"].push_back(inputJson(input));
    }
    json["files"] = OutcomeJson::array();
    for (const WrittenFile& file : outcome.files) {
        json["files"].push_back({{"path", file.path}, {"size", file.size}});
    }
    json["times"] = timesJson(outcome.times);
    return json;
}

}   // namespace

const std::vector<std::string_view>& figureNames()
{
    static const std::vector<std::string_view> names{"median_px",       "median_mm",    "p95_px",          "coverage",
                                                     "in_plane_std_mm", "depth_std_mm", "rotation_std_deg"};
    return names;
}

void addResult(BatchOutcome& outcome, const core::RegisteredCase& registered)
{
    const core::RegistrationResult& result = registered.result();
    const core::DistanceMetrics& metrics = result.metrics;
    outcome.status = result.trustworthy ? "done" : "not trustworthy";
    outcome.method = result.method;
    outcome.viewCount = registered.viewIndices.size();
    outcome.figures = {metrics.medianPx,
                       metrics.medianMm,
                       metrics.p95Px,
                       metrics.coverage,
                       result.uncertainty.inPlaneMm,
                       result.uncertainty.depthMm,
                       result.uncertainty.rotationDeg.maxCoeff()};
    outcome.message = joinedTexts(result.warnings);
    outcome.times.traceMs = result.time.traceMs;
    outcome.times.registerMs = result.time.totalMs;
}

std::string toJsonLine(const BatchOutcome& outcome)
{
    return outcomeJson(outcome).dump(-1, ' ', true, OutcomeJson::error_handler_t::replace);
}

BatchOutcome parseOutcome(const std::string& text)
{
    const OutcomeJson json = OutcomeJson::parse(text);
    BatchOutcome outcome;
    outcome.name = json.at("name");
    outcome.status = json.at("status");
    outcome.method = json.at("method");
    outcome.viewCount = json.at("views");
    outcome.figures = figuresFrom(json.at("figures"));
    outcome.message = json.at("message");
    outcome.notes = json.at("notes").get<std::vector<std::string>>();
    outcome.request = json.at("asked").dump();
    for (const OutcomeJson& input : json.at("inputs")) {
        outcome.inputs.push_back(inputFrom(input));
    }
    for (const OutcomeJson& file : json.at("files")) {
        outcome.files.push_back({file.at("path"), file.at("size")});
    }
    const OutcomeJson& times = json.at("times");
    outcome.times = {figureFrom(times.at("readMs")), figureFrom(times.at("traceMs")),
                     figureFrom(times.at("registerMs")), figureFrom(times.at("writeMs")), times.at("finished")};
    return outcome;
}

core::Status writeOutcome(const BatchOutcome& outcome, const std::string& folder)
{
    std::error_code failed;
    fs::create_directories(folder, failed);
    const std::string text = outcomeJson(outcome).dump(2, ' ', false, OutcomeJson::error_handler_t::replace);
    return io::writeAtomically((fs::path(folder) / outcomeFileName).string(), text + "\n");
}

std::optional<BatchOutcome> readOutcome(const std::string& folder)
{
    const auto content = io::openInput((fs::path(folder) / outcomeFileName).string());
    if (!content) {
        return std::nullopt;
    }
    try {
        return parseOutcome(std::string(content.value().view()));
    } catch (const std::exception&) {
        return std::nullopt;
    }
}

bool isUpToDate(const BatchOutcome& outcome, const std::string& request, const std::string& folder)
{
    if (outcome.status == "crashed" || outcome.status == "out of time" ||
        OutcomeJson::parse(outcome.request) != OutcomeJson::parse(request)) {
        return false;
    }
    const auto isWhole = [&folder](const WrittenFile& file) {
        std::error_code failed;
        return fs::file_size(fs::path(folder) / file.path, failed) == file.size && !failed;
    };
    return std::ranges::all_of(outcome.files, isWhole) && std::ranges::all_of(outcome.inputs, io::isUnchanged);
}

}   // namespace angiopose::app
