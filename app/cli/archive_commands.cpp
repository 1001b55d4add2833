#include "app/cli/archive_commands.h"

#include "app/cli/archive_arguments.h"
#include "app/cli/audit_hook.h"

#include <memory>

namespace angiopose::app {
namespace {

void addNodeFile(CLI::App& command, ArchiveArguments& common)
{
    command.add_option("--nodes", common.nodeFile, "List of archives (default: the user's own)");
    command.add_flag_callback(
        "--json", [&common] { common.format = OutputFormat::Json; }, "Print JSON and nothing else");
}

void addNode(CLI::App& command, ArchiveArguments& common)
{
    command.add_option("ARCHIVE", common.nodeName, "Its name in the list of archives")->required();
    addNodeFile(command, common);
    command.add_flag_callback(
        "--web", [&common] { common.way = io::ArchiveWay::Web; }, "By DICOMweb, though it has a host too");
}

/// Returns the audit file of the program that owns the archive commands.
std::string auditFileFor(const CLI::App& archive)
{
    return auditPathOf(*archive.get_parent());
}

void addEcho(CLI::App& archive, int& exitCode)
{
    auto* command = archive.add_subcommand("echo", "Try whether an archive answers");
    auto arguments = std::make_shared<ArchiveArguments>();
    addNode(*command, *arguments);
    command->callback([arguments, &exitCode] { exitCode = runArchiveEcho(*arguments); });
}

void addFind(CLI::App& archive, int& exitCode)
{
    auto* command = archive.add_subcommand("find", "List what an archive holds");
    auto arguments = std::make_shared<ArchiveFindArguments>();
    addNode(*command, arguments->common);
    io::ArchiveQuery& query = arguments->query;
    command->add_option("--patient", query.patientName, "Beginning of the name, or a pattern with * and ?");
    command->add_option("--id", query.patientId, "The patient's ID");
    command->add_option("--date", arguments->dates, "YYYY-MM-DD, or a range: 2024-01-01..2024-02-01, 2024-01-01..");
    command->add_option("--modality", query.modality, "CT, XA, …");
    command->add_option("--accession", query.accessionNumber, "Accession number");
    command->add_option("--study", query.studyUid, "Study instance UID");
    command->add_flag_callback(
        "--series", [arguments] { arguments->query.level = io::ArchiveLevel::Series; }, "List series, not studies");
    command->footer(
        "Example: angiopose-cli archive find pacs --patient Meier --date 2024-01-01.. --modality XA --series");
    command->callback([arguments, &exitCode] { exitCode = runArchiveFind(*arguments); });
}

void addRetrieve(CLI::App& archive, int& exitCode)
{
    auto* command = archive.add_subcommand("retrieve", "Bring a study or series here");
    auto arguments = std::make_shared<ArchiveRetrieveArguments>();
    addNode(*command, arguments->common);
    command->add_option("--study", arguments->request.studyUid, "Study instance UID")->required();
    command->add_option("--series", arguments->request.seriesUids,
                        "Series instance UID; may be repeated (default: all)");
    command->add_option("--into", arguments->folder, "A folder instead of the cache");
    command->add_option("--max-object", arguments->maxObjectGb, "Largest object taken, GB")
        ->check(CLI::Range(1e-6, 1000.0));
    command->footer("Example: angiopose-cli archive retrieve pacs --study 1.2.840.1 --series 1.2.840.1.3");
    command->callback([arguments, &archive, &exitCode] {
        arguments->auditFile = auditFileFor(archive);
        exitCode = runArchiveRetrieve(*arguments);
    });
}

void addSend(CLI::App& archive, int& exitCode)
{
    auto* command = archive.add_subcommand("send", "Send DICOM files to an archive, as they are");
    auto arguments = std::make_shared<ArchiveSendArguments>();
    addNode(*command, arguments->common);
    command->add_option("FILE", arguments->paths, "Files, or folders of them")->required();
    command->footer("Example: angiopose-cli archive send pacs result.dcm");
    command->callback([arguments, &exitCode] { exitCode = runArchiveSend(*arguments); });
}

void addReceive(CLI::App& archive, int& exitCode)
{
    auto* command = archive.add_subcommand("receive", "Take what others push to a port, until Ctrl+C");
    auto arguments = std::make_shared<ArchiveReceiveArguments>();
    io::ReceiverOptions& options = arguments->options;
    command->add_option("--port", options.port, "Port to listen on")->required()->check(CLI::Range(1, 65535));
    command->add_option("--into", arguments->folder, "Folder for what comes")->required();
    command->add_option("--title", options.ownTitle, "Our AE title; callers must use it")->capture_default_str();
    command->add_option("--from-title", options.titles, "AE title that may call; may be repeated (default: any)");
    command->add_option("--from-host", options.hosts, "Address that may call; may be repeated (default: any)");
    command->add_option("--max-object", arguments->maxObjectGb, "Largest object taken, GB")
        ->check(CLI::Range(1e-6, 1000.0));
    command->add_option("--max-total", arguments->maxGb, "Most that the folder may hold, GB (default: no limit)")
        ->check(CLI::Range(1e-6, 1e6));
    command->add_option("--count", arguments->count, "End after so many objects");
    auto* certificate =
        command->add_option("--tls-certificate", options.tls.certificateFile, "Our certificate, PEM: TLS");
    auto* key = command->add_option("--tls-key", options.tls.keyFile, "Its key, PEM");
    command
        ->add_option("--tls-ca", options.tls.caFile,
                     "Authorities that callers' certificates are checked with, PEM (default: the system's)")
        ->needs(certificate);
    certificate->needs(key);
    key->needs(certificate);
    command->add_flag_callback(
        "--json", [arguments] { arguments->format = OutputFormat::Json; }, "Print JSON and nothing else");
    command->footer("Example: angiopose-cli archive receive --port 11112 --into incoming --from-host 10.0.0.7");
    command->callback([arguments, &archive, &exitCode] {
        arguments->auditFile = auditFileFor(archive);
        exitCode = runArchiveReceive(*arguments);
    });
}

void addNodeList(CLI::App& archive, int& exitCode)
{
    auto* nodes = archive.add_subcommand("nodes", "The list of archives");
    nodes->require_subcommand(1);
    auto listed = std::make_shared<ArchiveArguments>();
    auto* list = nodes->add_subcommand("list", "Print it");
    addNodeFile(*list, *listed);
    list->callback([listed, &exitCode] { exitCode = runArchiveNodes(*listed); });

    auto removed = std::make_shared<ArchiveArguments>();
    auto* remove = nodes->add_subcommand("remove", "Take an archive from it");
    remove->add_option("ARCHIVE", removed->nodeName)->required();
    addNodeFile(*remove, *removed);
    remove->callback([removed, &exitCode] { exitCode = runArchiveRemove(*removed); });

    auto arguments = std::make_shared<ArchiveNodeArguments>();
    auto* add = nodes->add_subcommand("add", "Add an archive, or replace one of the same name");
    io::ArchiveNode& node = arguments->node;
    add->add_option("ARCHIVE", node.name, "A name to call it by")->required();
    addNodeFile(*add, arguments->common);
    add->add_option("--host", node.host, "Its host");
    add->add_option("--port", node.port, "Its port")->capture_default_str();
    add->add_option("--title", node.title, "Called AE title")->capture_default_str();
    add->add_option("--own-title", node.ownTitle, "Calling AE title")->capture_default_str();
    add->add_option("--receive-port", node.receivePort, "Port of ours for C-MOVE (default: C-GET only)");
    add->add_flag("--tls", node.isTls, "TLS for DIMSE");
    add->add_option("--ca", node.caFile, "Authorities that certificates are checked with, PEM (default: the system's)");
    add->add_option("--certificate", node.certificateFile, "Our certificate, PEM");
    add->add_option("--key", node.keyFile, "Its key, PEM; only the path is stored");
    add->add_flag("--any-host-name", arguments->isHostUnchecked, "The certificate need not be one of the host");
    add->add_option("--url", node.webUrl, "DICOMweb address, https://…");
    add->add_option("--authorization", node.authorizationFile, "File whose first line is sent as Authorization");
    add->add_option("--answer-seconds", node.answerSeconds, "How long one answer may take")->capture_default_str();
    add->footer("Example: angiopose-cli archive nodes add pacs --host pacs.example --port 104 --title PACS");
    add->callback([arguments, &exitCode] { exitCode = runArchiveAdd(*arguments); });
}

void addCache(CLI::App& archive, int& exitCode)
{
    auto* cache = archive.add_subcommand("cache", "What was retrieved and is kept");
    cache->require_subcommand(1);
    auto listed = std::make_shared<ArchiveCacheArguments>();
    auto* list = cache->add_subcommand("list", "Print it; with --limit, set how much is kept");
    addNodeFile(*list, listed->common);
    list->add_option("--limit", listed->limitGb, "GB; the longest unused is dropped first")
        ->check(CLI::Range(0.0, 1e5));
    list->callback([listed, &exitCode] { exitCode = runArchiveCacheList(*listed); });
    auto emptied = std::make_shared<ArchiveCacheArguments>();
    auto* empty = cache->add_subcommand("empty", "Drop all of it");
    addNodeFile(*empty, emptied->common);
    empty->callback([emptied, &exitCode] { exitCode = runArchiveCacheEmpty(*emptied); });
}

}   // namespace

void addArchive(CLI::App& app, int& exitCode)
{
    auto* archive = app.add_subcommand("archive", "Ask an archive (PACS): find, retrieve, send, receive");
    archive->require_subcommand(1);
    addEcho(*archive, exitCode);
    addFind(*archive, exitCode);
    addRetrieve(*archive, exitCode);
    addSend(*archive, exitCode);
    addReceive(*archive, exitCode);
    addNodeList(*archive, exitCode);
    addCache(*archive, exitCode);
    archive->footer(
        "Begin with: angiopose-cli archive nodes add pacs --host HOST --port 104 --title PACS\n"
        "            angiopose-cli archive echo pacs");
}

}   // namespace angiopose::app
