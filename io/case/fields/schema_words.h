#pragma once

#include <nlohmann/json.hpp>

#include <initializer_list>
#include <string_view>

/// The words that the schema of a stored field is made of (JSON Schema, draft 7).
namespace angiopose::io {

using Json = nlohmann::ordered_json;

/// The same schema with a sentence for readers.
Json about(Json schema, std::string_view sentence);

Json textSchema();
Json flagSchema();
Json numberSchema();
Json numberSchema(double min, double max);
Json integerSchema(int min, int max);
Json choiceSchema(std::initializer_list<const char*> choices);
Json anyOfSchema(Json one, Json other);
Json listSchema(Json items);
Json numbersSchema(int count);   ///< a list of so many numbers

/// An object with these members; others are allowed.
Json objectSchema(Json properties, std::initializer_list<const char*> required = {});

/// One that is defined once for the whole schema: see schemaDefinitions.
Json definedAs(std::string_view name);

/// The keys that a schema names, level by level, for telling which a file has beside them: "" marks a value.
Json knownKeys(const Json& schema);

/// Definitions that several fields refer to: input, branchIds, point, pair, origin, pose, matrix.
Json schemaDefinitions();

}   // namespace angiopose::io
