#include "io/case/fields/mark_fields.h"

#include "io/case/fields/enum_field.h"
#include "io/case/fields/json_values.h"
#include "io/messages/messages.h"
#include "io/support/measurement_words.h"

#include <set>

namespace angiopose::io {
namespace {

using core::ImageAnnotation;
using core::TargetObservation;
using core::VesselMark;
using core::VesselMarkKind;

constexpr double usableLength = 1e-6;

Json manyOf(const char* sentence)
{
    return {{"description", sentence}, {"maxItems", 10000}};
}

Json pointList(const char* definition, int least, int most)
{
    Json points = listSchema(schemaReference(definition));
    points["minItems"] = least;
    points["maxItems"] = most;
    return points;
}

StoredFields<VesselMark> markFields()
{
    return {valueField("id", about(integerSchema(1, 1000000), "Id used by `sightings`."), &VesselMark::id),
            enumField("kind", choiceSchema({"check-point", "ostium-ring"}), &VesselMark::kind, markKinds),
            optionalField("name", textSchema(), &VesselMark::name),
            valueField("pointInPatientMm", schemaReference("point"), &VesselMark::pointInPatient),
            optionalField("normal", about(schemaReference("point"), "Unit vector of a ring, along its branch."),
                          &VesselMark::normal),
            optionalField("radiusMm", about(numberSchema(0, 1000), "Of a ring."), &VesselMark::radiusMm)};
}

/// Reports invalid marks and normalizes directions to unit length.
void checkMarks(std::vector<VesselMark>& marks, ReadContext& reading)
{
    std::set<int> ids;
    for (VesselMark& mark : marks) {
        const std::string subject = "vessel.marks: " + std::to_string(mark.id);
        if (!ids.insert(mark.id).second) {
            reading.problems.push_back(messages::caseMarkTwice(mark.id).about(subject));
        }
        const bool isRing = mark.kind == VesselMarkKind::OstiumRing;
        if (isRing && !(mark.radiusMm > 0.0 && mark.normal.norm() > usableLength)) {
            reading.problems.push_back(messages::caseRingOpen().about(subject));
        } else if (std::abs(mark.normal.norm() - 1.0) > usableLength) {
            mark.normal = isRing ? mark.normal.normalized() : Eigen::Vector3d(Eigen::Vector3d::UnitZ());
        }
    }
}

}   // namespace

StoredField<core::Vessels> marksField()
{
    StoredField<core::Vessels> field =
        listField("marks", manyOf("Target points and ostium rings on the vessels."), &core::Vessels::marks,
                  objectSchema({}, {"id", "kind", "pointInPatientMm"}), markFields());
    field.read = [read = field.read](const Json& value, core::Vessels& vessels, ReadContext& reading) {
        read(value, vessels, reading);
        checkMarks(vessels.marks, reading);
    };
    return field;
}

StoredField<core::View> observationsField()
{
    return listField("sightings", manyOf("Positions of target points of the vessels in the image."),
                     &core::View::observations, objectSchema({}, {"mark", "pixel"}),
                     StoredFields<TargetObservation>{
                         valueField("mark", about(integerSchema(1, 1000000), "Id of the mark of the vessels."),
                                    &TargetObservation::markId),
                         valueField("pixel", schemaReference("pair"), &TargetObservation::pixel),
                         valueField("frame", integerSchema(0, 100000), &TargetObservation::frame)});
}

StoredField<core::View> annotationsField()
{
    StoredField<core::View> field = listField(
        "annotations", manyOf("Arrows and texts on the image; they are only drawn."), &core::View::annotations,
        objectSchema({}, {"kind", "pixels"}),
        StoredFields<ImageAnnotation>{
            enumField("kind", choiceSchema({"arrow", "text"}), &ImageAnnotation::kind, annotationKinds),
            valueField("pixels", about(pointList("pair", 1, 2), "Tail and tip of an arrow; position of a text."),
                       &ImageAnnotation::pixels),
            optionalField("text", textSchema(), &ImageAnnotation::text),
            valueField("frame", integerSchema(0, 100000), &ImageAnnotation::frame)});
    field.read = [read = field.read](const Json& value, core::View& view, ReadContext& reading) {
        read(value, view, reading);
        for (std::size_t i = 0; i < view.annotations.size(); ++i) {
            const ImageAnnotation& each = view.annotations[i];
            if (each.pixels.size() != (each.kind == core::AnnotationKind::Arrow ? 2U : 1U)) {
                reading.problems.push_back(messages::caseAnnotationPoints().about("annotations: " + std::to_string(i)));
            }
        }
    };
    return field;
}

}   // namespace angiopose::io
