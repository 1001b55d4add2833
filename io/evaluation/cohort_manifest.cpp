#include "io/evaluation/cohort_manifest.h"

#include "io/fiducial_file.h"
#include "io/messages/messages.h"
#include "io/support/csv_table.h"
#include "io/support/file_error.h"
#include "io/support/input_bytes.h"

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <initializer_list>

namespace angiopose::io {
namespace {

using Rows = std::vector<std::vector<double>>;

/// Reads the numbers in the given columns, row by row.
core::Result<Rows> parsePointRows(const CsvTable& table, std::initializer_list<std::string_view> wanted)
{
    std::vector<std::size_t> columns;
    for (const std::string_view name : wanted) {
        const auto column = table.column(name);
        if (!column) {
            return fileError(table.path, messages::ownPointColumnMissing(name));
        }
        columns.push_back(*column);
    }
    Rows rows;
    for (std::size_t row = 0; row < table.rows.size(); ++row) {
        std::vector<double>& numbers = rows.emplace_back();
        for (const std::size_t column : columns) {
            const auto number = numberInCell(table, row, column);
            if (!number) {
                return number.error();
            }
            numbers.push_back(number.value());
        }
    }
    return rows.empty() ? core::Result<Rows>(fileError(table.path, messages::ownNoPoints())) : core::Result<Rows>(rows);
}

core::Result<Rows> readPointRows(const std::string& path, std::initializer_list<std::string_view> wanted)
{
    const auto content = openInput(path);
    if (!content) {
        return content.error();
    }
    const auto table = parseCsv(content.value().view(), path);
    return table ? parsePointRows(table.value(), wanted) : core::Result<Rows>(table.error());
}

core::Result<std::vector<Eigen::Vector3d>> landmarksOfSlicer(const std::string& path)
{
    const auto fiducials = readFiducials(path);
    if (!fiducials) {
        return fiducials.error();
    }
    std::vector<Eigen::Vector3d> landmarks;
    for (const Fiducial& fiducial : fiducials.value()) {
        landmarks.push_back(fiducial.pointInPatient);
    }
    return landmarks;
}

constexpr std::string_view foundPrefix = "pose.";

bool isFileWord(const std::string& text)
{
    return !text.starts_with('.') && std::ranges::all_of(text, [](unsigned char c) {
        return std::isalnum(c) || c == '.' || c == '-' || c == '_';
    });
}

/// Accesses the cells of one row; resolves paths relative to the folder of the manifest.
class CohortRow {
public:
    CohortRow(const CsvTable& table, std::size_t row) : table_(table), row_(row) {}

    std::string text(std::string_view column) const
    {
        const auto index = table_.column(column);
        return index ? std::string(table_.rows[row_][*index]) : "";
    }

    std::string path(std::string_view column) const
    {
        const std::string written = text(column);
        return written.empty() ? "" : (std::filesystem::path(table_.path).parent_path() / written).string();
    }

    int line() const { return table_.lineOfRow[row_]; }

private:
    const CsvTable& table_;
    std::size_t row_;
};

core::Result<CohortEntry> parseCohortEntry(const CsvTable& table, const CohortRow& row)
{
    CohortEntry entry{row.line(),
                      row.path("case"),
                      row.path("reference"),
                      row.path("bent"),
                      row.path("landmarks"),
                      row.path("pairs"),
                      row.path("start"),
                      "all",
                      0,
                      {}};
    if (entry.casePath.empty()) {
        return fileError(table.path, messages::ownNoCase(entry.line));
    }
    if (entry.referencePath.empty() && entry.pointPairsPath.empty()) {
        return fileError(table.path, messages::ownNoTruth(entry.line));
    }
    if (!entry.deformedVesselsPath.empty() && (entry.referencePath.empty() || !entry.landmarksPath.empty())) {
        return fileError(table.path, messages::ownDeformedAlone(entry.line));
    }
    if (const std::string condition = row.text("condition"); !condition.empty()) {
        if (!isFileWord(condition)) {
            return fileError(table.path, messages::ownConditionName(entry.line, condition));
        }
        entry.condition = condition;
    }
    for (const std::string& column : table.columns) {
        if (column.starts_with(foundPrefix)) {
            if (column.size() == foundPrefix.size()) {
                return fileError(table.path, messages::ownPoseWithoutName());
            }
            if (std::string found = row.path(column); !found.empty()) {
                entry.methodPosePaths[column.substr(foundPrefix.size())] = std::move(found);
            }
        }
    }
    return entry;
}

core::Result<std::vector<CohortEntry>> parseCohortManifest(const CsvTable& table)
{
    const bool hasTruth = table.column("reference") || table.column("pairs");
    if (!table.column("case") || !hasTruth || table.rows.empty()) {
        return fileError(table.path, messages::ownNoHeader());
    }
    std::vector<CohortEntry> entries;
    std::map<std::string, int> patients;
    for (std::size_t k = 0; k < table.rows.size(); ++k) {
        const CohortRow row(table, k);
        auto entry = parseCohortEntry(table, row);
        if (!entry) {
            return entry.error();
        }
        const std::string patient = row.text("patient");
        const std::string key = patient.empty() ? "line " + std::to_string(row.line()) : "patient " + patient;
        entries.push_back(std::move(entry).value());
        entries.back().patient = patients.try_emplace(key, static_cast<int>(patients.size())).first->second;
    }
    return entries;
}

}   // namespace

core::Result<std::vector<Eigen::Vector3d>> readLandmarks(const std::string& path)
{
    if (path.ends_with(".fcsv") || path.ends_with(".json")) {
        return landmarksOfSlicer(path);
    }
    const auto rows = readPointRows(path, {"x", "y", "z"});
    if (!rows) {
        return rows.error();
    }
    std::vector<Eigen::Vector3d> landmarks;
    for (const std::vector<double>& row : rows.value()) {
        landmarks.emplace_back(row[0], row[1], row[2]);
    }
    return landmarks;
}

core::Result<std::vector<core::PointPair>> readPointPairs(const std::string& path)
{
    const auto rows = readPointRows(path, {"x", "y", "z", "u", "v"});
    if (!rows) {
        return rows.error();
    }
    std::vector<core::PointPair> pairs;
    for (const std::vector<double>& row : rows.value()) {
        pairs.push_back({{row[0], row[1], row[2]}, {row[3], row[4]}});
    }
    return pairs;
}

core::Result<std::vector<CohortEntry>> readCohortManifest(const std::string& path)
{
    const auto content = openInput(path);
    if (!content) {
        return content.error();
    }
    const auto table = parseCsv(content.value().view(), path);
    return table ? parseCohortManifest(table.value()) : core::Result<std::vector<CohortEntry>>(table.error());
}

}   // namespace angiopose::io
