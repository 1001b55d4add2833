#include "io/dicom/write_dicom.h"

#include "core/messages/messages.h"
#include "io/dicom/dicom_item.h"
#include "io/dicom/new_uid.h"
#include "io/dicom/siemens_tags.h"
#include "io/dicom/source_image.h"
#include "io/dicom/stored_values.h"
#include "io/messages/messages.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <exception>
#include <functional>
#include <optional>

namespace angiopose::io {
namespace {

using core::Angiogram;
using core::CArm;

constexpr const char* xaImageStorage = "1.2.840.10008.5.1.4.1.1.12.1";
constexpr const char* derivation = "Decoded, rescaled and stored again by AngioPose " ANGIOPOSE_VERSION;

void addDecimal(DicomItem& out, DicomTag tag, const core::SourcedValue<double>& number)
{
    if (number.value) {
        out.setDecimals(tag, {*number.value});
    }
}

/// Returns an error for an invalid distance or spacing; nullopt if all are valid.
std::optional<core::Message> findNoLength(const CArm& cArm)
{
    const auto isNone = [](const core::SourcedValue<double>& length) {
        return length.value && !(std::isfinite(*length.value) && *length.value > 0.0);
    };
    if (isNone(cArm.sourceToDetectorMm)) {
        return core::messages::valueMissing(core::messages::sidName());
    }
    return isNone(cArm.rowSpacingMm) || isNone(cArm.columnSpacingMm)
               ? std::optional(core::messages::valueMissing(core::messages::spacingName()))
               : std::nullopt;
}

std::optional<core::Message> findUnwritable(const Angiogram& angiogram)
{
    if (angiogram.frames.empty() || angiogram.frames.front().isEmpty()) {
        return messages::dicomNoFramesToWrite();
    }
    if (const auto wrong = findNoLength(angiogram.cArm)) {
        return wrong;
    }
    const int width = angiogram.width(), height = angiogram.height();
    for (const core::ImageF& frame : angiogram.frames) {
        if (frame.width != width || frame.height != height) {
            return messages::imageFramesDiffer();
        }
        if (!std::all_of(frame.pixels.begin(), frame.pixels.end(), [](float value) { return std::isfinite(value); })) {
            return messages::pixelNotFiniteWriting();
        }
    }
    const std::size_t pixels = angiogram.frames.front().pixels.size() * angiogram.frames.size();
    const bool isTooLarge = width > 65535 || height > 65535 || pixels > (std::size_t{1} << 31) - 16;
    return isTooLarge ? std::optional(messages::dicomRunTooLarge()) : std::nullopt;
}

std::string digitsOf(std::string text)
{
    std::erase_if(text, [](char c) { return c < '0' || c > '9'; });
    return text;
}

/// Returns the pixels as bytes, for hashing.
std::string_view bytesOf(const StoredValues& stored)
{
    return {reinterpret_cast<const char*>(stored.pixels.data()), 2 * stored.pixels.size()};
}

/// Adds the identity of an image in a new series of the same study, so that it never collides with an archived one.
void addIdentity(DicomItem& out, const core::StudyIdentity& identity, const StoredValues& stored)
{
    const std::string pixels = uidFromContent(bytesOf(stored));
    const std::string study =
        identity.studyUid.empty() ? uidFromContent("study " + pixels) : validUid(identity.studyUid);
    const std::string series = identity.seriesUid.empty() ? pixels : identity.seriesUid;
    out.text(0x00080005, "CS", "ISO_IR 192");
    out.text(0x00080008, "CS", "DERIVED\\PRIMARY\\SINGLE PLANE");
    out.text(0x00080016, "UI", xaImageStorage);
    out.text(0x00080020, "DA", digitsOf(identity.studyDate));
    out.text(0x00080030, "TM", digitsOf(identity.studyTime));
    out.text(0x00080050, "SH", identity.accessionNumber);
    out.text(0x00080060, "CS", "XA");
    out.text(0x00080070, "LO", identity.manufacturer);
    out.text(0x00080080, "LO", identity.institution);
    out.text(0x00080090, "PN", "");
    out.text(0x0008103e, "LO", identity.description);
    out.text(0x00100010, "PN", identity.patientName);
    out.text(0x00100020, "LO", identity.patientId);
    out.text(0x00100030, "DA", digitsOf(identity.birthDate));
    out.text(0x00100040, "CS", identity.sex);
    out.text(0x0020000d, "UI", study);
    out.text(0x0020000e, "UI", uidFromContent("converted series " + series));
    out.text(0x00200010, "SH", "1");
    out.text(0x00200011, "IS", "1");
    out.text(0x00200013, "IS", "1");
    out.text(0x00200060, "CS", identity.laterality);   // type 2C, empty if unknown
}

/// Returns the anatomical letters of an LPS direction, dominant direction first, for example "LA".
std::string lettersOf(const Eigen::Vector3d& direction)
{
    constexpr double minShare = 0.2;
    std::array<Eigen::Index, 3> axes{0, 1, 2};
    std::ranges::stable_sort(axes, std::greater(), [&](Eigen::Index axis) { return std::abs(direction[axis]); });
    std::string letters;
    for (const Eigen::Index axis : axes) {
        if (std::abs(direction[axis]) > minShare) {
            letters += (direction[axis] > 0.0 ? "LPH" : "RAF")[axis];
        }
    }
    return letters;
}

/// Adds Patient Orientation, with row and column directions that encode mirroring and quarter turns.
void addOrientation(DicomItem& out, const CArm& cArm)
{
    const core::ImageAxes axes = imageAxesOf(cArm);
    out.text(0x00200020, "CS", cArm.mirrored.value ? lettersOf(axes.right) + "\\" + lettersOf(axes.down) : "");
}

/// Adds isocenter and table position, if known, in the same tags from which they are read.
void addTable(DicomItem& out, const Angiogram& angiogram)
{
    const core::GantryHeader& gantry = angiogram.gantry;
    const auto& isocenter = angiogram.cArm.sourceToIsocenterMm;
    const bool isSiemens = gantry.table && gantry.table->tags == core::TablePosition::Tags::Siemens;
    if (isSiemens) {
        out.text(siemensBlock, "LO", siemensCreator);
    }
    const auto siemens = [](DicomTag number) { return 0x00211000U | number; };
    if (isocenter.value && isocenter.origin != core::Origin::Assumed) {
        if (isSiemens) {
            out.setSignedLongs(siemens(siemensIsocenter), {static_cast<std::int32_t>(std::lround(*isocenter.value))});
        } else {
            out.setFloats(0x00189402, {static_cast<float>(*isocenter.value)});
        }
    }
    const auto position = gantry.patientPosition.value_or(core::PatientPosition::HFS);
    if (gantry.patientPosition) {
        out.text(0x00185100, "CS", std::string(toText(position)));
    }
    if (gantry.table) {
        const Eigen::Vector3d onTable = patientFromTable(position).transpose() * gantry.table->isocenterInPatientMm;
        const auto tenths = [](double mm) { return static_cast<std::int32_t>(std::lround(10.0 * mm)); };
        if (isSiemens) {
            out.setSignedLongs(siemens(siemensTable),
                               {tenths(-onTable.z()), tenths(onTable.x()), tenths(-onTable.y())});
        }
        for (DicomTag axis = 0; axis < 3 && !isSiemens; ++axis) {
            out.setFloats(0x00189466U + axis, {static_cast<float>(-onTable[axis])});
        }
    }
    if (gantry.tableMoves) {
        out.text(0x00181134, "CS", "DYNAMIC");
    }
    if (const auto& biplane = gantry.biplane) {
        const auto seconds = static_cast<int>(biplane->timeS);
        const int time = 10000 * (seconds / 3600) + 100 * (seconds / 60 % 60) + seconds % 60;
        out.text(0x00080008, "CS", std::string("DERIVED\\PRIMARY\\BIPLANE ") + biplane->plane);
        out.text(0x00080022, "DA", biplane->date);
        out.text(0x00080032, "TM",
                 std::string(6 - std::min<std::size_t>(6, std::to_string(time).size()), '0') + std::to_string(time));
    }
}

/// Adds the principal point, which has no tag of its own, as the position of the field of view on the detector.
void addPrincipalPoint(DicomItem& out, const Angiogram& angiogram)
{
    const CArm& cArm = angiogram.cArm;
    if (!cArm.principalPointPx.value || !cArm.rowSpacingMm.value || !cArm.columnSpacingMm.value) {
        return;
    }
    const Eigen::Vector2d point = *cArm.principalPointPx.value;
    const double halfSidePx =
        std::ceil(std::max({point.x() + 1.0, point.y() + 1.0, double(angiogram.width()), double(angiogram.height())}));
    const double row = *cArm.rowSpacingMm.value, column = *cArm.columnSpacingMm.value;
    out.text(0x00187022, "DS", decimalString(row) + "\\" + decimalString(column));
    out.text(0x00187026, "DS", decimalString(2.0 * halfSidePx * row) + "\\" + decimalString(2.0 * halfSidePx * column));
    out.text(0x00187030, "DS",
             decimalString(halfSidePx - point.y() - 0.5) + "\\" + decimalString(halfSidePx - point.x() - 0.5));
    out.text(0x00187032, "DS", "0");
    out.text(0x00187034, "CS", "NO");
}

void addGeometry(DicomItem& out, const Angiogram& angiogram)
{
    const CArm& cArm = angiogram.cArm;
    out.text(0x00180060, "DS", "");
    for (const std::uint32_t unknown : {0x00181150U, 0x00181151U, 0x00181152U}) {   // exposure, which is unknown
        out.text(unknown, "IS", "");
    }
    out.text(0x00181155, "CS", "GR");
    addDecimal(out, 0x00181110, cArm.sourceToDetectorMm);
    addDecimal(out, 0x00181111, vesselDepthOf(cArm));
    if (cArm.rowSpacingMm.value && cArm.columnSpacingMm.value) {
        out.text(0x00181164, "DS",
                 decimalString(*cArm.rowSpacingMm.value) + "\\" + decimalString(*cArm.columnSpacingMm.value));
    }
    out.text(0x00181500, "CS", "STATIC");
    out.text(0x00181510, "DS", "");   // present even when unknown (type 2)
    out.text(0x00181511, "DS", "");
    addDecimal(out, 0x00181510, cArm.primaryAngleDeg);
    addDecimal(out, 0x00181511, cArm.secondaryAngleDeg);
    addOrientation(out, cArm);
    addTable(out, angiogram);
    addPrincipalPoint(out, angiogram);
}

std::vector<std::uint16_t> framesFromOne(const std::vector<int>& frames)
{
    std::vector<std::uint16_t> numbers;
    for (const int frame : frames) {
        numbers.push_back(static_cast<std::uint16_t>(frame + 1));
    }
    return numbers;
}

void addPixelHeader(DicomItem& out, const Angiogram& angiogram, const StoredValues& stored)
{
    if (angiogram.frameCount() > 1) {
        out.text(0x00181063, "DS", decimalString(angiogram.frameTimeMs));
        out.text(0x00280009, "AT", "(0018,1063)");
        out.text(0x00280008, "IS", std::to_string(angiogram.frameCount()));
        out.setUnsignedShorts(0x00286040, framesFromOne(angiogram.rWaveFrames));
    }
    out.setUnsignedShort(0x00280002, 1);
    out.text(0x00280004, "CS", "MONOCHROME2");
    out.setUnsignedShort(0x00280010, angiogram.height());
    out.setUnsignedShort(0x00280011, angiogram.width());
    out.setUnsignedShort(0x00280100, 16);
    out.setUnsignedShort(0x00280101, 16);
    out.setUnsignedShort(0x00280102, 15);
    out.setUnsignedShort(0x00280103, 0);
    out.text(0x00281040, "CS", "LOG");
    if (angiogram.polarity == core::Polarity::VesselsBright) {
        out.setSignedShort(0x00281041, -1);   // values decrease with increasing X-ray intensity
    }
    out.text(0x00281052, "DS", stored.intercept);
    out.text(0x00281053, "DS", stored.slope);
    out.text(0x00281054, "LO", "US");
    out.text(0x00282110, "CS", "00");
}

/// Adds the derivation description and, if the source is a DICOM instance, a reference to it.
void addDerivation(DicomItem& out, const SourceImage* source)
{
    out.text(0x00082111, "ST", derivation);
    if (source == nullptr || !source->isReferenceable()) {
        return;
    }
    addReference(out, 0x00082112, source->sopClassUid, source->sopInstanceUid);
    for (const SourceImage::Text& lost : source->lossyCompression) {
        out.text(lost.tag, lost.vr, lost.value);
    }
    if (source->declaresBurnedInText) {
        out.text(0x00280301, "CS", "YES");
    }
}

/// Adds everything except the pixels and the image's own UID.
void addHeader(DicomItem& out, const Angiogram& angiogram, const StoredValues& stored, const SourceImage* source)
{
    addIdentity(out, angiogram.identity, stored);
    addDerivation(out, source);
    addGeometry(out, angiogram);
    addPixelHeader(out, angiogram, stored);
}

/// Derives the instance UID from header and pixels, so that different images have different UIDs.
std::string instanceUidOf(const Angiogram& angiogram, const StoredValues& stored, const SourceImage* source)
{
    DicomObject header;
    DicomItem root = header.root();
    addHeader(root, angiogram, stored, source);
    root.text(0x00080018, "UI",
              angiogram.identity.sopInstanceUid.empty() ? uidFromContent(bytesOf(stored))
                                                        : angiogram.identity.sopInstanceUid);
    const auto content = header.content();
    return uidFromContent((content ? content.value() : std::string()) + uidFromContent(bytesOf(stored)));
}

}   // namespace

core::Result<std::string> encodeDicomAngiogram(const Angiogram& angiogram, const SourceImage* source)
{
    if (const auto unwritable = findUnwritable(angiogram)) {
        return core::Error(*unwritable);
    }
    try {
        const StoredValues stored = storedValuesOf(angiogram.frames);
        DicomObject object;
        DicomItem root = object.root();
        addHeader(root, angiogram, stored, source);
        root.text(0x00080018, "UI", instanceUidOf(angiogram, stored, source));
        root.words(0x7fe00010, stored.pixels);
        return object.content();
    } catch (const std::exception&) {
        return core::Error(messages::dicomNoMemoryToWrite());
    }
}

}   // namespace angiopose::io
