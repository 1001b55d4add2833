#include "io/sharing/case_summary.h"

#include "core/registration/options/option_fields.h"
#include "io/dicom/dicom_file.h"
#include "io/dicom/dicom_text.h"
#include "io/support/files_in_folder.h"

#include <dcmtk/dcmdata/dcelem.h>
#include <dcmtk/dcmdata/dcitem.h>
#include <filesystem>
#include <iomanip>
#include <sstream>
#include <variant>

namespace angiopose::io {
namespace {

constexpr int deepestSequence = 8;

void addIdentity(const core::StudyIdentity& identity, Redaction& redaction)
{
    for (const std::string& name :
         {identity.patientName, identity.patientId, identity.accessionNumber, identity.institution, identity.birthDate,
          identity.studyDate, identity.studyUid, identity.seriesUid, identity.sopInstanceUid}) {
        redaction.addName(name);
    }
    redaction.addText(identity.description);
}

template <class Named>
void addNames(const std::vector<Named>& named, Redaction& redaction)
{
    for (const Named& each : named) {
        redaction.addText(each.name);
    }
}

void addView(const core::View& view, Redaction& redaction)
{
    for (const core::InputFile* file : {&view.caseFile, &view.imageFile, &view.target.file}) {
        redaction.addPath(file->path);
    }
    redaction.addText(view.name);
    addNames(view.landmarks, redaction);
    addNames(view.measurements, redaction);
    for (const core::ImageAnnotation& annotation : view.annotations) {
        redaction.addText(annotation.text);
    }
    for (const core::PoseSnapshot& snapshot : view.snapshots) {
        redaction.addName(snapshot.author);
        redaction.addText(snapshot.name);
        redaction.addText(snapshot.note);
    }
    if (view.result) {
        redaction.addName(view.result->provenance.author);
    }
    if (view.angiogram) {
        addIdentity(view.angiogram->identity, redaction);
    }
}

/// Whether an element can identify somebody: by a name or number, by words, or not at all.
enum class IdentifierKind { Nothing, Name, Words };

IdentifierKind identifierKindOf(DcmEVR vr)
{
    switch (vr) {
        case EVR_PN:
        case EVR_UI:
        case EVR_DA:
        case EVR_DT:
        case EVR_SH:
            return IdentifierKind::Name;
        case EVR_LO:
        case EVR_ST:
        case EVR_LT:
        case EVR_UT:
        case EVR_UC:
        case EVR_AE:
            return IdentifierKind::Words;
        default:
            return IdentifierKind::Nothing;
    }
}

void addElements(const DicomDataset& data, int depth, Redaction& redaction)
{
    for (const auto& layer : data.layers()) {
        for (unsigned long i = 0; i < layer->card(); ++i) {
            const DcmElement* element = layer->getElement(i);
            const DicomTag tag = (static_cast<DicomTag>(element->getGTag()) << 16) | element->getETag();
            const IdentifierKind informative = identifierKindOf(element->getVR());
            if (informative == IdentifierKind::Name) {
                redaction.addName(utf8Text(data, tag));
            } else if (informative == IdentifierKind::Words) {
                redaction.addText(utf8Text(data, tag));
            }
        }
    }
    if (depth < deepestSequence) {
        for (const DicomDataset& item : data.itemsOfAllSequences()) {
            addElements(item, depth + 1, redaction);
        }
    }
}

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

/// Returns the extension, for example ".dcm"; empty if the extension is unusual and could be part of a name.
std::string endingOf(const core::InputFile& file)
{
    const std::string ending = std::filesystem::path(file.path).extension().string();
    return file.path.empty() ? "none" : ending.empty() ? "folder or no extension" : ending.substr(0, 10);
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
            << " with radii), " << tree.pointCount() << " points, " << core::extentMm(tree) << " mm across\n";
    }
    if (vessels.scan) {
        const auto& geometry = vessels.scan->geometry;
        out << "volume: " << geometry.size.transpose() << " voxels of " << geometry.spacingMm.transpose() << " mm\n";
    }
    out << "auxiliary, excluded, hidden branches: " << listed(vessels.auxiliaryBranchIds) << ", "
        << listed(vessels.excludedBranchIds) << ", " << listed(vessels.hiddenBranchIds) << "\nedited manually: lumen "
        << vessels.isLumenEdited << ", tree " << vessels.isTreeEdited
        << "\ntarget points and rings: " << vessels.marks.size()
        << "\nmeasurements in slices: " << vessels.measurements.size() << "\n";
}

void writeNumber(std::ostream& out, const char* key, const core::SourcedValue<double>& number)
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
        << " alternatives, bent " << (result.deformed != nullptr) << "\n";
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
    out << "  camera given directly: " << view.geometry.cameraOverride.has_value() << "\n";
}

void writeView(std::ostream& out, const core::View& view, std::size_t number)
{
    out << "view " << number << ": image " << endingOf(view.imageFile) << "\n";
    if (view.angiogram) {
        out << "  pixels: " << view.angiogram->width() << " x " << view.angiogram->height() << ", frames "
            << view.angiogram->frameCount() << ", shown " << view.frame << "\n";
        writeMessages(out, "image warning", view.angiogram->warnings);
    }
    writeCamera(out, view);
    out << "  curves given " << (view.target.centerline != nullptr) << ", edited "
        << view.target.editedFrame.has_value() << "; landmarks " << view.landmarks.size() << ", measures "
        << view.measurements.size() << ", sightings " << view.observations.size() << ", annotations "
        << view.annotations.size() << ", snapshots " << view.snapshots.size() << "\n";
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

void addIdentifiers(const core::Case& session, Redaction& redaction)
{
    redaction.addText(session.title);
    for (const core::InputFile* file : {&session.vessels.file, &session.vessels.scanFile}) {
        redaction.addPath(file->path);
    }
    redaction.addName(session.vessels.scanSeriesId);
    addIdentity(session.vessels.scanIdentity, redaction);
    addNames(session.vessels.marks, redaction);
    addNames(session.vessels.measurements, redaction);
    for (const core::View& view : session.views) {
        addView(view, redaction);
    }
}

void addIdentifiersOfFile(const std::string& path, Redaction& redaction)
{
    redaction.addPath(path);
    std::string file = path;
    std::error_code failed;
    if (std::filesystem::is_directory(path, failed)) {
        const auto files = filesInFolder(path, FolderDepth::Recursive);
        if (!files || files.value().empty()) {
            return;
        }
        file = files.value().front();
    }
    if (!isDicomFile(file)) {
        return;
    }
    const auto input = openDicom(file);
    const auto parsed = input ? parseDicom(input.value().view(), file) : core::Result<DicomFile>(input.error());
    if (parsed) {
        addElements(parsed.value().dataset, 0, redaction);
    }
}

std::string caseSummary(const core::Case& session)
{
    std::ostringstream out;
    out.imbue(std::locale::classic());
    out << std::setprecision(6) << std::boolalpha;
    writeVessels(out, session.vessels);
    writeOptions(out, session.options);
    out << "views: " << session.views.size() << ", shown " << session.shownView + 1 << "\n";
    for (std::size_t i = 0; i < session.views.size(); ++i) {
        writeView(out, session.views[i], i + 1);
    }
    return out.str();
}

}   // namespace angiopose::io
