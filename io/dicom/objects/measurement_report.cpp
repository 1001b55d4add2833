#include "io/dicom/objects/measurement_report.h"

#include "io/messages/messages.h"
#include "io/support/numbers.h"

namespace angiopose::io {
namespace {

constexpr ObjectKind reportKind{"1.2.840.10008.5.1.4.1.1.88.34", "SR", "measurements", "AngioPose measurements", 9007};

constexpr CodedTerm reportTerm{"126000", "DCM", "Imaging Measurement Report"};
constexpr CodedTerm languageTerm{"121049", "DCM", "Language of Content Item and Descendants"};
constexpr CodedTerm english{"en-US", "RFC5646", "English (United States)"};
constexpr CodedTerm observerType{"121005", "DCM", "Observer Type"};
constexpr CodedTerm device{"121007", "DCM", "Device"};
constexpr CodedTerm deviceUid{"121012", "DCM", "Device Observer UID"};
constexpr CodedTerm deviceName{"121013", "DCM", "Device Observer Name"};
constexpr CodedTerm deviceModel{"121015", "DCM", "Device Observer Model Name"};
constexpr CodedTerm procedureReported{"121058", "DCM", "Procedure reported"};
constexpr CodedTerm angiography{"77343006", "SCT", "Angiography"};
constexpr CodedTerm imageLibrary{"111028", "DCM", "Image Library"};
constexpr CodedTerm imageLibraryGroup{"126200", "DCM", "Image Library Group"};
constexpr CodedTerm imagingMeasurements{"126010", "DCM", "Imaging Measurements"};
constexpr CodedTerm measurementGroup{"125007", "DCM", "Measurement Group"};
constexpr CodedTerm trackingIdentifier{"112039", "DCM", "Tracking Identifier"};
constexpr CodedTerm trackingUid{"112040", "DCM", "Tracking Unique Identifier"};
constexpr DicomTag contentSequence = 0x0040a730;

DicomItem addContent(DicomItem& parent, const char* relationship, const char* valueType, const CodedTerm& meaning)
{
    DicomItem item = parent.addItem(contentSequence);
    item.text(0x0040a010, "CS", relationship);
    item.text(0x0040a040, "CS", valueType);
    addTerm(item, 0x0040a043, meaning);
    return item;
}

void addCodeContent(DicomItem& parent, const char* relationship, const CodedTerm& meaning, const CodedTerm& value)
{
    DicomItem item = addContent(parent, relationship, "CODE", meaning);
    addTerm(item, 0x0040a168, value);
}

void addTextContent(DicomItem& parent, const char* relationship, const CodedTerm& meaning, const std::string& words)
{
    addContent(parent, relationship, "TEXT", meaning).text(0x0040a160, "UT", words.empty() ? "-" : words);
}

void addUidContent(DicomItem& parent, const char* relationship, const CodedTerm& meaning, const std::string& uid)
{
    addContent(parent, relationship, "UIDREF", meaning).text(0x0040a124, "UI", uid);
}

DicomItem addContainer(DicomItem& parent, const CodedTerm& meaning)
{
    DicomItem item = addContent(parent, "CONTAINS", "CONTAINER", meaning);
    item.text(0x0040a050, "CS", "SEPARATE");
    return item;
}

void addImageContent(DicomItem& parent, const char* relationship, const SourceImage& source, int frame)
{
    DicomItem item = parent.addItem(contentSequence);
    item.text(0x0040a010, "CS", relationship);
    item.text(0x0040a040, "CS", "IMAGE");
    DicomItem image = addReference(item, 0x00081199, source.sopClassUid, source.sopInstanceUid);
    if (source.frames > 1 && frame >= 0) {
        image.text(0x00081160, "IS", std::to_string(frame + 1));
    }
}

/// Adds a polyline in image coordinates (origin at the corner of the first pixel) with a reference to the image.
void addPixelLine(DicomItem& number, const ReportNumber& reported, const SourceImage& source)
{
    std::vector<float> data;
    for (const Eigen::Vector2d& pixel : reported.pixels) {
        data.push_back(static_cast<float>(pixel.x() + 0.5));
        data.push_back(static_cast<float>(pixel.y() + 0.5));
    }
    DicomItem line = number.addItem(contentSequence);
    line.text(0x0040a010, "CS", "INFERRED FROM");
    line.text(0x0040a040, "CS", "SCOORD");
    line.setFloats(0x00700022, data);
    line.text(0x00700023, "CS", "POLYLINE");
    addImageContent(line, "SELECTED FROM", source, reported.frame);
}

void addPatientLine(DicomItem& number, const ReportNumber& reported, const std::string& frameOfReferenceUid)
{
    std::vector<float> data;
    for (const Eigen::Vector3d& point : reported.pointsInPatient) {
        for (const double value : point) {
            data.push_back(static_cast<float>(value));
        }
    }
    DicomItem line = number.addItem(contentSequence);
    line.text(0x0040a010, "CS", "INFERRED FROM");
    line.text(0x0040a040, "CS", "SCOORD3D");
    line.text(0x30060024, "UI", frameOfReferenceUid);
    line.setFloats(0x00700022, data);
    line.text(0x00700023, "CS", "POLYLINE");
}

void addNumber(DicomItem& group, const ReportNumber& reported, const MeasurementReport& report,
               const SourceImage& source)
{
    DicomItem item = addContent(group, "CONTAINS", "NUM", reported.meaning);
    DicomItem measured = item.addItem(0x0040a300);
    addTerm(measured, 0x004008ea, reported.unit);
    measured.setDoubles(0x0040a161, {reported.value});
    measured.setDecimals(0x0040a30a, {reported.value});
    if (!reported.pixels.empty() && source.isReferenceable()) {
        addPixelLine(item, reported, source);
    }
    if (!reported.pointsInPatient.empty() && !report.scanFrameOfReferenceUid.empty()) {
        addPatientLine(item, reported, report.scanFrameOfReferenceUid);
    }
}

/// Adds the language and the observer, which is a program (TID 1204, 1001 and 1004).
void addObservationContext(DicomItem& root, const ObjectOrigin& origin)
{
    addCodeContent(root, "HAS CONCEPT MOD", languageTerm, english);
    addCodeContent(root, "HAS OBS CONTEXT", observerType, device);
    addUidContent(root, "HAS OBS CONTEXT", deviceUid, origin.uidFor("device"));
    addTextContent(root, "HAS OBS CONTEXT", deviceName, "AngioPose");
    addTextContent(root, "HAS OBS CONTEXT", deviceModel,
                   "AngioPose " ANGIOPOSE_VERSION ", research, no medical device");
    addCodeContent(root, "HAS CONCEPT MOD", procedureReported, angiography);
}

void addImageLibrary(DicomItem& root, const SourceImage& source)
{
    if (source.isReferenceable()) {
        DicomItem library = addContainer(root, imageLibrary);
        DicomItem group = addContainer(library, imageLibraryGroup);
        addImageContent(group, "CONTAINS", source, -1);
    }
}

void addGroups(DicomItem& root, const MeasurementReport& report, const SourceImage& source, const ObjectOrigin& origin)
{
    DicomItem measurements = addContainer(root, imagingMeasurements);
    for (std::size_t i = 0; i < report.groups.size(); ++i) {
        const ReportGroup& reported = report.groups[i];
        DicomItem group = addContainer(measurements, measurementGroup);
        addTextContent(group, "HAS OBS CONTEXT", trackingIdentifier, reported.name);
        addUidContent(group, "HAS OBS CONTEXT", trackingUid, origin.uidFor("measurement " + std::to_string(i)));
        for (const ReportNumber& number : reported.numbers) {
            addNumber(group, number, report, source);
        }
        for (const ReportText& text : reported.texts) {
            addTextContent(group, "CONTAINS", text.meaning, text.words);
        }
    }
}

/// Adds the SR Document General module (PS3.3 C.17.2).
void addDocument(DicomItem& root, const SourceImage& source, const ObjectOrigin& origin)
{
    addContentTime(root, origin);
    root.addEmptySequence(0x00081111);
    root.addEmptySequence(0x0040a372);
    root.text(0x0040a491, "CS", "COMPLETE");
    root.text(0x0040a493, "CS", "UNVERIFIED");
    root.text(0x0040a496, "CS", "PRELIMINARY");
    if (source.isReferenceable()) {
        DicomItem study = root.addItem(0x0040a375);
        study.text(0x0020000d, "UI", studyUidOf(source, origin));
        DicomItem series = study.addItem(0x00081115);
        series.text(0x0020000e, "UI", source.seriesUid);
        addReference(series, 0x00081199, source.sopClassUid, source.sopInstanceUid);
    }
}

}   // namespace

core::Result<std::string> encodeMeasurementReport(const MeasurementReport& report, const SourceImage& source,
                                                  const ObjectOrigin& origin)
{
    if (report.groups.empty()) {
        return core::Error(messages::objectNothingMeasured());
    }
    DicomObject object;
    DicomItem root = object.root();
    addCommonModules(root, reportKind, source, origin);
    addDocument(root, source, origin);
    DicomItem ownTerms = root.addItem(0x00080110);
    ownTerms.text(0x00080102, "SH", "99ANGIOPOSE");
    ownTerms.text(0x00080115, "ST", "Terms of AngioPose, see its FORMATS");
    root.text(0x0040a040, "CS", "CONTAINER");
    addTerm(root, 0x0040a043, reportTerm);
    root.text(0x0040a050, "CS", "SEPARATE");
    DicomItem usedTemplate = root.addItem(0x0040a504);
    usedTemplate.text(0x00080105, "CS", "DCMR");
    usedTemplate.text(0x0040db00, "CS", "1500");
    addObservationContext(root, origin);
    addImageLibrary(root, source);
    addGroups(root, report, source, origin);
    return object.content();
}

}   // namespace angiopose::io
