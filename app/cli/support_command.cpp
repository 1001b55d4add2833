#include "app/cli/add_commands.h"

#include "app/cli/console.h"
#include "io/opening/read_case_inputs.h"
#include "io/sharing/case_summary.h"
#include "io/sharing/support_bundle.h"

#include <cstdio>
#include <memory>

namespace angiopose::app {
namespace {

struct SupportArguments {
    std::string archivePath;
    std::string casePath;
    bool isShownAlone = false;
};

/// Adds a description of the case, and adds its patient identifiers to the redaction.
core::Status addCase(const std::string& path, io::Redaction& redaction, std::vector<io::SupportFile>& texts)
{
    core::Messages nobodyReads;
    const auto session = io::openCase(path, nobodyReads, [](double) {
        return isInterrupted() ? core::ObserverDecision::Stop : core::ObserverDecision::Continue;
    });
    if (!session) {
        return session.error();
    }
    redaction.addPath(path);
    io::addIdentifiers(session.value(), redaction);
    for (const core::InputFile* file : {&session.value().vessels.file, &session.value().vessels.scanFile}) {
        io::addIdentifiersOfFile(file->path, redaction);
    }
    for (const core::View& view : session.value().views) {
        io::addIdentifiersOfFile(view.imageFile.path, redaction);
    }
    texts.push_back({"case.txt", io::caseSummary(session.value())});
    return core::Done{};
}

int runSupportBundle(const SupportArguments& arguments)
{
    io::Redaction redaction;
    auto texts = io::diagnosticFiles();
    if (!arguments.casePath.empty()) {
        if (const auto added = addCase(arguments.casePath, redaction, texts); !added) {
            return reportInputError(added.error());
        }
    }
    texts = io::redact(std::move(texts), redaction);
    if (arguments.isShownAlone) {
        std::fputs(io::joinTexts(texts).c_str(), stdout);
        return exitSuccess;
    }
    if (const auto written = io::writeSupportBundle(texts, arguments.archivePath); !written) {
        return reportInputError(written.error());
    }
    for (const io::SupportFile& supportText : texts) {
        printMessage("added: " + supportText.name + ", " + std::to_string(supportText.text.size()) + " bytes");
    }
    std::printf("%s\n", arguments.archivePath.c_str());
    return exitSuccess;
}

}   // namespace

void addSupportBundle(CLI::App& app, int& exitCode)
{
    auto* command = app.add_subcommand(
        "support-bundle", "Create a support bundle with diagnostic information for a bug report; it contains no names");
    auto arguments = std::make_shared<SupportArguments>();
    auto* archive = command->add_option("OUTPUT", arguments->archivePath, "Archive to write (.zip)");
    command->add_option("--case", arguments->casePath, "Case to summarize in the bundle: input types, sizes, options");
    auto* show = command->add_flag("--show", arguments->isShownAlone, "Print the contents without writing a file");
    archive->excludes(show);
    command->footer(
        "Contains versions, system information and the last crash dumps. Names, folders, UIDs and dates are removed; "
        "review the\ncontents before sharing.\n\nExample: angiopose-cli support-bundle for-support.zip --case "
        "case.angiopose");
    command->callback([arguments, archive, show, &exitCode] {
        if (archive->count() == 0 && show->count() == 0) {
            throw CLI::RequiredError("OUTPUT or --show");
        }
        exitCode = runSupportBundle(*arguments);
    });
}

}   // namespace angiopose::app
