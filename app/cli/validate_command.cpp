#include "app/cli/commands.h"
#include "io/case_file.h"

#include <cstdio>
#include <nlohmann/json.hpp>

namespace angiopose::app {

int runValidate(const FileArguments& arguments)
{
    const auto problems = io::validateCase(arguments.path);
    if (!problems) {
        return failInput(problems.error().message);
    }
    std::vector<std::string> warnings;
    if (problems.value().empty()) {
        auto doubts = io::doubtsOfCase(arguments.path);
        warnings = doubts ? std::move(doubts).value() : std::vector{doubts.error().message};
    }
    if (arguments.format == OutputFormat::Json) {
        const nlohmann::json report{{"file", arguments.path},
                                    {"valid", problems.value().empty()},
                                    {"problems", problems.value()},
                                    {"warnings", warnings}};
        std::puts(report.dump(2).c_str());
    } else if (problems.value().empty()) {
        std::printf("%s: valid\n", arguments.path.c_str());
    }
    for (const std::string& problem : problems.value()) {
        printMessage(arguments.path + ": " + problem);
    }
    for (const std::string& warning : warnings) {
        printMessage(arguments.path + ": warning: " + warning);
    }
    return problems.value().empty() ? exitDone : exitInput;
}

}   // namespace angiopose::app