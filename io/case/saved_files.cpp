#include "io/case/saved_files.h"

#include "io/case/edited_curves.h"
#include "io/file_hash.h"
#include "io/vessel_input_file.h"

#include <memory>
#include <optional>
#include <utility>

namespace angiopose::io {

using core::RegistrationCase;

namespace {

/// So that the file is found when it moves.
void noteHash(core::InputFile& file, core::Result<std::string> hash)
{
    if (hash) {
        file.sha256 = std::move(hash).value();
    }
}

/// Of one view; for the case itself also of its vessels.
core::Status completeView(RegistrationCase& hashed, const std::string& path, std::optional<std::size_t> otherView)
{
    if (hashed.editedFrame && hashed.givenTarget) {
        auto curves = keepEditedCurves(hashed, path, otherView);
        if (!curves) {
            return curves.error();
        }
        hashed.targetFile = std::move(curves).value();
    }
    for (core::InputFile* file : {&hashed.centerlineFile, &hashed.imageFile, &hashed.targetFile}) {
        if (!file->path.empty() && file->sha256.empty()) {
            noteHash(*file, file == &hashed.centerlineFile ? sha256OfVesselInput(file->path, hashed.vesselInput)
                                                           : sha256OfFile(file->path));
        }
    }
    return core::Done{};
}

}   // namespace

core::Status completeFiles(RegistrationCase& hashed, const std::string& path)
{
    if (auto completed = completeView(hashed, path, std::nullopt); !completed) {
        return completed;
    }
    std::erase_if(hashed.otherViews,
                  [](const core::OtherView& other) { return other.file.path.empty() && !other.view; });
    for (std::size_t k = 0; k < hashed.otherViews.size(); ++k) {
        core::OtherView& other = hashed.otherViews[k];
        if (!other.file.path.empty()) {
            noteHash(other.file, sha256OfFile(other.file.path));
            continue;
        }
        RegistrationCase view = *other.view;
        if (auto completed = completeView(view, path, k); !completed) {
            return completed;
        }
        other.view = std::make_shared<const RegistrationCase>(std::move(view));
    }
    return core::Done{};
}

}   // namespace angiopose::io