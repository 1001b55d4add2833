#include "io/archive/archive.h"

#include "io/archive/dimse/dimse_send.h"
#include "io/archive/dimse/find.h"
#include "io/archive/store/cache.h"
#include "io/archive/web/web_archive.h"
#include "io/dicom/dicom_file.h"
#include "io/messages/messages.h"
#include "io/support/input_bytes.h"

#include <algorithm>
#include <filesystem>

namespace angiopose::io {
namespace {

StopCheck stopQuestion(const ArchiveObserver& observe)
{
    return [&observe] { return observe && observe({}) == core::ObserverDecision::Stop; };
}

/// Returns whether a file found in a folder should be sent. Export folders also contain other files; damaged DICOM
/// files are recognized by their extension and reported.
bool shouldSend(const std::filesystem::path& path)
{
    return !path.filename().string().starts_with('.') &&
           (extensionOf(path.string()) == ".dcm" || isDicomFile(path.string()));
}

/// Replaces each folder among the paths by its DICOM files, sorted by name.
std::vector<std::string> expandFolders(const std::vector<std::string>& paths)
{
    namespace fs = std::filesystem;
    std::vector<std::string> files;
    for (const std::string& path : paths) {
        std::error_code failed;
        if (!fs::is_directory(path, failed)) {
            files.push_back(path);
            continue;
        }
        const std::size_t first = files.size();
        for (fs::recursive_directory_iterator each(path, failed), end; !failed && each != end; each.increment(failed)) {
            std::error_code unknown;
            if (each->is_regular_file(unknown) && shouldSend(each->path())) {
                files.push_back(each->path().string());
            }
        }
        std::sort(files.begin() + static_cast<std::ptrdiff_t>(first), files.end());
    }
    return files;
}

/// Fetches the requested series one after another.
class Retrieval {
public:
    Retrieval(SeriesSource& source, const ArchiveNode& node, StoreWriter& storeWriter, TransferReport& report)
        : source_(source), node_(node), storeWriter_(storeWriter), report_(report)
    {
    }

    core::Status run(const RetrieveRequest& request)
    {
        std::vector<std::string> series = request.seriesUids;
        if (series.empty()) {
            auto found = source_.seriesOf(request.studyUid);
            if (!found) {
                return found.error();
            }
            series = std::move(found).value();
        }
        if (series.empty()) {
            return core::Error(messages::archiveNothingThere(request.studyUid).about(node_.name));
        }
        if (auto planned = plan(request.studyUid, series); !planned) {
            return planned;
        }
        for (std::size_t i = 0; i < series.size(); ++i) {
            if (auto fetched = fetch(request.studyUid, series[i], objects_[i]); !fetched) {
                return fetched;
            }
        }
        return core::Done{};
    }

private:
    /// Lists all objects before fetching the first one, so that the total for the progress is known.
    core::Status plan(const std::string& studyUid, const std::vector<std::string>& series)
    {
        std::size_t all = 0;
        for (const std::string& uid : series) {
            auto found = source_.objectsOf(studyUid, uid);
            if (!found) {
                return found.error();
            }
            if (found.value().empty()) {
                return core::Error(messages::archiveNothingThere(uid).about(node_.name));
            }
            all += found.value().size();
            objects_.push_back(std::move(found).value());
        }
        report_.all = all;
        return core::Done{};
    }

    core::Status fetch(const std::string& studyUid, const std::string& seriesUid,
                       const std::vector<ArchiveObject>& objects)
    {
        const std::string folder = storeWriter_.store().seriesFolder(studyUid, seriesUid);
        report_.folders.push_back(folder);
        if (missingOf(studyUid, seriesUid, objects) == 0) {
            storeWriter_.addExisting(objects.size());
            markSeriesComplete(folder);
            return core::Done{};
        }
        markSeriesIncomplete(folder);
        const std::size_t failedBefore = report_.failed;
        if (auto fetched = source_.fetch(studyUid, seriesUid, objects, storeWriter_); !fetched) {
            return fetched;
        }
        const std::size_t missing = missingOf(studyUid, seriesUid, objects);
        if (missing == 0) {
            markSeriesComplete(folder);
            return core::Done{};
        }
        report_.failed = std::max(report_.failed, failedBefore + missing);
        report_.addProblem(
            messages::archiveNotAllCame(objects.size() - missing, objects.size(), seriesUid).about(node_.name));
        return core::Done{};
    }

    std::size_t missingOf(const std::string& studyUid, const std::string& seriesUid,
                          const std::vector<ArchiveObject>& objects) const
    {
        const auto isMissing = [&](const ArchiveObject& object) {
            return !storeWriter_.store().storedSize({studyUid, seriesUid, object.sopInstance});
        };
        return static_cast<std::size_t>(std::ranges::count_if(objects, isMissing));
    }

    SeriesSource& source_;
    const ArchiveNode& node_;
    StoreWriter& storeWriter_;
    TransferReport& report_;
    std::vector<std::vector<ArchiveObject>> objects_;   ///< objects of each requested series
};

std::optional<std::string> findInvalidUid(const RetrieveRequest& request)
{
    if (!isUid(request.studyUid)) {
        return request.studyUid;
    }
    const auto wrong = std::ranges::find_if_not(request.seriesUids, isUid);
    return wrong == request.seriesUids.end() ? std::nullopt : std::optional(*wrong);
}

}   // namespace

ArchiveProtocol protocolFor(const ArchiveNode& node, ArchiveProtocol requested)
{
    if (requested != ArchiveProtocol::Default) {
        return requested;
    }
    return node.host.empty() ? ArchiveProtocol::Web : ArchiveProtocol::Dimse;
}

core::Status echoArchive(const ArchiveNode& node, ArchiveProtocol protocol, const ArchiveObserver& observe)
{
    return protocolFor(node, protocol) == ArchiveProtocol::Web ? webEcho(node, stopQuestion(observe))
                                                               : dimseEcho(node, stopQuestion(observe));
}

core::Result<ArchiveMatches> queryArchive(const ArchiveNode& node, ArchiveProtocol protocol, const ArchiveQuery& query,
                                          const ArchiveObserver& observe)
{
    if (!query.studyUid.empty() && !isUid(query.studyUid)) {
        return core::Error(messages::archiveBadUid(query.studyUid));
    }
    return protocolFor(node, protocol) == ArchiveProtocol::Web ? webFind(node, query, stopQuestion(observe))
                                                               : dimseFind(node, query, stopQuestion(observe));
}

TransferReport retrieveFromArchive(const ArchiveNode& node, ArchiveProtocol protocol, const RetrieveRequest& request,
                                   const ObjectStore& store, const StoreLimit& limit, const ArchiveObserver& observe)
{
    TransferReport report;
    if (const auto wrong = findInvalidUid(request)) {
        report.end = core::Error(messages::archiveBadUid(*wrong));
        return report;
    }
    const auto isStopRequested = stopQuestion(observe);
    const auto source = protocolFor(node, protocol) == ArchiveProtocol::Web ? makeWebSource(node, isStopRequested)
                                                                            : makeDimseSource(node, isStopRequested);
    StoreWriter storeWriter(store, limit, report, observe);
    if (auto run = Retrieval(*source, node, storeWriter, report).run(request); !run) {
        report.end = run.error();
    }
    return report;
}

TransferReport sendToArchive(const ArchiveNode& node, ArchiveProtocol protocol, const std::vector<std::string>& paths,
                             const ArchiveObserver& observe)
{
    TransferReport report;
    std::vector<SendableFile> files;
    for (const std::string& path : expandFolders(paths)) {
        auto read = readSendableFile(path);
        ++report.all;
        if (read) {
            files.push_back(std::move(read).value());
        } else {
            ++report.failed;
            report.addProblem(read.error().message);
        }
    }
    if (protocolFor(node, protocol) == ArchiveProtocol::Web) {
        webSend(node, files, observe, report);
    } else {
        dimseSend(node, files, observe, report);
    }
    return report;
}

}   // namespace angiopose::io
