#include "io/case/case_settings.h"

#include "core/registration/options/option_text.h"
#include "core/support/nearest_word.h"
#include "io/case/case_schema.h"
#include "io/case/fields/vessel_fields.h"
#include "io/case/fields/view_fields.h"
#include "io/messages/messages.h"
#include "io/support/numbers.h"

#include <algorithm>
#include <map>
#include <optional>

namespace angiopose::io {
namespace {

const std::string tracePrefix = "angiogram.trace.";
const std::string tracingPrefix = "vessel.tracing.";

template <class Owner>
std::vector<std::string> namesUnder(const std::string& prefix, const StoredFields<Owner>& fields)
{
    std::vector<std::string> names;
    for (const StoredField<Owner>& field : fields) {
        names.push_back(prefix + field.key);
    }
    return names;
}

std::string lastPartOf(const std::string& name)
{
    return name.substr(name.rfind('.') + 1);
}

/// Returns the setting name as spelled in case files; nullopt if there is no setting of that name.
std::optional<std::string> nameLike(const std::string& word)
{
    for (const std::string& name : caseSettingNames()) {
        if (toLower(name) == toLower(word)) {
            return name;
        }
    }
    return std::nullopt;
}

/// Finds setting names similar to `word`. Compares full names and last components, so that names entered without
/// "vessel.tracing." are found as well.
std::vector<std::string> namesNear(const std::string& word)
{
    std::map<std::string, std::vector<std::string>> namesByWord;
    for (const std::string& name : caseSettingNames()) {
        namesByWord[toLower(name)].push_back(name);
        if (lastPartOf(name) != name) {
            namesByWord[toLower(lastPartOf(name))].push_back(name);
        }
    }
    std::vector<std::string> words;
    for (const auto& [each, names] : namesByWord) {
        words.push_back(each);
    }
    std::vector<std::string> near;
    for (const std::string& asked : {toLower(word), toLower(lastPartOf(word))}) {
        const std::string found = core::nearestWord(asked, words);
        for (const std::string& name : found.empty() ? std::vector<std::string>() : namesByWord[found]) {
            if (std::ranges::find(near, name) == near.end()) {
                near.push_back(name);
            }
        }
    }
    return near.empty() ? caseSettingNames() : near;
}

/// Converts text to the type that a schema requires; unsuitable text remains a string, which the schema then rejects.
Json valueAsWanted(const std::string& text, const Json& schema)
{
    const std::string type = schema.contains("type") && schema["type"].is_string() ? schema["type"] : Json("string");
    if (type == "boolean" && (text == "on" || text == "off")) {
        return text == "on";
    }
    if (type == "string") {
        return text;
    }
    const Json parsed = Json::parse(text, nullptr, false);
    return parsed.is_discarded() ? Json(text) : parsed;
}

/// Validates a value by checking the smallest case that contains it against the schema.
core::Messages problemsOf(const std::string& name, const Json& value)
{
    Json root{{"format", "angiopose-case"}, {"version", 1}};
    root["vessel"]["centerline"]["path"] = "x";
    root["angiogram"]["image"]["path"] = "x";
    Json::json_pointer place;
    for (std::size_t begin = 0; begin <= name.size();) {
        const std::size_t end = std::min(name.find('.', begin), name.size());
        place /= name.substr(begin, end - begin);
        begin = end + 1;
    }
    root[place] = value;
    return findSchemaProblems(root.dump());
}

using Apply = std::function<void(core::Case&)>;

core::Result<Apply> optionApplier(const std::string& name, const std::string& text)
{
    const std::string assignment = name + "=" + text;
    core::RegistrationOptions tried;
    if (const auto status = core::setOption(tried, assignment); !status) {
        return status.error();
    }
    return Apply([assignment](core::Case& session) { (void)core::setOption(session.options, assignment); });
}

template <class Owner, class PartsOf>
core::Result<Apply> fieldApplier(const std::string& name, const std::string& text, const StoredFields<Owner>& fields,
                                 PartsOf partsOf)
{
    const auto field = std::ranges::find(fields, lastPartOf(name), &StoredField<Owner>::key);
    const Json value = valueAsWanted(text, field->schema);
    if (const core::Messages problems = problemsOf(name, value); !problems.empty()) {
        return core::Error(messages::settingValue(name, text.substr(0, 40), problems.front()));
    }
    return Apply([read = field->read, value, partsOf](core::Case& session) {
        for (Owner* part : partsOf(session)) {
            ReadContext reading;
            read(value, *part, reading);
        }
    });
}

core::Result<Apply> applierOf(const std::string& name, const std::string& text)
{
    if (name.starts_with(tracePrefix)) {
        return fieldApplier(name, text, traceOptionFields(), [](core::Case& session) {
            std::vector<core::TraceOptions*> parts;
            for (core::View& view : session.views) {
                parts.push_back(&view.traceOptions);
            }
            return parts;
        });
    }
    if (name.starts_with(tracingPrefix)) {
        return fieldApplier(name, text, vesselTracingFields(),
                            [](core::Case& session) { return std::vector{&session.vessels.input.tracing}; });
    }
    return optionApplier(name, text);
}

}   // namespace

std::vector<std::string> caseSettingNames()
{
    std::vector<std::string> names;
    for (const core::OptionField& field : core::optionFields()) {
        names.emplace_back(field.key);
    }
    for (const std::vector<std::string>& more :
         {namesUnder(tracePrefix, traceOptionFields()), namesUnder(tracingPrefix, vesselTracingFields())}) {
        names.insert(names.end(), more.begin(), more.end());
    }
    return names;
}

core::Status CaseSettings::add(const std::string& assignment)
{
    const std::size_t equals = assignment.find('=');
    const std::string word = assignment.substr(0, equals);
    const std::string value = equals == std::string::npos ? "" : assignment.substr(equals + 1);
    const auto name = nameLike(word);
    if (!name) {
        return core::Error(messages::settingUnknown(word.substr(0, 60), namesNear(word)));
    }
    auto apply = applierOf(*name, value);
    if (!apply) {
        return apply.error();
    }
    std::erase_if(settings_, [&](const Setting& each) { return each.name == *name; });
    settings_.push_back({*name, value, std::move(apply).value()});
    std::ranges::sort(settings_, {}, &Setting::name);
    return core::Done{};
}

core::Status CaseSettings::add(const std::vector<std::string>& assignments)
{
    for (const std::string& assignment : assignments) {
        if (auto status = add(assignment); !status) {
            return status;
        }
    }
    return core::Done{};
}

std::vector<std::string> CaseSettings::assignments() const
{
    std::vector<std::string> all;
    for (const Setting& setting : settings_) {
        all.push_back(setting.name + "=" + setting.value);
    }
    return all;
}

void CaseSettings::applyTo(core::Case& session) const
{
    for (const Setting& setting : settings_) {
        setting.apply(session);
    }
}

}   // namespace angiopose::io
