#include "io/centerline2d_file.h"

#include "core/tracing/angiogram/trace_angiogram.h"
#include "core/vessel/polyline.h"
#include "io/messages/messages.h"
#include "io/raster/read_raster.h"
#include "io/support/atomic_file.h"
#include "io/support/csv_table.h"
#include "io/support/file_error.h"
#include "io/support/input_bytes.h"
#include "io/support/numbers.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace angiopose::io {
namespace {

using core::Centerline2d;
using core::Curve2d;

constexpr double maxCoordinatePx = 1e5;
constexpr std::size_t maxPoints = 1'000'000;

struct CurveColumns {
    std::size_t x = 0, y = 0;
    std::optional<std::size_t> branch, radius;
};

core::Result<CurveColumns> curveColumnsOf(const CsvTable& table)
{
    const auto x = table.column("x"), y = table.column("y");
    if (!x || !y) {
        return fileError(table.path, messages::centerlineNoColumns());
    }
    if (table.column("z")) {
        return fileError(table.path, messages::centerlineIs3d());
    }
    if (table.rows.size() > maxPoints) {
        return fileError(table.path, messages::centerlineTooLong());
    }
    return CurveColumns{*x, *y, table.column("branch"), table.column("radius")};
}

/// Adds a row to the curve of its branch; consecutive rows of the same branch form a curve.
core::Status appendRow(const CsvTable& table, std::size_t row, const CurveColumns& columns, Centerline2d& centerline)
{
    const auto u = numberInCell(table, row, columns.x);
    const auto v = numberInCell(table, row, columns.y);
    if (!u || !v) {
        return u ? v.error() : u.error();
    }
    if (std::max(std::abs(u.value()), std::abs(v.value())) > maxCoordinatePx) {
        return fileError(table.path, messages::centerlineOutside(table.lineOfRow[row]));
    }
    const auto id = columns.branch ? branchIdInCell(table, row, *columns.branch) : core::Result<int>(1);
    if (!id) {
        return id.error();
    }
    if (centerline.curves.empty() || centerline.curves.back().id != id.value()) {
        centerline.curves.push_back({id.value(), {}, {}});
    }
    centerline.curves.back().pointsPx.emplace_back(u.value(), v.value());
    const auto radius = columns.radius ? parseNumber(table.rows[row][*columns.radius]) : std::nullopt;
    if (radius && std::isfinite(*radius) && *radius >= 0.0) {
        centerline.curves.back().radiusPx.push_back(*radius);
    }
    return core::Done{};
}

core::Result<Centerline2d> centerlineFromTable(std::string_view content, const std::string& path)
{
    const auto parsed = parseCsv(content, path);
    if (!parsed) {
        return parsed.error();
    }
    const CsvTable& table = parsed.value();
    const auto columns = curveColumnsOf(table);
    if (!columns) {
        return columns.error();
    }
    Centerline2d centerline;
    for (std::size_t row = 0; row < table.rows.size(); ++row) {
        if (const auto appended = appendRow(table, row, columns.value(), centerline); !appended) {
            return appended.error();
        }
    }
    for (Curve2d& curve : centerline.curves) {
        if (curve.radiusPx.size() != curve.pointsPx.size()) {
            curve.radiusPx.clear();
        }
    }
    return centerline;
}

/// Returns whether an image is a drawn mask: only two levels, except at blurred edges.
bool isMask(const core::ImageF& image, float low, float high)
{
    const float margin = 0.1F * (high - low);
    const auto extreme = std::count_if(image.pixels.begin(), image.pixels.end(),
                                       [&](float value) { return value <= low + margin || value >= high - margin; });
    return static_cast<double>(extreme) > 0.9 * static_cast<double>(image.pixels.size());
}

core::Result<Centerline2d> centerlineFromMask(std::string_view content, const std::string& path)
{
    const auto raster = readRaster(content, path);
    if (!raster) {
        return raster.error();
    }
    if (raster.value().frames.size() > 1) {
        return fileError(path, messages::centerlineMaskPages(raster.value().frames.size()));
    }
    const core::ImageF& image = raster.value().frames.front();
    const auto [low, high] = std::minmax_element(image.pixels.begin(), image.pixels.end());
    if (*low == *high || !isMask(image, *low, *high)) {
        return fileError(path, messages::centerlineNoMask());
    }
    core::Mask2d mask(image.width, image.height);
    for (std::size_t i = 0; i < mask.pixels.size(); ++i) {
        mask.pixels[i] = image.pixels[i] > 0.5F * (*low + *high) ? 255 : 0;
    }
    const auto traced = core::traceMask(mask);
    return traced ? traced : fileError(path, traced.error());
}

}   // namespace

core::Result<Centerline2d> readCenterline2d(const std::string& path)
{
    const auto input = openInput(path);
    if (!input) {
        return input.error();
    }
    const std::string_view content = input.value().view();
    if (looksLikeRaster(content)) {
        return centerlineFromMask(content, path);
    }
    const auto* found = describeContent(content);
    if (found != nullptr) {
        return fileError(path, messages::centerlineIsOther((*found)()));
    }
    auto centerline = centerlineFromTable(content, path);
    if (!centerline) {
        return centerline;
    }
    if (const auto problem = core::findProblem(centerline.value())) {
        return fileError(path, *problem);
    }
    return centerline;
}

std::string centerline2dText(const Centerline2d& centerline)
{
    const bool hasRadius = std::any_of(centerline.curves.begin(), centerline.curves.end(),
                                       [](const Curve2d& curve) { return !curve.radiusPx.empty(); });
    std::string text = hasRadius ? "x,y,branch,radius\n" : "x,y,branch\n";
    for (const Curve2d& curve : centerline.curves) {
        for (std::size_t i = 0; i < curve.pointsPx.size(); ++i) {
            text +=
                toText(curve.pointsPx[i].x()) + "," + toText(curve.pointsPx[i].y()) + "," + std::to_string(curve.id);
            if (hasRadius) {
                text += "," + (curve.radiusPx.empty() ? std::string("nan") : toText(curve.radiusPx[i]));
            }
            text += "\n";
        }
    }
    return text;
}

core::Status writeCenterline2d(const Centerline2d& centerline, const std::string& path)
{
    return writeAtomically(path, centerline2dText(centerline));
}

}   // namespace angiopose::io
