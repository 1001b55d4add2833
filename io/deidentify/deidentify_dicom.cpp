#include "io/deidentify/deidentify_dicom.h"

#include "io/deidentify/copy_pixels.h"
#include "io/dicom/dicom_file.h"
#include "io/messages/messages.h"
#include "io/support/file_error.h"

#include <array>
#include <string_view>
#include <utility>

namespace angiopose::io {
namespace {

/// Kinds of DICOM objects that can be de-identified.
enum class DeidentifiableClass { Image, Segmentation, Report, PresentationState, Registration };

constexpr std::string_view storage = "1.2.840.10008.5.1.4.1.1.";
constexpr std::string_view grayState = "11.1";
constexpr std::string_view spatialClass = "66.1";
constexpr std::string_view segmentClass = "66.4";
constexpr std::string_view reports = "88.";
constexpr std::string_view documents = "104.";

/// Unsupported SOP classes: other presentation states and spatial objects, waveforms, raw data, treatment plans.
constexpr std::array<std::string_view, 8> unsupportedClasses{"9.", "11.", "66", "67", "68.", "78.", "79.", "481."};

core::Result<DeidentifiableClass> classOf(const DicomDataset& data, const std::string& path)
{
    const std::string_view classUid = data.text(0x00080016);
    if (!classUid.starts_with(storage)) {
        return data.text(0x00080060) == "SEG" ? DeidentifiableClass::Segmentation : DeidentifiableClass::Image;
    }
    const std::string_view kind = classUid.substr(storage.size());
    if (kind == segmentClass) {
        return DeidentifiableClass::Segmentation;
    }
    if (kind == grayState) {   // other presentation states require an ICC profile, which contains text
        return DeidentifiableClass::PresentationState;
    }
    if (kind == spatialClass) {
        return DeidentifiableClass::Registration;
    }
    if (kind.starts_with(reports)) {
        return DeidentifiableClass::Report;
    }
    if (kind.starts_with(documents)) {
        return fileError(path, messages::pagesStay());
    }
    for (const std::string_view stays : unsupportedClasses) {
        if (kind.starts_with(stays)) {
            return fileError(path, messages::objectStays(std::string(classUid)));
        }
    }
    return DeidentifiableClass::Image;
}

bool hasPixels(DeidentifiableClass freed)
{
    return freed == DeidentifiableClass::Image || freed == DeidentifiableClass::Segmentation;
}

/// Determines the kind of object from its SOP class: an image unless the SOP class indicates otherwise. Fails and names
/// the file if text or pages of the object cannot be cleared reliably, or if the object holds pixels that are unusual
/// for its class and would be lost.
core::Result<DeidentifiableClass> deidentifiableClassOf(const DicomFile& file, const std::string& path)
{
    const auto freed = classOf(file.dataset, path);
    if (freed && !hasPixels(freed.value()) && !file.pixels.empty()) {
        return fileError(path, messages::objectWithPixels(std::string(file.dataset.text(0x00080016))));
    }
    return freed;
}

/// Code from PS3.16 CID 7050, De-identification Method.
struct Method {
    const char* value;
    const char* meaning;
};
constexpr Method basicProfile{"113100", "Basic Application Confidentiality Profile"};
constexpr Method cleanPixels{"113101", "Clean Pixel Data Option"};
constexpr Method cleanGraphics{"113103", "Clean Graphics Option"};
constexpr Method cleanStructure{"113104", "Clean Structured Content Option"};
constexpr Method cleanDescriptors{"113105", "Clean Descriptors Option"};
constexpr Method modifiedDates{"113107", "Retain Longitudinal Temporal Information Modified Dates Option"};

/// Type 2 elements of the image modules, which are written empty if unknown.
constexpr std::array<std::pair<DicomTag, const char*>, 8> emptyWhereAbsent{{{0x00080020, "DA"},
                                                                            {0x00080030, "TM"},
                                                                            {0x00080050, "SH"},
                                                                            {0x00080070, "LO"},
                                                                            {0x00080090, "PN"},
                                                                            {0x00100030, "DA"},
                                                                            {0x00100040, "CS"},
                                                                            {0x00200010, "SH"}}};

void addMethod(DicomItem& root, const Method& method)
{
    DicomItem item = root.addItem(0x00120064);
    item.text(0x00080100, "SH", method.value);
    item.text(0x00080102, "SH", "DCM");
    item.text(0x00080104, "LO", method.meaning);
}

void addDeidentificationMethod(DicomItem& root, const DeidentificationOptions& requested)
{
    const bool areShifted = requested.dates == DatePolicy::Shifted;
    root.text(0x00120062, "CS", "YES");
    root.text(0x00120063, "LO", "AngioPose " ANGIOPOSE_VERSION ": what describes the image was copied");
    for (const Method& method : {basicProfile, cleanGraphics, cleanStructure, cleanDescriptors}) {
        addMethod(root, method);
    }
    if (requested.letters == BurnedInTextPolicy::Masked) {
        addMethod(root, cleanPixels);
    }
    if (areShifted) {
        addMethod(root, modifiedDates);
    }
    root.text(0x00280303, "CS", areShifted ? "MODIFIED" : "REMOVED");
}

/// Limits text to a single value of at most 64 characters, as required for names and IDs.
std::string asOneValue(const std::string& requested)
{
    std::string value = truncateUtf8(requested, 64);
    std::erase_if(value, [](char c) { return c == '\\' || static_cast<unsigned char>(c) < ' '; });
    return value;
}

/// Returns the value that identifies the patient: the ID or, if there is no ID, the name.
std::string patientOf(const DicomDataset& data)
{
    const std::string_view id = data.text(0x00100020);
    return std::string(id.empty() ? data.text(0x00100010) : id);
}

/// Adds missing instance, study and series UIDs; files without series UID form one series per patient.
void addMissingUids(const DicomDataset& data, const std::string& path, const Replacements& replacements,
                    DicomItem& root)
{
    const Pseudonyms& pseudonyms = replacements.pseudonyms;
    root.setTextIfAbsent(0x00080018, "UI", pseudonyms.uid("instance " + path));
    root.setTextIfAbsent(0x0020000d, "UI", pseudonyms.uid("study of " + replacements.patient));
    root.setTextIfAbsent(0x0020000e, "UI", pseudonyms.uid("series of " + replacements.patient));
    const std::string_view modality = data.text(0x00080060);
    const bool saysSideElsewhere =
        data.has(0x00200062) || data.has(0x52009229) || modality == "SEG" || modality == "SR";
    if (!saysSideElsewhere) {
        root.setTextIfAbsent(0x00200060, "CS", "");
    }
}

/// Adds the patient, and the required elements whose values are unknown.
void addPatient(const DicomDataset& data, const std::string& patient, DicomItem& root)
{
    root.text(0x00080005, "CS", "ISO_IR 192");
    root.text(0x00100010, "PN", patient);
    root.text(0x00100020, "LO", patient);
    for (const auto& [tag, vr] : emptyWhereAbsent) {
        root.setTextIfAbsent(tag, vr, "");
    }
    if (data.has(0x00200052)) {
        root.setTextIfAbsent(0x00201040, "LO", "");   // position reference indicator
    }
}

/// Adds the elements that the modules of objects other than images require.
void addObjectParts(DeidentifiableClass freed, DicomItem& root)
{
    root.setTextIfAbsent(0x00181000, "LO", "none");
    root.setTextIfAbsent(0x00181020, "LO", "unknown");
    if (freed == DeidentifiableClass::Report) {
        root.addEmptySequence(0x00081111);
        root.addEmptySequence(0x0040a372);
        DicomItem ownTerms = root.addItem(0x00080110);
        ownTerms.text(0x00080102, "SH", "99ANGIOPOSE");
        ownTerms.text(0x00080115, "ST", "Terms of AngioPose, see its FORMATS");
    }
}

/// Copies the pixels or voxels, if the object has any.
core::Status copyBulk(DeidentifiableClass freed, const DicomFile& file, const std::string& path,
                      BurnedInTextPolicy letters, DeidentifiedDicom& nameless, DicomItem& root)
{
    switch (freed) {
        case DeidentifiableClass::Image:
            return copyPixels(file, path, letters, root, nameless.warnings);
        case DeidentifiableClass::Segmentation:
            return copySegments(file, path, root);
        case DeidentifiableClass::Report:
        case DeidentifiableClass::PresentationState:
        case DeidentifiableClass::Registration:
            break;
    }
    return core::Done{};
}

}   // namespace

core::Result<DeidentifiedDicom> deidentifyDicom(const DicomFile& file, const std::string& path,
                                                const DeidentificationOptions& requested, const Pseudonyms& pseudonyms)
{
    const DicomDataset& data = file.dataset;
    const auto freed = deidentifiableClassOf(file, path);
    if (!freed) {
        return freed.error();
    }
    const bool isImage = freed.value() == DeidentifiableClass::Image;
    const IdentityWords words(data);
    ContentCleaner kept(words);
    const Replacements replacements{pseudonyms, words, patientOf(data), requested.dates, isImage ? nullptr : &kept};
    DeidentifiedDicom nameless;
    DicomObject object;
    DicomItem root = object.root();
    copyPermittedElements(data, root, replacements);
    if (const auto copied = copyBulk(freed.value(), file, path, requested.letters, nameless, root); !copied) {
        return copied.error();
    }
    if (!isImage) {
        addObjectParts(freed.value(), root);
    }
    if (kept.removedCount() > 0) {
        nameless.warnings.push_back(messages::objectWordsCleared(kept.removedCount()));
    }
    const std::string patient =
        requested.patientName.empty() ? pseudonyms.patient(replacements.patient) : asOneValue(requested.patientName);
    addPatient(data, patient, root);
    addMissingUids(data, path, replacements, root);
    addDeidentificationMethod(root, requested);
    auto content = object.content();
    if (!content) {
        return content.error().about(path);
    }
    nameless.content = std::move(content).value();
    const std::string_view series = data.text(0x0020000e);
    nameless.seriesUid = pseudonyms.uid(series.empty() ? "series of " + replacements.patient : std::string(series));
    nameless.instanceNumber = data.integer(0x00200013).value_or(0);
    return nameless;
}

}   // namespace angiopose::io
