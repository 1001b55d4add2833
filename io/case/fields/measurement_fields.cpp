#include "io/case/fields/measurement_fields.h"

#include "core/measuring/measure_image.h"
#include "io/case/fields/enum_field.h"
#include "io/case/fields/json_values.h"
#include "io/messages/messages.h"
#include "io/support/measurement_words.h"

namespace angiopose::io {
namespace {

using core::ImageMeasurement;
using core::MeasurementKind;
using core::MeasurementPlane;
using core::SliceMeasurement;

StoredFields<ImageMeasurement> measurementFields()
{
    Json points = listSchema(schemaReference("pair"));
    points["minItems"] = 2;
    points["maxItems"] = 1000;
    return {
        enumField("kind", choiceSchema({"length", "angle", "area"}), &ImageMeasurement::kind, measurementKinds),
        enumField("plane",
                  about(choiceSchema({"vessels", "detector", "pixels", "typed"}),
                        "Assumed depth: that of the vessels' centroid, the detector, none, or a pixel size of "
                        "angiogram.typedMmPerPx."),
                  &ImageMeasurement::plane, measurementPlanes),
        valueField("pixels",
                   about(points, "Points along a length; of an angle, the second is its vertex; outline of an area."),
                   &ImageMeasurement::pixels),
        valueField("frame", integerSchema(0, 100000), &ImageMeasurement::frame),
        optionalField("name", textSchema(), &ImageMeasurement::name)};
}

StoredFields<SliceMeasurement> sliceMeasurementFields()
{
    Json points = listSchema(schemaReference("point"));
    points["minItems"] = 2;
    points["maxItems"] = 1000;
    return {
        enumField("kind", choiceSchema({"length", "angle", "area"}), &SliceMeasurement::kind, measurementKinds),
        enumField(
            "plane",
            about(choiceSchema({"axial", "coronal", "sagittal"}), "Orientation of the slice relative to the patient."),
            &SliceMeasurement::plane, bodyPlaneWords),
        valueField(
            "pointsInPatientMm",
            about(points,
                  "Points in the slice: along a length; of an angle, the second is its vertex; outline of an area."),
            &SliceMeasurement::pointsInPatient),
        optionalField("name", textSchema(), &SliceMeasurement::name)};
}

/// Reports a measurement that has too few points for its kind.
void targetPoints(MeasurementKind kind, std::size_t points, const std::string& subject, ReadContext& reading)
{
    if (points < core::minPoints(kind)) {
        reading.problems.push_back(messages::caseMeasurementPoints(core::minPoints(kind), points).about(subject));
    }
}

}   // namespace

StoredField<core::View> measurementsField()
{
    const Json schema{{"description", "Measurements in the image. Values are computed from camera and pose."},
                      {"maxItems", 10000}};
    StoredField<core::View> field = listField("measurements", schema, &core::View::measurements,
                                              objectSchema({}, {"kind", "plane", "pixels"}), measurementFields());
    field.read = [read = field.read](const Json& value, core::View& view, ReadContext& reading) {
        read(value, view, reading);
        for (std::size_t i = 0; i < view.measurements.size(); ++i) {
            const ImageMeasurement& each = view.measurements[i];
            targetPoints(each.kind, each.pixels.size(), "measurements: " + std::to_string(i), reading);
        }
    };
    return field;
}

StoredField<core::Vessels> sliceMeasurementsField()
{
    const Json schema{{"description", "Measurements in slices of the scan, mm."}, {"maxItems", 10000}};
    StoredField<core::Vessels> field =
        listField("measurements", schema, &core::Vessels::measurements,
                  objectSchema({}, {"kind", "plane", "pointsInPatientMm"}), sliceMeasurementFields());
    field.read = [read = field.read](const Json& value, core::Vessels& vessels, ReadContext& reading) {
        read(value, vessels, reading);
        for (std::size_t i = 0; i < vessels.measurements.size(); ++i) {
            const SliceMeasurement& each = vessels.measurements[i];
            targetPoints(each.kind, each.pointsInPatient.size(), "vessel.measurements: " + std::to_string(i), reading);
        }
    };
    return field;
}

}   // namespace angiopose::io
