#include "io/evaluation/run_files.h"
#include "io/support/atomic_file.h"
#include "io/support/numbers.h"

#include <cmath>
#include <filesystem>

namespace angiopose::io {
namespace {

std::string cell(double value)
{
    return std::isnan(value) ? "nan" : toText(value);   // without the sign that a NaN may carry
}

std::string keyOf(const core::RunRecord& run)
{
    return run.condition + "," + run.method + "," + std::to_string(run.trial);
}

std::string fieldNames(bool areTimes)
{
    std::string text;
    for (const core::RunField& field : core::runFields()) {
        text += field.isTime == areTimes ? "," + std::string(field.name) : "";
    }
    return text + "\n";
}

std::string fieldValues(const core::RunRecord& run, bool areTimes)
{
    std::string text;
    for (const core::RunField& field : core::runFields()) {
        text += field.isTime == areTimes ? "," + cell(run.*field.value) : "";
    }
    return text + "\n";
}

std::string runsText(const core::RunSet& runs)
{
    std::string text = "protocol,seed,condition,method,trial,anatomy" + fieldNames(false);
    for (const core::RunRecord& run : runs.runs) {
        text += runs.protocol + "," + std::to_string(runs.seed) + "," + keyOf(run) + "," + std::to_string(run.anatomy) +
                fieldValues(run, false);
    }
    return text;
}

std::string timesText(const core::RunSet& runs)
{
    std::string text = "condition,method,trial" + fieldNames(true);
    for (const core::RunRecord& run : runs.runs) {
        text += keyOf(run) + fieldValues(run, true);
    }
    return text;
}

std::string historiesText(const core::RunSet& runs)
{
    std::string text = "condition,method,trial,report,mean_px\n";
    for (const core::RunRecord& run : runs.runs) {
        for (std::size_t k = 0; k < run.history.size(); ++k) {
            text += keyOf(run) + "," + std::to_string(k) + "," + cell(run.history[k]) + "\n";
        }
    }
    return text;
}

}   // namespace

core::Status writeRuns(const core::RunSet& runs, const std::string& folder)
{
    const std::filesystem::path path(folder);
    if (auto status = writeAtomically((path / "runs.csv").string(), runsText(runs)); !status) {
        return status;
    }
    if (auto status = writeAtomically((path / "times.csv").string(), timesText(runs)); !status) {
        return status;
    }
    return writeAtomically((path / "histories.csv").string(), historiesText(runs));
}

}   // namespace angiopose::io