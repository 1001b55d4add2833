#include "app/library/case_content.h"
#include "app/library/conversions.h"
#include "app/library/observer_adapter.h"
#include "io/angiogram_file.h"
#include "io/case/overwrite_case.h"
#include "io/opening/assemble_case.h"
#include "io/opening/read_case_inputs.h"
#include "io/opening/read_inputs.h"
#include "io/results/result_file.h"
#include "io/vessel_input_file.h"
#include "io/vessel_tree_file.h"

#include <filesystem>

namespace angiopose::library {
namespace {

namespace fs = std::filesystem;

std::string absolute(const std::string& path)
{
    return fs::absolute(path).lexically_normal().string();
}

/// Returns the path of a file next to the case at `casePath`, with the same base name.
std::string siblingPath(const std::string& casePath, const std::string& ending)
{
    return fs::path(absolute(casePath)).replace_extension(ending).string();
}

/// Writes the vessels and the angiogram to files unless they are already stored in files.
void storeInputs(core::Case& values, const std::string& casePath)
{
    core::Vessels& vessels = values.vessels;
    core::View& view = values.shown();
    if (vessels.file.path.empty()) {
        const std::string path = siblingPath(casePath, ".tree.vtp");
        check(io::writeVesselTree(*vessels.tree, path));
        vessels.file = {path, {}};
    }
    if (view.imageFile.path.empty()) {
        const std::string path = siblingPath(casePath, ".angiogram.dcm");
        check(io::writeAngiogram(*view.angiogram, path));
        view.imageFile = {path, {}};
    }
}

/// Throws the error that explains why the two files are not vessels and an angiogram.
[[noreturn]] void throwNotACase(const std::string& vesselPath, const core::VesselInput& input,
                                const std::string& imagePath)
{
    (void)valueOf(io::readVessels(vesselPath, input));
    (void)valueOf(io::readAngiogram(imagePath));
    throwError(io::messages::openNoAngiogram().about(imagePath));
}

}   // namespace

void addAngiogram(core::Case& values, const std::shared_ptr<const core::Angiogram>& angiogram)
{
    core::View& view = values.shown();
    view.angiogram = angiogram;
    view.frame = angiogram->suggestedFrame;
    view.geometry.cArm = angiogram->cArm;
    if (const auto start = core::initialPoseOf(values)) {
        view.cameraFromPatient = start.value();
    }
}

}   // namespace angiopose::library

namespace angiopose {

Case readCase(const std::string& path, const Observer& observe)
{
    auto content = std::make_unique<Case::Content>();
    library::ObserverAdapter relay(observe);
    content->path = library::absolute(path);
    content->sha256 = io::caseFileHash(path);
    content->values = relay.resultOf(io::openCase(path, content->warnings, relay.reading("reading")));
    return Case(std::move(content));
}

Case readCase(const std::string& vesselPath, const std::string& imagePath, const VesselReadOptions& options,
              const Observer& observe)
{
    auto content = std::make_unique<Case::Content>();
    library::ObserverAdapter relay(observe);
    io::OpenHints hints;
    hints.vessels = library::vesselInputOf(vesselPath, options);
    hints.seriesId = hints.vessels->seriesId;
    const io::LoadedInputs inputs = relay.resultOf(
        io::readInputs({library::absolute(vesselPath), library::absolute(imagePath)}, hints, relay.reading("reading")));
    if (!io::isCompleteCase(inputs)) {
        library::throwNotACase(vesselPath, *hints.vessels, imagePath);
    }
    content->warnings = inputs.warnings;
    content->values = io::assembleCase({}, inputs);
    return Case(std::move(content));
}

void writeCase(Case& session, const std::string& path)
{
    Case::Content& content = session.content();
    const std::string target = library::absolute(path);
    const std::string known = content.path == target ? content.sha256 : std::string();
    library::storeInputs(content.values, path);
    content.sha256 = library::valueOf(io::overwriteCase(content.values, path, known));
    content.path = target;
}

void writeResult(const Case& session, const std::string& path)
{
    const core::Case& values = session.content().values;
    if (!values.shown().result) {
        throw Error(
            "library.no-result",
            "The case has no result: it has not been registered, or its pose has changed since the registration.");
    }
    library::check(io::writeResult(values, path));
}

}   // namespace angiopose
