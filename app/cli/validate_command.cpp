#include "app/cli/add_warnings.h"
#include "app/cli/commands.h"
#include "io/case/case_file.h"

#include <cstdio>
#include <nlohmann/json.hpp>

namespace angiopose::app {

int runValidate(const FileArguments& arguments)
{
    const auto problems = io::validateCase(arguments.path);
    if (!problems) {
        return reportInputError(problems.error(), arguments.format);
    }
    core::Messages warnings;
    if (problems.value().empty()) {
        auto doubts = io::checkCaseGeometry(arguments.path);
        warnings =
            doubts ? std::move(doubts).value() : core::Messages{doubts.error().message.as(core::Severity::Warning)};
    }
    if (arguments.format == OutputFormat::Json) {
        nlohmann::ordered_json report{{"file", arguments.path}, {"valid", problems.value().empty()}};
        report["problems"] = nlohmann::json::array();
        for (const core::Message& problem : problems.value()) {
            report["problems"].push_back(problem.text());
        }
        addWarnings(report, warnings);
        for (const core::Message& problem : problems.value()) {
            report["messages"].push_back(
                nlohmann::ordered_json::parse(io::messageJson(problem.as(core::Severity::Error))));
        }
        std::puts(report.dump(2).c_str());
    } else if (problems.value().empty()) {
        std::printf("%s: valid\n", arguments.path.c_str());
    }
    for (const core::Message& problem : problems.value()) {
        printMessage(arguments.path + ": " + problem.text());
    }
    for (const core::Message& warning : warnings) {
        printMessage(arguments.path + ": warning: " + warning.text());
    }
    return problems.value().empty() ? exitSuccess : exitInputError;
}

}   // namespace angiopose::app
