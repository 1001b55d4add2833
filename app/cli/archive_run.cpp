#include "app/cli/add_warnings.h"
#include "app/cli/archive_arguments.h"
#include "app/cli/audit_hook.h"
#include "io/sharing/audit_file.h"

#include <cstdio>
#include <nlohmann/json.hpp>

namespace angiopose::app {
namespace {

using ArchiveJson = nlohmann::ordered_json;

std::string listOf(const ArchiveArguments& arguments)
{
    return arguments.nodeFile.empty() ? io::defaultArchiveSettingsFile() : arguments.nodeFile;
}

core::Result<io::ArchiveNode> nodeOf(const ArchiveArguments& arguments)
{
    const auto settings = io::readArchiveSettings(listOf(arguments));
    return settings ? io::findNode(settings.value(), arguments.nodeName, listOf(arguments))
                    : core::Result<io::ArchiveNode>(settings.error());
}

core::ObserverDecision stopVerdict()
{
    return isInterrupted() ? core::ObserverDecision::Stop : core::ObserverDecision::Continue;
}

void printArchiveJson(const ArchiveJson& json)
{
    std::puts(json.dump(2, ' ', false, ArchiveJson::error_handler_t::replace).c_str());
}

ArchiveJson matchJson(const io::ArchiveMatch& match, io::ArchiveLevel level)
{
    ArchiveJson json{{"patientName", match.patientName},
                     {"patientId", match.patientId},
                     {"birthDate", match.birthDate},
                     {"studyUid", match.studyUid},
                     {"studyDate", match.studyDate},
                     {"studyTime", match.studyTime},
                     {"studyDescription", match.studyDescription},
                     {"accessionNumber", match.accessionNumber},
                     {"modalities", match.modalities},
                     {"objects", match.objects}};
    if (level == io::ArchiveLevel::Series) {
        json["seriesUid"] = match.seriesUid;
        json["seriesNumber"] = match.seriesNumber;
        json["seriesDescription"] = match.seriesDescription;
        json["bodyPart"] = match.bodyPart;
    }
    return json;
}

void printMatch(const io::ArchiveMatch& match, io::ArchiveLevel level)
{
    const std::string count = match.objects > 0 ? "  " + std::to_string(match.objects) + " objects" : "";
    if (level == io::ArchiveLevel::Study) {
        printText(match.studyDate + "  " + match.patientName + "  " + match.patientId + "  " + match.modalities + "  " +
                  match.studyDescription + count);
        printText("  study " + match.studyUid);
        return;
    }
    printText(match.studyDate + "  " + match.patientName + "  " + match.modalities + "  " +
              std::to_string(match.seriesNumber) + "  " + match.seriesDescription + count);
    printText("  study " + match.studyUid);
    printText("  series " + match.seriesUid);
}

ArchiveJson reportJson(const io::TransferReport& report)
{
    ArchiveJson json{{"objects", report.all},
                     {"transferred", report.transferred},
                     {"alreadyThere", report.duplicates},
                     {"failed", report.failed},
                     {"bytes", report.bytes}};
    if (!report.folders.empty()) {
        json["folders"] = report.folders;
    }
    if (report.end) {
        json["error"] = ArchiveJson::parse(io::messageJson(report.end->message));
    }
    addWarnings(json, report.problems);
    return json;
}

/// Prints the outcome of a transfer and returns the exit code.
int finishTransfer(const io::TransferReport& report, const char* done, OutputFormat format)
{
    printWarnings(report.problems);
    if (report.end) {
        printMessage(report.end->message.text());
    }
    if (format == OutputFormat::Json) {
        printArchiveJson(reportJson(report));
    } else {
        for (const std::string& folder : report.folders) {
            std::printf("%s\n", folder.c_str());
        }
        std::printf("%zu objects %s (%s), %zu already present, %zu failed\n", report.transferred, done,
                    io::sizeText(report.bytes).c_str(), report.duplicates, report.failed);
    }
    if (report.end) {
        return report.end->isCancellation() ? exitInterrupted : exitInputError;
    }
    return report.failed > 0 ? exitInputError : exitSuccess;
}

io::ArchiveObserver showing(ProgressLine& line)
{
    return [&line](const io::ArchiveProgress& progress) {
        if (progress.all > 0) {
            line.show(static_cast<double>(progress.objects) / static_cast<double>(progress.all),
                      std::to_string(progress.objects) + " of " + std::to_string(progress.all) + " objects, " +
                          io::sizeText(progress.bytes));
        }
        return stopVerdict();
    };
}

/// Records the received objects in the audit file even if the transfer is incomplete.
void auditRetrieved(const std::string& auditFile, const io::TransferReport& report, const std::string& archive)
{
    io::AuditBatch batch(auditFile, {io::AuditEvent::Retrieved, "angiopose-cli", {}, archive});
    for (const std::string& folder : report.folders) {
        batch.add(folder);
    }
    batch.flush();
    if (batch.problem()) {
        reportUnaudited(*batch.problem());
    }
}

std::uint64_t bytesOf(double gigabytes)
{
    return static_cast<std::uint64_t>(gigabytes * 1e9);
}

}   // namespace

int runArchiveEcho(const ArchiveArguments& arguments)
{
    const auto node = nodeOf(arguments);
    if (!node) {
        return reportInputError(node.error(), arguments.format);
    }
    const auto answered = io::echoArchive(node.value(), arguments.protocol, [](const auto&) { return stopVerdict(); });
    if (!answered) {
        return reportInputError(answered.error(), arguments.format);
    }
    const core::Messages notes = io::connectionWarnings(node.value());
    printWarnings(notes);
    if (arguments.format == OutputFormat::Json) {
        ArchiveJson json{{"archive", node.value().name}, {"answers", true}};
        addWarnings(json, notes);
        printArchiveJson(json);
    } else {
        std::printf("%s answers\n", node.value().name.c_str());
    }
    return exitSuccess;
}

int runArchiveFind(const ArchiveFindArguments& arguments)
{
    const OutputFormat format = arguments.connection.format;
    const auto node = nodeOf(arguments.connection);
    const auto dates = io::parseQueryDates(arguments.dates);
    if (!node || !dates) {
        return reportInputError(node ? dates.error() : node.error(), format);
    }
    io::ArchiveQuery query = arguments.query;
    query.dates = dates.value();
    const auto found =
        io::queryArchive(node.value(), arguments.connection.protocol, query, [](const auto&) { return stopVerdict(); });
    if (!found) {
        return reportInputError(found.error(), format);
    }
    printWarnings(found.value().warnings);
    if (format == OutputFormat::Json) {
        ArchiveJson json{{"matches", ArchiveJson::array()}};
        for (const io::ArchiveMatch& match : found.value().found) {
            json["matches"].push_back(matchJson(match, query.level));
        }
        addWarnings(json, found.value().warnings);
        printArchiveJson(json);
    } else {
        for (const io::ArchiveMatch& match : found.value().found) {
            printMatch(match, query.level);
        }
        std::printf("%zu found\n", found.value().found.size());
    }
    return exitSuccess;
}

int runArchiveRetrieve(const ArchiveRetrieveArguments& arguments)
{
    const OutputFormat format = arguments.connection.format;
    const auto settings = io::readArchiveSettings(listOf(arguments.connection));
    const auto node = nodeOf(arguments.connection);
    if (!settings || !node) {
        return reportInputError(settings ? node.error() : settings.error(), format);
    }
    const bool isCache = arguments.folder.empty();
    const auto store =
        io::ObjectStore::open(isCache ? settings.value().cache() : arguments.folder, bytesOf(arguments.maxObjectGb));
    if (!store) {
        return reportInputError(store.error(), format);
    }
    io::StoreLimit limit;
    limit.maxBytes = isCache ? settings.value().cacheBytes : 0;
    ProgressLine line("retrieving");
    const auto report = io::retrieveFromArchive(node.value(), arguments.connection.protocol, arguments.request,
                                                store.value(), limit, showing(line));
    auditRetrieved(arguments.auditFile, report, node.value().name);
    return finishTransfer(report, "came", format);
}

int runArchiveSend(const ArchiveSendArguments& arguments)
{
    const auto node = nodeOf(arguments.connection);
    if (!node) {
        return reportInputError(node.error(), arguments.connection.format);
    }
    ProgressLine line("sending");
    const auto report = io::sendToArchive(node.value(), arguments.connection.protocol, arguments.paths, showing(line));
    return finishTransfer(report, "sent", arguments.connection.format);
}

int runArchiveReceive(const ArchiveReceiveArguments& arguments)
{
    const auto store = io::ObjectStore::open(arguments.folder, bytesOf(arguments.maxObjectGb));
    if (!store) {
        return reportInputError(store.error(), arguments.format);
    }
    io::StorageScpOptions options = arguments.options;
    options.isTls = !options.tls.certificateFile.empty();
    auto listening = io::StorageScp::listen(options);
    if (!listening) {
        return reportInputError(listening.error(), arguments.format);
    }
    io::StorageScp receiver = std::move(listening).value();
    printMessage("listening on port " + std::to_string(options.port) + ", Ctrl+C to stop");
    io::TransferReport report;
    const io::ArchiveObserver observer;
    const io::StoreLimit limit{bytesOf(arguments.maxGb), io::StoreLimit::FullStorePolicy::Refuse};
    io::StoreWriter storeWriter(store.value(), limit, report, observer);
    io::AuditBatch audit(arguments.auditFile, {io::AuditEvent::Received, "angiopose-cli", {}});
    storeWriter.tell([&arguments, &audit](const io::StoredObject& object) {
        audit.add(object.path);
        if (arguments.format == OutputFormat::Text) {
            std::printf("%s\n", object.path.c_str());
            std::fflush(stdout);
        }
    });
    receiver.serve(storeWriter, [&arguments, &report, &audit] {
        audit.flushIfDue();
        const std::size_t receivedCount = report.transferred + report.duplicates;
        return isInterrupted() || (arguments.count > 0 && receivedCount >= arguments.count);
    });
    audit.flush();
    if (audit.problem()) {
        reportUnaudited(*audit.problem());
    }
    report.end = receiver.failure();
    return finishTransfer(report, "came", arguments.format);
}

}   // namespace angiopose::app
