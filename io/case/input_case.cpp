#include "io/case/input_case.h"

#include "core/messages/messages.h"
#include "io/case/case_document.h"

#include <algorithm>
#include <exception>
#include <filesystem>
#include <set>
#include <utility>
#include <vector>

namespace angiopose::io {
namespace {

namespace fs = std::filesystem;

const fs::path placeOfInputs =
    "/angiopose-inputs";   // folder that does not exist, used because actual folder names may identify patients

fs::path baseName(const fs::path& path)
{
    return path.has_filename() ? path.filename() : path.parent_path().filename();
}

/// Replaces the folders of all input paths; files with the same name stay distinct, for example "2/IM1.dcm".
void replaceFolders(core::Case& session)
{
    std::vector<core::InputFile*> files{&session.vessels.file, &session.vessels.scanFile};
    for (core::View& view : session.views) {
        files.insert(files.end(), {&view.imageFile, &view.target.file});
    }
    std::set<fs::path> taken;
    for (core::InputFile* file : files) {
        if (file->path.empty()) {
            continue;
        }
        fs::path place = placeOfInputs / baseName(file->path);
        for (int number = 2; !taken.insert(place).second; ++number) {
            place = placeOfInputs / std::to_string(number) / baseName(file->path);
        }
        file->path = place.string();
    }
}

void keepOnlyWhatIsAsked(core::View& view)
{
    view.caseFile = {};   // the view is stored in this case, not in a case file of its own
    view.result.reset();
    view.followed = {};
    view.snapshots.clear();
    view.measurements.clear();
    view.observations.clear();
    view.annotations.clear();
    view.extraKeys.clear();
}

bool hasEstimatedGeometry(const core::RegistrationResult& result)
{
    return std::ranges::any_of(
        result.warnings, [](const core::Message& warning) { return warning.is(core::messages::cameraEstimated); });
}

}   // namespace

std::string inputCaseJson(const core::Case& asked)
{
    core::Case bare = asked;
    bare.extraKeys.clear();
    bare.vessels.marks.clear();
    bare.vessels.measurements.clear();
    for (core::View& view : bare.views) {
        keepOnlyWhatIsAsked(view);
    }
    try {
        replaceFolders(bare);
        return caseDocumentJson(bare, placeOfInputs);
    } catch (const std::exception&) {   // file names may not be UTF-8
        return {};
    }
}

std::string inputCaseJson(const core::RegisteredCase& registered)
{
    return registered.asked ? inputCaseJson(*registered.asked) : std::string();
}

core::Case keepJointlyRegisteredViews(core::Case session)
{
    const core::Provenance run = session.shown().result->provenance;
    const auto isOfRun = [&run](const core::View& view) {
        return view.result && !run.time.empty() && view.result->provenance.time == run.time &&
               view.result->provenance.author == run.author;
    };
    std::vector<core::View> views;
    std::size_t shown = 0;
    for (std::size_t i = 0; i < session.views.size(); ++i) {
        if (i == session.shownView) {
            shown = views.size();
        }
        if (i == session.shownView || isOfRun(session.views[i])) {
            views.push_back(std::move(session.views[i]));
        }
    }
    session.views = std::move(views);
    session.shownView = shown;
    return session;
}

std::string inputCaseJsonFromResult(core::Case jointViews)
{
    jointViews.options = jointViews.shown().result->provenance.options;
    jointViews.options.method =
        jointViews.shown().result->method;   // a case stores the method separately from the options
    for (core::View& view : jointViews.views) {
        const core::RegistrationResult& result = *view.result;
        if (!result.provenance.start || hasEstimatedGeometry(result)) {
            return {};
        }
        view.cameraFromPatient = *result.provenance.start;
        view.frame = result.provenance.frame.value_or(view.frame);
    }
    return inputCaseJson(jointViews);
}

}   // namespace angiopose::io
