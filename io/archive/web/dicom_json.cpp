#include "io/archive/web/dicom_json.h"

#include "io/messages/messages.h"
#include "io/support/json_text.h"

#include <nlohmann/json.hpp>

namespace angiopose::io {
namespace {

using Json = nlohmann::json;

/// Returns the values of an element; returns an empty array if the element is absent or empty.
Json valuesOf(const Json& set, const char* tag)
{
    const auto element = set.find(tag);
    if (element == set.end() || !element->is_object()) {
        return Json::array();
    }
    const auto values = element->find("Value");
    return values != element->end() && values->is_array() ? *values : Json::array();
}

std::string textOf(const Json& value)
{
    if (value.is_string()) {
        return value.get<std::string>();
    }
    if (value.is_number_integer()) {
        return std::to_string(value.get<long>());
    }
    if (value.is_object()) {   // person name (VR PN)
        const auto name = value.find("Alphabetic");
        return name != value.end() && name->is_string() ? name->get<std::string>() : std::string();
    }
    return {};
}

std::string textOf(const Json& set, const char* tag)
{
    std::string text;
    for (const Json& value : valuesOf(set, tag)) {
        text += (text.empty() ? "" : "\\") + textOf(value);
    }
    return text;
}

int numberOf(const Json& set, const char* tag)
{
    const Json values = valuesOf(set, tag);
    if (values.empty()) {
        return 0;
    }
    const Json& value = values.front();
    if (value.is_number()) {
        const double number = value.get<double>();
        return number >= 0.0 && number < 1e9 ? static_cast<int>(number) : 0;
    }
    return value.is_string() ? std::atoi(value.get<std::string>().c_str()) : 0;
}

core::Result<Json> parsedSets(const std::string& json)
{
    if (json.empty()) {   // the body is empty if the status is "204 No Content"
        return Json::array();
    }
    if (!checkJson(json, "")) {
        return core::Error(messages::archiveNonsense("JSON"));
    }
    Json parsed = Json::parse(json, nullptr, false);
    const bool areSets =
        parsed.is_array() && std::ranges::all_of(parsed, [](const Json& set) { return set.is_object(); });
    return areSets ? core::Result<Json>(std::move(parsed)) : core::Error(messages::archiveNonsense("JSON"));
}

ArchiveMatch matchOf(const Json& set)
{
    ArchiveMatch match;
    match.patientName = textOf(set, "00100010");
    match.patientId = textOf(set, "00100020");
    match.birthDate = textOf(set, "00100030");
    match.studyUid = textOf(set, "0020000D");
    match.studyDate = textOf(set, "00080020");
    match.studyTime = textOf(set, "00080030");
    match.studyDescription = textOf(set, "00081030");
    match.accessionNumber = textOf(set, "00080050");
    match.seriesUid = textOf(set, "0020000E");
    match.seriesDescription = textOf(set, "0008103E");
    match.bodyPart = textOf(set, "00180015");
    match.seriesNumber = numberOf(set, "00200011");
    const bool isSeries = !match.seriesUid.empty();
    match.modalities = textOf(set, isSeries ? "00080060" : "00080061");
    match.objects = numberOf(set, isSeries ? "00201209" : "00201208");
    return match;
}

}   // namespace

core::Result<std::vector<ArchiveMatch>> parseMatches(const std::string& json)
{
    const auto sets = parsedSets(json);
    if (!sets) {
        return sets.error();
    }
    std::vector<ArchiveMatch> matches;
    for (const Json& set : sets.value()) {
        matches.push_back(matchOf(set));
    }
    return matches;
}

core::Result<std::vector<ArchiveObject>> parseObjects(const std::string& json)
{
    const auto sets = parsedSets(json);
    if (!sets) {
        return sets.error();
    }
    std::vector<ArchiveObject> objects;
    for (const Json& set : sets.value()) {
        objects.push_back({textOf(set, "00080016"), textOf(set, "00080018")});
    }
    return objects;
}

StoreResult parseStoreResult(const std::string& json)
{
    const Json parsed = checkJson(json, "") ? Json::parse(json, nullptr, false) : Json();
    StoreResult answer;
    if (!parsed.is_object()) {
        return answer;
    }
    const Json failed = valuesOf(parsed, "00081198");
    answer.failure = failed.empty() || !failed.front().is_object() ? 0 : numberOf(failed.front(), "00081197");
    answer.isStored = failed.empty() && !valuesOf(parsed, "00081199").empty();
    return answer;
}

}   // namespace angiopose::io
