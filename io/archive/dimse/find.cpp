#include "io/archive/dimse/find.h"

#include "io/archive/dimse/identifier.h"
#include "io/archive/dimse/storage_classes.h"
#include "io/dicom/dicom_text.h"
#include "io/messages/messages.h"

#include <map>

namespace angiopose::io {
namespace {

using Keys = std::map<DicomTag, std::string>;

constexpr DicomTag levelTag = 0x00080052;
constexpr DicomTag studyUidTag = 0x0020000d;
constexpr DicomTag seriesUidTag = 0x0020000e;
struct QueryResponses {
    std::vector<DicomDataset> sets;
    bool isTruncated = false;   ///< true if the archive has more matches; the association is then unusable
};

core::Result<QueryResponses> ask(DimseLink& link, const ArchiveNode& node, const Keys& keys, std::size_t most)
{
    const auto context = link.contextFor(sop::find);
    if (!context) {
        return core::Error(messages::archiveNoService("C-FIND", node.ownAeTitle).about(node.name));
    }
    DimseCommand request(DimseMessageType::FindRequest, 1, sop::find);
    request.setNumber(DimseCommand::priority, 0);
    request.setHasData();
    if (auto sent = link.send(context->id, request); !sent) {
        return sent.error();
    }
    if (auto sent = link.sendData(context->id, encodeIdentifier(keys)); !sent) {
        return sent.error();
    }
    QueryResponses answers;
    for (;;) {
        auto received = link.receive();
        if (!received) {
            return received.error();
        }
        if (!received.value() || received.value()->command.kind() != DimseMessageType::FindResponse) {
            return core::Error(messages::archiveNonsense("C-FIND").about(node.name));
        }
        const DimseCommand& answer = received.value()->command;
        std::string data;
        if (answer.hasData()) {
            auto read = link.receiveData();
            if (!read) {
                return read.error();
            }
            data = std::move(read).value();
        }
        if (answer.status() == dimse::success) {
            return answers;
        }
        if (answer.status() != dimse::pending && answer.status() != dimse::pendingWithWarning) {
            return core::Error(messages::archiveStatus("C-FIND", statusText(answer)).about(node.name));
        }
        if (answers.sets.size() == most) {
            answers.isTruncated = true;
            return answers;
        }
        answers.sets.push_back(decodeIdentifier(data));
    }
}

Keys studyKeys(const ArchiveQuery& query)
{
    return {{levelTag, "STUDY"},
            {0x00080020, query.dates},
            {0x00080030, ""},
            {0x00080050, query.accessionNumber},
            {0x00080061, query.modality},
            {0x00081030, ""},
            {0x00100010, namePattern(query.patientName)},
            {0x00100020, query.patientId},
            {0x00100030, ""},
            {studyUidTag, query.studyUid},
            {0x00201208, ""}};
}

Keys seriesKeys(const std::string& studyUid, const std::string& modality)
{
    return {{levelTag, "SERIES"},    {0x00080060, modality}, {0x0008103e, ""}, {0x00180015, ""},
            {studyUidTag, studyUid}, {seriesUidTag, ""},     {0x00200011, ""}, {0x00201209, ""}};
}

ArchiveMatch studyMatch(const DicomDataset& data)
{
    ArchiveMatch match;
    match.patientName = utf8Text(data, 0x00100010);
    match.patientId = utf8Text(data, 0x00100020);
    match.birthDate = utf8Text(data, 0x00100030);
    match.studyUid = data.text(studyUidTag);
    match.studyDate = utf8Text(data, 0x00080020);
    match.studyTime = utf8Text(data, 0x00080030);
    match.studyDescription = utf8Text(data, 0x00081030);
    match.accessionNumber = utf8Text(data, 0x00080050);
    match.modalities = data.text(0x00080061);
    match.objects = data.integer(0x00201208).value_or(0);
    return match;
}

ArchiveMatch seriesMatch(ArchiveMatch match, const DicomDataset& data)
{
    match.seriesUid = data.text(seriesUidTag);
    match.modalities = data.text(0x00080060);
    match.seriesDescription = utf8Text(data, 0x0008103e);
    match.bodyPart = utf8Text(data, 0x00180015);
    match.seriesNumber = data.integer(0x00200011).value_or(0);
    match.objects = data.integer(0x00201209).value_or(0);
    return match;
}

/// Replaces each study by its series; fails on the first study that cannot be queried.
core::Status expandToSeries(DimseLink& link, const ArchiveNode& node, const ArchiveQuery& query,
                            ArchiveMatches& matches)
{
    std::vector<ArchiveMatch> series;
    for (const ArchiveMatch& study : matches.found) {
        auto answers = ask(link, node, seriesKeys(study.studyUid, query.modality), maxMatches);
        if (!answers) {
            return answers.error();
        }
        for (const DicomDataset& data : answers.value().sets) {
            series.push_back(seriesMatch(study, data));
        }
    }
    matches.found = std::move(series);
    return core::Done{};
}

}   // namespace

core::Status dimseEcho(const ArchiveNode& node, const StopCheck& isStopRequested)
{
    auto opened = DimseLink::open(node, {{sop::verification, {implicitLittleEndian}}}, isStopRequested);
    if (!opened) {
        return opened.error();
    }
    DimseLink link = std::move(opened).value();
    const auto context = link.contextFor(sop::verification);
    if (!context) {
        return core::Error(messages::archiveNoService("C-ECHO", node.ownAeTitle).about(node.name));
    }
    if (auto sent = link.send(context->id, DimseCommand(DimseMessageType::EchoRequest, 1, sop::verification)); !sent) {
        return sent;
    }
    auto received = link.receive();
    if (!received) {
        return received.error();
    }
    if (!received.value() || received.value()->command.status() != dimse::success) {
        return core::Error(messages::archiveNonsense("C-ECHO").about(node.name));
    }
    link.release();
    return core::Done{};
}

core::Result<DimseLink> openFindAssociation(const ArchiveNode& node, const StopCheck& isStopRequested)
{
    return DimseLink::open(node, {{sop::find, {implicitLittleEndian}}}, isStopRequested);
}

core::Result<ArchiveMatches> dimseFind(const ArchiveNode& node, const ArchiveQuery& query,
                                       const StopCheck& isStopRequested)
{
    auto opened = openFindAssociation(node, isStopRequested);
    if (!opened) {
        return opened.error();
    }
    DimseLink link = std::move(opened).value();
    const bool isOfSeries = query.level == ArchiveLevel::Series;
    const std::size_t most = isOfSeries ? maxSeriesStudies : maxMatches;
    auto answers = ask(link, node, studyKeys(query), most);
    if (!answers) {
        return answers.error();
    }
    ArchiveMatches matches;
    for (const DicomDataset& data : answers.value().sets) {
        matches.found.push_back(studyMatch(data));
    }
    sortAndFilterMatches(query, matches.found);
    if (answers.value().isTruncated) {
        matches.warnings.push_back(messages::archiveManyMatches(most).about(node.name));
        if (isOfSeries) {
            return core::Error(messages::archiveManyMatches(most).about(node.name));
        }
        return matches;
    }
    if (isOfSeries) {
        if (auto found = expandToSeries(link, node, query, matches); !found) {
            return found.error();
        }
        sortAndFilterMatches(query, matches.found);
    }
    link.release();
    return matches;
}

core::Result<std::vector<std::string>> findSeries(DimseLink& link, const ArchiveNode& node, const std::string& studyUid)
{
    auto answers = ask(link, node, {{levelTag, "SERIES"}, {studyUidTag, studyUid}, {seriesUidTag, ""}}, maxMatches);
    if (!answers) {
        return answers.error();
    }
    std::vector<std::string> series;
    for (const DicomDataset& data : answers.value().sets) {
        series.emplace_back(data.text(seriesUidTag));
    }
    return series;
}

core::Result<std::vector<ArchiveObject>> findObjects(DimseLink& link, const ArchiveNode& node,
                                                     const std::string& studyUid, const std::string& seriesUid)
{
    const Keys keys{
        {0x00080016, ""}, {0x00080018, ""}, {levelTag, "IMAGE"}, {studyUidTag, studyUid}, {seriesUidTag, seriesUid}};
    auto answers = ask(link, node, keys, maxObjects);
    if (!answers) {
        return answers.error();
    }
    std::vector<ArchiveObject> objects;
    for (const DicomDataset& data : answers.value().sets) {
        objects.push_back({std::string(data.text(0x00080016)), std::string(data.text(0x00080018))});
    }
    return objects;
}

}   // namespace angiopose::io
