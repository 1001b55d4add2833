#include "app/cli/add_commands.h"

#include "app/cli/console.h"
#include "app/cli/deidentify_options.h"
#include "io/sharing/pack_case.h"

#include <cstdio>

namespace angiopose::app {
namespace {

struct PackArguments {
    std::string casePath;
    std::string archivePath;
    std::shared_ptr<DeidentifyArguments> identity;
};

core::Result<core::Messages> pack(const PackArguments& arguments, const io::Pseudonyms& pseudonyms)
{
    ProgressLine progress("packing");
    return io::packCaseFile(arguments.casePath, arguments.archivePath,
                            {deidentificationOf(*arguments.identity), pseudonyms}, [&progress](double fraction) {
                                progress.show(fraction, "");
                                return isInterrupted() ? core::ObserverDecision::Stop
                                                       : core::ObserverDecision::Continue;
                            });
}

int runPack(const PackArguments& arguments)
{
    const auto pseudonyms = pseudonymsOf(*arguments.identity);
    if (!pseudonyms) {
        return reportInputError(pseudonyms.error());
    }
    const auto packed = pack(arguments, pseudonyms.value());
    if (!packed) {
        return reportInputError(packed.error());
    }
    printWarnings(packed.value());
    std::printf("%s\n", arguments.archivePath.c_str());
    return exitSuccess;
}

}   // namespace

void addPack(CLI::App& app, int& exitCode)
{
    auto* command = app.add_subcommand("pack", "Pack a case, its inputs and its results into one ZIP archive");
    auto arguments = std::make_shared<PackArguments>();
    command->add_option("CASE", arguments->casePath, "Case file, *.angiopose")->required();
    command->add_option("ARCHIVE", arguments->archivePath, "Archive to write (.zip)")->required();
    arguments->identity = addDeidentifyOptions(*command);
    command->footer(
        "After unpacking, case.angiopose can be opened on any computer.\n\nExample: angiopose-cli pack case.angiopose "
        "for-others.zip --deidentify");
    command->callback([arguments, &exitCode] { exitCode = runPack(*arguments); });
}

}   // namespace angiopose::app
