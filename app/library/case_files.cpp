#include "app/library/case_content.h"
#include "app/library/conversions.h"
#include "app/library/relay.h"
#include "io/angiogram_file.h"
#include "io/case/case_file.h"
#include "io/result_file.h"
#include "io/subtraction_file.h"
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

/// A file beside the case at `casePath` that is called after it.
std::string besideCase(const std::string& casePath, const std::string& ending)
{
    return fs::path(absolute(casePath)).replace_extension(ending).string();
}

void putVessels(core::Vessels& vessels, const std::string& path, io::LoadedVessels loaded)
{
    vessels.file = {absolute(path), valueOf(io::sha256OfVesselInput(path, loaded.input))};
    vessels.input = loaded.input;
    vessels.scan = loaded.volume;
    vessels.scanIdentity = loaded.identity;
    vessels.lumen = io::sharedLumen(loaded);
    vessels.tree = std::make_shared<const core::VesselTree>(std::move(loaded.tree));
}

/// Vessels and angiogram that come from no file get one.
void keepInputs(core::Case& values, const std::string& casePath)
{
    core::Vessels& vessels = values.vessels;
    core::View& view = values.shown();
    if (vessels.file.path.empty()) {
        const std::string path = besideCase(casePath, ".tree.vtp");
        check(io::writeVesselTree(*vessels.tree, path));
        vessels.file = {path, {}};
    }
    if (view.imageFile.path.empty()) {
        const std::string path = besideCase(casePath, ".angiogram.dcm");
        check(io::writeAngiogram(*view.angiogram, path));
        view.imageFile = {path, {}};
    }
}

}   // namespace

void putAngiogram(core::Case& values, const std::shared_ptr<const core::Angiogram>& angiogram)
{
    core::View& view = values.shown();
    view.angiogram = angiogram;
    view.frame = angiogram->suggestedFrame;
    view.geometry.cArm = angiogram->cArm;
    if (const auto start = core::startPoseOf(values)) {
        view.cameraFromPatient = start.value();
    }
}

}   // namespace angiopose::library

namespace angiopose {

Case readCase(const std::string& path, const Observer& observe)
{
    auto content = std::make_unique<Case::Content>();
    library::Relay relay(observe);
    content->values = relay.take(io::loadCase(path, content->warnings, relay.reading("reading")));
    return Case(std::move(content));
}

Case readCase(const std::string& vesselPath, const std::string& imagePath, const VesselReadOptions& options,
              const Observer& observe)
{
    auto content = std::make_unique<Case::Content>();
    library::Relay relay(observe);
    io::LoadedVessels vessels =
        relay.take(io::readVessels(vesselPath, library::vesselInputOf(vesselPath, options), relay.reading("reading")));
    content->warnings = vessels.warnings;
    library::putVessels(content->values.vessels, vesselPath, std::move(vessels));
    auto angiogram = std::make_shared<const core::Angiogram>(library::valueOf(io::readAngiogram(imagePath)));
    content->warnings.insert(content->warnings.end(), angiogram->warnings.begin(), angiogram->warnings.end());
    library::putAngiogram(content->values, angiogram);
    core::View& view = content->values.shown();
    view.imageFile = {library::absolute(imagePath), {}};
    view.headerPlan = library::valueOf(io::readSubtractionPlan(imagePath));
    view.treatment.plan = view.headerPlan;
    return Case(std::move(content));
}

void writeCase(Case& theCase, const std::string& path)
{
    library::keepInputs(theCase.content().values, path);
    library::check(io::saveCase(theCase.content().values, path));
}

void writeResult(const Case& theCase, const std::string& path)
{
    const core::Case& values = theCase.content().values;
    if (!values.shown().result) {
        throw Error("library.no-result",
                    "The case has no result: it was not registered, or its pose was changed since.");
    }
    library::check(io::writeResult(values, *values.shown().result, path));
}

}   // namespace angiopose
