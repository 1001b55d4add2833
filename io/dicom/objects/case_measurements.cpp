#include "io/dicom/objects/case_measurements.h"

#include "core/measuring/measure_image.h"

namespace angiopose::io {
namespace {

constexpr CodedTerm millimeter{"mm", "UCUM", "millimeter"};
constexpr CodedTerm squareMillimeter{"mm2", "UCUM", "square millimeter"};
constexpr CodedTerm degree{"deg", "UCUM", "degree"};
constexpr CodedTerm pixel{"{pixels}", "UCUM", "pixels"};
constexpr CodedTerm squarePixel{"{pixels2}", "UCUM", "square pixels"};
constexpr CodedTerm noUnit{"1", "UCUM", "no units"};

constexpr const char* ownScheme = "99ANGIOPOSE";
constexpr CodedTerm medianDistancePx{"AP1", ownScheme, "Median distance, projected to seen vessels, image"};
constexpr CodedTerm medianDistance{"AP2", ownScheme, "Median distance, projected to seen vessels"};
constexpr CodedTerm distance95{"AP3", ownScheme, "95th percentile of distance to seen vessels"};
constexpr CodedTerm coverage{"AP4", ownScheme, "Share of seen vessels near projected vessels"};
constexpr CodedTerm within2mm{"AP5", ownScheme, "Probability that the overlay lies within 2 mm"};
constexpr CodedTerm errorInPlane{"AP6", ownScheme, "Standard error across the rays"};
constexpr CodedTerm errorAlongRay{"AP7", ownScheme, "Standard error along the rays"};
constexpr CodedTerm methodTerm{"AP8", ownScheme, "Registration method"};
constexpr CodedTerm judgementTerm{"AP9", ownScheme, "Judgement of the registration"};
constexpr CodedTerm noteTerm{"121106", "DCM", "Comment"};

CodedTerm termOf(core::MeasurementKind kind)
{
    return kind == core::MeasurementKind::Length  ? lengthTerm
           : kind == core::MeasurementKind::Angle ? angleTerm
                                                  : areaTerm;
}

CodedTerm unitOf(std::string_view unit)
{
    return unit == "mm"    ? millimeter
           : unit == "mm²" ? squareMillimeter
           : unit == "°"   ? degree
           : unit == "px"  ? pixel
           : unit == "px²" ? squarePixel
                           : noUnit;
}

std::string joinedTexts(const core::Messages& messages)
{
    std::string joined;
    for (const core::Message& message : messages) {
        joined += (joined.empty() ? "" : " ") + message.text();
    }
    return joined;
}

std::string nameOr(const std::string& name, core::MeasurementKind kind, std::size_t place)
{
    return name.empty() ? std::string(termOf(kind).meaning) + " " + std::to_string(place + 1) : name;
}

/// Closes an outline by repeating its first point.
template <class Points>
Points closedWhereArea(Points points, core::MeasurementKind kind)
{
    if (kind == core::MeasurementKind::Area && !points.empty()) {
        points.push_back(points.front());
    }
    return points;
}

void addImageMeasurements(std::vector<ReportGroup>& groups, const core::Case& session)
{
    const core::MeasurementContext seen(session.shown(), session.vessels.tree.get());
    const std::vector<core::ImageMeasurement>& all = session.shown().measurements;
    for (std::size_t i = 0; i < all.size(); ++i) {
        const auto measured = core::measureImage(all[i], seen);
        if (!measured) {
            continue;
        }
        const core::Quantity& value = measured.value().value;
        const std::string basis = joinedTexts(core::basisOf(measured.value(), all[i].kind, seen));
        groups.push_back({nameOr(all[i].name, all[i].kind, i),
                          {{termOf(all[i].kind), value.value, unitOf(value.unit), all[i].frame,
                            closedWhereArea(all[i].pixels, all[i].kind)}},
                          {{noteTerm, basis}}});
    }
}

void addSliceMeasurements(std::vector<ReportGroup>& groups, const core::Vessels& vessels)
{
    for (std::size_t i = 0; i < vessels.measurements.size(); ++i) {
        const core::SliceMeasurement& measurement = vessels.measurements[i];
        if (const auto value = core::valueOf(measurement)) {
            ReportNumber number{termOf(measurement.kind), value.value().value, unitOf(value.value().unit)};
            number.pointsInPatient = closedWhereArea(measurement.pointsInPatient, measurement.kind);
            groups.push_back({nameOr(measurement.name, measurement.kind, i) + ", in the scan", {number}});
        }
    }
}

void addRegistration(std::vector<ReportGroup>& groups, const core::View& view)
{
    if (!view.result) {
        return;
    }
    const core::RegistrationResult& result = *view.result;
    const int frame = result.provenance.frame.value_or(view.frame);
    ReportGroup group{"Registration of vessels, frame " + std::to_string(frame + 1), {}};
    const auto add = [&](const CodedTerm& meaning, double value, const CodedTerm& unit) {
        group.numbers.push_back({meaning, value, unit, frame});
    };
    add(medianDistancePx, result.metrics.medianPx, pixel);
    add(medianDistance, result.metrics.medianMm, millimeter);
    add(distance95, result.metrics.p95Mm, millimeter);
    add(coverage, result.metrics.coverage, noUnit);
    add(errorInPlane, result.uncertainty.inPlaneMm, millimeter);
    add(errorAlongRay, result.uncertainty.depthMm, millimeter);
    if (result.probabilityWithin2Mm) {
        add(within2mm, *result.probabilityWithin2Mm, noUnit);
    }
    group.texts = {{methodTerm, result.method},
                   {judgementTerm, result.trustworthy ? "trustworthy" : "not trustworthy"},
                   {noteTerm, joinedTexts(result.warnings)}};
    std::erase_if(group.texts, [](const ReportText& text) { return text.words.empty(); });
    groups.push_back(std::move(group));
}

}   // namespace

std::vector<ReportGroup> reportGroups(const core::Case& session)
{
    std::vector<ReportGroup> groups;
    addImageMeasurements(groups, session);
    addSliceMeasurements(groups, session.vessels);
    addRegistration(groups, session.shown());
    return groups;
}

}   // namespace angiopose::io
