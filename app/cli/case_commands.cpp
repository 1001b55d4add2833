#include "app/cli/add_commands.h"

#include "app/cli/commands.h"
#include "app/cli/common_options.h"
#include "core/registration/options/option_fields.h"
#include "io/case/case_settings.h"

#include <map>
#include <memory>

namespace angiopose::app {
namespace {

std::string optionList()
{
    std::string text = "Options for --set and their ranges:";
    for (const core::OptionField& field : core::optionFields()) {
        text += "\n  " + std::string(field.key);
        for (const std::string_view& name : core::namesOf(field)) {
            text += (&name == core::namesOf(field).data() ? "=" : "|") + std::string(name);
        }
        text += "  " + std::string(field.help);
    }
    return text;
}

std::string settingList()
{
    std::string text = "Settings, method options first (see register --help):";
    for (const std::string& name : io::caseSettingNames()) {
        text += "\n  " + name;
    }
    return text;
}

}   // namespace

void addRegister(CLI::App& app, int& exitCode)
{
    auto* command = app.add_subcommand("register", "Register the vessel tree of a case to its angiogram");
    auto arguments = std::make_shared<RegisterArguments>();
    addCaseOrResult(command, arguments->casePath, arguments->from);
    command
        ->add_option("ANGIOGRAM", arguments->angiogramPath,
                     "Angiogram, if CASE is not a case file but a vessel tree or a scan to trace")
        ->excludes("--from");
    command->add_option("--save", arguments->savedPath,
                        "Case file (*.angiopose) in which to save the result, for the window and all other commands");
    command->add_option("--method", arguments->method, "Method ID; see the list below");
    command->add_option("--set", arguments->options, "Method option as key=value; may be repeated");
    command->add_option("--auxiliary", arguments->auxiliaryBranchIds, "Auxiliary branches, e.g. 1,2,5")->delimiter(',');
    command->add_option("--exclude", arguments->excludedBranchIds, "Branches to exclude, e.g. 7,9")->delimiter(',');
    command->add_option("--lock", arguments->locks, "Degrees of freedom to lock: " + core::poseAxisIds() + ", or none")
        ->delimiter(',');
    addFrameOption(*command, arguments->frame, "Frame of the angiogram, starting at 1");
    command->add_option("--view", arguments->otherViews,
                        "Case with another view of the same vessels, to be registered jointly; may be repeated");
    command->add_flag("--same-patient", arguments->isSamePatient,
                      "Confirm that all images show the same patient even if their headers differ; without this "
                      "option, results from such images are never rated reliable");
    command->add_flag("--deformable", arguments->deformVessels,
                      "Deform the vessels after rigid registration if the image supports a deformation; writes "
                      "bent.vtp and motion.csv");
    command->add_option("--output", arguments->outputFolder,
                        "Output folder for result.json, overlay.png and pose.tfm (default: CASE-registered)");
    command->add_flag_callback(
        "--json", [arguments] { arguments->format = OutputFormat::Json; }, "Print only the result, as JSON");
    command->footer([] {
        return methodList() + "\n\n" + optionList() +
               "\n\nExamples: angiopose-cli register case.angiopose --method angiopose --output result\n"
               "          angiopose-cli register scan.nii.gz angiogram.dcm --output result --save found.angiopose\n"
               "          angiopose-cli register --from result/result.json --inputs . --output again";
    });
    command->callback([arguments, &exitCode] {
        requireCaseOrResult(arguments->casePath, arguments->from);
        exitCode = runRegister(*arguments);
    });
}

void addTrack(CLI::App& app, int& exitCode)
{
    auto* command = app.add_subcommand("track", "Track the vessels of a case through the frames of its run");
    auto arguments = std::make_shared<TrackArguments>();
    command->add_option("CASE", arguments->casePath, "Case file, *.angiopose")->required();
    command->add_option("--output", arguments->outputPath, "Pose table to write (.csv)")->required();
    command->add_flag("--keep-pose", arguments->keepPose,
                      "Track from the pose of the case (default: register the frame of the case first)");
    command->add_option("--bent", arguments->deformedFolder,
                        "Output folder for the vessels of each frame in which they are deformed (frame0.vtp, …)");
    command->footer("Example: angiopose-cli track case.angiopose --output poses.csv");
    command->callback([arguments, &exitCode] { exitCode = runTrack(*arguments); });
}

void addProject(CLI::App& app, int& exitCode)
{
    auto* command = app.add_subcommand("project", "Draw the projected vessel tree of a case at a given pose");
    auto arguments = std::make_shared<ProjectArguments>();
    addCaseOrResult(command, arguments->casePath, arguments->from);
    command->add_option("--pose", arguments->posePath,
                        "Pose file: .json, or .tfm, .mat or .h5 from ITK (default: the pose of the case)");
    command->add_option("--output", arguments->outputPath, "Image to write (.png or .svg)")->required();
    command
        ->add_option("--width", arguments->widthPx,
                     "Width of the written image in pixels (default: twice that of the angiogram)")
        ->check(CLI::Range(64, 8192));
    addFrameOption(*command, arguments->frame, "Frame of the angiogram, starting at 1");
    command->add_flag("--depth-cue", arguments->depthCue, "Depth cueing");
    command->add_option(
        "--swipe", arguments->swipePx,
        "Swipe position as a column of the angiogram; no vessels are drawn to the right of this column");
    command->add_flag("--rigid", arguments->isRigid,
                      "Draw the vessels at the rigid pose even if the case has deformed vessels");
    command->add_flag("--motion", arguments->isMotionColored, "Colors: displacement of the deformed vessels");
    command->add_flag("--before-after", arguments->showInitialPose,
                      "Also draw the vessels at the initial pose, on the left");
    command->add_option("--dpi", arguments->dotsPerInch, "Print resolution in pixels per inch")
        ->check(CLI::Range(10, 4800));
    command->add_flag("--bare", arguments->frameOnly, "Angiogram only, without vessels");
    command->add_flag("--16-bit", arguments->is16Bit, "Gray values of the frame only, as a 16-bit .png without text");
    command->footer(
        "Examples: angiopose-cli project case.angiopose --pose result/result.json --output overlay.png\n"
        "          angiopose-cli project --from result/result.json --inputs . --output overlay.png");
    command->callback([arguments, &exitCode] {
        requireCaseOrResult(arguments->casePath, arguments->from);
        exitCode = runProject(*arguments);
    });
}

void addMovie(CLI::App& app, int& exitCode)
{
    auto* command = app.add_subcommand(
        "movie",
        "Write a movie: the overlay through a run, the convergence of a registration, or a rotation of the vessels");
    auto arguments = std::make_shared<MovieArguments>();
    command->add_option("CASE", arguments->casePath, "Case file, *.angiopose")->required();
    command->add_option("--output", arguments->outputPath, "Movie to write (.mp4 or .gif)")->required();
    const std::map<std::string, MovieContent> contents{
        {"run", MovieContent::Run}, {"convergence", MovieContent::Convergence}, {"turn", MovieContent::Turn}};
    command
        ->add_option("--show", arguments->content,
                     "run: the overlay through the frames (default); convergence: the poses of the registration (a "
                     "case without a registration is registered first); turn: one full rotation of the vessels alone")
        ->transform(CLI::CheckedTransformer(contents, CLI::ignore_case).description("{run,convergence,turn}"));
    command->add_option("--frames", arguments->frames, "First and last frame of the run, starting at 1 (default: all)")
        ->expected(2);
    command->add_flag("--back-and-forth", arguments->isBackAndForth, "Play the run forward, then backward");
    command->add_flag("--register", arguments->isRegistered, "Register the frame of the case first");
    command->add_flag(
        "--follow", arguments->isTracked,
        "Track the vessels through the run, starting from the pose of the case, and show each frame with its own pose");
    command->add_option("--fps", arguments->framesPerSecond, "Frames per second (default: the acquisition rate)")
        ->check(CLI::Range(0.5, 100.0));
    command->add_option("--speed", arguments->speed, "Speed factor relative to the frame rate")
        ->check(CLI::Range(0.05, 20.0));
    command
        ->add_option("--width", arguments->widthPx,
                     "Width of the movie in pixels (default: twice that of the angiogram)")
        ->check(CLI::Range(64, 8192));
    addFrameOption(*command, arguments->frame, "Frame to which the pose of the case belongs, starting at 1");
    command->add_flag("--depth-cue", arguments->depthCue, "Depth cueing");
    command->add_flag("--rigid", arguments->isRigid,
                      "Draw the vessels at the rigid pose even if the case has deformed vessels");
    command->footer("Example: angiopose-cli movie case.angiopose --register --follow --output run.mp4");
    command->callback([arguments, &exitCode] { exitCode = runMovie(*arguments); });
}

void addAngles(CLI::App& app, int& exitCode)
{
    auto* command =
        app.add_subcommand("angles", "Find C-arm angles that show a branch without foreshortening or overlap");
    auto arguments = std::make_shared<AnglesArguments>();
    command->add_option("CASE", arguments->casePath, "Case file, *.angiopose; its pose and angles are used")
        ->required();
    command->add_option("--branch", arguments->branchId, "ID of the branch to view")->required();
    command->add_flag("--take-off", arguments->takeoffOnly, "View only the origin of the branch (±10 mm)");
    const auto addRange = [&](const char* name, core::AngleRange& range, const char* help) {
        command
            ->add_option_function<std::vector<double>>(
                name,
                [&range](const std::vector<double>& given) {
                    range = {given[0], given[1]};
                },
                help)
            ->expected(2);
    };
    addRange("--primary", arguments->map.primary, "Gantry range from RAO (-) to LAO (+) (default: -90 90)");
    addRange("--secondary", arguments->map.secondary, "Gantry range from CAU (-) to CRA (+) (default: -40 40)");
    command->add_option("--step", arguments->map.stepDeg, "Angle step of the table in degrees (default: 2.5)");
    addFrameOption(*command, arguments->frame, "Frame of the angiogram, starting at 1");
    command->add_option("--output", arguments->outputPath, "Table of all angles to write (.csv)");
    command->add_flag_callback(
        "--json", [arguments] { arguments->format = OutputFormat::Json; }, "Print only the angles, as JSON");
    command->footer("Example: angiopose-cli angles case.angiopose --branch 3 --take-off");
    command->callback([arguments, &exitCode] { exitCode = runAngles(*arguments); });
}

void addMeasure(CLI::App& app, int& exitCode)
{
    auto* command = app.add_subcommand(
        "measure", "Print the measurements of a case as CSV, either those in the images or those along the branches");
    auto arguments = std::make_shared<MeasureArguments>();
    command->add_option("CASE", arguments->casePath, "Case file, *.angiopose")->required();
    command->add_option("--output", arguments->outputPath, "Table to write (.csv; default: standard output)");
    auto* branches = command->add_flag("--branches", arguments->writeBranches,
                                       "Length, diameters, narrowest point, tortuosity and curvature of every branch");
    command->add_option("--profile", arguments->profileBranchId, "Diameter and curvature along the branch with this ID")
        ->excludes(branches);
    auto* targetPoints =
        command
            ->add_flag(
                "--check-points", arguments->writeTargetPoints,
                "Target points: distance of each projection from its marked position, with the estimated uncertainty")
            ->excludes(branches);
    command
        ->add_flag_callback(
            "--json", [arguments] { arguments->format = OutputFormat::Json; }, "Print target points as JSON")
        ->needs(targetPoints);
    command->footer("Example: angiopose-cli measure case.angiopose --branches --output branches.csv");
    command->callback([arguments, &exitCode] { exitCode = runMeasure(*arguments); });
}

void addBatch(CLI::App& app, int& exitCode)
{
    auto* command = app.add_subcommand("batch", "Register many cases; failed cases do not stop the batch");
    auto arguments = std::make_shared<BatchArguments>();
    command
        ->add_option("MANIFEST", arguments->manifestPath,
                     "CSV file with the column case, or the columns vessels and angiogram (paths relative to the "
                     "file), and optionally the columns seeds, name, method, frame and set.NAME")
        ->required();
    command->add_option("--output", arguments->outputFolder, "Output folder for summary.csv and one folder per case")
        ->required();
    command->add_option("--threads", arguments->threads, "Number of cases to run in parallel (default: all cores)")
        ->check(CLI::Range(1, 1024));
    command->add_flag("--resume", arguments->resumes,
                      "Skip cases that were already completed with the same inputs and settings");
    command->add_flag("--no-pictures", arguments->skipImages,
                      "Write only results, poses and tables but no images, which takes two thirds of the time and a "
                      "tenth of the disk space");
    command->add_option("--time-limit", arguments->timeLimitSeconds, "Time limit per case in seconds")
        ->check(CLI::Range(0.1, 1e7));
    command->add_option("--set", arguments->settings,
                        "Setting for all cases as name=value; may be repeated. A column set.NAME overrides it.");
    auto* shard = command
                      ->add_option("--shard", arguments->shard,
                                   "Process only part I of N of the rows, given as I/N, and write its table, "
                                   "summary-I-of-N.csv; the last part to finish also writes the combined table")
                      ->capture_default_str();
    command
        ->add_option("--merge", arguments->mergedFolders,
                     "Process no cases; merge the results of the shards in these folders and write the tables")
        ->excludes(shard);
    command->footer([] {
        return "Exit codes: 0 all completed, 3 some failed or missing, 4 some not reliable, 130 stopped; see "
               "summary.csv for details.\n\n" +
               settingList() +
               "\n\nExamples: angiopose-cli batch cases.csv --threads 8 --time-limit 600 --output results\n          "
               "angiopose-cli batch cases.csv --resume --output results   (after any interruption)\n          "
               "angiopose-cli batch cases.csv --shard 1/2 --output a   (and 2/2 to b, on another machine)\n          "
               "angiopose-cli batch cases.csv --merge a b --output results";
    });
    command->callback([arguments, &exitCode] { exitCode = runBatch(*arguments); });
}

void addBatchWorker(CLI::App& app, int& exitCode)
{
    auto* command = app.add_subcommand("batch-worker", "Process cases for the batch that started this worker");
    command->group("");
    auto parent = std::make_shared<int>(0);
    auto threads = std::make_shared<int>(1);
    command->add_option("PARENT", *parent, "Process ID of the batch")->required();
    command->add_option("THREADS", *threads, "Number of threads")->required();
    command->callback([parent, threads, &exitCode] { exitCode = runBatchWorker(*parent, *threads); });
}

}   // namespace angiopose::app
