#include "io/centerline2d_file.h"

#include "core/tracing/trace_angiogram.h"
#include "io/angiogram_file.h"
#include "io/support/atomic_file.h"
#include "io/support/csv_table.h"
#include "io/support/file_error.h"
#include "io/support/input_bytes.h"
#include "io/support/numbers.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace io {
namespace {

using Columns = std::optional<std::size_t>;

/// Rows with equal `branch` make one curve, in the order of the file; without the column all rows are one curve.
core::Result<core::Centerline2d> curvesOf(const CsvTable& table, const std::string& path)
{
    const Columns x = table.column("x");
    const Columns y = table.column("y");
    if (!x || !y) {
        return fileError(path, "a 2-D centreline needs the columns x and y. Write the header x,y,branch,radius.");
    }
    const Columns branch = table.column("branch");
    const Columns radius = table.column("radius");
    std::map<int, std::size_t> curveOfBranch;
    core::Centerline2d centerline;
    for (std::size_t row = 0; row < table.rows.size(); ++row) {
        const auto column = numberAt(table, row, *x, path);
        const auto line = numberAt(table, row, *y, path);
        const auto id = branch ? numberAt(table, row, *branch, path) : core::Result<double>(1.0);
        const auto width = radius ? numberAt(table, row, *radius, path) : core::Result<double>(0.0);
        for (const auto* cell : {&column, &line, &id, &width}) {
            if (!*cell) {
                return cell->error();
            }
        }
        const int branchId = static_cast<int>(std::lround(id.value()));
        const auto [found, isNew] = curveOfBranch.try_emplace(branchId, centerline.curves.size());
        if (isNew) {
            centerline.curves.push_back({branchId, {}, {}});
        }
        core::Curve2d& curve = centerline.curves[found->second];
        curve.pointsPx.emplace_back(column.value(), line.value());
        if (radius) {
            curve.radiusPx.push_back(width.value());
        }
    }
    return centerline;
}

core::Result<core::Centerline2d> readTable(const std::string& path)
{
    const auto bytes = openInput(path);
    if (!bytes) {
        return bytes.error();
    }
    const auto table = parseCsv(bytes.value().view(), path);
    return table ? curvesOf(table.value(), path) : table.error();
}

core::Result<core::Centerline2d> readMask(const std::string& path)
{
    const auto image = readAngiogram(path);
    if (!image) {
        return image.error();
    }
    const core::ImageF& frame = image.value().frames.front();
    core::Mask2d mask(frame.width, frame.height);
    std::transform(frame.pixels.begin(), frame.pixels.end(), mask.pixels.begin(),
                   [](float value) { return static_cast<std::uint8_t>(value > 0.0F ? 255 : 0); });
    auto traced = core::traceMask(mask);
    return traced ? std::move(traced) : core::Result<core::Centerline2d>(fileError(path, traced.error().message));
}

}   // namespace

core::Result<core::Centerline2d> readCenterline2d(const std::string& path)
{
    auto centerline = extensionOf(path) == ".csv" ? readTable(path) : readMask(path);
    if (centerline) {
        if (const std::string problem = core::findProblem(centerline.value()); !problem.empty()) {
            return fileError(path, problem);
        }
    }
    return centerline;
}

core::Status writeCenterline2d(const core::Centerline2d& centerline, const std::string& path)
{
    std::string text = "x,y,branch,radius\n";
    for (const core::Curve2d& curve : centerline.curves) {
        const bool hasRadius = curve.radiusPx.size() == curve.pointsPx.size();
        for (std::size_t i = 0; i < curve.pointsPx.size(); ++i) {
            text += toText(curve.pointsPx[i].x()) + "," + toText(curve.pointsPx[i].y()) + "," +
                    std::to_string(curve.id) + "," + toText(hasRadius ? curve.radiusPx[i] : 0.0) + "\n";
        }
    }
    return writeAtomically(path, text);
}

}   // namespace io
