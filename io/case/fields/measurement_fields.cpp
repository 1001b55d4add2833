#include "io/case/fields/measurement_fields.h"

#include "core/measuring/measure_image.h"
#include "io/case/fields/json_values.h"
#include "io/messages/says.h"
#include "io/support/measurement_words.h"

#include <algorithm>

namespace angiopose::io {
namespace {

using core::ImageMeasurement;
using core::MeasurementKind;
using core::MeasurementPlane;

/// A choice that has a word in files.
template <class Choice, std::size_t Count>
StoredField<ImageMeasurement> choiceField(std::string key, Json schema, Choice ImageMeasurement::*member,
                                          const std::array<const char*, Count>& words)
{
    return {std::move(key), std::move(schema),
            [member, words](const Json& value, ImageMeasurement& measurement, Reading&) {
                const auto found = std::ranges::find(words, value.get<std::string>());
                measurement.*member = static_cast<Choice>(found - words.begin());
            },
            [member, words](const ImageMeasurement& measurement, const std::filesystem::path&) {
                return Json(words[static_cast<std::size_t>(measurement.*member)]);
            }};
}

StoredFields<ImageMeasurement> measurementFields()
{
    Json points = listSchema(definedAs("pair"));
    points["minItems"] = 2;
    points["maxItems"] = 1000;
    return {
        choiceField("kind", choiceSchema({"length", "angle", "area"}), &ImageMeasurement::kind, measurementKinds),
        choiceField("plane",
                    about(choiceSchema({"vessels", "detector", "pixels"}),
                          "Where it is taken to lie: at the depth of the vessels' centroid, on the detector, "
                          "nowhere."),
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
