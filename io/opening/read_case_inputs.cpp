#include "io/opening/read_case_inputs.h"

#include "io/case/case_file.h"
#include "io/case/load_case_with_options.h"
#include "io/messages/messages.h"
#include "io/opening/open_case_with_options.h"

#include <filesystem>

namespace angiopose::io {
namespace {

namespace fs = std::filesystem;

std::string folderOf(const std::string& path)
{
    return fs::absolute(path).lexically_normal().parent_path().string();
}

/// Locates the missing inputs of a case through the hints and by a search.
core::Status findInputs(LoadedInputs& inputs, const std::string& path, const OpenHints& hints,
                        const ReadObserver& observe)
{
    auto missing = findMissingInputs(path);
    if (!missing) {
        return missing.error();
    }
    inputs.missing = std::move(missing).value();
    inputs.moved = hints.moved;
    const auto isFound = [&inputs](const MissingInput& each) { return inputs.moved.contains(each.path); };
    std::erase_if(inputs.missing, isFound);
    std::vector<std::string> folders{folderOf(path)};
    folders.insert(folders.end(), hints.searchFolders.begin(), hints.searchFolders.end());
    if (!inputs.missing.empty()) {
        inputs.moved.merge(findMovedInputs(inputs.missing, folders, observe));
        std::erase_if(inputs.missing, isFound);
    }
    if (hints.skipsOptionalInputs) {
        std::erase_if(inputs.missing, [](const MissingInput& each) { return each.isOptional; });
    }
    return core::Done{};
}

}   // namespace

namespace {

core::Result<LoadedInputs> readCaseInputsWithOptions(const CaseLoadOptions& request, const std::string& path,
                                                     const OpenHints& hints, const ReadObserver& observe)
{
    LoadedInputs inputs;
    if (const auto found = findInputs(inputs, path, hints, observe); !found) {
        return found.error();
    }
    if (!inputs.missing.empty()) {
        return inputs;
    }
    auto loaded = loadCaseWithOptions(request, path, inputs.warnings, observe, inputs.moved);
    if (!loaded) {
        return loaded.error();
    }
    for (const auto& [wanted, place] : inputs.moved) {
        inputs.warnings.push_back(messages::openMoved(fs::path(wanted).filename().string(), place));
    }
    inputs.loadedCase = std::move(loaded).value();
    return inputs;
}

}   // namespace

core::Result<LoadedInputs> readCaseInputs(const std::string& path, const OpenHints& hints, const ReadObserver& observe)
{
    return readCaseInputsWithOptions({}, path, hints, observe);
}

core::Result<core::Case> openCase(const std::string& path, core::Messages& warnings, const ReadObserver& observe)
{
    return openCaseWithOptions({}, path, warnings, observe);
}

core::Result<core::Case> openCaseWithOptions(const CaseLoadOptions& request, const std::string& path,
                                             core::Messages& warnings, const ReadObserver& observe)
{
    auto read = readCaseInputsWithOptions(request, path, {}, observe);
    if (!read) {
        return read.error();
    }
    LoadedInputs inputs = std::move(read).value();
    if (!inputs.loadedCase) {
        return loadCaseWithOptions(request, path, warnings, observe,
                                   inputs.moved);   // reports missing inputs, or opens the case without optional ones
    }
    warnings.insert(warnings.end(), inputs.warnings.begin(), inputs.warnings.end());
    return *std::move(inputs.loadedCase);
}

}   // namespace angiopose::io
