#include "io/case/case_document.h"

#include "core/support/message.h"
#include "io/case/case_file.h"
#include "io/case/fields/case_fields.h"
#include "io/case/fields/view_fields.h"
#include "io/file_hash.h"
#include "io/messages/messages.h"
#include "io/support/json_text.h"

#include <algorithm>
#include <array>
#include <initializer_list>
#include <nlohmann/json.hpp>
#include <utility>

namespace angiopose::io {
namespace {

/// Names of the parts of the file that have changed since a result was saved; empty if nothing has changed or the file
/// has no digests.
struct ChangedParts {
    core::Messages sinceResult;
    core::Messages sinceTracking;
};

constexpr const char* sealKey = "savedWith";
constexpr const char* resultKey = "result";
constexpr const char* trackingKey = "followed";
constexpr std::array sealedKeys{
    resultKey, trackingKey};   // the results have their own digests, because a file may keep an older result
constexpr std::size_t digestLength = 16;

/// Returns the member of `json` at the path `keys`; null if the member is absent.
Json memberAt(const Json& json, std::initializer_list<const char*> keys)
{
    const Json* found = &json;
    for (const char* key : keys) {
        const auto member = found->find(key);
        if (member == found->end()) {
            return {};
        }
        found = &*member;
    }
    return *found;
}

Json withoutMembers(Json json, std::initializer_list<const char*> keys)
{
    for (const char* key : keys) {
        if (json.is_object()) {
            json.erase(key);
        }
    }
    return json;
}

/// Returns the canonical form of a JSON value: keys are sorted, numbers are doubles, and file paths are omitted because
/// the location of a file does not affect its contents.
nlohmann::json canonicalJson(const Json& json)
{
    if (json.is_number()) {
        return json.get<double>();
    }
    if (!json.is_structured()) {
        return nlohmann::json::parse(json.dump());
    }
    nlohmann::json same = json.is_object() ? nlohmann::json::object() : nlohmann::json::array();
    for (const auto& item : json.items()) {
        if (json.is_array()) {
            same.push_back(canonicalJson(item.value()));
        } else if (item.key() != "path") {
            same[item.key()] = canonicalJson(item.value());
        }
    }
    return same;
}

std::string partDigest(const Json& json)
{
    const auto hash = sha256OfText(canonicalJson(json).dump());
    return hash ? hash.value().substr(0, digestLength) : std::string();
}

/// Part of a case on which a result depends.
struct ResultDependency {
    const char* key;
    core::Message name;
    Json (*of)(const Json& session, const Json& view);
};

const auto& resultDependencies()
{
    static const std::array parts{
        ResultDependency{"vessels", messages::partVessels(),
                         [](const Json& session, const Json&) {
                             return withoutMembers(
                                 memberAt(session, {"vessel"}),
                                 {"auxiliaryBranches", "excludedBranches", "hiddenBranches", "pivotInPatientMm"});
                         }},
        ResultDependency{"auxiliaryBranches", messages::partAuxiliaryBranches(),
                         [](const Json& session, const Json&) {
                             return memberAt(session, {"vessel", "auxiliaryBranches"});
                         }},
        ResultDependency{"excludedBranches", messages::partExcludedBranches(),
                         [](const Json& session, const Json&) {
                             return memberAt(session, {"vessel", "excludedBranches"});
                         }},
        ResultDependency{"image", messages::partImage(),
                         [](const Json&, const Json& view) {
                             return memberAt(view, {"angiogram", "image"});
                         }},
        ResultDependency{"frame", messages::partFrame(),
                         [](const Json&, const Json& view) {
                             return memberAt(view, {"angiogram", "frame"});
                         }},
        ResultDependency{"subtraction", messages::partSubtraction(),
                         [](const Json&, const Json& view) {
                             return memberAt(view, {"angiogram", "subtraction"});
                         }},
        ResultDependency{
            "curves", messages::partCurves(),
            [](const Json&, const Json& view) {
                return Json{memberAt(view, {"angiogram", "centerline"}), memberAt(view, {"angiogram", "trace"})};
            }},
        ResultDependency{"geometry", messages::partGeometry(),
                         [](const Json&, const Json& view) { return memberAt(view, {"geometry"}); }},
        ResultDependency{"start", messages::partInitialPose(),
                         [](const Json&, const Json& view) {
                             return memberAt(view, {"pose", "initial"});
                         }},
        ResultDependency{
            "locks", messages::partLocks(),
            [](const Json& session, const Json&) {
                return Json{memberAt(session, {"pose", "locked"}), memberAt(session, {"vessel", "pivotInPatientMm"})};
            }},
        ResultDependency{"method", messages::partMethod(),
                         [](const Json& session, const Json&) { return memberAt(session, {"method"}); }},
        ResultDependency{"options", messages::partOptions(),
                         [](const Json& session, const Json&) { return memberAt(session, {"options"}); }},
    };
    return parts;
}

void sealFindingsOf(const Json& session, Json& view)
{
    if (std::ranges::none_of(sealedKeys, [&view](const char* key) { return view.contains(key); })) {
        return;
    }
    Json digests = Json::object();
    for (const ResultDependency& part : resultDependencies()) {
        digests[part.key] = partDigest(part.of(session, view));
    }
    for (const char* key : sealedKeys) {
        if (const auto finding = view.find(key); finding != view.end()) {
            (*finding)[sealKey] = digests;
        }
    }
}

core::Messages findChangedParts(const char* finding, const Json& session, const Json& view)
{
    const Json digests = memberAt(view, {finding, sealKey});
    core::Messages changed;
    for (const ResultDependency& part : resultDependencies()) {
        const auto digest = digests.find(part.key);
        if (digest != digests.end() && *digest != partDigest(part.of(session, view))) {
            changed.push_back(part.name);
        }
    }
    return changed;
}

/// Adds to every result and tracking result in a case's JSON the digests of the data on which it depends (FORMATS
/// §2.9): vessels, image, curves, geometry, initial pose, locks, method and options.
std::string addResultDigests(std::string_view caseJson)
{
    const Json session = Json::parse(caseJson);
    Json sealed = session;
    sealFindingsOf(session, sealed);
    if (const auto views = sealed.find("views"); views != sealed.end()) {
        for (Json& view : *views) {
            sealFindingsOf(session, view);
        }
    }
    return sealed.dump();
}

/// Returns the changed parts of each view: first the view stored in the case itself, then those of `views`.
std::vector<ChangedParts> findChangesSinceResults(std::string_view caseJson)
{
    const Json session = Json::parse(caseJson);
    const auto besideFindings = [&session](const Json& view) {
        return ChangedParts{findChangedParts(resultKey, session, view), findChangedParts(trackingKey, session, view)};
    };
    std::vector<ChangedParts> changed{besideFindings(session)};
    for (const Json& view : memberAt(session, {"views"})) {
        changed.push_back(besideFindings(view));
    }
    return changed;
}

/// Stores the keys unknown to this version in the view to which they belong.
void readUnknown(const Json& root, core::Case& values)
{
    const std::string unknown = unknownKeys(root.dump(), knownCaseKeys(values.vessels.input.kind).dump());
    Json ofCase = unknown.empty() ? Json::object() : Json::parse(unknown);
    Json ofView = Json::object();
    for (const StoredField<core::View>& field : viewFields()) {
        if (const auto found = ofCase.find(field.key); found != ofCase.end()) {
            ofView[field.key] = *found;
            ofCase.erase(field.key);
        }
    }
    values.extraKeys = ofCase.empty() ? std::string() : ofCase.dump();
    values.shown().extraKeys = ofView.empty() ? std::string() : ofView.dump();
}

}   // namespace

const std::string& caseSchema()
{
    return caseSchemaText();
}

CaseDocument parseCaseDocument(std::string_view json)
{
    const Json root = Json::parse(json);
    CaseDocument document;
    if (root["version"].get<double>() > 1.0) {
        document.problems.push_back(messages::caseNewer().about("version"));
        return document;
    }
    ReadContext reading;
    readFields(root, document.values, caseFields(), reading);
    readUnknown(root, document.values);
    document.notes = std::move(reading.otherViews);
    document.notes.insert(document.notes.begin(), std::move(reading.view));
    std::vector<ChangedParts> changed = findChangesSinceResults(json);
    for (std::size_t k = 0; k < document.notes.size(); ++k) {
        document.notes[k].changedSinceResult = std::move(changed[k].sinceResult);
        document.notes[k].changedSinceTracking = std::move(changed[k].sinceTracking);
    }
    document.shownViewIndex = std::min(reading.shownViewIndex, document.values.views.size() - 1);
    document.problems = std::move(reading.problems);
    return document;
}

std::string caseDocumentJson(const core::Case& session, const std::filesystem::path& folder)
{
    const Json known = writeFields(session, caseFields(), folder);
    const std::string whole = withExtraKeys(withExtraKeys(known.dump(), session.shown().extraKeys), session.extraKeys);
    return prettyJson(addResultDigests(whole));
}

}   // namespace angiopose::io
