#include "app/texts/dicom_state.h"

#include "app/messages/says.h"
#include "app/messages/says_dicom.h"
#include "core/measuring/measure_image.h"
#include "io/dicom/objects/presentation_state.h"
#include "ui/scenes/projected_tree.h"

#include <algorithm>

namespace angiopose::app {
namespace {

using Line = std::vector<Eigen::Vector2d>;

io::RgbColor rgb(const ui::Color& color)
{
    return {color.red, color.green, color.blue};
}

bool passesImage(const Line& line, const core::ProjectionCamera& camera)
{
    return std::ranges::any_of(line, [&camera](const Eigen::Vector2d& point) {
        return point.x() > -0.5 && point.y() > -0.5 && point.x() < camera.width - 0.5 &&
               point.y() < camera.height - 0.5;
    });
}

/// The vessels that are shown, auxiliary ones in a layer of their own.
std::vector<io::StateLayer> vesselLayers(const DicomGround& ground, const core::ProjectionCamera& camera)
{
    const core::Case& theCase = ground.theCase;
    const ui::BranchColors colors = ui::branchColors(ui::palette(ui::ThemeMode::Dark));
    io::StateLayer plain{"VESSELS", "Vessels of the 3-D tree", rgb(colors.plain), {}, {}};
    io::StateLayer auxiliary{"AUXILIARY", "Auxiliary vessels of the 3-D tree", rgb(colors.auxiliary), {}, {}};
    const core::RigidTransform& pose = theCase.shown().cameraFromPatient;
    const DrawnVessels drawn = drawnVessels(theCase.shown(), theCase.vessels, pose, ground.wanted.look.shape);
    const core::VesselTree tree = core::without(drawn.tree, theCase.vessels.hiddenBranchIds);
    for (const ui::ProjectedBranch& branch : ui::projectedTree(tree, camera, pose)) {
        const std::vector<int>& ids = theCase.vessels.auxiliaryBranchIds;
        io::StateLayer& layer = std::ranges::find(ids, branch.id) == ids.end() ? plain : auxiliary;
        for (const auto& run : branch.runs) {
            Line line;
            std::ranges::transform(run, std::back_inserter(line), &ui::ProjectedPoint::px);
            if (passesImage(line, camera)) {
                layer.lines.push_back(std::move(line));
            }
        }
    }
    return {plain, auxiliary};
}

/// What was measured in the frame, with its value beside it.
io::StateLayer measuredLayer(const core::Case& theCase)
{
    io::StateLayer layer{"MEASURED", "Measurements in the image", {255, 200, 87}, {}, {}};
    const core::MeasuredView seen(theCase.shown(), theCase.vessels.tree.get());
    for (const core::ImageMeasurement& measurement : theCase.shown().measurements) {
        if (measurement.frame != theCase.shown().frame || measurement.pixels.empty()) {
            continue;
        }
        Line line = measurement.pixels;
        if (measurement.kind == core::MeasurementKind::Area) {
            line.push_back(line.front());
        }
        layer.lines.push_back(line);
        if (const auto measured = core::measureImage(measurement, seen)) {
            layer.texts.push_back({core::labelOf(measured.value(), measurement.kind).text(), line.front()});
        }
    }
    return layer;
}

/// Grey values of the file: mirrored where reading turned the image round.
core::DisplayRange storedRange(core::DisplayRange range, const core::Angiogram& run, const io::SourceImage& source)
{
    if (!source.isShownInverted) {
        return range;
    }
    float low = run.frames.front().pixels.front();
    float high = low;
    for (const core::ImageF& frame : run.frames) {
        const auto [least, most] = std::ranges::minmax_element(frame.pixels);
        low = std::min(low, *least);
        high = std::max(high, *most);
    }
    const double sum = static_cast<double>(low) + static_cast<double>(high);
    return {sum - range.high, sum - range.low};
}

core::DisplayRange shownRange(const DicomGround& ground, int frame, core::Messages& notes)
{
    const core::View& view = ground.theCase.shown();
    const core::Angiogram& run = *core::storedRunOf(view);
    const bool isTreated = view.storedRun != nullptr;
    if (isTreated) {
        notes.push_back(says::dicomTreated());
    }
    const auto& look = ground.wanted.look;
    const core::DisplayRange range =
        look.range && !isTreated ? *look.range : core::displayRange(run.frames[static_cast<std::size_t>(frame)]);
    return storedRange(range, run, ground.angiogram);
}

}   // namespace

core::Result<std::string> stateObject(const DicomGround& ground, core::Messages& notes)
{
    const core::View& view = ground.theCase.shown();
    const auto camera = core::cameraOf(view);
    if (!camera) {
        return camera.error();
    }
    io::ShownState shown;
    shown.layers = vesselLayers(ground, camera.value());
    shown.layers.push_back(measuredLayer(ground.theCase));
    shown.layers.push_back({"NOTICE", "What the overlay is", {200, 200, 200}, {}, {}});
    shown.layers.back().texts.push_back({"AngioPose. " + says::notForClinicalUse().text(), {8.0, 16.0}});
    shown.frame = std::min(view.frame, core::storedRunOf(view)->frameCount() - 1);
    shown.description = "Vessels of a registered 3-D tree as vectors";
    if (ground.angiogram.isDicom) {
        shown.range = shownRange(ground, shown.frame, notes);
    }
    return io::presentationState(shown, ground.angiogram, ground.origin);
}

}   // namespace angiopose::app
