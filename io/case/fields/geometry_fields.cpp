#include "io/case/fields/geometry_fields.h"

#include "io/case/fields/json_values.h"

#include <tuple>

namespace angiopose::io {
namespace {

using core::CArm;
using core::Origin;
using core::SourcedValue;
using core::ViewGeometry;
namespace fs = std::filesystem;

Origin originFrom(const std::string& text)
{
    return text == "header"    ? Origin::Header
           : text == "derived" ? Origin::Derived
           : text == "assumed" ? Origin::Assumed
                               : Origin::User;
}

const char* originText(Origin origin)
{
    switch (origin) {
        case Origin::Header:
            return "header";
        case Origin::Derived:
            return "derived";
        case Origin::Assumed:
            return "assumed";
        default:
            return "user";
    }
}

/// Returns the schema of a value stored alone or as an object with its origin.
Json sourcedSchema(const Json& value)
{
    return anyOfSchema(
        value,
        objectSchema({{"value", value}, {"origin", schemaReference("origin")}, {"basis", textSchema()}}, {"value"}));
}

/// Reads a value with its origin; a value stored alone counts as entered by the user.
template <class Value>
SourcedValue<Value> sourcedFrom(const Json& json)
{
    return json.is_object() ? SourcedValue<Value>{json.at("value").get<Value>(),
                                                  originFrom(json.value("origin", "user")), json.value("basis", "")}
                            : SourcedValue<Value>{json.get<Value>(), Origin::User, ""};
}

template <class Value>
Json sourcedJson(const SourcedValue<Value>& sourced)
{
    if (!sourced.value) {
        return {};
    }
    Json json{{"value", *sourced.value}, {"origin", originText(sourced.origin)}};
    if (!sourced.basis.empty()) {
        json["basis"] = sourced.basis;
    }
    return json;
}

template <class Value>
StoredField<ViewGeometry> sourcedField(const char* key, const Json& valueSchema, SourcedValue<Value> CArm::*member,
                                       std::string_view sentence = {})
{
    const Json schema = sourcedSchema(valueSchema);
    return {key, sentence.empty() ? schema : about(schema, sentence),
            [member](const Json& value, ViewGeometry& geometry, ReadContext&) {
                geometry.cArm.*member = sourcedFrom<Value>(value);
            },
            [member](const ViewGeometry& geometry, const fs::path&) { return sourcedJson(geometry.cArm.*member); }};
}

/// Returns the field of the row and column spacing: two values with a common origin.
StoredField<ViewGeometry> spacingField()
{
    return {"imagerPixelSpacingMm", about(sourcedSchema(schemaReference("pair")), "Row spacing, column spacing."),
            [](const Json& value, ViewGeometry& geometry, ReadContext&) {
                const auto both = sourcedFrom<Eigen::Vector2d>(value);
                geometry.cArm.rowSpacingMm = {both.value->x(), both.origin, both.basis};
                geometry.cArm.columnSpacingMm = {both.value->y(), both.origin, both.basis};
            },
            [](const ViewGeometry& geometry, const fs::path&) {
                const auto& [rows, columns] = std::tie(geometry.cArm.rowSpacingMm, geometry.cArm.columnSpacingMm);
                return rows.value && columns.value
                           ? sourcedJson(SourcedValue<Eigen::Vector2d>{Eigen::Vector2d(*rows.value, *columns.value),
                                                                       columns.origin, columns.basis})
                           : Json();
            }};
}

StoredFields<core::ProjectionCamera> cameraFields()
{
    using core::ProjectionCamera;
    return {valueField("fx", numberSchema(), &ProjectionCamera::fx),
            valueField("fy", numberSchema(), &ProjectionCamera::fy),
            valueField("cx", numberSchema(), &ProjectionCamera::cx),
            valueField("cy", numberSchema(), &ProjectionCamera::cy),
            valueField("width", integerSchema(1, 100000), &ProjectionCamera::width),
            valueField("height", integerSchema(1, 100000), &ProjectionCamera::height)};
}

StoredField<ViewGeometry> cameraField()
{
    return {"camera",
            about(objectSchema(propertiesOf(cameraFields()), {"fx", "fy", "cx", "cy", "width", "height"}),
                  "Overrides the camera computed from the values below. fx is negative for an image shown as seen from "
                  "the detector."),
            [](const Json& value, ViewGeometry& geometry, ReadContext& reading) {
                core::ProjectionCamera& camera = geometry.cameraOverride.emplace();
                readFields(value, camera, cameraFields(), reading);
                if (const auto problem = core::findProblem(camera)) {
                    reading.problems.push_back(problem->about("geometry.camera"));
                }
            },
            [](const ViewGeometry& geometry, const fs::path& folder) {
                return geometry.cameraOverride ? writeFields(*geometry.cameraOverride, cameraFields(), folder) : Json();
            }};
}

/// Returns the field of the single distance in older files; if from an image header, it refers to the object plane.
StoredField<ViewGeometry> legacyDistanceField()
{
    return {"sourceToPatientMm", about(sourcedSchema(numberSchema()), "In older files: sourceToIsocenterMm."),
            [](const Json& value, ViewGeometry& geometry, ReadContext&) {
                const auto former = sourcedFrom<double>(value);
                const bool isFromHeader = former.origin == Origin::Header || former.origin == Origin::Derived;
                const bool isObject = isFromHeader && !former.basis.starts_with("(0018,9402)");
                auto& distance = isObject ? geometry.cArm.sourceToObjectMm : geometry.cArm.sourceToIsocenterMm;
                if (!distance.value) {
                    distance = former;
                }
            },
            [](const ViewGeometry&, const fs::path&) { return Json(); }};
}

}   // namespace

StoredFields<ViewGeometry> geometryFields()
{
    return {
        cameraField(),
        sourcedField("sourceToDetectorMm", numberSchema(), &CArm::sourceToDetectorMm),
        sourcedField("sourceToIsocenterMm", numberSchema(), &CArm::sourceToIsocenterMm,
                     "Source-to-isocenter distance; the gantry rotates about the isocenter."),
        sourcedField("sourceToObjectMm", numberSchema(), &CArm::sourceToObjectMm,
                     "Object position along the beam assumed by the device: initial depth of the vessels."),
        legacyDistanceField(),
        spacingField(),
        sourcedField("primaryAngleDeg", numberSchema(), &CArm::primaryAngleDeg, "LAO +, RAO -."),
        sourcedField("secondaryAngleDeg", numberSchema(), &CArm::secondaryAngleDeg, "CRA +, CAU -."),
        sourcedField("rollDeg", numberSchema(), &CArm::rollDeg, "Clockwise rotation of the image on screen."),
        sourcedField("principalPointPx", schemaReference("pair"), &CArm::principalPointPx, "cx, cy."),
        sourcedField("isocentreInPatientMm", schemaReference("point"), &CArm::isocenterInPatientMm,
                     "Rotation center of the gantry, in the vessels' coordinates; absent: the tree's centroid."),
        sourcedField("mirrored", flagSchema(), &CArm::mirrored, "True: shown as seen from the source."),
    };
}

}   // namespace angiopose::io
