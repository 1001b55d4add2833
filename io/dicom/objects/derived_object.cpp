#include "io/dicom/objects/derived_object.h"

#include "io/dicom/new_uid.h"
#include "io/dicom/objects/coded_term.h"

namespace angiopose::io {
namespace {

constexpr const char* notADevice =
    "Made by AngioPose, a program for research. It is not a medical device; not for diagnosis or treatment.";

/// Returns whether an object has the Laterality element (PS3.3 C.7.3.1), which is empty if unknown; segmentations and
/// reports store the laterality elsewhere.
bool hasLaterality(const ObjectKind& kind)
{
    const std::string_view modality = kind.modality;
    return modality != "SEG" && modality != "SR";
}

}   // namespace

std::string ObjectOrigin::uidFor(const std::string& role) const
{
    return uidFromContent(seed + " " + role);
}

ObjectOrigin makeOrigin(const std::string& author)
{
    return {makeUid(), localTimeNow(), author};
}

std::string studyUidOf(const SourceImage& source, const ObjectOrigin& origin)
{
    return source.studyUid.empty() ? origin.uidFor("study") : source.studyUid;
}

void addCommonModules(DicomItem& root, const ObjectKind& kind, const SourceImage& source, const ObjectOrigin& origin)
{
    root.text(0x00080005, "CS", "ISO_IR 192");
    root.text(0x00080012, "DA", origin.created.date);
    root.text(0x00080013, "TM", origin.created.time);
    root.text(0x00080016, "UI", kind.sopClassUid);
    root.text(0x00080018, "UI", origin.uidFor(std::string("instance of ") + kind.role));
    root.text(0x00080021, "DA", origin.created.date);
    root.text(0x00080031, "TM", origin.created.time);
    root.text(0x00080060, "CS", kind.modality);
    root.text(0x00080070, "LO", "AngioPose");
    root.text(0x0008103e, "LO", kind.description);
    root.text(0x00081090, "LO", "AngioPose");
    for (const SourceImage::Text& taken : source.patientAndStudy) {
        root.text(taken.tag, taken.vr, taken.value);
    }
    root.text(0x00181000, "LO", "none");   // a program has no serial number, but some objects require one
    root.text(0x00181020, "LO", "AngioPose " ANGIOPOSE_VERSION);
    root.text(0x00189004, "CS", "RESEARCH");
    root.text(0x0020000d, "UI", studyUidOf(source, origin));
    root.text(0x0020000e, "UI", origin.uidFor(std::string("series of ") + kind.role));
    root.text(0x00200011, "IS", std::to_string(kind.seriesNumber));
    root.text(0x00200013, "IS", "1");
    if (hasLaterality(kind)) {
        root.text(0x00200060, "CS", source.laterality);
    }
    root.text(0x00400280, "ST", notADevice);
}

void addContentIdentification(DicomItem& root, const char* label, const std::string& description,
                              const ObjectOrigin& origin)
{
    root.text(0x00700080, "CS", label);
    root.text(0x00700081, "LO", truncateUtf8(description, 64));
    root.text(0x00700084, "PN", truncateUtf8(origin.author, 64));
}

void addContentTime(DicomItem& root, const ObjectOrigin& origin)
{
    root.text(0x00080023, "DA", origin.created.date);
    root.text(0x00080033, "TM", origin.created.time);
}

void addDerivedFrom(DicomItem& root, const std::string& words, const SourceImage& source)
{
    root.text(0x00082111, "ST", truncateUtf8(words, 1024));
    if (source.isReferenceable()) {
        DicomItem reference = addReference(root, 0x00082112, source.sopClassUid, source.sopInstanceUid);
        addTerm(reference, 0x0040a170, sourceImageForProcessing);
    }
    for (const SourceImage::Text& lost : source.lossyCompression) {
        root.text(lost.tag, lost.vr, lost.value);
    }
}

void addReferencedSeries(DicomItem& root, const SourceImage& source)
{
    if (source.isReferenceable()) {
        DicomItem series = root.addItem(0x00081115);
        series.text(0x0020000e, "UI", source.seriesUid);
        addReference(series, 0x0008114a, source.sopClassUid, source.sopInstanceUid);
    }
}

}   // namespace angiopose::io
