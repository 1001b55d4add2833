#include "io/results/result_schema.h"

#include "io/case/fields/deformation_fields.h"
#include "io/case/fields/geometry_fields.h"
#include "io/case/fields/result_fields.h"

namespace angiopose::io {
namespace {

Json inputOfResult()
{
    Json uids = objectSchema(
        {{"studyInstanceUid", textSchema()}, {"seriesInstanceUid", textSchema()}, {"sopInstanceUid", textSchema()}});
    return objectSchema(
        {{"file", about(textSchema(), "File name without the folder.")}, {"sha256", textSchema()}, {"dicom", uids}});
}

Json inputsSchema()
{
    return objectSchema({{"vessel", inputOfResult()},
                         {"angiogram", inputOfResult()},
                         {"centerline", inputOfResult()},
                         {"frame", integerSchema(0, 100000)},
                         {"mismatch", listSchema(textSchema())}},
                        {"frame"});
}

Json projectionSchema()
{
    const Json number = numberSchema();
    const Json count{{"type", "integer"}, {"minimum", 1}};
    return about(
        objectSchema(
            {{"fx", number}, {"fy", number}, {"cx", number}, {"cy", number}, {"width", count}, {"height", count}},
            {"fx", "fy", "cx", "cy", "width", "height"}),
        "The camera of the pose, px: u = fx X/Z + cx, v = fy Y/Z + cy, from the center of the first pixel.");
}

/// Returns the properties of result.json other than the fields of a result that a case also stores.
Json ownProperties()
{
    Json anything{{"type", "object"}};
    return {{"format", choiceSchema({"angiopose-result"})},
            {"version", about(Json{{"type", "integer"}, {"minimum", 1}}, "2 since the file includes its provenance.")},
            {"title", textSchema()},
            {"view", about(Json{{"type", "integer"}, {"minimum", 1}}, "Number of the view in the case, from 1.")},
            {"warnings", listSchema(textSchema())},
            {"inputs", inputsSchema()},
            {"projection", projectionSchema()},
            {"geometry", objectSchema(propertiesOf(geometryFields()))},
            {"deformable", about(anything, "Deformation of the vessels (FORMATS, section 3.5).")},
            {"bent", about(deformationField().schema, "The same, including the motion of every point.")},
            {"checkPoints", listSchema(anything)},
            {"case", about(anything,
                           "Input of the registration: a case file (angiopose-case.schema.json) whose inputs are "
                           "identified by name and content.")}};
}

}   // namespace

const std::string& resultSchema()
{
    static const std::string text = [] {
        Json schema{{"$schema", "http://json-schema.org/draft-07/schema#"},
                    {"$id", "https://angiopose.org/schema/angiopose-result-2.json"},
                    {"title", "AngioPose result"},
                    {"description",
                     "Result of a registration for one view, with everything needed to reproduce it except the input "
                     "files. Lengths in mm, angles in degrees, pixels from the center of the first pixel; patient "
                     "space is DICOM LPS. Other keys are allowed."}};
        Json properties = ownProperties();
        const Json kept = propertiesOf(resultFields());
        for (const auto& [key, value] : kept.items()) {
            properties[key] = value;
        }
        schema.update(objectSchema(
            std::move(properties),
            {"format", "version", "method", "pose", "metrics", "uncertainty", "perBranch", "trustworthy", "warnings",
             "messages", "stopReason", "iterations", "timeMs", "inputs", "options", "programVersion"}));
        schema["definitions"] = schemaDefinitions();
        return prettyJson(schema.dump());
    }();
    return text;
}

}   // namespace angiopose::io
