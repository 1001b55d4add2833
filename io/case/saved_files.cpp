#include "io/case/saved_files.h"

#include "io/case/tracked_deformations_file.h"
#include "io/edited_curves.h"
#include "io/edited_mask.h"
#include "io/file_hash.h"
#include "io/vessel_input_file.h"

#include <algorithm>
#include <optional>
#include <utility>

namespace angiopose::io {

namespace {

/// Stores the hash, which identifies the file after it has been moved.
void storeHash(core::InputFile& file, core::Result<std::string> hash)
{
    if (hash) {
        file.sha256 = std::move(hash).value();
    }
}

void storeMissingHash(core::InputFile& file)
{
    if (!file.path.empty() && file.sha256.empty()) {
        storeHash(file, sha256OfFile(file.path));
    }
}

core::Status completeView(core::View& view, const std::string& path, std::optional<std::size_t> otherView)
{
    if (view.target.editedFrame && view.target.centerline) {
        auto curves = saveEditedCurves(view.target, path, otherView);
        if (!curves) {
            return curves.error();
        }
        view.target.file = std::move(curves).value();
    }
    auto deformations = saveTrackedDeformations(view.followed, path, otherView);
    if (!deformations) {
        return deformations.error();
    }
    view.followed.deformationsFile = std::move(deformations).value();
    storeMissingHash(view.imageFile);
    storeMissingHash(view.target.file);
    return core::Done{};
}

/// Returns whether a view has neither a case file nor an image.
bool isBlank(const core::View& view)
{
    return view.caseFile.path.empty() && view.imageFile.path.empty();
}

}   // namespace

core::Status writeCompanionFiles(core::Case& savedCase, const std::string& path)
{
    core::Vessels& vessels = savedCase.vessels;
    if (vessels.isLumenEdited) {
        auto mask = saveEditedMask(vessels, path);
        if (!mask) {
            return mask.error();
        }
        vessels.file = std::move(mask).value();
    }
    if (!vessels.file.path.empty() && vessels.file.sha256.empty()) {
        storeHash(vessels.file, sha256OfVesselInput(vessels.file.path, vessels.input));
    }
    core::View shown = savedCase.shown();
    if (auto completed = completeView(shown, path, std::nullopt); !completed) {
        return completed;
    }
    const auto before = savedCase.views.begin() + static_cast<std::ptrdiff_t>(savedCase.shownView);
    const auto place = std::count_if(savedCase.views.begin(), before, [](const auto& view) { return !isBlank(view); });
    savedCase.views.erase(savedCase.views.begin() + static_cast<std::ptrdiff_t>(savedCase.shownView));
    std::erase_if(savedCase.views, isBlank);
    for (std::size_t k = 0; k < savedCase.views.size(); ++k) {
        core::View& view = savedCase.views[k];
        if (!view.caseFile.path.empty()) {
            storeHash(view.caseFile, sha256OfFile(view.caseFile.path));
        } else if (auto completed = completeView(view, path, k); !completed) {
            return completed;
        }
    }
    savedCase.views.insert(savedCase.views.begin() + place, std::move(shown));
    savedCase.shownView = static_cast<std::size_t>(place);
    return core::Done{};
}

}   // namespace angiopose::io
