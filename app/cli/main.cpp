#include "app/cli/commands.h"
#include "app/cli/vessel_commands.h"
#include "core/evaluation/protocol.h"
#include "core/registration/registration_options.h"

#include <CLI/CLI.hpp>
#include <clocale>
#include <exception>
#include <iostream>

namespace {

using namespace app;

std::string methodList()
{
    std::string text = "Methods:";
    for (const core::MethodInfo& method : core::methodInfos()) {
        text += "\n  " + std::string(method.id) + "  " + std::string(method.summary);
    }
    return text;
}

std::string optionList()
{
    std::string text = "Options of --set, with their range:";
    for (const core::OptionField& field : core::optionFields()) {
        text += "\n  " + std::string(field.key);
        if (!field.choices.empty()) {
            text += "=";
            for (const std::string_view choice : field.choices) {
                text += (text.back() == '=' ? "" : "|") + std::string(choice);
            }
        }
        text += "  " + std::string(field.help);
    }
    return text;
}

void addRegister(CLI::App& app, int& exitCode)
{
    auto* command = app.add_subcommand("register", "Find the pose of the vessel tree in the angiogram of a case");
    auto arguments = std::make_shared<RegisterArguments>();
    command->add_option("CASE", arguments->casePath, "Case file, *.angiopose")->required();
    command->add_option("--method", arguments->method, "Method id; see the list below");
    command->add_option("--set", arguments->options, "Option of the method as key=value; may be repeated");
    command->add_option("--auxiliary", arguments->auxiliaryBranchIds, "Branches of the auxiliary problem, e.g. 1,2,5")
        ->delimiter(',');
    command->add_option("--exclude", arguments->excludedBranchIds, "Branches left out, e.g. 7,9")->delimiter(',');
    command->add_option("--lock", arguments->locks, "What stays as it is, of " + core::poseAxisIds() + ", or none")
        ->delimiter(',');
    command->add_option("--frame", arguments->frame, "Frame of the angiogram, from 0");
    command->add_option("--view", arguments->otherViews,
                        "Case of the same vessels in another view, registered together; may be repeated");
    command->add_option("--output", arguments->outputFolder,
                        "Folder for result.json, overlay.png and pose.tfm (default: CASE-registered)");
    command->add_flag_callback(
        "--json", [arguments] { arguments->format = OutputFormat::Json; }, "Print the result as JSON and nothing else");
    command->footer([] {
        return methodList() + "\n\n" + optionList() +
               "\n\nExample: angiopose-cli register case.angiopose --method angiopose --output result";
    });
    command->callback([arguments, &exitCode] { exitCode = runRegister(*arguments); });
}

void addTrack(CLI::App& app, int& exitCode)
{
    auto* command = app.add_subcommand("track", "Follow the vessels of a case through the frames of its run");
    auto arguments = std::make_shared<TrackArguments>();
    command->add_option("CASE", arguments->casePath, "Case file, *.angiopose")->required();
    command->add_option("--output", arguments->outputPath, "Table of poses to write, .csv")->required();
    command->add_flag("--keep-pose", arguments->keepPose,
                      "Follow from the pose of the case (default: its frame is registered first)");
    command->footer("Example: angiopose-cli track case.angiopose --output poses.csv");
    command->callback([arguments, &exitCode] { exitCode = runTrack(*arguments); });
}

void addProject(CLI::App& app, int& exitCode)
{
    auto* command = app.add_subcommand("project", "Draw the projected tree of a case at a given pose");
    auto arguments = std::make_shared<ProjectArguments>();
    command->add_option("CASE", arguments->casePath, "Case file, *.angiopose")->required();
    command->add_option("--pose", arguments->posePath, "Pose: .json or .tfm (default: the pose of the case)");
    command->add_option("--output", arguments->outputPath, "Picture to write, .png")->required();
    command->add_option("--width", arguments->widthPx, "Width of the picture in pixels (default: twice the image)")
        ->check(CLI::Range(64, 8192));
    command->add_option("--frame", arguments->frame, "Frame of the angiogram, from 0");
    command->footer("Example: angiopose-cli project case.angiopose --pose result/result.json --output overlay.png");
    command->callback([arguments, &exitCode] { exitCode = runProject(*arguments); });
}

void addSimulate(CLI::App& app, int& exitCode)
{
    auto* command = app.add_subcommand("simulate", "Make a synthetic case whose pose is known");
    auto arguments = std::make_shared<SimulateArguments>();
    command->add_option("--seed", arguments->seed, "Same seed, same case")->required();
    command->add_option("--output", arguments->outputFolder, "Folder for the case and its files")->required();
    command->add_option("--branches", arguments->branches, "Number of branches")->check(CLI::Range(1, 200));
    command->add_option("--non-rigid", arguments->nonRigidMm, "Smooth deformation of the true vessel, std in mm")
        ->check(CLI::Range(0.0, 10.0));
    command->footer("Example: angiopose-cli simulate --seed 7 --output demo");
    command->callback([arguments, &exitCode] { exitCode = runSimulate(*arguments); });
}

void addTraceAngiogram(CLI::App& app, int& exitCode)
{
    auto* command = app.add_subcommand("trace-angiogram", "Trace the vessels of an angiogram as 2-D centrelines");
    auto arguments = std::make_shared<TraceAngiogramArguments>();
    command->add_option("IMAGE", arguments->imagePath, "DICOM, PNG, TIFF or JPEG")->required();
    command->add_option("--frame", arguments->frame, "Frame, from 0 (default: the fullest)");
    command->add_option("--output", arguments->outputPath, "Centrelines to write, .csv")->required();
    command->add_option("--mask", arguments->maskPath, "Vessel mask to write, .png");
    command->add_option("--sensitivity", arguments->sensitivity, "Above 1: fainter vessels too")
        ->check(CLI::Range(0.2, 5.0));
    command->add_flag("--subtract", arguments->subtract, "Subtract the frames before the contrast first");
    command->add_option("--mask-frames", arguments->maskFrames, "Frames to average and subtract, from 0")
        ->delimiter(',');
    command->add_option("--mask-shift", arguments->maskShiftPx, "Px right,down that they move (default: found)")
        ->delimiter(',')
        ->expected(2);
    command
        ->add_option_function<std::string>(
            "--composite", [arguments](const std::string&) { arguments->composite = true; },
            "Trace all frames in one: minimum (what each pixel is filled with at most)")
        ->check(CLI::IsMember({"minimum"}))
        ->excludes("--frame");
    command->footer("Example: angiopose-cli trace-angiogram run.dcm --frame 5 --output centreline.csv --mask mask.png");
    command->callback([arguments, &exitCode] { exitCode = runTraceAngiogram(*arguments); });
}

std::string protocolList()
{
    std::string text = "Experiments, and their conditions (* runs when none is asked for):";
    for (const core::Protocol& protocol : core::protocols()) {
        text += "\n  " + std::string(protocol.id) + "  " + std::string(protocol.summary) + " " +
                std::to_string(protocol.defaultTrials) + " trials.\n   ";
        for (const core::Condition& condition : protocol.conditions) {
            text += " " + condition.id + (condition.isStandard ? "*" : "");
        }
    }
    return text;
}

std::vector<std::string> protocolIds()
{
    std::vector<std::string> ids;
    for (const core::Protocol& protocol : core::protocols()) {
        ids.emplace_back(protocol.id);
    }
    return ids;
}

void addEvaluate(CLI::App& app, int& exitCode)
{
    auto* command = app.add_subcommand("evaluate", "Run an experiment whose answers are known; print and write tables");
    auto arguments = std::make_shared<EvaluateArguments>();
    command->add_option("EXPERIMENT", arguments->protocol, "See the list below")
        ->required()
        ->check(CLI::IsMember(protocolIds()));
    command
        ->add_option("--method", arguments->methods,
                     "Methods, comma-separated, the one to compare with first; settings after colons: "
                     "dynaweight:seed_mean:rotationFirst=off. Groups: all, ablation")
        ->capture_default_str();
    command->add_option("--condition", arguments->conditions,
                        "Conditions or their beginnings, comma-separated, or all");
    command->add_option("--trials", arguments->trials, "Trials of each condition")
        ->check(CLI::Range(std::uint64_t{1}, std::uint64_t{10000000}));
    command->add_option("--seed", arguments->seed, "Another seed, other trees and start poses")->capture_default_str();
    command
        ->add_option("--threads", arguments->threads, "Changes the time only, never the numbers (default: all cores)")
        ->check(CLI::Range(1, 1024));
    auto* shard =
        command->add_option("--shard", arguments->shard, "Part I of N of the trials, as I/N")->capture_default_str();
    command
        ->add_option("--merge", arguments->mergedFolders,
                     "Run nothing: bring the runs in these folders together (shards, methods or conditions)")
        ->excludes(shard);
    command->add_option("--output", arguments->outputFolder, "Folder for tables, plots and runs.csv")->required();
    command->footer([] {
        return protocolList() + "\n\n" + methodList() +
               "\n\nExamples: angiopose-cli evaluate simulation --trials 200 --output simulation\n"
               "          angiopose-cli evaluate simulation --method ablation --condition cam-2-5 --output ablation\n"
               "          angiopose-cli evaluate toy --shard 1/2 --output a   (and 2/2 to b, on another machine)\n"
               "          angiopose-cli evaluate toy --merge a b --output toy";
    });
    command->callback([arguments, &exitCode] { exitCode = runEvaluate(*arguments); });
}

void addBatch(CLI::App& app, int& exitCode)
{
    auto* command = app.add_subcommand("batch", "Register many cases; one that fails never stops the others");
    auto arguments = std::make_shared<BatchArguments>();
    command
        ->add_option("MANIFEST", arguments->manifestPath,
                     "CSV with the column case (paths, relative to it), and where wanted name, method, frame")
        ->required();
    command->add_option("--shard", arguments->shard, "Part I of N of the rows, as I/N")->capture_default_str();
    command->add_option("--output", arguments->outputFolder, "Folder for summary.csv and a folder for each case")
        ->required();
    command->footer(
        "Exit codes: 0 all done, 3 some failed, 4 some not trustworthy, 130 stopped; summary.csv says which.\n\n"
        "Example: angiopose-cli batch cases.csv --output results");
    command->callback([arguments, &exitCode] { exitCode = runBatch(*arguments); });
}

void addFileCommand(CLI::App& app, int& exitCode, const std::string& name, const std::string& help,
                    int (*run)(const FileArguments&))
{
    auto* command = app.add_subcommand(name, help);
    auto arguments = std::make_shared<FileArguments>();
    command->add_option("FILE", arguments->path)->required();
    command->add_flag_callback(
        "--json", [arguments] { arguments->format = OutputFormat::Json; }, "Print JSON and nothing else");
    command->footer("Example: angiopose-cli " + name + " case.angiopose");
    command->callback([arguments, run, &exitCode] { exitCode = run(*arguments); });
}

int parseAndRun(int argc, char** argv)
{
    int exitCode = exitDone;
    CLI::App app("AngioPose: where a 3-D vessel tree lies in a 2-D angiogram. Not for clinical use.", "angiopose-cli");
    app.set_version_flag("--version", std::string("angiopose-cli ") + ANGIOPOSE_VERSION);
    app.require_subcommand(1);
    app.footer(
        "Exit codes: 0 done, 2 wrong usage, 3 input missing or invalid, 4 result not trustworthy, 130 stopped.\n"
        "Help on a command: angiopose-cli COMMAND --help");
    addRegister(app, exitCode);
    addTrack(app, exitCode);
    addProject(app, exitCode);
    addSimulate(app, exitCode);
    addTraceAngiogram(app, exitCode);
    addEvaluate(app, exitCode);
    addBatch(app, exitCode);
    addTraceVessel(app, exitCode);
    addConvert(app, exitCode);
    addFileCommand(app, exitCode, "info", "Say what a file holds and what follows from it", runInfo);
    addFileCommand(app, exitCode, "validate", "Check a case file and name every problem", runValidate);
    try {
        app.parse(argc, argv);
    } catch (const CLI::ParseError& error) {
        return app.exit(error) == 0 ? exitDone : exitUsage;
    }
    return exitCode;
}

}   // namespace

int main(int argc, char** argv)
{
    std::setlocale(LC_ALL, "C");
    app::catchInterrupts();
    try {
        return parseAndRun(argc, argv);
    } catch (const std::bad_alloc&) {
        return app::failInput("There is not enough memory for this input.");
    } catch (const std::exception& error) {
        return app::failInput(std::string("Unexpected failure: ") + error.what());
    }
}
