#include "app/cli/add_commands.h"

#include "app/cli/commands.h"
#include "app/cli/common_options.h"
#include "app/cli/evaluate_own.h"
#include "core/evaluation/protocols/protocol.h"

#include <memory>

namespace angiopose::app {
namespace {

std::string protocolList()
{
    std::string text = "Experiments and their conditions (*: run by default):";
    for (const core::Protocol& protocol : core::protocols()) {
        text += "\n  " + std::string(protocol.id) + "  " + std::string(protocol.summary) + " " +
                std::to_string(protocol.defaultTrials) + " trials.\n   ";
        for (const core::Condition& condition : protocol.conditions) {
            text += " " + condition.id + (condition.isStandard ? "*" : "");
        }
    }
    return text +
           "\n  own  Your own cases, with reference poses, landmarks or point pairs.\n  observers  Agreement of "
           "observers who registered the vessels manually (blind trial logs).";
}

std::vector<std::string> protocolIds()
{
    std::vector<std::string> ids;
    for (const core::Protocol& protocol : core::protocols()) {
        ids.emplace_back(protocol.id);
    }
    ids.emplace_back(userCasesProtocol);
    ids.emplace_back(observerLogs);
    return ids;
}

}   // namespace

void addSimulate(CLI::App& app, int& exitCode)
{
    auto* command = app.add_subcommand("simulate", "Generate a synthetic case with a known pose");
    auto arguments = std::make_shared<SimulateArguments>();
    auto* seed =
        command->add_option("--seed", arguments->seed, "Seed for one case; the same seed reproduces the same case");
    auto* study = command->add_option("--study", arguments->studyPath,
                                      "Study file for many cases; specifies the trees, the settings and how many cases "
                                      "of each to generate (FORMATS)");
    study->excludes(seed);
    command->add_option("--output", arguments->outputFolder, "Output folder for the case and its files")->required();
    command->add_option("--branches", arguments->branches, "Number of branches")->check(CLI::Range(1, 200));
    command
        ->add_option("--non-rigid", arguments->nonRigidMm,
                     "Standard deviation in mm of the smooth deformation of the true vessels")
        ->check(CLI::Range(0.0, 10.0));
    command->add_flag("--scan", arguments->withScan,
                      "Also write a simulated CT angiogram of the same vessels, scan.nii.gz");
    auto* room =
        command
            ->add_option(
                "--room", arguments->room,
                "Generate two views of one study, view-1 and view-2, with the headers of an angiography room: siemens, "
                "standard (with isocenter and table position), without-table, object-plane (with neither)")
            ->check(CLI::IsMember({"siemens", "standard", "without-table", "object-plane"}))
            ->needs(seed);
    command->add_flag("--table-moves", arguments->moveTable, "With --room: the table moves during the second view")
        ->needs(room);
    command
        ->add_flag("--mirrored", arguments->isMirrored,
                   "With --room: the second view is mirrored, as stated in its header")
        ->needs(room);
    command
        ->add_option("--threads", arguments->threads,
                     "Number of threads for --study; the cases do not depend on it (default: all cores)")
        ->check(CLI::Range(1, 1024))
        ->needs(study);
    command->add_option("--shard", arguments->shard, "Generate part I of N of the cases of a study, as I/N")
        ->capture_default_str()
        ->needs(study);
    command->footer(
        "Examples: angiopose-cli simulate --seed 7 --scan --output demo\n"
        "          angiopose-cli simulate --study study.json --output study");
    command->callback([arguments, &exitCode] { exitCode = runSimulate(*arguments); });
}

void addEvaluate(CLI::App& app, int& exitCode)
{
    auto* command = app.add_subcommand(
        "evaluate", "Run an experiment with known ground truth; print the result tables and write them to files");
    auto arguments = std::make_shared<EvaluateArguments>();
    command->add_option("EXPERIMENT", arguments->protocol, "Experiment; see the list below")
        ->required()
        ->check(CLI::IsMember(protocolIds()));
    command->add_option("INPUT", arguments->inputPaths,
                        "For own: the table of cases and their ground truth; for observers: blind trial logs");
    command->add_option("--method", arguments->methods,
                        "Methods, comma-separated; the first is compared with the others; settings after colons: "
                        "dynaweight:seed_mean:rotationFirst=off. Groups: all, ablation. Default: " +
                            std::string(defaultMethods) + "; for own cases the method and options of each case");
    command->add_option("--condition", arguments->conditions,
                        "Conditions or prefixes of conditions, comma-separated, or all");
    command->add_option("--trials", arguments->trials, "Trials per condition")
        ->check(CLI::Range(std::uint64_t{1}, std::uint64_t{10000000}));
    command->add_option("--seed", arguments->seed, "Random seed; determines the trees and initial poses")
        ->capture_default_str();
    command
        ->add_option("--threads", arguments->threads,
                     "Number of threads; affects only the computing time, not the results (default: all cores)")
        ->check(CLI::Range(1, 1024));
    auto* shard = command->add_option("--shard", arguments->shard, "Run part I of N of the trials, as I/N")
                      ->capture_default_str();
    command
        ->add_option("--merge", arguments->mergedFolders,
                     "Run no trials; merge the results in these folders (shards, methods or conditions)")
        ->excludes(shard);
    command->add_option("--output", arguments->outputFolder, "Output folder for tables, plots and runs.csv")
        ->required();
    command->footer([] {
        return protocolList() + "\n\n" + methodList() +
               "\n\nExamples: angiopose-cli evaluate simulation --trials 200 --output simulation\n"
               "          angiopose-cli evaluate simulation --method ablation --condition cam-2-5 --output ablation\n"
               "          angiopose-cli evaluate toy --shard 1/2 --output a   (and 2/2 to b, on another machine)\n"
               "          angiopose-cli evaluate toy --merge a b --output toy\n"
               "          angiopose-cli evaluate own cases.csv --method angiopose,dynaweight --output own\n"
               "          angiopose-cli evaluate observers trials.csv --output observers";
    });
    command->callback([arguments, &exitCode] { exitCode = runEvaluate(*arguments); });
}

}   // namespace angiopose::app
