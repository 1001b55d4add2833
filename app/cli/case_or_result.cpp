#include "app/cli/case_or_result.h"

namespace angiopose::app {

void addCaseOrResult(CLI::App* command, std::string& casePath, ResultSource& from)
{
    auto* file = command->add_option("CASE", casePath, "Case file, *.angiopose");
    auto* result = command
                       ->add_option("--from", from.path,
                                    "Result to use instead of a case (result.json or joint.json), with all inputs from "
                                    "which it was computed")
                       ->excludes(file);
    command
        ->add_option("--inputs", from.inputFolders,
                     "Folder to search for the inputs of that result, by name and content, in addition to the folder "
                     "of the result; may be repeated")
        ->needs(result);
}

void requireCaseOrResult(const std::string& casePath, const ResultSource& from)
{
    if (casePath.empty() && from.path.empty()) {
        throw CLI::RequiredError("CASE or --from");
    }
}

}   // namespace angiopose::app
