#include "app/cli/audit_hook.h"

#include "app/cli/console.h"
#include "io/sharing/audit_file.h"

#include <algorithm>
#include <array>
#include <filesystem>

namespace angiopose::app {
namespace {

using io::AuditEvent;

/// Names of the command-line operands that denote input and output files, over all commands.
constexpr std::array inputNames{"CASE",     "IN",     "FILE",   "FOLDER", "VOLUME", "IMAGE",
                                "MANIFEST", "--view", "--pose", "--case", "--from"};
constexpr std::array outputNames{"OUT", "PICTURE", "OUTPUT", "--output", "--mask", "--bent"};

std::vector<std::string> valuesOf(const CLI::App& command, const auto& names)
{
    std::vector<std::string> values;
    for (const char* name : names) {
        const CLI::Option* option = command.get_option_no_throw(name);
        if (option != nullptr && option->count() > 0) {
            const auto results = option->results();
            values.insert(values.end(), results.begin(), results.end());
        }
    }
    return values;
}

/// Removes paths that do not exist, because the audit file stores the hash of each file.
std::vector<std::string> existingPaths(std::vector<std::string> paths)
{
    std::erase_if(paths, [](const std::string& path) {
        std::error_code failed;
        return !std::filesystem::exists(path, failed);
    });
    return paths;
}

void record(const std::string& auditPath, AuditEvent event, std::vector<std::string> paths)
{
    if (paths.empty()) {
        return;
    }
    const core::Status written = io::recordAudit(auditPath, {event, "angiopose-cli", std::move(paths)});
    if (!written) {
        reportUnaudited(written.error().message);
    }
}

/// Returns the file for the audit entries of a command. The program that writes reports makes its own entries.
std::string auditPathFor(const CLI::App& app, const CLI::App& command)
{
    return command.get_name() == "report" && app.count("--audit") == 0 ? std::string() : auditPathOf(app);
}

bool isDeidentifying(const CLI::App& command)
{
    const CLI::Option* option = command.get_option_no_throw("--deidentify");
    return option != nullptr && option->count() > 0;
}

std::vector<std::string> outputsOf(const CLI::App& command)
{
    std::vector<std::string> outputs = valuesOf(command, outputNames);
    if (outputs.empty() && command.get_name() == "register") {
        const auto cases = valuesOf(command, std::array{"CASE"});
        outputs = {std::filesystem::path(cases.empty() ? "" : cases.front()).stem().string() + "-registered"};
    }
    return outputs;
}

void recordOutcome(const std::string& auditPath, const CLI::App& command)
{
    const std::string& name = command.get_name();
    if (name == "pack") {
        record(auditPath, AuditEvent::Packed, existingPaths(valuesOf(command, std::array{"ARCHIVE"})));
    } else if (name == "send") {
        record(auditPath, AuditEvent::Sent, existingPaths(valuesOf(command, std::array{"FILE"})));
    } else if (name == "retrieve" || name == "receive") {
        return;
    } else {
        const AuditEvent event = name == "register" || name == "batch" ? AuditEvent::Registered
                                 : isDeidentifying(command)            ? AuditEvent::Deidentified
                                                                       : AuditEvent::Exported;
        record(auditPath, event, existingPaths(outputsOf(command)));
    }
}

}   // namespace

std::string auditPathOf(const CLI::App& app)
{
    const CLI::Option* option = app.get_option_no_throw("--audit");
    return option != nullptr && option->count() > 0 ? option->results().front() : io::auditFileFromEnvironment();
}

void reportUnaudited(const core::Message& problem)
{
    printMessage("warning: " + problem.text());
}

void addAudit(CLI::App& app)
{
    app.add_option("--audit", "Audit log to which one line is appended for each file opened or written (FORMATS §4)")
        ->option_text("FILE");
    for (CLI::App* command : app.get_subcommands(nullptr)) {
        command->parse_complete_callback([&app, command] {
            const std::string auditPath = auditPathFor(app, *command);
            if (!auditPath.empty()) {
                record(auditPath, AuditEvent::Opened, existingPaths(valuesOf(*command, inputNames)));
            }
        });
    }
}

void auditOutcome(const CLI::App& app, int exitCode)
{
    if (exitCode != exitSuccess && exitCode != exitUnreliable) {
        return;
    }
    for (const CLI::App* command : app.get_subcommands()) {
        const auto below = command->get_subcommands();
        if (const std::string auditPath = auditPathFor(app, *command); !auditPath.empty()) {
            recordOutcome(auditPath, below.empty() ? *command : *below.front());
        }
    }
}

}   // namespace angiopose::app
