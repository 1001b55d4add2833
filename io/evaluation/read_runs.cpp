#include "io/evaluation/run_files.h"
#include "io/messages/messages.h"
#include "io/support/atomic_file.h"
#include "io/support/csv_table.h"
#include "io/support/file_error.h"
#include "io/support/input_bytes.h"
#include "io/support/numbers.h"

#include <charconv>
#include <cmath>
#include <filesystem>
#include <map>
#include <tuple>

namespace angiopose::io {
namespace {

using Key = std::tuple<std::string, std::string, std::uint64_t>;   ///< condition, method, trial
using RunByKey = std::map<Key, core::RunRecord*>;

/// Accesses cells by row and column name and converts them to numbers.
class RowReader {
public:
    explicit RowReader(const CsvTable& table) : table_(table) {}

    core::Status require(std::string_view name)
    {
        const auto column = table_.column(name);
        if (!column) {
            return fileError(table_.path, messages::runsColumnMissing(name));
        }
        columns_[std::string(name)] = *column;
        return core::Done{};
    }

    std::string_view text(std::size_t row, std::string_view name) const
    {
        return table_.rows[row][columns_.find(name)->second];
    }

    core::Result<double> number(std::size_t row, std::string_view name) const
    {
        const auto value = parseNumber(text(row, name));
        return value ? core::Result<double>(*value) : broken(row, name);
    }

    core::Result<std::uint64_t> count(std::size_t row, std::string_view name) const
    {
        const std::string_view cell = text(row, name);
        std::uint64_t value = 0;
        const auto [end, error] = std::from_chars(cell.data(), cell.data() + cell.size(), value);
        return error == std::errc{} && end == cell.data() + cell.size() ? core::Result<std::uint64_t>(value)
                                                                        : broken(row, name);
    }

private:
    core::Error broken(std::size_t row, std::string_view name) const
    {
        return fileError(table_.path, messages::runsNoNumber(table_.lineOfRow[row], name));
    }

    const CsvTable& table_;
    std::map<std::string, std::size_t, std::less<>> columns_;
};

core::Status requireColumns(RowReader& reader, std::initializer_list<std::string_view> names)
{
    for (const std::string_view name : names) {
        if (auto status = reader.require(name); !status) {
            return status;
        }
    }
    return core::Done{};
}

core::Status requireFields(RowReader& reader, bool areTimes)
{
    for (const core::RunField& field : core::runFields()) {
        if (field.isTime == areTimes) {
            if (auto status = reader.require(field.name); !status) {
                return status;
            }
        }
    }
    return core::Done{};
}

core::Status readFields(const RowReader& reader, std::size_t row, bool areTimes, core::RunRecord& run)
{
    for (const core::RunField& field : core::runFields()) {
        if (field.isTime == areTimes) {
            const auto value = reader.number(row, field.name);
            if (!value) {
                return value.error();
            }
            run.*field.value = value.value();
        }
    }
    return core::Done{};
}

core::Result<core::RunRecord> readRun(const RowReader& reader, std::size_t row)
{
    core::RunRecord run;
    run.condition = reader.text(row, "condition");
    run.method = reader.text(row, "method");
    const auto trial = reader.count(row, "trial");
    const auto anatomy = reader.count(row, "anatomy");
    if (!trial || !anatomy) {
        return trial ? anatomy.error() : trial.error();
    }
    run.trial = trial.value();
    run.anatomy = static_cast<int>(anatomy.value());
    if (auto status = readFields(reader, row, false, run); !status) {
        return status.error();
    }
    return run;
}

core::Result<core::RunSet> parseRuns(const CsvTable& table)
{
    RowReader reader(table);
    if (auto status = requireColumns(reader, {"protocol", "seed", "condition", "method", "trial", "anatomy"});
        !status) {
        return status.error();
    }
    if (auto status = requireFields(reader, false); !status) {
        return status.error();
    }
    core::RunSet runs;
    for (std::size_t row = 0; row < table.rows.size(); ++row) {
        const auto seed = reader.count(row, "seed");
        if (!seed) {
            return seed.error();
        }
        if (row > 0 && (seed.value() != runs.seed || reader.text(row, "protocol") != runs.protocol)) {
            return fileError(table.path, messages::runsMixed());
        }
        runs.seed = seed.value();
        runs.protocol = reader.text(row, "protocol");
        auto run = readRun(reader, row);
        if (!run) {
            return run.error();
        }
        runs.runs.push_back(std::move(run).value());
    }
    return runs;
}

/// Returns the run to which a row of another file refers; null if there is none.
core::RunRecord* runOf(const RowReader& reader, std::size_t row, const RunByKey& runs)
{
    const auto trial = reader.count(row, "trial");
    const auto found = runs.find(
        Key(reader.text(row, "condition"), reader.text(row, "method"), trial ? trial.value() : ~std::uint64_t{0}));
    return found == runs.end() ? nullptr : found->second;
}

core::Status addTimes(const CsvTable& table, const RunByKey& runs)
{
    RowReader reader(table);
    if (auto status = requireColumns(reader, {"condition", "method", "trial"}); !status) {
        return status;
    }
    if (auto status = requireFields(reader, true); !status) {
        return status;
    }
    for (std::size_t row = 0; row < table.rows.size(); ++row) {
        if (core::RunRecord* run = runOf(reader, row, runs)) {
            if (auto status = readFields(reader, row, true, *run); !status) {
                return status;
            }
        }
    }
    return core::Done{};
}

core::Status addHistories(const CsvTable& table, const RunByKey& runs)
{
    RowReader reader(table);
    if (auto status = requireColumns(reader, {"condition", "method", "trial", "mean_px"}); !status) {
        return status;
    }
    for (std::size_t row = 0; row < table.rows.size(); ++row) {
        const auto value = reader.number(row, "mean_px");
        if (!value) {
            return value.error();
        }
        if (core::RunRecord* run = runOf(reader, row, runs)) {
            run->history.push_back(value.value());
        }
    }
    return core::Done{};
}

/// Reads a table, if the file exists, and adds its rows to the runs.
core::Status addOptional(const std::filesystem::path& path, const RunByKey& runs,
                         core::Status (*add)(const CsvTable&, const RunByKey&))
{
    std::error_code unknown;
    if (!std::filesystem::exists(path, unknown) && !unknown) {
        return core::Done{};
    }
    const auto content = openInput(path.string());
    if (!content) {
        return content.error();
    }
    const auto table = parseCsv(content.value().view(), path.string());
    return table ? add(table.value(), runs) : core::Status(table.error());
}

std::string cell(double value)
{
    return std::isnan(value) ? "nan" : toText(value);   // omits the sign of NaN
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

core::Result<core::RunSet> readRuns(const std::string& folder)
{
    const std::filesystem::path path(folder);
    const auto content = openInput((path / "runs.csv").string());
    if (!content) {
        return content.error();
    }
    const auto table = parseCsv(content.value().view(), (path / "runs.csv").string());
    if (!table) {
        return table.error();
    }
    auto parsed = parseRuns(table.value());
    if (!parsed) {
        return parsed;
    }
    core::RunSet runs = std::move(parsed).value();
    RunByKey byKey;
    for (core::RunRecord& run : runs.runs) {
        byKey[Key(run.condition, run.method, run.trial)] = &run;
    }
    if (const auto status = addOptional(path / "times.csv", byKey, addTimes); !status) {
        return status.error();
    }
    if (const auto status = addOptional(path / "histories.csv", byKey, addHistories); !status) {
        return status.error();
    }
    return runs;
}

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
