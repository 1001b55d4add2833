#include "io/sharing/pack_case.h"

#include "io/case/case_file.h"
#include "io/case/deidentified_case.h"
#include "io/messages/messages.h"
#include "io/sharing/zip_archive.h"
#include "io/support/file_error.h"
#include "io/support/input_bytes.h"
#include "io/support/scratch_folder.h"

#include <cmath>
#include <filesystem>

namespace angiopose::io {
namespace {

namespace fs = std::filesystem;

constexpr double sameLength = 0.002;   ///< relative tolerance of the length of a tree traced in re-encoded voxels

double lengthMm(const core::Case& session)
{
    double sum = 0.0;
    if (session.vessels.tree) {
        for (const core::VesselBranch& branch : session.vessels.tree->branches) {
            for (std::size_t n = 1; n < branch.pointsInPatient.size(); ++n) {
                sum += (branch.pointsInPatient[n] - branch.pointsInPatient[n - 1]).norm();
            }
        }
    }
    return sum;
}

bool areSameRuns(const core::View& a, const core::View& b)
{
    if (!a.angiogram || !b.angiogram) {
        return !a.angiogram && !b.angiogram;
    }
    const auto& from = storedRunOf(a)->frames;
    const auto& to = storedRunOf(b)->frames;
    return from.size() == to.size() &&
           std::equal(from.begin(), from.end(), to.begin(),
                      [](const core::ImageF& x, const core::ImageF& y) { return x.pixels == y.pixels; });
}

/// Describes what the packed case lacks compared with the original; returns nullopt if nothing is lost.
std::optional<core::Message> difference(const core::Case& from, const core::Case& to, bool mayPixelsDiffer)
{
    if (from.views.size() != to.views.size()) {
        return messages::packedViews();
    }
    for (std::size_t k = 0; k < from.views.size(); ++k) {
        if (!mayPixelsDiffer && !areSameRuns(from.views[k], to.views[k])) {
            return messages::packedPixels();
        }
        if (from.views[k].result.has_value() != to.views[k].result.has_value()) {
            return messages::packedResults();
        }
    }
    const bool isSameTree = std::abs(lengthMm(from) - lengthMm(to)) <= sameLength * lengthMm(from);
    return isSameTree ? std::nullopt : std::optional(messages::packedVessels());
}

}   // namespace

core::Result<core::Messages> packCase(const core::Case& session, const std::string& archivePath,
                                      const CopyOptions& request, const ReadObserver& observe)
{
    if (extensionOf(archivePath) != ".zip") {
        return fileError(archivePath, messages::packedFormat());
    }
    const ScratchFolder scratch(archivePath);
    if (const auto made = scratch.make(); !made) {
        return made.error();
    }
    core::Case packed = session;
    auto copied = copyInputs(packed, scratch.path(), request, progressPart(observe, 0.0, 0.4));
    if (!copied) {
        return copied.error();
    }
    core::Messages warnings = std::move(copied).value();
    if (request.deidentification) {
        if (const std::size_t count = removeFreeText(packed); count > 0) {
            warnings.push_back(messages::textsCleared(count));
        }
    }
    const std::string packedPath = (scratch.path() / "case.angiopose").string();
    if (const auto saved = saveCase(packed, packedPath); !saved) {
        return saved.error();
    }
    core::Messages ofPacked;
    const auto reopened = loadCase(packedPath, ofPacked, progressPart(observe, 0.4, 0.95));
    if (!reopened) {
        return reopened.isStopped() ? reopened.error()
                                    : fileError(archivePath, messages::packedDiffers(reopened.error().message));
    }
    const bool mayPixelsDiffer =
        request.deidentification && request.deidentification->letters == BurnedInTextPolicy::Masked;
    if (const auto differs = difference(session, reopened.value(), mayPixelsDiffer)) {
        return fileError(archivePath, messages::packedDiffers(*differs));
    }
    const auto written = writeZip(scratch.path().string(), archivePath);
    return written ? core::Result<core::Messages>(std::move(warnings)) : written.error();
}

core::Result<core::Messages> packCaseFile(const std::string& casePath, const std::string& archivePath,
                                          const CopyOptions& request, const ReadObserver& observe)
{
    core::Messages warnings;
    const auto loaded = loadCase(casePath, warnings, progressPart(observe, 0.0, 0.4));
    if (!loaded) {
        return loaded.error();
    }
    auto packed = packCase(loaded.value(), archivePath, request, progressPart(observe, 0.4, 1.0));
    if (!packed) {
        return packed.error();
    }
    warnings.insert(warnings.end(), packed.value().begin(), packed.value().end());
    return warnings;
}

}   // namespace angiopose::io
