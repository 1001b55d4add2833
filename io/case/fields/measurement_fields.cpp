#include "io/case/fields/measurement_fields.h"

#include "core/measuring/measure_image.h"
#include "io/case/fields/json_values.h"
#include "io/case/fields/word_field.h"
#include "io/messages/says.h"
#include "io/support/measurement_words.h"

namespace angiopose::io {
namespace {

using core::ImageMeasurement;
using core::MeasurementKind;
using core::MeasurementPlane;

StoredFields<ImageMeasurement> measurementFields()
{
    Json points = listSchema(definedAs("pair"));
    points["minItems"] = 2;
    points["maxItems"] = 1000;
    return {
        wordField("kind", choiceSchema({"length", "angle", "area"}), &ImageMeasurement::kind, measurementKinds),
        wordField("plane",
                  about(choiceSchema({"vessels", "detector", "pixels", "typed"}),
                        "Where it is taken to lie: at the depth of the vessels' centroid, on the detector, "
                        "nowhere, or where a pixel is angiogram.typedMmPerPx."),
                  &ImageMeasurement::plane, measurementPlanes),
        storedValue("pixels", about(points, "Along a length; of an angle the second is its vertex; around an area."),
                    &ImageMeasurement::pixels),
        storedValue("frame", integerSchema(0, 100000), &ImageMeasurement::frame),
        storedIfSet("name", textSchema(), &ImageMeasurement::name)};
}

}   // namespace

StoredField<core::View> measurementsField()
{
    const Json schema{{"description", "What was measured in the image. Values follow from camera and pose."},
                      {"maxItems", 10000}};
    StoredField<core::View> field = storedList("measurements", schema, &core::View::measurements,
                                               objectSchema({}, {"kind", "plane", "pixels"}), measurementFields());
    field.read = [read = field.read](const Json& value, core::View& view, Reading& reading) {
        read(value, view, reading);
        for (std::size_t i = 0; i < view.measurements.size(); ++i) {
            const ImageMeasurement& measurement = view.measurements[i];
            if (measurement.pixels.size() < core::leastPoints(measurement.kind)) {
                reading.problems.push_back(
                    says::caseMeasurementPoints(core::leastPoints(measurement.kind), measurement.pixels.size())
                        .about("measurements: " + std::to_string(i)));
            }
        }
    };
    return field;
}

}   // namespace angiopose::io
