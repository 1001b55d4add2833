#include "io/sharing/case_summary.h"

#include "core/registration/options/option_fields.h"

#include <filesystem>
#include <iomanip>
#include <sstream>
#include <variant>

namespace angiopose::io {
namespace {

const char* kindOf(core::VesselInputKind kind)
{
    switch (kind) {
        case core::VesselInputKind::Centerline:
            return "centrelines";
        case core::VesselInputKind::Segmentation:
            return "labels";
        case core::VesselInputKind::Surface:
            return "surface";
        case core::VesselInputKind::Volume:
            break;
    }
    return "volume";
}

/// ".dcm"; endings that are no usual ones could be part of a name.
std::string endingOf(const core::InputFile& file)
{
    const std::string ending = std::filesystem::path(file.path).extension().string();
    return file.path.empty() ? "none" : ending.empty() ? "folder or without ending" : ending.substr(0, 10);
}

std::string listed(const std::vector<int>& ids)
{
    return std::to_string(ids.size());
}

void writeVessels(std::ostream& out, const core::Vessels& vessels)
{
    out << "vessels from: " << kindOf(vessels.input.kind) << ", " << endingOf(vessels.file) << "\n";
    if (vessels.tree) {
        const auto& tree = *vessels.tree;
        std::size_t named = 0;
        std::size_t withRadii = 0;
        for (const core::VesselBranch& branch : tree.branches) {
            named += branch.name.empty() ? 0 : 1;
            withRadii += branch.radiusMm.empty() ? 0 : 1;
        }
        out << "tree: " << tree.branches.size() << " branches (" << named << " labelled, " << withRadii
            << " with radii), " << tree.pointCount() << " points, " << core::acrossMm(tree) << " mm across\n";
    }
    if (vessels.scan) {
        const auto& geometry = vessels.scan->geometry;
        out << "volume: " << geometry.size.transpose() << " voxels of " << geometry.spacingMm.transpose() << " mm\n";
    }
    out << "branches auxiliary, excluded, hidden: " << listed(vessels.auxiliaryBranchIds) << ", "
        << listed(vessels.excludedBranchIds) << ", " << listed(vessels.hiddenBranchIds) << "\nedited by hand: lumen "
        << vessels.isLumenEdited << ", tree " << vessels.isTreeEdited
        << "\ncheck points and rings: " << vessels.marks.size()
        << "\nmeasures in slices: " << vessels.measurements.size() << "\n";
}

void writeNumber(std::ostream& out, const char* key, const core::Sourced<double>& number)
{
    out << "  " << key << ": ";
    if (number.value) {
        out << *number.value << " (origin " << static_cast<int>(number.origin) << ")\n";
    } else {
        out << "not known\n";
    }
}

void writeMessages(std::ostream& out, const char* key, const core::Messages& messages)
{
    for (const core::Message& message : messages) {
        out << "  " << key << ": " << message.id();
        for (const core::MessageArgument& argument : message.arguments()) {
            if (const auto* number = std::get_if<core::Quantity>(&argument)) {
                out << " " << number->value << number->unit;
            }
        }
        out << "\n";
    }
}

void writeResult(std::ostream& out, const core::RegistrationResult& result)
{
    out << "  result: method " << result.method << ", " << core::toText(result.stopReason) << ", " << result.iterations
        << " iterations, median " << result.metrics.medianPx << " px, "
        << (result.trustworthy ? "trustworthy" : "not trustworthy") << ", " << result.alternatives.size()
        << " alternatives, bent " << (result.bent != nullptr) << "\n";
    writeMessages(out, "verdict", result.warnings);
}

void writeCamera(std::ostream& out, const core::View& view)
{
    const core::CArm& arm = view.geometry.cArm;
    writeNumber(out, "source to detector, mm", arm.sourceToDetectorMm);
    writeNumber(out, "source to isocenter, mm", arm.sourceToIsocenterMm);
    writeNumber(out, "source to object, mm", arm.sourceToObjectMm);
    writeNumber(out, "column spacing, mm", arm.columnSpacingMm);
    writeNumber(out, "primary angle, degrees", arm.primaryAngleDeg);
    writeNumber(out, "secondary angle, degrees", arm.secondaryAngleDeg);
    writeNumber(out, "roll, degrees", arm.rollDeg);
    out << "  camera given as a whole: " << view.geometry.cameraOverride.has_value() << "\n";
}

void writeView(std::ostream& out, const core::View& view, std::size_t number)
{
    out << "view " << number << ": image " << endingOf(view.imageFile) << "\n";
    if (view.angiogram) {
        out << "  pixels: " << view.angiogram->width() << " x " << view.angiogram->height() << ", frames "
            << view.angiogram->frameCount() << ", shown " << view.frame << "\n";
        writeMessages(out, "note of reading", view.angiogram->warnings);
    }
    writeCamera(out, view);
    out << "  curves given " << (view.target.centerline != nullptr) << ", edited "
        << view.target.editedFrame.has_value() << "; landmarks " << view.landmarks.size() << ", measures "
        << view.measurements.size() << ", sightings " << view.sightings.size() << ", drawn marks "
        << view.annotations.size() << ", kept poses " << view.snapshots.size() << "\n";
    if (view.result) {
        writeResult(out, *view.result);
    }
}

void writeOptions(std::ostream& out, const core::RegistrationOptions& options)
{
    const core::RegistrationOptions usual;
    out << "method: " << options.method << "\n";
    for (const core::OptionField& field : core::optionFields()) {
        const core::OptionValue value = field.read(options);
        if (value == field.read(usual)) {
            continue;
        }
        out << "option " << field.key << ": ";
        if (const auto* number = std::get_if<double>(&value)) {
            out << *number << "\n";
        } else {
            out << core::nameOf(field, value) << "\n";
        }
    }
}

}   // namespace

std::string caseSummary(const core::Case& theCase)
{
    std::ostringstream out;
    out.imbue(std::locale::classic());
    out << std::setprecision(6) << std::boolalpha;
    writeVessels(out, theCase.vessels);
    writeOptions(out, theCase.options);
    out << "views: " << theCase.views.size() << ", shown " << theCase.shownView + 1 << "\n";
    for (std::size_t i = 0; i < theCase.views.size(); ++i) {
        writeView(out, theCase.views[i], i + 1);
    }
    return out.str();
}

}   // namespace angiopose::io
