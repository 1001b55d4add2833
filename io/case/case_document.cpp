#include "io/case/case_document.h"

#include "io/case/case_file.h"
#include "io/case/fields/case_fields.h"
#include "io/case/fields/view_fields.h"
#include "io/case/result_digests.h"
#include "io/messages/messages.h"
#include "io/support/json_text.h"

#include <algorithm>
#include <utility>

namespace angiopose::io {
namespace {

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

std::string caseDocumentText(const core::Case& session, const std::filesystem::path& folder)
{
    const Json known = writeFields(session, caseFields(), folder);
    const std::string whole = withExtraKeys(withExtraKeys(known.dump(), session.shown().extraKeys), session.extraKeys);
    return prettyJson(addResultDigests(whole));
}

}   // namespace angiopose::io
