#include "app/cli/case_or_result.h"

namespace angiopose::app {

void addCaseOrResult(CLI::App* command, std::string& casePath, FromResult& from)
{
    auto* file = command->add_option("CASE", casePath, "Case file, *.angiopose");
    auto* result =
        command
            ->add_option(
                "--from", from.path,
                "Result to use instead of a case: result.json or joint.json, with everything it was computed from")
            ->excludes(file);
    command
        ->add_option("--inputs", from.inputFolders,
                     "Folder with the inputs of that result, matched by name and content, in addition to its own "
                     "folder; may be repeated")
        ->needs(result);
}

void needCaseOrResult(const std::string& casePath, const FromResult& from)
{
    if (casePath.empty() && from.path.empty()) {
        throw CLI::RequiredError("CASE or --from");
    }
}

}   // namespace angiopose::app
