#include "io/case/fields/schema_builder.h"

namespace angiopose::io {
namespace {

constexpr std::string_view definitionPrefix = "#/definitions/";

const Json& resolved(const Json& schema)
{
    static const Json definitions = schemaDefinitions();
    const auto reference = schema.find("$ref");
    return reference == schema.end() ? schema
                                     : definitions.at(reference->get<std::string>().substr(definitionPrefix.size()));
}

}   // namespace

Json knownKeys(const Json& schema)
{
    const Json& wanted = resolved(schema);
    for (const Json& choice : wanted.value("anyOf", Json::array())) {   // a value, or an object that contains it
        if (const Json keys = knownKeys(choice); keys.is_object()) {
            return keys;
        }
    }
    if (!wanted.contains("properties")) {
        return "";
    }
    Json keys = Json::object();
    for (const auto& [key, member] : wanted["properties"].items()) {
        keys[key] = knownKeys(member);
    }
    return keys;
}

}   // namespace angiopose::io
