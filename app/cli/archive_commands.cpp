#include "app/cli/add_commands.h"

#include "app/cli/archive_arguments.h"
#include "app/cli/audit_hook.h"

#include <memory>

namespace angiopose::app {
namespace {

void addNodeFile(CLI::App& command, ArchiveArguments& connection)
{
    command.add_option("--nodes", connection.nodeFile, "PACS list file (default: the user's list)");
    command.add_flag_callback(
        "--json", [&connection] { connection.format = OutputFormat::Json; }, "Print JSON only");
}

void addNode(CLI::App& command, ArchiveArguments& connection)
{
    command.add_option("ARCHIVE", connection.nodeName, "Name in the PACS list")->required();
    addNodeFile(command, connection);
    command.add_flag_callback(
        "--web", [&connection] { connection.protocol = io::ArchiveProtocol::Web; },
        "Use DICOMweb even if a host is also specified for the PACS");
}

/// Returns the audit file of the program to which the archive commands belong.
std::string auditFileFor(const CLI::App& archive)
{
    return auditPathOf(*archive.get_parent());
}

void addEcho(CLI::App& archive, int& exitCode)
{
    auto* command = archive.add_subcommand("echo", "Check that a PACS responds (C-ECHO)");
    auto arguments = std::make_shared<ArchiveArguments>();
    addNode(*command, *arguments);
    command->callback([arguments, &exitCode] { exitCode = runArchiveEcho(*arguments); });
}

void addFind(CLI::App& archive, int& exitCode)
{
    auto* command = archive.add_subcommand("find", "Query a PACS for studies or series");
    auto arguments = std::make_shared<ArchiveFindArguments>();
    addNode(*command, arguments->connection);
    io::ArchiveQuery& query = arguments->query;
    command->add_option("--patient", query.patientName, "Beginning of the patient name, or a pattern with * and ?");
    command->add_option("--id", query.patientId, "Patient ID");
    command->add_option("--date", arguments->dates, "YYYY-MM-DD, or a range: 2024-01-01..2024-02-01, 2024-01-01..");
    command->add_option("--modality", query.modality, "CT, XA, …");
    command->add_option("--accession", query.accessionNumber, "Accession number");
    command->add_option("--study", query.studyUid, "Study Instance UID");
    command->add_flag_callback(
        "--series", [arguments] { arguments->query.level = io::ArchiveLevel::Series; },
        "List series instead of studies");
    command->footer(
        "Example: angiopose-cli archive find pacs --patient Meier --date 2024-01-01.. --modality XA --series");
    command->callback([arguments, &exitCode] { exitCode = runArchiveFind(*arguments); });
}

void addRetrieve(CLI::App& archive, int& exitCode)
{
    auto* command = archive.add_subcommand("retrieve", "Retrieve a study or series");
    auto arguments = std::make_shared<ArchiveRetrieveArguments>();
    addNode(*command, arguments->connection);
    command->add_option("--study", arguments->request.studyUid, "Study Instance UID")->required();
    command->add_option("--series", arguments->request.seriesUids,
                        "Series Instance UID; may be repeated (default: all)");
    command->add_option("--into", arguments->folder, "Destination folder (default: the cache)");
    command->add_option("--max-object", arguments->maxObjectGb, "Maximum size of an object in GB")
        ->check(CLI::Range(1e-6, 1000.0));
    command->footer("Example: angiopose-cli archive retrieve pacs --study 1.2.840.1 --series 1.2.840.1.3");
    command->callback([arguments, &archive, &exitCode] {
        arguments->auditFile = auditFileFor(archive);
        exitCode = runArchiveRetrieve(*arguments);
    });
}

void addSend(CLI::App& archive, int& exitCode)
{
    auto* command = archive.add_subcommand("send", "Send DICOM files unchanged to a PACS");
    auto arguments = std::make_shared<ArchiveSendArguments>();
    addNode(*command, arguments->connection);
    command->add_option("FILE", arguments->paths, "Files or folders")->required();
    command->footer("Example: angiopose-cli archive send pacs result.dcm");
    command->callback([arguments, &exitCode] { exitCode = runArchiveSend(*arguments); });
}

void addReceive(CLI::App& archive, int& exitCode)
{
    auto* command = archive.add_subcommand("receive", "Receive DICOM objects on a port (storage SCP) until Ctrl+C");
    auto arguments = std::make_shared<ArchiveReceiveArguments>();
    io::StorageScpOptions& options = arguments->options;
    command->add_option("--port", options.port, "Port to listen on")->required()->check(CLI::Range(1, 65535));
    command->add_option("--into", arguments->folder, "Folder for received objects")->required();
    command
        ->add_option("--title", options.ownAeTitle,
                     "Local AE title; calling applications must use it as the called AE title")
        ->capture_default_str();
    command->add_option("--from-title", options.titles, "Calling AE title to accept; may be repeated (default: any)");
    command->add_option("--from-host", options.hosts, "IP address to accept; may be repeated (default: any)");
    command->add_option("--max-object", arguments->maxObjectGb, "Maximum size of an object in GB")
        ->check(CLI::Range(1e-6, 1000.0));
    command->add_option("--max-total", arguments->maxGb, "Maximum size of the folder in GB (default: no limit)")
        ->check(CLI::Range(1e-6, 1e6));
    command->add_option("--count", arguments->count, "Stop after this many objects");
    auto* certificate =
        command->add_option("--tls-certificate", options.tls.certificateFile, "Local certificate (PEM); enables TLS");
    auto* key = command->add_option("--tls-key", options.tls.keyFile, "Private key of the local certificate (PEM)");
    command
        ->add_option("--tls-ca", options.tls.caFile,
                     "CA certificates (PEM) used to verify calling applications (default: the system's)")
        ->needs(certificate);
    certificate->needs(key);
    key->needs(certificate);
    command->add_flag_callback(
        "--json", [arguments] { arguments->format = OutputFormat::Json; }, "Print JSON only");
    command->footer("Example: angiopose-cli archive receive --port 11112 --into incoming --from-host 10.0.0.7");
    command->callback([arguments, &archive, &exitCode] {
        arguments->auditFile = auditFileFor(archive);
        exitCode = runArchiveReceive(*arguments);
    });
}

void addNodeList(CLI::App& archive, int& exitCode)
{
    auto* nodes = archive.add_subcommand("nodes", "Manage the PACS list");
    nodes->require_subcommand(1);
    auto listed = std::make_shared<ArchiveArguments>();
    auto* list = nodes->add_subcommand("list", "Print the list");
    addNodeFile(*list, *listed);
    list->callback([listed, &exitCode] { exitCode = runArchiveNodes(*listed); });

    auto removed = std::make_shared<ArchiveArguments>();
    auto* remove = nodes->add_subcommand("remove", "Remove a PACS from the list");
    remove->add_option("ARCHIVE", removed->nodeName)->required();
    addNodeFile(*remove, *removed);
    remove->callback([removed, &exitCode] { exitCode = runArchiveRemove(*removed); });

    auto arguments = std::make_shared<ArchiveNodeArguments>();
    auto* add = nodes->add_subcommand("add", "Add a PACS, or replace the PACS with the same name");
    io::ArchiveNode& node = arguments->node;
    add->add_option("ARCHIVE", node.name, "Name of the PACS")->required();
    addNodeFile(*add, arguments->connection);
    add->add_option("--host", node.host, "Host name or IP address");
    add->add_option("--port", node.port, "DICOM port of the PACS")->capture_default_str();
    add->add_option("--title", node.title, "Called AE title")->capture_default_str();
    add->add_option("--own-title", node.ownAeTitle, "Calling AE title")->capture_default_str();
    add->add_option("--receive-port", node.receivePort, "Local port for C-MOVE (default: C-GET only)");
    add->add_flag("--tls", node.isTls, "Use TLS for DIMSE");
    add->add_option("--ca", node.caFile, "CA certificates (PEM) used to verify the PACS (default: the system's)");
    add->add_option("--certificate", node.certificateFile, "Local certificate (PEM)");
    add->add_option("--key", node.keyFile, "Private key of the local certificate (PEM); only its path is stored");
    add->add_flag("--any-host-name", arguments->isHostUnchecked, "Accept a certificate issued for another host name");
    add->add_option("--url", node.webUrl, "DICOMweb address (https://…)");
    add->add_option("--authorization", node.authorizationFile,
                    "File whose first line is sent as the Authorization header");
    add->add_option("--answer-seconds", node.responseTimeoutSeconds, "Response timeout in seconds")
        ->capture_default_str();
    add->footer("Example: angiopose-cli archive nodes add pacs --host pacs.example --port 104 --title PACS");
    add->callback([arguments, &exitCode] { exitCode = runArchiveAdd(*arguments); });
}

void addCache(CLI::App& archive, int& exitCode)
{
    auto* cache = archive.add_subcommand("cache", "Manage the cache of retrieved objects");
    cache->require_subcommand(1);
    auto listed = std::make_shared<ArchiveCacheArguments>();
    auto* list = cache->add_subcommand("list", "List the cache; --limit sets its maximum size");
    addNodeFile(*list, listed->connection);
    list->add_option("--limit", listed->limitGb, "Maximum size in GB; the least recently used series are deleted first")
        ->check(CLI::Range(0.0, 1e5));
    list->callback([listed, &exitCode] { exitCode = runArchiveCacheList(*listed); });
    auto emptied = std::make_shared<ArchiveCacheArguments>();
    auto* empty = cache->add_subcommand("empty", "Delete all cached objects");
    addNodeFile(*empty, emptied->connection);
    empty->callback([emptied, &exitCode] { exitCode = runArchiveCacheEmpty(*emptied); });
}

}   // namespace

void addArchive(CLI::App& app, int& exitCode)
{
    auto* archive = app.add_subcommand(
        "archive", "Query a PACS, retrieve objects from it, send objects to it, and receive objects");
    archive->require_subcommand(1);
    addEcho(*archive, exitCode);
    addFind(*archive, exitCode);
    addRetrieve(*archive, exitCode);
    addSend(*archive, exitCode);
    addReceive(*archive, exitCode);
    addNodeList(*archive, exitCode);
    addCache(*archive, exitCode);
    archive->footer(
        "Start with: angiopose-cli archive nodes add pacs --host HOST --port 104 --title PACS\n            "
        "angiopose-cli archive echo pacs");
}

}   // namespace angiopose::app
