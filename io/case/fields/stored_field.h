#pragma once

#include "core/case/case.h"
#include "io/case/fields/schema_words.h"
#include "io/case/fields/view_notes.h"
#include "io/support/json_text.h"

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace angiopose::io {

/// What reading finds beside the values.
struct Reading {
    core::Messages problems;   ///< what makes no sense, each with key and remedy
    ViewNotes view;   ///< of the view that is read
    std::vector<ViewNotes> otherViews;   ///< of a case, in order
    std::size_t shownPlace = 0;   ///< of the view that stands in the case itself, among all its views
    bool hasVessels = false;   ///< one of the kinds of vessels has been found
};

/// One value of an Owner that a case file keeps: the row from which reading, writing, the schema and the keys that are
/// known all follow.
template <class Owner>
struct StoredField {
    std::string key;   ///< rows of one key share an object
    Json schema;
    std::function<void(const Json& value, Owner& owner, Reading& reading)> read;   ///< of a value that is there
    std::function<Json(const Owner& owner, const std::filesystem::path& folder)> write;   ///< null: nothing to say
};
template <class Owner>
using StoredFields = std::vector<StoredField<Owner>>;

/// Takes over what `json` says; what it does not say stays as it is. The schema has been checked.
template <class Owner>
void readFields(const Json& json, Owner& owner, const StoredFields<Owner>& fields, Reading& reading)
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

/// The members that the rows describe.
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

/// A value that JSON knows as it is.
template <class Owner, class Value>
StoredField<Owner> storedValue(std::string key, Json schema, Value Owner::*member)
{
    return {std::move(key), std::move(schema),
            [member](const Json& value, Owner& owner, Reading&) { owner.*member = value.get<Value>(); },
            [member](const Owner& owner, const std::filesystem::path&) { return Json(owner.*member); }};
}

/// Likewise of one that is only written where it differs from a fresh Owner's.
template <class Owner, class Value>
StoredField<Owner> storedIfSet(std::string key, Json schema, Value Owner::*member)
{
    StoredField<Owner> field = storedValue(std::move(key), std::move(schema), member);
    field.write = [member](const Owner& owner, const std::filesystem::path&) {
        return owner.*member == Owner().*member ? Json() : Json(owner.*member);
    };
    return field;
}

/// A part with rows of its own, as an object.
template <class Owner, class Part>
StoredField<Owner> storedPart(std::string key, Json schema, Part Owner::*member, StoredFields<Part> fields)
{
    schema["type"] = "object";
    schema["properties"] = propertiesOf(fields);
    return {std::move(key), std::move(schema),
            [member, fields](const Json& value, Owner& owner, Reading& reading) {
                readFields(value, owner.*member, fields, reading);
            },
            [member, fields](const Owner& owner, const std::filesystem::path& folder) {
                return writeFields(owner.*member, fields, folder);
            }};
}

/// Rows of the same owner that stand in an object of their own.
template <class Owner>
StoredField<Owner> storedGroup(std::string key, Json schema, StoredFields<Owner> fields)
{
    schema["type"] = "object";
    schema["properties"] = propertiesOf(fields);
    return {std::move(key), std::move(schema),
            [fields](const Json& value, Owner& owner, Reading& reading) { readFields(value, owner, fields, reading); },
            [fields](const Owner& owner, const std::filesystem::path& folder) {
                return writeFields(owner, fields, folder);
            }};
}

/// The row of a part among those of its owner. `partOf`: from an owner, const or not, to its part.
template <class Owner, class Part, class PartOf>
StoredField<Owner> storedThrough(PartOf partOf, StoredField<Part> field)
{
    return {field.key, field.schema,
            [partOf, read = field.read](const Json& value, Owner& owner, Reading& reading) {
                read(value, partOf(owner), reading);
            },
            [partOf, write = field.write](const Owner& owner, const std::filesystem::path& folder) {
                return write(partOf(owner), folder);
            }};
}

/// The row, written only where `isWritten` holds for the owner.
template <class Owner, class Condition>
StoredField<Owner> writtenWhere(Condition isWritten, StoredField<Owner> field)
{
    field.write = [isWritten, write = field.write](const Owner& owner, const std::filesystem::path& folder) {
        return isWritten(owner) ? write(owner, folder) : Json();
    };
    return field;
}

/// Keys by which a version knows an object: see knownKeys.
template <class Owner>
Json keysOf(const StoredFields<Owner>& fields)
{
    return knownKeys(objectSchema(propertiesOf(fields)));
}

/// One of a list, with what the file says of it that this version does not know, where an Item has a place for that.
template <class Item>
void readItem(const Json& json, Item& item, const StoredFields<Item>& fields, Reading& reading)
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

/// A list of objects with rows of their own; left out where it is empty.
template <class Owner, class Item>
StoredField<Owner> storedList(std::string key, Json schema, std::vector<Item> Owner::*member, Json itemSchema,
                              StoredFields<Item> fields)
{
    itemSchema["type"] = "object";
    itemSchema["properties"] = propertiesOf(fields);
    schema["type"] = "array";
    schema["items"] = std::move(itemSchema);
    return {std::move(key), std::move(schema),
            [member, fields](const Json& value, Owner& owner, Reading& reading) {
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
