#include "io/sharing/case_identifiers.h"

#include "io/dicom/dicom_file.h"
#include "io/dicom/dicom_text.h"
#include "io/support/files_in_folder.h"

#include <dcmtk/dcmdata/dcelem.h>
#include <dcmtk/dcmdata/dcitem.h>
#include <filesystem>
#include <initializer_list>

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

/// How an element tells: by a name or number, by words, or not at all.
enum class Telling { Nothing, Name, Words };

Telling tellingOf(DcmEVR vr)
{
    switch (vr) {
        case EVR_PN:
        case EVR_UI:
        case EVR_DA:
        case EVR_DT:
        case EVR_SH:
            return Telling::Name;
        case EVR_LO:
        case EVR_ST:
        case EVR_LT:
        case EVR_UT:
        case EVR_UC:
        case EVR_AE:
            return Telling::Words;
        default:
            return Telling::Nothing;
    }
}

void addElements(const DicomDataset& data, int depth, Redaction& redaction)
{
    for (const auto& layer : data.layers()) {
        for (unsigned long i = 0; i < layer->card(); ++i) {
            const DcmElement* element = layer->getElement(i);
            const DicomTag tag = (static_cast<DicomTag>(element->getGTag()) << 16) | element->getETag();
            const Telling telling = tellingOf(element->getVR());
            if (telling == Telling::Name) {
                redaction.addName(utf8Text(data, tag));
            } else if (telling == Telling::Words) {
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

}   // namespace

void addIdentifiers(const core::Case& theCase, Redaction& redaction)
{
    redaction.addText(theCase.title);
    for (const core::InputFile* file : {&theCase.vessels.file, &theCase.vessels.scanFile}) {
        redaction.addPath(file->path);
    }
    redaction.addName(theCase.vessels.scanSeriesId);
    addIdentity(theCase.vessels.scanIdentity, redaction);
    addNames(theCase.vessels.marks, redaction);
    addNames(theCase.vessels.measurements, redaction);
    for (const core::View& view : theCase.views) {
        addView(view, redaction);
    }
}

void addIdentifiersOfFile(const std::string& path, Redaction& redaction)
{
    redaction.addPath(path);
    std::string file = path;
    std::error_code failed;
    if (std::filesystem::is_directory(path, failed)) {
        const auto files = filesInFolder(path, Reach::Below);
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

}   // namespace angiopose::io
