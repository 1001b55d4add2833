#include "io/case/fields/case_fields.h"

#include "core/registration/methods/method_info.h"
#include "io/case/fields/file_fields.h"
#include "io/case/fields/option_values.h"
#include "io/case/fields/vessel_fields.h"
#include "io/case/fields/vessel_key.h"
#include "io/case/fields/view_fields.h"
#include "io/messages/messages.h"
#include "io/support/json_text.h"

#include <algorithm>

namespace angiopose::io {
namespace {

namespace fs = std::filesystem;
using core::Case;

/// Returns a field with a constant value that identifies the file and is checked before all other fields.
StoredField<Case> constantField(std::string key, Json schema, Json value)
{
    return {std::move(key), std::move(schema), [](const Json&, Case&, ReadContext&) {},
            [value = std::move(value)](const Case&, const fs::path&) { return value; }};
}

StoredField<Case> vesselField()
{
    StoredField<Case> field = objectField("vessel", Json::object(), &Case::vessels, vesselFields());
    field.read = [read = field.read](const Json& value, Case& session, ReadContext& reading) {
        read(value, session, reading);
        if (!reading.hasVessels) {
            reading.problems.push_back(messages::caseNoInput().about("vessel"));
        }
    };
    return field;
}

/// Returns the field of the locked pose axes, which belong to the options but are stored with the pose.
StoredField<Case> locksField()
{
    const Json schema = about(listSchema(choiceSchema({"right", "up", "along-ray", "roll", "lao-rao", "cra-cau"})),
                              "Degrees of freedom that nudging and registration do not change.");
    return {
        "locked", schema,
        [](const Json& value, Case& session, ReadContext&) {
            for (const Json& id : value) {
                if (const auto axis = core::parsePoseAxis(id.get<std::string>())) {   // the schema permits no others
                    session.options.locks[static_cast<std::size_t>(*axis)] = true;
                }
            }
        },
        [](const Case& session, const fs::path&) {
            Json ids;
            for (const core::PoseAxis axis : core::poseAxes) {
                if (core::isLocked(session.options.locks, axis)) {
                    ids.push_back(core::idOf(axis));
                }
            }
            return ids;
        }};
}

void readOtherView(const Json& json, core::View& view, ReadContext& reading)
{
    ReadContext own;
    if (json.contains("angiogram")) {
        readItem(json, view, viewFields(), own);
    } else {
        view.caseFile = fileFrom(json);
    }
    for (const core::Message& problem : own.problems) {
        reading.problems.push_back(problem.about("views"));
    }
    reading.otherViews.push_back(std::move(own.view));
}

Json otherViewJson(const core::View& view, const fs::path& folder)
{
    return view.caseFile.path.empty() ? itemJson(view, viewFields(), folder) : fileJson(view.caseFile, folder);
}

StoredField<Case> otherViewsField()
{
    Json schema = listSchema(anyOfSchema(schemaReference("input"), schemaReference("view")));
    schema["maxItems"] = 100;
    return {"views",
            about(std::move(schema),
                  "Other views of the same vessels, registered jointly with this one: a case file, or the view entries "
                  "of a case. Their angles define the geometry between the views."),
            [](const Json& value, Case& session, ReadContext& reading) {
                for (const Json& each : value) {
                    readOtherView(each, session.views.emplace_back(), reading);
                }
            },
            [](const Case& session, const fs::path& folder) {
                Json list;
                for (const core::View& view : session.views) {
                    if (&view != &session.shown()) {
                        list.push_back(otherViewJson(view, folder));
                    }
                }
                return list;
            }};
}

/// Returns the field of the index of the shown view, which keeps the order of the views: its fields are at top level.
StoredField<Case> shownPlaceField()
{
    return {
        "shownPlace",
        about(integerSchema(0, 100), "Number of `views` that precede the view of this case; absent: none."),
        [](const Json& value, Case&, ReadContext& reading) { reading.shownViewIndex = value.get<std::size_t>(); },
        [](const Case& session, const fs::path&) { return session.shownView > 0 ? Json(session.shownView) : Json(); }};
}

StoredField<Case> methodField()
{
    return {
        "method", textSchema(),
        [](const Json& value, Case& session, ReadContext& reading) {
            const std::string& method = session.options.method = value.get<std::string>();
            const auto methods = core::methodInfos();
            if (std::ranges::find(methods, method, &core::MethodInfo::id) == methods.end()) {
                std::vector<std::string> known;
                for (const core::MethodInfo& info : methods) {
                    known.emplace_back(info.id);
                }
                reading.problems.push_back(messages::caseMethodUnknown(method.substr(0, 40), known).about("method"));
            }
        },
        [](const Case& session, const fs::path&) { return Json(session.options.method); }};
}

StoredField<Case> optionsField()
{
    const Json anything{{"type", {"number", "string", "boolean", "null", "object", "array"}}};
    Json schema{{"type", "object"}, {"additionalProperties", anything}};
    for (const core::OptionField& field : core::optionFields()) {
        schema["properties"][std::string(field.key)] = anything;   // validated with its own message during reading
    }
    return {"options", std::move(schema),
            [](const Json& value, Case& session, ReadContext& reading) {
                readOptions(value.dump(), session.options, reading.problems);
            },
            [](const Case& session, const fs::path&) { return Json::parse(optionsJson(session.options)); }};
}

/// Returns the schema of a view, whether stored in the case itself or in `views`; permits unknown members.
Json viewSchema()
{
    Json properties = Json::object();
    for (const StoredField<core::View>& field : viewFields()) {
        properties[field.key] = {{"$ref", "#/properties/" + field.key}};
    }
    return objectSchema(std::move(properties), {"angiogram"});
}

Json schemaOfRows()
{
    Json schema{{"$schema", "http://json-schema.org/draft-07/schema#"},
                {"$id", "https://angiopose.org/schema/angiopose-case-1.json"},
                {"title", "AngioPose case"},
                {"description",
                 "One session: a vessel tree, an angiogram, the geometry between them and the pose. Lengths in mm, "
                 "angles in degrees, pixels from the center of the first pixel; patient space is DICOM LPS. Keys not "
                 "listed here are allowed and preserved."}};
    schema.update(objectSchema(propertiesOf(caseFields()), {"format", "version", "vessel", "angiogram"}));
    schema["definitions"] = schemaDefinitions();
    schema["definitions"]["view"] = viewSchema();
    return schema;
}

}   // namespace

const StoredFields<Case>& caseFields()
{
    static const StoredFields<Case> fields = [] {
        StoredFields<Case> rows{
            constantField("format", choiceSchema({"angiopose-case"}), "angiopose-case"),
            constantField("version", Json{{"type", "integer"}, {"minimum", 1}}, 1),
            valueField("title", textSchema(), &Case::title),
            vesselField(),
        };
        for (const StoredField<core::View>& field : viewFields()) {
            rows.push_back(memberField<Case>(
                [](auto& session) -> auto& { return session.shown(); }, field));
        }
        rows.push_back(groupField<Case>("pose", Json::object(), {locksField()}));
        rows.push_back(otherViewsField());
        rows.push_back(shownPlaceField());
        rows.push_back(methodField());
        rows.push_back(optionsField());
        return rows;
    }();
    return fields;
}

const std::string& caseSchemaText()
{
    static const std::string schema = prettyJson(schemaOfRows().dump());
    return schema;
}

Json knownCaseKeys(core::VesselInputKind kind)
{
    Json keys = keysOf(caseFields());
    for (const core::VesselInputKind other :
         vesselInputKinds) {   // inputs of kinds not in use are preserved as unknown keys
        if (other != kind && other != core::VesselInputKind::Volume) {   // except a volume, which is read as the scan
            keys["vessel"].erase(vesselKey(other));
        }
    }
    keys["vessel"]["editedTree"] = "";   // treated as a single value
    return keys;
}

}   // namespace angiopose::io
