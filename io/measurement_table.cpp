#include "io/measurement_table.h"

#include "core/measuring/measure_image.h"
#include "io/support/atomic_file.h"
#include "io/support/csv_table.h"
#include "io/support/measurement_words.h"
#include "io/support/numbers.h"

#include <string_view>

namespace angiopose::io {
namespace {

constexpr std::string_view measurementHeader =
    "view,frame,kind,name,value,unit,plane,mm_per_px_u,mm_per_px_v,depth_mm,geometry,notes,points\n";

/// Spells a unit in ASCII letters.
std::string_view unitInTable(std::string_view unit)
{
    return unit == "°" ? "deg" : unit == "mm²" ? "mm2" : unit == "px²" ? "px2" : unit;
}

std::string_view originInTable(core::Origin origin)
{
    switch (origin) {
        case core::Origin::Header:
            return "header";
        case core::Origin::Derived:
            return "derived";
        case core::Origin::User:
            return "user";
        case core::Origin::Assumed:
            return "assumed";
        case core::Origin::Missing:
            break;
    }
    return "missing";
}

std::string scaleCells(const core::ImageScale& scale)
{
    if (!scale.isInMm()) {
        return ",,,";
    }
    return toText(scale.unitsPerPx.x()) + "," + toText(scale.unitsPerPx.y()) + "," +
           (scale.plane == core::MeasurementPlane::Vessels ? toText(scale.depthMm) : "") + "," +
           std::string(originInTable(scale.origin));
}

std::string notesOf(const core::Messages& messages)
{
    std::string notes;
    for (const core::Message& message : messages) {
        notes += (notes.empty() ? "" : " ") + message.text();
    }
    return notes;
}

std::string pointsOf(const core::ImageMeasurement& measurement)
{
    std::string points;
    for (const Eigen::Vector2d& pixel : measurement.pixels) {
        points += (points.empty() ? "" : ";") + toText(pixel.x()) + " " + toText(pixel.y());
    }
    return points;
}

void addMeasurementRow(std::string& table, std::size_t place, const core::MeasurementContext& seen,
                       const core::ImageMeasurement& measurement)
{
    const std::string plane = measurementPlanes[static_cast<std::size_t>(measurement.plane)];
    table += std::to_string(place + 1) + "," + std::to_string(measurement.frame) + "," +
             measurementKinds[static_cast<std::size_t>(measurement.kind)] + "," + csvCell(measurement.name) + ",";
    if (const auto measured = core::measureImage(measurement, seen)) {
        const core::ImageMeasurementResult& found = measured.value();
        table += toText(found.value.value) + "," + std::string(unitInTable(found.value.unit)) + "," + plane + "," +
                 scaleCells(found.scale) + "," + csvCell(notesOf(core::basisOf(found, measurement.kind, seen)));
    } else {
        table += ",," + plane + ",,,,," + csvCell(measured.error().message.text());
    }
    table += "," + pointsOf(measurement) + "\n";
}

std::string pointsOf(const core::SliceMeasurement& measurement)
{
    std::string points;
    for (const Eigen::Vector3d& point : measurement.pointsInPatient) {
        points += (points.empty() ? "" : ";") + toText(point.x()) + " " + toText(point.y()) + " " + toText(point.z());
    }
    return points;
}

/// Adds a row with empty view and frame cells; measurements in patient mm need no scale.
void addSliceRow(std::string& table, const core::SliceMeasurement& measurement, const core::VolumeGeometry* scan)
{
    const std::string plane = bodyPlaneWords[static_cast<std::size_t>(measurement.plane)];
    table += std::string(",,") + measurementKinds[static_cast<std::size_t>(measurement.kind)] + "," +
             csvCell(measurement.name) + ",";
    const auto value = core::valueOf(measurement);
    table += value ? toText(value.value().value) + "," + std::string(unitInTable(value.value().unit)) : ",";
    table += "," + plane + ",,,," + (value ? "scan" : "") + "," +
             csvCell(value ? notesOf(core::basisOf(measurement, scan)) : value.error().message.text()) + "," +
             pointsOf(measurement) + "\n";
}

}   // namespace

std::string measurementTable(const core::Case& session)
{
    std::string table(measurementHeader);
    for (std::size_t place = 0; place < session.views.size(); ++place) {
        for (const core::ImageMeasurement& measurement : session.views[place].measurements) {
            addMeasurementRow(table, place, {session.views[place], session.vessels.tree.get()}, measurement);
        }
    }
    const core::VolumeGeometry* scan = session.vessels.scan ? &session.vessels.scan->geometry : nullptr;
    for (const core::SliceMeasurement& measurement : session.vessels.measurements) {
        addSliceRow(table, measurement, scan);
    }
    return table;
}

core::Status writeMeasurements(const core::Case& session, const std::string& path)
{
    return writeAtomically(path, measurementTable(session));
}

}   // namespace angiopose::io
