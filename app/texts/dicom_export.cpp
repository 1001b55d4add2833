#include "app/texts/dicom_export.h"

#include "app/messages/messages.h"
#include "app/texts/dicom_objects.h"
#include "core/case/case_patients.h"
#include "io/camera_pose_file.h"
#include "io/support/atomic_file.h"

#include <algorithm>
#include <array>
#include <filesystem>

namespace angiopose::app {
namespace {

namespace fs = std::filesystem;

struct KindInfo {
    DicomKind kind;
    std::string_view id;
    const char* file;
};
constexpr std::array kindTable{
    KindInfo{DicomKind::Picture, "sc", "overlay.dcm"},
    KindInfo{DicomKind::Run, "run", "overlay-run.dcm"},
    KindInfo{DicomKind::Report, "pdf", "report.dcm"},
    KindInfo{DicomKind::State, "ps", "presentation-state.dcm"},
    KindInfo{DicomKind::Registration, "reg", "registration.dcm"},
    KindInfo{DicomKind::Segmentation, "seg", "segmentation.dcm"},
    KindInfo{DicomKind::Measurements, "sr", "measurements.dcm"},
};

const KindInfo& infoOf(DicomKind kind)
{
    return kindTable[static_cast<std::size_t>(kind)];
}

/// Contents of a file that is ready to be written.
struct CreatedFile {
    fs::path path;
    std::string content;
};

core::Error stoppedExport()
{
    return core::Error(core::Cancellation{messages::dicomStopped()});
}

std::vector<DicomKind> kindsOf(const DicomExport& dicomExport)
{
    std::vector<DicomKind> kinds = dicomExport.kinds;
    if (kinds.empty()) {
        std::ranges::transform(kindTable, std::back_inserter(kinds), &KindInfo::kind);
    }
    return kinds;
}

core::Result<DicomExportInput> collectExportInput(const core::Case& session, const core::Centerline2d& target,
                                                  const DicomExport& dicomExport, DicomFiles& files)
{
    auto angiogram = io::readSourceImage(session.shown().imageFile.path);
    if (!angiogram) {
        return angiogram.error();
    }
    if (!angiogram.value().isDicom) {
        files.notes.push_back(messages::dicomNewStudy());
    }
    for (const core::Message& mismatch : core::findMismatch(session)) {
        files.notes.push_back(mismatch);
    }
    return DicomExportInput{session,
                            target,
                            dicomExport,
                            std::move(angiogram).value(),
                            scanReferenceOf(session.vessels),
                            io::makeOrigin(dicomExport.author),
                            {}};
}

/// Returns whether the case allows this kind; a single frame gets no cine object, because the image object shows it.
bool isOffered(DicomKind kind, const DicomExportInput& exportInput)
{
    return kind != DicomKind::Run || exportInput.session.shown().angiogram->frameCount() > 1;
}

core::Result<std::vector<CreatedFile>> madeObjects(DicomExportInput& exportInput, const fs::path& folder,
                                                   DicomFiles& files, const DicomObserver& observe)
{
    const std::vector<DicomKind> kinds = kindsOf(exportInput.dicomExport);
    std::vector<CreatedFile> made;
    for (std::size_t i = 0; i < kinds.size(); ++i) {
        exportInput.shouldContinue = [&observe, i, count = kinds.size()](double fraction) {
            return observe ? observe((static_cast<double>(i) + fraction) / static_cast<double>(count))
                           : core::ObserverDecision::Continue;
        };
        if (exportInput.shouldContinue(0.0) == core::ObserverDecision::Stop) {
            return stoppedExport();
        }
        if (exportInput.dicomExport.kinds.empty() && !isOffered(kinds[i], exportInput)) {
            continue;
        }
        auto content = dicomObject(kinds[i], exportInput, files.notes);
        if (content) {
            made.push_back({folder / infoOf(kinds[i]).file, std::move(content).value()});
        } else if (!exportInput.dicomExport.kinds.empty() || content.isStopped()) {
            return content.error();
        } else {
            files.notes.push_back(messages::dicomLeftOut(infoOf(kinds[i]).file, content.error().message));
        }
    }
    return made;
}

/// Adds the camera as a file next to the registration object, because no DICOM object can hold it.
void addCameraFile(std::vector<CreatedFile>& made, const core::View& view, const fs::path& folder)
{
    const auto isRegistration = [](const CreatedFile& file) {
        return file.path.filename() == infoOf(DicomKind::Registration).file;
    };
    const auto camera = core::cameraOf(view);
    if (camera && std::ranges::any_of(made, isRegistration)) {
        made.push_back({folder / "camera.json", io::cameraPoseText(view.cameraFromPatient, camera.value())});
    }
}

core::Status writeAll(const std::vector<CreatedFile>& made, const fs::path& folder, DicomFiles& files)
{
    std::error_code failed;
    fs::create_directories(folder, failed);
    for (const CreatedFile& file : made) {
        if (auto written = io::writeAtomically(file.path.string(), file.content); !written) {
            return written;
        }
        files.paths.push_back(file.path.string());
    }
    return core::Done{};
}

}   // namespace

std::string_view idOf(DicomKind kind)
{
    return infoOf(kind).id;
}

std::string dicomKindIds()
{
    std::string ids;
    for (const KindInfo& info : kindTable) {
        ids += (ids.empty() ? "" : ", ") + std::string(info.id);
    }
    return ids;
}

std::optional<DicomKind> parseDicomKind(std::string_view id)
{
    const auto found = std::ranges::find(kindTable, id, &KindInfo::id);
    return found == kindTable.end() ? std::nullopt : std::optional(found->kind);
}

core::Result<DicomFiles> writeDicomObjects(const core::Case& session, const core::Centerline2d& target,
                                           const DicomExport& dicomExport, const std::string& folder,
                                           const DicomObserver& observe)
{
    if (!session.vessels.tree || !session.shown().angiogram || session.shown().angiogram->frames.empty()) {
        return core::Error(messages::dicomNothing());
    }
    DicomFiles files;
    auto exportInput = collectExportInput(session, target, dicomExport, files);
    if (!exportInput) {
        return exportInput.error();
    }
    DicomExportInput kept = std::move(exportInput).value();
    auto made = madeObjects(kept, folder, files, observe);
    if (!made) {
        return made.error();
    }
    std::vector<CreatedFile> ready = std::move(made).value();
    addCameraFile(ready, session.shown(), folder);
    if (observe && observe(1.0) == core::ObserverDecision::Stop) {
        return stoppedExport();
    }
    if (auto written = writeAll(ready, folder, files); !written) {
        return written.error();
    }
    return files;
}

}   // namespace angiopose::app
