#include "app/cli/commands.h"
#include "io/case_file.h"

#include <cstdio>
#include <nlohmann/json.hpp>

namespace app {

int runValidate(const FileArguments& arguments)
{
    const auto problems = io::validateCase(arguments.path);
    if (!problems) {
        return failInput(problems.error().message);
    }
    if (arguments.format == OutputFormat::Json) {
        const nlohmann::json report{
            {"file", arguments.path}, {"valid", problems.value().empty()}, {"problems", problems.value()}};
        std::puts(report.dump(2).c_str());
    } else if (problems.value().empty()) {
        std::printf("%s: valid\n", arguments.path.c_str());
    }
    for (const std::string& problem : problems.value()) {
        printMessage(arguments.path + ": " + problem);
    }
    return problems.value().empty() ? exitDone : exitInput;
}

}   // namespace app
