#include "io/result_file.h"

#include "core/case/case_patients.h"
#include "io/case/fields/result_fields.h"
#include "io/support/atomic_file.h"
#include "io/support/file_error.h"
#include "io/support/json_text.h"
#include "io/support/message_json.h"

#include <exception>
#include <filesystem>
#include <nlohmann/json.hpp>

namespace angiopose::io {
namespace {

using Json = nlohmann::ordered_json;

/// What the tree calls its branches stands beside their ids.
void nameBranches(Json& branches, const core::Case& theCase)
{
    for (Json& branch : branches) {
        const core::VesselBranch* known =
            theCase.vessels.tree ? theCase.vessels.tree->find(branch.at("branch").get<int>()) : nullptr;
        if (known && !known->name.empty()) {
            branch["name"] = known->name;
        }
    }
}

/// File names only: results are passed around, and folders may name patients.
Json inputsJson(const core::Case& theCase)
{
    Json inputs = Json::object();
    const auto add = [&](const char* key, const core::InputFile& file) {
        if (!file.path.empty()) {
            inputs[key] = {{"file", std::filesystem::path(file.path).filename().string()}, {"sha256", file.sha256}};
        }
    };
    add("vessel", theCase.vessels.file);
    add("angiogram", theCase.shown().imageFile);
    add("centerline", theCase.shown().target.file);
    inputs["frame"] = theCase.shown().frame;
    return inputs;
}

}   // namespace

std::string resultJson(const core::Case& theCase, const core::RegistrationResult& result)
{
    Json root;
    root["format"] = "angiopose-result";
    root["version"] = 1;
    root["title"] = theCase.title;
    root.update(writeFields(result, resultFields(), {}));
    for (const char* list : {"perBranch", "alternatives"}) {   // there even where they are empty
        if (!root.contains(list)) {
            root[list] = Json::array();
        }
    }
    if (!root.contains("programVersion")) {
        root["programVersion"] = ANGIOPOSE_VERSION;
    }
    nameBranches(root["perBranch"], theCase);
    root["warnings"] = sentencesOf(result.warnings);
    root["inputs"] = inputsJson(theCase);
    if (const core::Messages mismatch = core::findMismatch(theCase); !mismatch.empty()) {
        root["inputs"]["mismatch"] = sentencesOf(mismatch);
    }
    // File names and titles need not be UTF-8; the result must be written all the same.
    return prettyJson(root.dump(-1, ' ', false, Json::error_handler_t::replace));
}

core::Status writeResult(const core::Case& theCase, const core::RegistrationResult& result, const std::string& path)
{
    return writeAtomically(path, resultJson(theCase, result));
}

}   // namespace angiopose::io