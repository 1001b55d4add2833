#include "io/opening/open_result.h"

#include "core/case/case_views.h"
#include "io/case/fields/deformation_fields.h"
#include "io/case/fields/geometry_fields.h"
#include "io/case/fields/result_fields.h"
#include "io/case/load_case_with_options.h"
#include "io/messages/messages.h"
#include "io/support/file_error.h"
#include "io/support/input_bytes.h"

#include <exception>
#include <filesystem>
#include <utility>

namespace angiopose::io {
namespace {

namespace fs = std::filesystem;

core::Result<Json> readResultJson(const std::string& path)
{
    const auto input = openInput(path);
    if (!input) {
        return input.error();
    }
    if (const auto valid = checkJson(input.value().view(), path); !valid) {
        return valid.error();
    }
    Json root = Json::parse(input.value().view());
    const Json format = root.is_object() ? root.value("format", Json()) : Json();
    if (format != "angiopose-result" && format != "angiopose-joint-result") {
        return fileError(path, messages::resultNotOne());
    }
    if (!root.contains("case")) {
        return fileError(path, messages::resultWithoutCase());
    }
    return root;
}

/// Finds the inputs of a result by name and SHA-256. Fails and names the file if an input is missing.
core::Result<MovedInputs> locateInputs(const std::vector<core::InputFile>& files, const ResultLocation& location,
                                       const ReadObserver& observe)
{
    std::vector<MissingInput> wanted;
    for (const core::InputFile& file : files) {
        wanted.push_back({file.path, file.sha256, false});
    }
    std::vector<std::string> folders{fs::absolute(location.path).parent_path().string()};
    folders.insert(folders.end(), location.inputFolders.begin(), location.inputFolders.end());
    MovedInputs found = findMovedInputs(wanted, folders, observe);
    for (const MissingInput& each : wanted) {
        if (!found.contains(each.path)) {
            const std::string name = fs::path(each.path).filename().string();
            return fileError(location.path, messages::resultInputMissing(name, each.sha256));
        }
    }
    return found;
}

/// Checks the SHA-256 of the loaded inputs, because the search compares folders only by name.
core::Status checkContents(const std::vector<core::InputFile>& wanted, const MovedInputs& places,
                           const core::Case& loaded, const std::string& path)
{
    for (const core::InputFile& file : inputFilesOf(loaded)) {
        for (const core::InputFile& each : wanted) {
            const auto found = places.find(each.path);
            const bool isSame = found != places.end() && found->second == file.path;
            if (isSame && !each.sha256.empty() && each.sha256 != file.sha256) {
                return fileError(path, messages::resultInputChanged(fs::path(file.path).filename().string()));
            }
        }
    }
    return core::Done{};
}

core::Result<core::Case> loadInputCase(const Json& root, const ResultLocation& location, core::Messages& warnings,
                                       const ReadObserver& observe)
{
    CaseLoadOptions request;
    request.text = root.at("case").dump();
    request.peak = PeakFrameSearch::Skipped;
    const std::vector<core::InputFile> wanted = referencedFiles(*request.text, location.path);
    const auto places = locateInputs(wanted, location, observe);
    if (!places) {
        return places.error();
    }
    auto loaded = loadCaseWithOptions(request, location.path, warnings, observe, places.value());
    if (!loaded) {
        return loaded;
    }
    if (const auto checked = checkContents(wanted, places.value(), loaded.value(), location.path); !checked) {
        return checked.error();
    }
    return loaded;
}

/// Copies the registration result of a view from the JSON to that view.
core::Messages applyResult(core::View& view, const Json& json)
{
    ReadContext reading;
    core::RegistrationResult result;
    readFields(json, result, resultFields(), reading);
    if (json.contains("bent")) {
        deformationField().read(json.at("bent"), result, reading);
    }
    result.provenance.frame = json.at("inputs").value("frame", view.frame);
    core::ViewGeometry geometry;
    readFields(json.at("geometry"), geometry, geometryFields(), reading);
    view.geometry = geometry;
    view.cameraFromPatient = result.cameraFromPatient;
    view.result = std::move(result);
    return reading.problems;
}

}   // namespace

core::Result<core::Case> openInputCase(const ResultLocation& location, core::Messages& warnings,
                                       const ReadObserver& observe)
{
    const auto root = readResultJson(location.path);
    return root ? loadInputCase(root.value(), location, warnings, observe) : core::Result<core::Case>(root.error());
}

core::Result<core::Case> openResultCase(const ResultLocation& location, core::Messages& warnings,
                                        const ReadObserver& observe)
{
    const auto root = readResultJson(location.path);
    if (!root) {
        return root.error();
    }
    auto loaded = loadInputCase(root.value(), location, warnings, observe);
    if (!loaded) {
        return loaded;
    }
    core::Case session = std::move(loaded).value();
    try {
        const Json results = root.value().contains("views") ? root.value()["views"] : Json::array({root.value()});
        const std::size_t first = results.at(0).at("view").get<std::size_t>() - 1;
        for (const Json& each : results) {
            core::Messages problems = applyResult(session.views.at(each.at("view").get<std::size_t>() - 1), each);
            if (!problems.empty()) {
                return fileError(location.path, problems.front());
            }
        }
        return core::withShownView(std::move(session), first);
    } catch (const std::exception&) {   // a value has the wrong type
        return fileError(location.path, messages::resultNotOne());
    }
}

}   // namespace angiopose::io
