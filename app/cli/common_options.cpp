#include "app/cli/common_options.h"

#include "core/registration/methods/method_info.h"
#include "core/registration/options/registration_options.h"

#include <algorithm>

namespace angiopose::app {

void addCaseOrResult(CLI::App* command, std::string& casePath, ResultSource& from)
{
    auto* file = command->add_option("CASE", casePath, "Case file, *.angiopose");
    auto* result = command
                       ->add_option("--from", from.path,
                                    "Result to use instead of a case (result.json or joint.json), together with all "
                                    "inputs from which it was computed")
                       ->excludes(file);
    command
        ->add_option("--inputs", from.inputFolders,
                     "Folder to search for the inputs of the result, by file name and contents, in addition to the "
                     "folder of the result; may be repeated")
        ->needs(result);
}

void requireCaseOrResult(const std::string& casePath, const ResultSource& from)
{
    if (casePath.empty() && from.path.empty()) {
        throw CLI::RequiredError("CASE or --from");
    }
}

CLI::Option* addFrameOption(CLI::App& command, std::optional<int>& frame, const std::string& help)
{
    return command.add_option_function<int>(
        "--frame", [&frame](int number) { frame = std::max(number, 0) - 1; }, help);
}

std::string methodList()
{
    std::string text = "Methods:";
    for (const core::MethodInfo& method : core::methodInfos()) {
        text += "\n  " + std::string(method.id) + "  " + std::string(method.summary);
    }
    return text;
}

}   // namespace angiopose::app
