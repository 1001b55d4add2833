#pragma once

#include "core/case/case.h"
#include "io/case/fields/schema_builder.h"
#include "io/case/fields/view_notes.h"
#include "io/support/json_text.h"

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace angiopose::io {

/// Information collected while reading, in addition to the values themselves.
struct ReadContext {
    core::Messages problems;   ///< invalid values, each with key and remedy
    ViewNotes view;   ///< notes on the view being read
    std::vector<ViewNotes> otherViews;   ///< notes on the other views of the case, in order
    std::size_t shownViewIndex = 0;   ///< index of the shown view, which is stored in the case itself
    bool hasVessels = false;   ///< whether a vessel input of any kind was found
};

/// Describes one value of an Owner that is stored in a case file. The row determines how the value is read and written,
/// its schema and its known keys.
template <class Owner>
struct StoredField {
    std::string key;   ///< rows with the same key share an object
    Json schema;
    std::function<void(const Json& value, Owner& owner, ReadContext& reading)>
        read;   ///< called only if the value is present
    std::function<Json(const Owner& owner, const std::filesystem::path& folder)> write;   ///< null if nothing to write
};
template <class Owner>
using StoredFields = std::vector<StoredField<Owner>>;

/// Reads the fields present in `json` and leaves the others unchanged. `json` must conform to the schema.
template <class Owner>
void readFields(const Json& json, Owner& owner, const StoredFields<Owner>& fields, ReadContext& reading)
{
    for (const StoredField<Owner>& field : fields) {
        if (const auto value = json.find(field.key); value != json.end()) {
            field.read(*value, owner, reading);
        }
    }
}

template <class Owner>
Json writeFields(const Owner& owner, const StoredFields<Owner>& fields, const std::filesystem::path& folder)
{
    Json json = Json::object();
    for (const StoredField<Owner>& field : fields) {
        if (const Json value = field.write(owner, folder); value.is_object() && json.contains(field.key)) {
            json[field.key].update(value, true);
        } else if (!value.is_null()) {
            json[field.key] = value;
        }
    }
    return json;
}

/// Returns the schema properties of the rows.
template <class Owner>
Json propertiesOf(const StoredFields<Owner>& fields)
{
    Json properties = Json::object();
    for (const StoredField<Owner>& field : fields) {
        if (properties.contains(field.key)) {
            properties[field.key].update(field.schema, true);
        } else {
            properties[field.key] = field.schema;
        }
    }
    return properties;
}

/// Returns the row of a value that JSON represents directly.
template <class Owner, class Value>
StoredField<Owner> valueField(std::string key, Json schema, Value Owner::*member)
{
    return {std::move(key), std::move(schema),
            [member](const Json& value, Owner& owner, ReadContext&) { owner.*member = value.get<Value>(); },
            [member](const Owner& owner, const std::filesystem::path&) { return Json(owner.*member); }};
}

/// Returns the row of a value that JSON represents directly and that is written only if it differs from the default.
template <class Owner, class Value>
StoredField<Owner> optionalField(std::string key, Json schema, Value Owner::*member)
{
    StoredField<Owner> field = valueField(std::move(key), std::move(schema), member);
    field.write = [member](const Owner& owner, const std::filesystem::path&) {
        return owner.*member == Owner().*member ? Json() : Json(owner.*member);
    };
    return field;
}

/// Returns the row of a part that is stored as an object with the rows `fields`.
template <class Owner, class Part>
StoredField<Owner> objectField(std::string key, Json schema, Part Owner::*member, StoredFields<Part> fields)
{
    schema["type"] = "object";
    schema["properties"] = propertiesOf(fields);
    return {std::move(key), std::move(schema),
            [member, fields](const Json& value, Owner& owner, ReadContext& reading) {
                readFields(value, owner.*member, fields, reading);
            },
            [member, fields](const Owner& owner, const std::filesystem::path& folder) {
                return writeFields(owner.*member, fields, folder);
            }};
}

/// Returns the row of an object that groups several rows of the same owner.
template <class Owner>
StoredField<Owner> groupField(std::string key, Json schema, StoredFields<Owner> fields)
{
    schema["type"] = "object";
    schema["properties"] = propertiesOf(fields);
    return {
        std::move(key), std::move(schema),
        [fields](const Json& value, Owner& owner, ReadContext& reading) { readFields(value, owner, fields, reading); },
        [fields](const Owner& owner, const std::filesystem::path& folder) {
            return writeFields(owner, fields, folder);
        }};
}

/// Adapts the row of a part to its owner. `partOf` returns the part of a const or non-const owner.
template <class Owner, class Part, class PartOf>
StoredField<Owner> memberField(PartOf partOf, StoredField<Part> field)
{
    return {field.key, field.schema,
            [partOf, read = field.read](const Json& value, Owner& owner, ReadContext& reading) {
                read(value, partOf(owner), reading);
            },
            [partOf, write = field.write](const Owner& owner, const std::filesystem::path& folder) {
                return write(partOf(owner), folder);
            }};
}

/// Restricts a row: the value is written only if `isWritten` is true for the owner.
template <class Owner, class Condition>
StoredField<Owner> writeFieldIf(Condition isWritten, StoredField<Owner> field)
{
    field.write = [isWritten, write = field.write](const Owner& owner, const std::filesystem::path& folder) {
        return isWritten(owner) ? write(owner, folder) : Json();
    };
    return field;
}

/// Returns the known keys of an object with these rows (see knownKeys).
template <class Owner>
Json keysOf(const StoredFields<Owner>& fields)
{
    return knownKeys(objectSchema(propertiesOf(fields)));
}

/// Reads an item of a list, including its unknown keys if Item has `extraKeys`.
template <class Item>
void readItem(const Json& json, Item& item, const StoredFields<Item>& fields, ReadContext& reading)
{
    readFields(json, item, fields, reading);
    if constexpr (requires { item.extraKeys; }) {
        item.extraKeys = unknownKeys(json.dump(), keysOf(fields).dump());
    }
}

template <class Item>
Json itemJson(const Item& item, const StoredFields<Item>& fields, const std::filesystem::path& folder)
{
    Json json = writeFields(item, fields, folder);
    if constexpr (requires { item.extraKeys; }) {
        json = Json::parse(withExtraKeys(json.dump(), item.extraKeys));
    }
    return json;
}

/// Returns the row of a list of objects, each with the rows `fields`; an empty list is omitted.
template <class Owner, class Item>
StoredField<Owner> listField(std::string key, Json schema, std::vector<Item> Owner::*member, Json itemSchema,
                             StoredFields<Item> fields)
{
    itemSchema["type"] = "object";
    itemSchema["properties"] = propertiesOf(fields);
    schema["type"] = "array";
    schema["items"] = std::move(itemSchema);
    return {std::move(key), std::move(schema),
            [member, fields](const Json& value, Owner& owner, ReadContext& reading) {
                for (const Json& item : value) {
                    readItem(item, (owner.*member).emplace_back(), fields, reading);
                }
            },
            [member, fields](const Owner& owner, const std::filesystem::path& folder) {
                Json list;
                for (const Item& item : owner.*member) {
                    list.push_back(itemJson(item, fields, folder));
                }
                return list;
            }};
}

}   // namespace angiopose::io
