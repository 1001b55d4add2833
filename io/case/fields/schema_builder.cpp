#include "io/case/fields/schema_builder.h"

#include <limits>
#include <string>
#include <utility>
#include <vector>

namespace angiopose::io {

Json about(Json schema, std::string_view sentence)
{
    schema["description"] = sentence;
    return schema;
}

Json textSchema()
{
    return {{"type", "string"}};
}

Json flagSchema()
{
    return {{"type", "boolean"}};
}

Json numberSchema()
{
    return {{"type", "number"}};
}

Json numberSchema(double min, double max)
{
    return {{"type", "number"}, {"minimum", min}, {"maximum", max}};
}

Json integerSchema(int min, int max)
{
    return {{"type", "integer"}, {"minimum", min}, {"maximum", max}};
}

Json choiceSchema(std::initializer_list<const char*> choices)
{
    Json schema;
    schema["enum"] = std::vector<std::string>(choices.begin(), choices.end());
    return schema;
}

Json anyOfSchema(Json one, Json other)
{
    Json schema;
    schema["anyOf"] = Json::array({std::move(one), std::move(other)});
    return schema;
}

Json listSchema(Json items)
{
    return {{"type", "array"}, {"items", std::move(items)}};
}

Json numbersSchema(int count)
{
    return {{"type", "array"}, {"items", numberSchema()}, {"minItems", count}, {"maxItems", count}};
}

Json objectSchema(Json properties, std::initializer_list<const char*> required)
{
    Json schema{{"type", "object"}};
    if (required.size() > 0) {
        schema["required"] = std::vector<std::string>(required.begin(), required.end());
    }
    schema["properties"] = std::move(properties);
    return schema;
}

Json schemaReference(std::string_view name)
{
    return {{"$ref", "#/definitions/" + std::string(name)}};
}

Json schemaDefinitions()
{
    const Json identifiers{
        {"studyInstanceUid", textSchema()}, {"seriesInstanceUid", textSchema()}, {"sopInstanceUid", textSchema()}};
    const Json path{{"type", "string"}, {"minLength", 1}};
    const Json hash{{"type", "string"}, {"pattern", "^[0-9a-f]{64}$"}};
    Json rows = listSchema(numbersSchema(4));
    rows["minItems"] = rows["maxItems"] = 4;
    constexpr int lowest = std::numeric_limits<int>::min();
    constexpr int highest = std::numeric_limits<int>::max();
    return {{"path", about(path, "Relative to the case file.")},
            {"sha256", hash},
            {"input", objectSchema({{"path", schemaReference("path")},
                                    {"sha256", schemaReference("sha256")},
                                    {"dicom", objectSchema(identifiers)}},
                                   {"path"})},
            {"branchIds", listSchema(integerSchema(lowest, highest))},
            {"origin", choiceSchema({"header", "derived", "user", "assumed"})},
            {"point", numbersSchema(3)},
            {"pair", numbersSchema(2)},
            {"pose", objectSchema({{"cameraFromPatient", schemaReference("matrix")}}, {"cameraFromPatient"})},
            {"matrix", about(rows, "4 x 4, row-major: pointInCamera = cameraFromPatient * pointInPatient.")}};
}

}   // namespace angiopose::io
