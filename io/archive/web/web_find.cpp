#include "io/archive/web/dicom_json.h"
#include "io/archive/web/http.h"
#include "io/archive/web/web_archive.h"
#include "io/archive/web/web_query.h"
#include "io/messages/says_archive.h"

namespace angiopose::io {
namespace {

void addValue(std::string& url, const char* key, const std::string& value)
{
    if (!value.empty()) {
        url += (url.find('?') == std::string::npos ? "?" : "&") + std::string(key) + "=" + urlEscaped(value);
    }
}

std::string studiesUrl(const ArchiveNode& node, const ArchiveQuery& query, std::size_t most)
{
    std::string url = webBase(node) + "/studies";
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

/// What the study says is said of its series too: not every archive repeats it.
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

core::Status intoWebSeries(HttpConnection& http, const ArchiveNode& node, const ArchiveQuery& query,
                           ArchiveMatches& matches)
{
    std::vector<ArchiveMatch> series;
    for (const ArchiveMatch& study : matches.found) {
        std::string url = webBase(node) + "/studies/" + urlEscaped(study.studyUid) + "/series";
        addValue(url, "Modality", query.modality);
        addValue(url, "includefield", "BodyPartExamined");
        auto reply = askWeb(http, node, "QIDO-RS", url);
        if (!reply) {
            return reply.error();
        }
        auto found = matchesOfJson(reply.value());
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

}   // namespace

std::string webBase(const ArchiveNode& node)
{
    std::string base = node.webUrl;
    base.erase(base.find_last_not_of('/') + 1);
    return base;
}

core::Result<std::string> askWeb(HttpConnection& http, const ArchiveNode& node, const std::string& service,
                                 const std::string& url)
{
    auto reply = http.get(url, "application/dicom+json");
    if (!reply) {
        return reply.error();
    }
    if (reply.value().status != 200 && reply.value().status != 204) {
        return core::Error(says::archiveHttpStatus(service, std::to_string(reply.value().status)).about(node.name));
    }
    return std::move(reply).value().body;
}

core::Status webEcho(const ArchiveNode& node, const std::function<bool()>& isStopWished)
{
    auto http = HttpConnection::open(node, isStopWished);
    if (!http) {
        return http.error();
    }
    HttpConnection connection = std::move(http).value();
    auto reply = askWeb(connection, node, "QIDO-RS", webBase(node) + "/studies?limit=1");
    if (!reply) {
        return reply.error();
    }
    const auto found = matchesOfJson(reply.value());
    return found ? core::Status(core::Done{}) : core::Status(found.error().about(node.name));
}

core::Result<ArchiveMatches> webFind(const ArchiveNode& node, const ArchiveQuery& query,
                                     const std::function<bool()>& isStopWished)
{
    auto opened = HttpConnection::open(node, isStopWished);
    if (!opened) {
        return opened.error();
    }
    HttpConnection http = std::move(opened).value();
    const bool isOfSeries = query.level == ArchiveLevel::Series;
    const std::size_t most = isOfSeries ? mostSeriesStudies : mostMatches;
    auto reply = askWeb(http, node, "QIDO-RS", studiesUrl(node, query, most));
    if (!reply) {
        return reply.error();
    }
    auto found = matchesOfJson(reply.value());
    if (!found) {
        return found.error().about(node.name);
    }
    ArchiveMatches matches{std::move(found).value(), {}};
    settleMatches(query, matches.found);
    if (matches.found.size() > most) {
        matches.found.resize(most);
        matches.warnings.push_back(says::archiveManyMatches(most).about(node.name));
    }
    if (isOfSeries) {
        if (auto series = intoWebSeries(http, node, query, matches); !series) {
            return series.error();
        }
        settleMatches(query, matches.found);
    }
    return matches;
}

}   // namespace angiopose::io
