#include "app/cli/add_commands.h"

#include "app/cli/commands.h"
#include "app/cli/common_options.h"
#include "io/case/case_file.h"
#include "io/results/result_schema.h"

#include <cstdio>
#include <memory>

namespace angiopose::app {
namespace {

void addFileCommand(CLI::App& app, int& exitCode, const std::string& name, const std::string& help,
                    int (*run)(const FileArguments&))
{
    auto* command = app.add_subcommand(name, help);
    auto arguments = std::make_shared<FileArguments>();
    command->add_option("FILE", arguments->path)->required();
    command->add_flag_callback(
        "--json", [arguments] { arguments->format = OutputFormat::Json; }, "Print JSON only");
    command->footer("Example: angiopose-cli " + name + " case.angiopose");
    command->callback([arguments, run, &exitCode] { exitCode = run(*arguments); });
}

}   // namespace

void addTraceAngiogram(CLI::App& app, int& exitCode)
{
    auto* command = app.add_subcommand("trace-angiogram", "Trace the vessels of an angiogram as 2-D centerlines");
    auto arguments = std::make_shared<TraceAngiogramArguments>();
    command->add_option("IMAGE", arguments->imagePath, "DICOM, PNG, TIFF or JPEG")->required();
    addFrameOption(*command, arguments->frame, "Frame, starting at 1 (default: peak opacification)");
    command->add_option("--output", arguments->outputPath, "Centerlines to write (.csv)")->required();
    command->add_option("--apart", arguments->devicePath,
                        "Write curves that may be catheters, guidewires or bone edges to this .csv file instead of to "
                        "the output; the method wire can use this file as the path of a guidewire");
    command->add_option("--mask", arguments->maskPath, "Vessel mask to write (.png)");
    command
        ->add_option("--sensitivity", arguments->sensitivity,
                     "Tracing sensitivity; above 1, fainter vessels are also traced")
        ->check(CLI::Range(0.2, 5.0));
    command->add_flag("--subtract,!--native", arguments->subtract,
                      "Subtract the frames before contrast arrival, or use native frames (default: subtract if the "
                      "file specifies a mask)");
    command->add_option("--mask-frames", arguments->maskFrames, "Mask frames to average and subtract, starting at 1")
        ->delimiter(',');
    command
        ->add_option("--mask-shift", arguments->maskShiftPx,
                     "Pixel shift of the mask as right,down (default: automatic)")
        ->delimiter(',')
        ->expected(2);
    command
        ->add_option_function<std::string>(
            "--composite", [arguments](const std::string&) { arguments->composite = true; },
            "Trace the peak-opacification image of the run; the only value is minimum (lowest value of each pixel over "
            "all frames)")
        ->check(CLI::IsMember({"minimum"}))
        ->excludes("--frame");
    command->footer("Example: angiopose-cli trace-angiogram run.dcm --frame 5 --output centerline.csv --mask mask.png");
    command->callback([arguments, &exitCode] { exitCode = runTraceAngiogram(*arguments); });
}

void addStudies(CLI::App& app, int& exitCode)
{
    auto* command =
        app.add_subcommand("studies", "List the patients, studies and series of a folder, a CD or a DICOMDIR");
    auto arguments = std::make_shared<FileArguments>();
    command->add_option("FOLDER", arguments->path, "A folder, or a DICOMDIR")->required();
    command->add_flag_callback(
        "--json", [arguments] { arguments->format = OutputFormat::Json; }, "Print JSON only");
    command->add_flag("--all-files", arguments->allFiles, "Also read files that the DICOMDIR does not list");
    command->footer("Example: angiopose-cli studies /media/cdrom");
    command->callback([arguments, &exitCode] { exitCode = runStudies(*arguments); });
}

void addInfo(CLI::App& app, int& exitCode)
{
    addFileCommand(app, exitCode, "info", "Describe a file and the values derived from it", runInfo);
}

void addValidate(CLI::App& app, int& exitCode)
{
    addFileCommand(app, exitCode, "validate", "Check a case file and list every problem", runValidate);
}

void addSchema(CLI::App& app, int& exitCode)
{
    CLI::App* command = app.add_subcommand("schema", "Print the JSON Schema of case files or of results");
    auto isOfResults = std::make_shared<bool>(false);
    command->add_flag("--result", *isOfResults, "Print the schema of result.json");
    command->callback([&exitCode, isOfResults] {
        std::puts((*isOfResults ? io::resultSchema() : io::caseSchema()).c_str());
        exitCode = exitSuccess;
    });
}

}   // namespace angiopose::app
