#include "io/sharing/copied_inputs.h"

#include "io/angiogram_file.h"
#include "io/centerline2d_file.h"
#include "io/deidentify_file.h"
#include "io/dicom/dicom_file.h"
#include "io/dicom_series.h"
#include "io/label_list.h"
#include "io/messages/messages.h"
#include "io/support/file_error.h"
#include "io/support/input_bytes.h"
#include "io/surface_file.h"
#include "io/vessel_tree_file.h"
#include "io/volume_file.h"

#include <algorithm>
#include <set>
#include <string>
#include <vector>

namespace angiopose::io {
namespace {

namespace fs = std::filesystem;
using core::VesselInputKind;

core::Status copied(const fs::path& from, const fs::path& to)
{
    std::error_code failed;
    fs::create_directories(to.parent_path(), failed);
    fs::copy_file(from, to, failed);
    return failed ? core::Status(fileError(from.string(), messages::fileNotRead(failed.message()))) : core::Done{};
}

/// Returns the files of a series and of other volumes with the same UID, which are all needed to separate the volumes.
std::vector<std::string> seriesFiles(const std::vector<DicomSeries>& all, const DicomSeries& wanted)
{
    std::set<std::string> files;
    const std::string uid = wanted.id.substr(0, wanted.id.find('#'));
    for (const DicomSeries& series : all) {
        if (series.id.substr(0, series.id.find('#')) == uid) {
            for (const SliceRecord& slice : series.slices) {
                files.insert(slice.path);
            }
        }
    }
    return {files.begin(), files.end()};
}

class InputCopier {
public:
    InputCopier(const fs::path& folder, const CopyOptions& request, const ReadObserver& observe)
        : folder_(folder), request_(request), observe_(observe)
    {
    }

    core::Status copyVessels(core::Vessels& vessels)
    {
        if (!vessels.file.path.empty() && !vessels.isLumenEdited) {   // saving writes an edited mask
            if (const auto done = copyVesselFile(vessels); !done) {
                return done;
            }
        }
        vessels.file.sha256.clear();
        if (vessels.scanFile.path.empty()) {
            return core::Done{};
        }
        const auto scan = copyVolume(vessels.scanFile.path, "scan", vessels.scanSeriesId);
        if (!scan && !scan.isStopped()) {   // the scan is optional
            warnings_.push_back(messages::packedInputMissing(scan.error().message.text()));
            vessels.scanFile = {};
            vessels.scanSeriesId.clear();
            return core::Done{};
        }
        return scan ? named(vessels.scanFile, scan.value()) : core::Status(scan.error());
    }

    core::Status copyView(core::View& view, std::size_t number)
    {
        const std::string name = "view-" + std::to_string(number);
        view.caseFile = {};
        if (view.imageFile.path.empty()) {
            return core::Done{};
        }
        const auto image = copyImage(view.imageFile.path, name);
        if (!image) {
            return image.error();
        }
        view.imageFile = {image.value(), {}};
        if (request_.deidentification) {
            assignNewUids(view);
        }
        const bool isGiven = !view.target.file.path.empty() && !view.target.editedFrame;
        if (isGiven) {
            return copyTarget(view.target, name + "-curves");
        }
        view.target.file = {};   // edited curves are written when the case is saved
        view.followed.deformationsFile = {};
        return core::Done{};
    }

    core::Messages warnings() && { return std::move(warnings_); }

private:
    static core::Status named(core::InputFile& file, const std::string& path)
    {
        file = {path, {}};
        return core::Done{};
    }

    std::string placeFor(const std::string& name) const { return (folder_ / name).string(); }

    void add(const core::Messages& messages)
    {
        for (const core::Message& message : messages) {
            if (std::ranges::find(warnings_, message) == warnings_.end()) {
                warnings_.push_back(message);
            }
        }
    }

    core::Result<std::string> copyPlain(const fs::path& from, const std::string& name) const
    {
        const std::string place = placeFor(name);
        const auto done = copied(from, place);
        return done ? core::Result<std::string>(place) : done.error();
    }

    /// Copies the target file. For de-identification, writes a new file with the curves only, because tables can
    /// contain hidden text.
    core::Status copyTarget(core::GivenTarget& target, const std::string& name)
    {
        if (request_.deidentification && target.centerline) {
            const std::string place = placeFor(name + ".csv");
            const auto written = writeCenterline2d(*target.centerline, place);
            return written ? named(target.file, place) : written;
        }
        const auto place = copyPlain(target.file.path, name + extensionOf(target.file.path));
        return place ? named(target.file, place.value()) : core::Status(place.error());
    }

    core::Result<std::string> copyImage(const std::string& path, const std::string& name)
    {
        const bool isDicom = isDicomFile(path);
        const std::string place = placeFor(name + (isDicom ? ".dcm" : extensionOf(path)));
        const auto done = copyImageFile(path, place);
        return done ? core::Result<std::string>(place) : done.error();
    }

    core::Status copyImageFile(const std::string& path, const fs::path& place)
    {
        if (!request_.deidentification) {
            return copied(path, place);
        }
        std::error_code ignored;
        fs::create_directories(place.parent_path(), ignored);   // the subsequent write reports any error
        const auto done = deidentifyFile(path, place.string(), *request_.deidentification, request_.pseudonyms);
        if (!done) {
            return done.error();
        }
        add(done.value());
        return core::Done{};
    }

    /// Applies the pseudonyms to the header values of the image that the case stores.
    void assignNewUids(core::View& view) const
    {
        if (!view.angiogram) {
            return;
        }
        const auto read = readAngiogram(view.imageFile.path);
        const core::StudyIdentity identity = read ? read.value().identity : core::StudyIdentity{};
        const auto renamed = [&](const std::shared_ptr<const core::Angiogram>& run) {
            auto copy = std::make_shared<core::Angiogram>(*run);
            copy->identity = identity;
            return copy;
        };
        view.angiogram = renamed(view.angiogram);
        if (view.storedRun) {
            view.storedRun = renamed(view.storedRun);
        }
    }

    core::Status copyVesselFile(core::Vessels& vessels)
    {
        auto place = vessels.input.kind == VesselInputKind::Volume
                         ? copyVolume(vessels.file.path, "vessels", vessels.input.seriesId)
                     : request_.deidentification
                         ? rewritten(vessels)
                         : copyPlain(vessels.file.path, "vessels" + extensionOf(vessels.file.path));
        return place ? named(vessels.file, place.value()) : core::Status(place.error());
    }

    /// Writes centerlines, masks and surfaces in AngioPose's own formats, which contain only coordinates, numbers and
    /// branch names.
    core::Result<std::string> rewritten(core::Vessels& vessels)
    {
        const std::string& path = vessels.file.path;
        const auto end = [](const core::Status& written, const std::string& place) {
            return written ? core::Result<std::string>(place) : written.error();
        };
        if (vessels.input.kind == VesselInputKind::Centerline) {
            VesselTreeReadOptions options;
            options.unitMm = vessels.input.unitMm;
            const auto tree = readVesselTree(path, options);
            vessels.input.unitMm = 0.0;
            add({messages::branchNamesStay()});
            const std::string place = placeFor("vessels.vtp");
            return tree ? end(writeVesselTree(tree.value(), place), place) : core::Result<std::string>(tree.error());
        }
        if (vessels.input.kind == VesselInputKind::Surface) {
            const auto surface = readSurface(path, vessels.input.unitMm);
            vessels.input.unitMm = 0.0;
            const std::string place = placeFor("vessels.stl");
            return surface ? end(writeSurface(surface.value().mesh, place), place)
                           : core::Result<std::string>(surface.error());
        }
        if (vessels.input.labels.empty()) {   // the label names, which identified the vessels, are not copied
            const auto overview = readLabelOverview(path);
            vessels.input.labels = overview ? vesselLabelsByName(overview.value().labels) : std::vector<int>{};
        }
        const auto labels = readLabels(path, progressPart(observe_, 0.0, 0.5));
        const std::string place = placeFor("vessels.nrrd");
        return labels ? end(writeLabels(labels.value(), place), place) : core::Result<std::string>(labels.error());
    }

    /// Copies a file, or the series to which a folder or slice belongs, and updates `seriesId`.
    core::Result<std::string> copyVolume(const std::string& path, const std::string& name, std::string& seriesId)
    {
        if (isFolder(path) || isDicomFile(path)) {
            return copySeries(path, name, seriesId);
        }
        if (!request_.deidentification) {
            return copyPlain(path, name + extensionOf(path));
        }
        const auto volume = readVolume(path, {}, observe_);
        const std::string place = placeFor(name + ".nrrd");
        const auto written = volume ? writeVolume(volume.value().volume, place) : core::Status(volume.error());
        return written ? core::Result<std::string>(place) : written.error();
    }

    core::Result<std::string> copySeries(const std::string& path, const std::string& name, std::string& seriesId)
    {
        const std::string folder = isFolder(path) ? path : fs::path(path).parent_path().string();
        const auto all = listSeries(folder, observe_);
        if (!all) {
            return all.error();
        }
        const auto isWanted = [&](const DicomSeries& series) {
            return !series.isAngiogram && (seriesId.empty() || series.id == seriesId) &&
                   (isFolder(path) ||
                    std::ranges::any_of(series.slices, [&](const SliceRecord& slice) { return slice.path == path; }));
        };
        const auto wanted = std::ranges::find_if(all.value(), isWanted);
        if (wanted == all.value().end()) {
            return fileError(path, messages::nothingToDeidentify());
        }
        std::size_t number = 0;
        for (const std::string& file : seriesFiles(all.value(), *wanted)) {
            const fs::path place = folder_ / name / instanceFileName(++number);
            if (const auto done = copyImageFile(file, place); !done) {
                return done.error();
            }
        }
        const std::string uid = wanted->id.substr(0, wanted->id.find('#'));
        if (request_.deidentification) {
            seriesId = uid.empty() ? std::string() : request_.pseudonyms.uid(uid) + wanted->id.substr(uid.size());
        } else {
            seriesId = wanted->id;
        }
        return placeFor(name);
    }

    const fs::path& folder_;
    const CopyOptions& request_;
    const ReadObserver& observe_;
    core::Messages warnings_;
};

}   // namespace

core::Result<core::Messages> copyInputs(core::Case& session, const fs::path& folder, const CopyOptions& request,
                                        const ReadObserver& observe)
{
    InputCopier copier(folder, request, observe);
    if (const auto done = copier.copyVessels(session.vessels); !done) {
        return done.error();
    }
    for (std::size_t k = 0; k < session.views.size(); ++k) {
        if (const auto done = copier.copyView(session.views[k], k + 1); !done) {
            return done.error();
        }
        if (isStopRequested(observe, static_cast<double>(k + 1) / static_cast<double>(session.views.size()))) {
            return readingCanceled(session.views[k].imageFile.path);
        }
    }
    return std::move(copier).warnings();
}

}   // namespace angiopose::io
