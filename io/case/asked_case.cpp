#include "io/case/asked_case.h"

#include "io/case/case_document.h"

#include <exception>
#include <filesystem>
#include <set>
#include <vector>

namespace angiopose::io {
namespace {

namespace fs = std::filesystem;

const fs::path placeOfInputs = "/angiopose-inputs";   // nowhere: folders may name patients

fs::path nameAlone(const fs::path& path)
{
    return path.has_filename() ? path.filename() : path.parent_path().filename();
}

/// Two files of one name stay two: "2/IM1.dcm".
void forgetFolders(core::Case& theCase)
{
    std::vector<core::InputFile*> files{&theCase.vessels.file, &theCase.vessels.scanFile};
    for (core::View& view : theCase.views) {
        files.insert(files.end(), {&view.imageFile, &view.target.file});
    }
    std::set<fs::path> taken;
    for (core::InputFile* file : files) {
        if (file->path.empty()) {
            continue;
        }
        fs::path place = placeOfInputs / nameAlone(file->path);
        for (int number = 2; !taken.insert(place).second; ++number) {
            place = placeOfInputs / std::to_string(number) / nameAlone(file->path);
        }
        file->path = place.string();
    }
}

void keepOnlyWhatIsAsked(core::View& view)
{
    view.caseFile = {};   // it stands here
    view.result.reset();
    view.followed = {};
    view.snapshots.clear();
    view.measurements.clear();
    view.sightings.clear();
    view.annotations.clear();
    view.extraKeys.clear();
}

}   // namespace

std::string askedCaseText(const core::Case& asked)
{
    core::Case bare = asked;
    bare.extraKeys.clear();
    bare.vessels.marks.clear();
    bare.vessels.measurements.clear();
    for (core::View& view : bare.views) {
        keepOnlyWhatIsAsked(view);
    }
    try {
        forgetFolders(bare);
        return caseDocumentText(bare, placeOfInputs);
    } catch (const std::exception&) {   // names need not be UTF-8
        return {};
    }
}

ResultOrigin originOf(const core::RegisteredCase& registered)
{
    if (!registered.asked) {
        return {};
    }
    return {registered.asked.get(), askedCaseText(*registered.asked)};
}

}   // namespace angiopose::io
