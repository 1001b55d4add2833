#include "io/evaluation/point_table.h"

#include "io/fiducial_file.h"
#include "io/messages/says_own.h"
#include "io/support/csv_table.h"
#include "io/support/file_error.h"
#include "io/support/input_bytes.h"

#include <initializer_list>

namespace angiopose::io {
namespace {

using Rows = std::vector<std::vector<double>>;

/// The numbers of the wanted columns, row by row.
core::Result<Rows> parsePointRows(const CsvTable& table, std::initializer_list<std::string_view> wanted)
{
    std::vector<std::size_t> columns;
    for (const std::string_view name : wanted) {
        const auto column = table.column(name);
        if (!column) {
            return fileError(table.path, says::ownPointColumnMissing(name));
        }
        columns.push_back(*column);
    }
    Rows rows;
    for (std::size_t row = 0; row < table.rows.size(); ++row) {
        std::vector<double>& numbers = rows.emplace_back();
        for (const std::size_t column : columns) {
            const auto number = numberAt(table, row, column);
            if (!number) {
                return number.error();
            }
            numbers.push_back(number.value());
        }
    }
    return rows.empty() ? core::Result<Rows>(fileError(table.path, says::ownNoPoints())) : core::Result<Rows>(rows);
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

}   // namespace angiopose::io
