#include "io/archive/web/dicom_json.h"
#include "io/archive/web/http.h"
#include "io/archive/web/web_archive.h"
#include "io/messages/messages.h"

#include <algorithm>
#include <cstring>
#include <fstream>
#include <random>

namespace angiopose::io {
namespace {

void addValue(std::string& url, const char* key, const std::string& value)
{
    if (!value.empty()) {
        url += (url.find('?') == std::string::npos ? "?" : "&") + std::string(key) + "=" + percentEncode(value);
    }
}

std::string studiesUrl(const ArchiveNode& node, const ArchiveQuery& query, std::size_t most)
{
    std::string url = dicomWebUrl(node) + "/studies";
    addValue(url, "PatientName", namePattern(query.patientName));
    addValue(url, "PatientID", query.patientId);
    addValue(url, "StudyDate", query.dates);
    addValue(url, "ModalitiesInStudy", query.modality);
    addValue(url, "AccessionNumber", query.accessionNumber);
    addValue(url, "StudyInstanceUID", query.studyUid);
    addValue(url, "includefield", "StudyDescription");
    addValue(url, "limit", std::to_string(most + 1));
    return url;
}

/// Adds the study's values to a series, because not every archive repeats them.
ArchiveMatch seriesOf(const ArchiveMatch& study, ArchiveMatch series)
{
    ArchiveMatch match = study;
    match.seriesUid = series.seriesUid;
    match.modalities = series.modalities;
    match.seriesDescription = series.seriesDescription;
    match.bodyPart = series.bodyPart;
    match.seriesNumber = series.seriesNumber;
    match.objects = series.objects;
    return match;
}

core::Status expandToSeriesByWeb(HttpConnection& http, const ArchiveNode& node, const ArchiveQuery& query,
                                 ArchiveMatches& matches)
{
    std::vector<ArchiveMatch> series;
    for (const ArchiveMatch& study : matches.found) {
        std::string url = dicomWebUrl(node) + "/studies/" + percentEncode(study.studyUid) + "/series";
        addValue(url, "Modality", query.modality);
        addValue(url, "includefield", "BodyPartExamined");
        auto reply = queryDicomWeb(http, node, "QIDO-RS", url);
        if (!reply) {
            return reply.error();
        }
        auto found = parseMatches(reply.value());
        if (!found) {
            return found.error().about(node.name);
        }
        for (const ArchiveMatch& match : found.value()) {
            series.push_back(seriesOf(study, match));
        }
    }
    matches.found = std::move(series);
    return core::Done{};
}

constexpr int duplicateReason = 0x0111;

std::string randomBoundary()
{
    std::random_device device;
    std::string boundary = "angiopose-";
    for (int i = 0; i < 4; ++i) {
        boundary += std::to_string(device());
    }
    return boundary;
}

/// Multipart body with a single file, provided chunk by chunk.
class SingleFileBody {
public:
    SingleFileBody(const SendableFile& file, const std::string& boundary)
        : stream_(file.path, std::ios::binary),
          head_("--" + boundary + "\r\nContent-Type: application/dicom\r\n\r\n"),
          tail_("\r\n--" + boundary + "--\r\n"),
          remainingBytes_(file.bytes)
    {
        size_ = head_.size() + remainingBytes_ + tail_.size();
    }

    std::uint64_t size() const { return size_; }

    std::optional<std::size_t> fill(char* buffer, std::size_t room)
    {
        if (!head_.empty()) {
            return give(head_, buffer, room);
        }
        if (remainingBytes_ == 0) {
            return give(tail_, buffer, room);
        }
        const auto wanted = static_cast<std::streamsize>(std::min<std::uint64_t>(remainingBytes_, room));
        if (!stream_.read(buffer, wanted)) {
            return std::nullopt;
        }
        remainingBytes_ -= static_cast<std::uint64_t>(wanted);
        return static_cast<std::size_t>(wanted);
    }

private:
    static std::size_t give(std::string& text, char* buffer, std::size_t room)
    {
        const std::size_t given = std::min(text.size(), room);
        std::memcpy(buffer, text.data(), given);
        text.erase(0, given);
        return given;
    }

    std::ifstream stream_;
    std::string head_;
    std::string tail_;
    std::uint64_t remainingBytes_;
    std::uint64_t size_ = 0;
};

/// Counts the result of one file; fails if sending further files is pointless.
core::Status recordStoreResult(const ArchiveNode& node, const SendableFile& file, const HttpResponse& reply,
                               TransferReport& report)
{
    const StoreResult answer = parseStoreResult(reply.body);
    if (reply.status == 200 && answer.isStored) {
        ++report.transferred;
        report.bytes += file.bytes;
    } else if (answer.failure == duplicateReason) {
        ++report.duplicates;
    } else if (answer.failure != 0 || reply.status == 409 || reply.status == 202) {
        ++report.failed;
        report.addProblem(
            messages::archiveStoreRefused(statusText(static_cast<unsigned>(answer.failure))).about(file.path));
    } else {
        return core::Error(messages::archiveHttpStatus("STOW-RS", std::to_string(reply.status)).about(node.name));
    }
    return core::Done{};
}

}   // namespace

std::string dicomWebUrl(const ArchiveNode& node)
{
    std::string base = node.webUrl;
    base.erase(base.find_last_not_of('/') + 1);
    return base;
}

core::Result<std::string> queryDicomWeb(HttpConnection& http, const ArchiveNode& node, const std::string& service,
                                        const std::string& url)
{
    auto reply = http.get(url, "application/dicom+json");
    if (!reply) {
        return reply.error();
    }
    if (reply.value().status != 200 && reply.value().status != 204) {
        return core::Error(messages::archiveHttpStatus(service, std::to_string(reply.value().status)).about(node.name));
    }
    return std::move(reply).value().body;
}

core::Status webEcho(const ArchiveNode& node, const std::function<bool()>& isStopRequested)
{
    auto http = HttpConnection::open(node, isStopRequested);
    if (!http) {
        return http.error();
    }
    HttpConnection connection = std::move(http).value();
    auto reply = queryDicomWeb(connection, node, "QIDO-RS", dicomWebUrl(node) + "/studies?limit=1");
    if (!reply) {
        return reply.error();
    }
    const auto found = parseMatches(reply.value());
    return found ? core::Status(core::Done{}) : core::Status(found.error().about(node.name));
}

core::Result<ArchiveMatches> webFind(const ArchiveNode& node, const ArchiveQuery& query,
                                     const std::function<bool()>& isStopRequested)
{
    auto opened = HttpConnection::open(node, isStopRequested);
    if (!opened) {
        return opened.error();
    }
    HttpConnection http = std::move(opened).value();
    const bool isOfSeries = query.level == ArchiveLevel::Series;
    const std::size_t most = isOfSeries ? maxSeriesStudies : maxMatches;
    auto reply = queryDicomWeb(http, node, "QIDO-RS", studiesUrl(node, query, most));
    if (!reply) {
        return reply.error();
    }
    auto found = parseMatches(reply.value());
    if (!found) {
        return found.error().about(node.name);
    }
    ArchiveMatches matches{std::move(found).value(), {}};
    sortAndFilterMatches(query, matches.found);
    if (matches.found.size() > most) {
        matches.found.resize(most);
        matches.warnings.push_back(messages::archiveManyMatches(most).about(node.name));
    }
    if (isOfSeries) {
        if (auto series = expandToSeriesByWeb(http, node, query, matches); !series) {
            return series.error();
        }
        sortAndFilterMatches(query, matches.found);
    }
    return matches;
}

void webSend(const ArchiveNode& node, const std::vector<SendableFile>& files, const ArchiveObserver& observe,
             TransferReport& report)
{
    std::uint64_t bytes = 0;
    const auto isStopRequested = [&] {
        const std::size_t done = report.transferred + report.duplicates + report.failed;
        return observe && observe({done, report.all, bytes}) == core::ObserverDecision::Stop;
    };
    auto opened = HttpConnection::open(node, isStopRequested);
    if (!opened) {
        report.end = opened.error();
        return;
    }
    HttpConnection http = std::move(opened).value();
    for (const SendableFile& file : files) {
        const std::string boundary = randomBoundary();
        SingleFileBody body(file, boundary);
        HttpConnection::Upload upload;
        upload.contentType = R"(multipart/related; type="application/dicom"; boundary=)" + boundary;
        upload.accept = "application/dicom+json";
        upload.bytes = body.size();
        upload.source = [&body, &bytes](char* buffer, std::size_t room) {
            const auto given = body.fill(buffer, room);
            bytes += given.value_or(0);
            return given;
        };
        auto reply = http.post(dicomWebUrl(node) + "/studies", upload);
        if (!reply) {
            report.end = reply.error();
            return;
        }
        if (auto settled = recordStoreResult(node, file, reply.value(), report); !settled) {
            report.end = settled.error();
            return;
        }
    }
}

}   // namespace angiopose::io
