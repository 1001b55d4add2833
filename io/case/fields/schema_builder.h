#pragma once

#include <nlohmann/json.hpp>

#include <initializer_list>
#include <string_view>

/// Building blocks for the schema of a stored field (JSON Schema, draft 7).
namespace angiopose::io {

using Json = nlohmann::ordered_json;

/// Adds a description for human readers to a schema.
Json about(Json schema, std::string_view sentence);

Json textSchema();
Json flagSchema();
Json numberSchema();
Json numberSchema(double min, double max);
Json integerSchema(int min, int max);
Json choiceSchema(std::initializer_list<const char*> choices);
Json anyOfSchema(Json one, Json other);
Json listSchema(Json items);
Json numbersSchema(int count);   ///< Returns the schema of a list of `count` numbers.

/// Returns the schema of an object with these members; permits other members.
Json objectSchema(Json properties, std::initializer_list<const char*> required = {});

/// References a definition that the whole schema shares (see schemaDefinitions).
Json schemaReference(std::string_view name);

/// Returns the keys that a schema names, level by level, for finding unknown keys in a file; "" marks a value.
Json knownKeys(const Json& schema);

/// Returns the definitions shared by several fields: input, branchIds, point, pair, origin, pose, matrix.
Json schemaDefinitions();

}   // namespace angiopose::io
