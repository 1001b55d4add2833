#include "app/cli/add_commands.h"

#include "app/cli/case_input.h"
#include "app/cli/common_options.h"
#include "app/cli/console.h"
#include "app/cli/register_case.h"
#include "app/messages/messages.h"
#include "app/texts/dicom_export.h"
#include "core/case/initial_pose.h"
#include "io/support/input_bytes.h"

#include <cstdio>
#include <memory>

namespace angiopose::app {
namespace {

struct ExportDicomArguments {
    std::string casePath;
    ResultSource from;
    std::string outputFolder;
    std::vector<std::string> objects;   ///< object IDs; if empty, all objects that the case allows
    std::string reportPath;   ///< path of the PDF to encapsulate; may be empty
    std::optional<int> frame;
    int widthPx = 0;   ///< image width; if 0, twice the width of the angiogram, or for runs, that width
    bool isRegistered = false;   ///< whether to register the frame of the case first
    bool isStartWanted = false;   ///< whether to export the initial pose even if nothing has been registered
    bool isRigid = false;
    bool isIdentityShown = false;   ///< whether to burn the patient identity into images
    std::string author;
};

core::Result<std::string> pdfBytes(const std::string& path)
{
    const auto input = io::openInput(path);
    return input ? core::Result<std::string>(std::string(input.value().view())) : input.error();
}

core::Result<DicomExport> exportFor(const ExportDicomArguments& arguments)
{
    DicomExport dicomExport;
    for (const std::string& id : arguments.objects) {
        const auto kind = parseDicomKind(id);
        if (!kind) {
            return core::Error(messages::dicomKindUnknown(id, dicomKindIds()).about("--objects"));
        }
        dicomExport.kinds.push_back(*kind);
    }
    dicomExport.imageOptions.widthPx = arguments.widthPx;
    dicomExport.imageOptions.coloring = OverlayColoring::Branches;
    dicomExport.imageOptions.shape = arguments.isRigid ? VesselShape::Rigid : VesselShape::Deformed;
    dicomExport.imageOptions.identity = arguments.isIdentityShown ? Identity::Shown : Identity::Hidden;
    dicomExport.author = arguments.author;
    if (!arguments.reportPath.empty()) {
        dicomExport.report = [path = arguments.reportPath] { return pdfBytes(path); };
    }
    return dicomExport;
}

core::Result<core::Case> caseFor(const ExportDicomArguments& arguments)
{
    auto loaded = arguments.from.path.empty()
                      ? loadCaseForCommand(arguments.casePath, arguments.frame)
                      : loadResultForCommand(arguments.from, ResultState::Registered, arguments.frame);
    if (!loaded) {
        return loaded;
    }
    if (!arguments.isRegistered) {
        const core::Case& session = loaded.value();
        const bool isUnwanted = !arguments.isStartWanted && core::isAtInitialPose(session.shown(), session.vessels);
        return isUnwanted ? core::Error(messages::exportAtStart().about(arguments.casePath)) : loaded;
    }
    auto found = registerForCommand(std::move(loaded).value(), "registering");
    return found ? core::Result<core::Case>(std::move(found).value().session) : core::Result<core::Case>(found.error());
}

core::Result<DicomFiles> writeObjects(const core::Case& session, const DicomExport& dicomExport,
                                      const std::string& folder)
{
    ProgressLine progress("writing");
    return writeDicomObjects(session, {}, dicomExport, folder, [&progress](double fraction) {
        progress.show(fraction, "");
        return isInterrupted() ? core::ObserverDecision::Stop : core::ObserverDecision::Continue;
    });
}

int runExportDicom(const ExportDicomArguments& arguments)
{
    const auto dicomExport = exportFor(arguments);
    if (!dicomExport) {
        printMessage(dicomExport.error().message.text());
        return exitUsageError;
    }
    const auto session = caseFor(arguments);
    if (!session) {
        return reportInputError(session.error());
    }
    const auto files = writeObjects(session.value(), dicomExport.value(), arguments.outputFolder);
    if (!files) {
        return reportInputError(files.error());
    }
    printWarnings(files.value().notes);
    for (const std::string& path : files.value().paths) {
        std::printf("%s\n", path.c_str());
    }
    return exitSuccess;
}

}   // namespace

void addExportDicom(CLI::App& app, int& exitCode)
{
    auto* command = app.add_subcommand("export-dicom", "Export a case and its results as DICOM objects");
    auto arguments = std::make_shared<ExportDicomArguments>();
    addCaseOrResult(command, arguments->casePath, arguments->from);
    command->add_option("--output", arguments->outputFolder, "Output folder; one file per object")->required();
    command
        ->add_option("--objects", arguments->objects,
                     "Which, of " + dicomKindIds() + " (default: all that can be created from the case)")
        ->delimiter(',');
    command->add_option("--report", arguments->reportPath,
                        "PDF of the report, written by `angiopose-cli report`, for pdf");
    addFrameOption(*command, arguments->frame, "Frame of the angiogram, starting at 1");
    command
        ->add_option("--width", arguments->widthPx,
                     "Width of the images in pixels (default: twice that of the angiogram)")
        ->check(CLI::Range(64, 8192));
    command->add_flag("--register", arguments->isRegistered, "Register the frame of the case first");
    command->add_flag("--start-pose", arguments->isStartWanted,
                      "Use the initial pose if the case has not been registered");
    command->add_flag("--rigid", arguments->isRigid,
                      "Draw the vessels at the rigid pose even if the case has deformed vessels");
    command->add_flag("--identity", arguments->isIdentityShown, "Also show the patient's name in the images");
    command->add_option("--author", arguments->author, "Author of the objects, as Family^Given");
    command->footer(
        "sc: image, run: images of the run, pdf: report, ps: lines on the stored image, reg: pose, seg: vessels in the "
        "scan, sr: measurements. Each is a new instance in the study of its image.\n\nExamples: angiopose-cli "
        "export-dicom case.angiopose --register --output objects --objects sc,ps,reg\n          angiopose-cli "
        "export-dicom --from result/result.json --inputs . --output objects");
    command->callback([arguments, &exitCode] {
        requireCaseOrResult(arguments->casePath, arguments->from);
        exitCode = runExportDicom(*arguments);
    });
}

}   // namespace angiopose::app
