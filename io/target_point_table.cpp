#include "io/target_point_table.h"

#include "io/case/fields/json_values.h"
#include "io/support/atomic_file.h"
#include "io/support/csv_table.h"
#include "io/support/json_text.h"
#include "io/support/measurement_words.h"
#include "io/support/message_json.h"
#include "io/support/numbers.h"

#include <nlohmann/json.hpp>
#include <string_view>

namespace angiopose::io {
namespace {

using OrderedJson = nlohmann::ordered_json;

constexpr std::string_view targetPointHeader =
    "mark,kind,name,x_mm,y_mm,z_mm,radius_mm,view,frame,seen_u_px,seen_v_px,expected_u_px,expected_v_px,error_px,"
    "error_mm,claimed_mm,bent_error_mm,depth_mm,notes\n";

std::string wordOf(const core::VesselMark& mark)
{
    return markKinds[static_cast<std::size_t>(mark.kind)];
}

std::string placeCells(const core::VesselMark& mark)
{
    const bool isRing = mark.kind == core::VesselMarkKind::OstiumRing;
    return std::to_string(mark.id) + "," + wordOf(mark) + "," + csvCell(mark.name) + "," +
           toText(mark.pointInPatient.x()) + "," + toText(mark.pointInPatient.y()) + "," +
           toText(mark.pointInPatient.z()) + "," + (isRing ? toText(mark.radiusMm) : "");
}

std::string noteCell(const core::Messages& messages)
{
    std::string notes;
    for (const std::string& sentence : sentencesOf(messages)) {
        notes += (notes.empty() ? "" : " ") + sentence;
    }
    return csvCell(notes);
}

std::string known(const std::optional<double>& value)
{
    return value ? toText(*value) : std::string();
}

std::string pixelCells(const Eigen::Vector2d& pixel)
{
    return toText(pixel.x()) + "," + toText(pixel.y());
}

std::string viewCells(const core::TargetPointViewResult& checked)
{
    const std::string where = std::to_string(checked.view + 1) + "," + std::to_string(checked.frame) + ",";
    const std::string notes = noteCell(core::sentencesOf(checked));
    if (!checked.error) {
        return where + ",,,,,,,,," + notes;
    }
    const core::ImageError& error = checked.error.value();
    const auto predicted = checked.predicted ? std::optional(checked.predicted->inPlaneMm) : std::nullopt;
    return where + pixelCells(error.markedPx) + "," + pixelCells(error.projectedPx) + "," + toText(error.px) + "," +
           toText(error.mm) + "," + known(predicted) + "," + known(checked.deformedMm) + "," + toText(error.depthMm) +
           "," + notes;
}

std::string spaceCells(const core::TargetPointResult& checked)
{
    return "space,,,,,,," + toText(checked.spaceMm()) + "," + known(checked.predictedSpaceMm) + ",,," +
           noteCell(core::spaceErrorMessages(checked));
}

OrderedJson viewJson(const core::TargetPointViewResult& checked)
{
    OrderedJson json{{"view", checked.view + 1}, {"frame", checked.frame}};
    if (checked.error) {
        const core::ImageError& error = checked.error.value();
        json["seenPx"] = {error.markedPx.x(), error.markedPx.y()};
        json["expectedPx"] = {error.projectedPx.x(), error.projectedPx.y()};
        json["errorPx"] = error.px;
        json["errorMm"] = error.mm;
        json["claimedMm"] = checked.predicted ? OrderedJson(checked.predicted->inPlaneMm) : OrderedJson();
        json["depthMm"] = error.depthMm;
    }
    if (checked.deformedMm) {
        json["bentErrorMm"] = *checked.deformedMm;
    }
    json["notes"] = sentencesOf(core::sentencesOf(checked));
    return json;
}

OrderedJson pointJson(const core::VesselMark& mark)
{
    OrderedJson json{{"mark", mark.id}, {"kind", wordOf(mark)}, {"name", mark.name}};
    json["pointInPatientMm"] = {mark.pointInPatient.x(), mark.pointInPatient.y(), mark.pointInPatient.z()};
    if (mark.kind == core::VesselMarkKind::OstiumRing) {
        json["normal"] = {mark.normal.x(), mark.normal.y(), mark.normal.z()};
        json["radiusMm"] = mark.radiusMm;
    }
    return json;
}

OrderedJson checkedJson(const core::TargetPointResult& checked)
{
    OrderedJson json = pointJson(checked.mark);
    json["views"] = OrderedJson::array();
    for (const core::TargetPointViewResult& view : checked.views) {
        json["views"].push_back(viewJson(view));
    }
    if (checked.triangulated) {
        const core::TriangulatedPoint& triangulated = checked.triangulated.value();
        const Eigen::Vector3d& point = triangulated.pointInPatient;
        json["space"] = {
            {"pointInPatientMm", {point.x(), point.y(), point.z()}},
            {"errorMm", checked.spaceMm()},
            {"claimedMm", checked.predictedSpaceMm ? OrderedJson(*checked.predictedSpaceMm) : OrderedJson()},
            {"angleDeg", triangulated.angleDeg},
            {"raysApartMm", triangulated.maxRayDistanceMm}};
    }
    return json;
}

bool isRing(const core::VesselMark& mark)
{
    return mark.kind == core::VesselMarkKind::OstiumRing;
}

}   // namespace

std::string targetPointTable(const core::Case& session)
{
    std::string table(targetPointHeader);
    for (const core::TargetPointResult& checked : core::evaluateTargetPoints(session)) {
        const std::string place = placeCells(checked.mark) + ",";
        for (const core::TargetPointViewResult& view : checked.views) {
            table += place + viewCells(view) + "\n";
        }
        if (checked.triangulated) {
            table += place + spaceCells(checked) + "\n";
        } else if (checked.views.empty()) {
            table += place + ",,,,,,,,,,," + noteCell(core::spaceErrorMessages(checked)) + "\n";
        }
    }
    for (const core::VesselMark& mark : session.vessels.marks) {
        table += isRing(mark) ? placeCells(mark) + ",,,,,,,,,,,,\n" : std::string();
    }
    return table;
}

core::Status writeTargetPoints(const core::Case& session, const std::string& path)
{
    return writeAtomically(path, targetPointTable(session));
}

std::string targetPointJson(const core::Case& session)
{
    OrderedJson list = OrderedJson::array();
    for (const core::TargetPointResult& checked : core::evaluateTargetPoints(session)) {
        list.push_back(checkedJson(checked));
    }
    for (const core::VesselMark& mark : session.vessels.marks) {
        if (isRing(mark)) {
            list.push_back(pointJson(mark));
        }
    }
    return prettyJson(list.dump(-1, ' ', false, OrderedJson::error_handler_t::replace));
}

}   // namespace angiopose::io
