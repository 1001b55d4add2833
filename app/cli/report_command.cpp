#include "app/cli/add_commands.h"

#include "app/cli/console.h"
#include "app/messages/messages.h"
#include "io/support/system/current_process.h"
#include "io/support/system/run_program.h"

#include <filesystem>
#include <memory>

namespace angiopose::app {
namespace {

struct ReportArguments {
    std::string casePath;
    std::string outputPath;
    bool isRegistered = false;
    std::string templatePath;
    std::string author;
    bool isIdentityShown = false;
    std::string language;
};

/// Builds the arguments for the GUI program. Values follow "=" because they may begin with a dash.
std::vector<std::string> guiReportArguments(const ReportArguments& arguments)
{
    std::vector<std::string> words{"--report=" + arguments.outputPath};
    if (arguments.isRegistered) {
        words.emplace_back("--register");
    }
    if (!arguments.templatePath.empty()) {
        words.push_back("--template=" + arguments.templatePath);
    }
    if (!arguments.author.empty()) {
        words.push_back("--author=" + arguments.author);
    }
    if (arguments.isIdentityShown) {
        words.emplace_back("--identity");
    }
    if (!arguments.language.empty()) {
        words.push_back("--language=" + arguments.language);
    }
    words.emplace_back("--");
    words.push_back(arguments.casePath);
    return words;
}

/// Returns the path of the GUI program next to this one or, if the location of this program is unknown (no /proc), the
/// bare name, to be found on PATH.
std::string guiProgramPath()
{
    const std::filesystem::path own = io::currentBinaryPath();
    return own.has_parent_path() ? (own.parent_path() / "angiopose").string() : "angiopose";
}

/// Runs the GUI program to write the report: Qt lays out text and pages, and this program is not linked to Qt.
int runReport(const ReportArguments& arguments)
{
    const std::string program = guiProgramPath();
    const io::ProgramExit end = io::runProgram(program, guiReportArguments(arguments), isInterrupted);
    if (!end.isStarted) {
        return reportInputError(messages::reportProgramMissing(program));
    }
    return end.signal != 0 ? reportInputError(messages::reportProgramFault(std::to_string(end.signal))) : end.exitCode;
}

}   // namespace

void addReport(CLI::App& app, int& exitCode)
{
    auto* command = app.add_subcommand("report", "Write the report of a case as PDF or HTML");
    auto arguments = std::make_shared<ReportArguments>();
    command->add_option("CASE", arguments->casePath, "Case file, *.angiopose")->required();
    command->add_option("--output", arguments->outputPath, "Report to write (.pdf or .html)")->required();
    command->add_flag("--register", arguments->isRegistered,
                      "Register the case first (default: report the current pose)");
    command->add_option("--template", arguments->templatePath, "Report template (.html; default: built-in)");
    command->add_option("--author", arguments->author, "Author of the report (default: the account name)");
    command->add_flag("--identity", arguments->isIdentityShown, "Include the patient's identity (default: omitted)");
    command->add_option("--language", arguments->language, "Language of the report (default: UI language)")
        ->check(CLI::IsMember({"en", "de", "zh_CN"}));
    command->footer(
        "The report is created by the program angiopose, which must be in the same folder; no display is "
        "required.\nExit code 4: the pose of the report is not reliable.\n\nExample: angiopose-cli report "
        "case.angiopose --register --output report.pdf");
    command->callback([arguments, &exitCode] { exitCode = runReport(*arguments); });
}

}   // namespace angiopose::app
