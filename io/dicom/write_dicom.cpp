#include "io/dicom/write_dicom.h"

#include "io/dicom/stored_values.h"
#include "io/messages/says.h"
#include "io/support/quiet_libraries.h"

#include <dcmtk/config/osconfig.h>
// DCMTK's macros first.
#include <dcmtk/dcmdata/dcostrmb.h>
#include <dcmtk/dcmdata/dctk.h>
#include <openssl/evp.h>
#include <algorithm>
#include <array>
#include <cmath>
#include <exception>
#include <numbers>
#include <optional>

namespace angiopose::io {
namespace {

using core::Angiogram;
using core::CArm;

constexpr const char* xaImageStorage = "1.2.840.10008.5.1.4.1.1.12.1";

/// Adds elements to a data set; what is there already is replaced.
class DatasetWriter {
public:
    explicit DatasetWriter(DcmDataset& data) : data_(&data) {}

    void text(std::uint32_t tag, DcmEVR vr, const std::string& value)
    {
        data_->putAndInsertString(tagOf(tag, vr), value.c_str());
    }
    void unsignedShort(std::uint32_t tag, int value)
    {
        data_->putAndInsertUint16(tagOf(tag, EVR_US), static_cast<Uint16>(value));
    }
    void unsignedShorts(std::uint32_t tag, const std::vector<std::uint16_t>& values)
    {
        if (!values.empty()) {
            data_->putAndInsertUint16Array(tagOf(tag, EVR_US), values.data(), values.size());
        }
    }
    void signedShort(std::uint32_t tag, int value)
    {
        data_->putAndInsertSint16(tagOf(tag, EVR_SS), static_cast<Sint16>(value));
    }
    void decimal(std::uint32_t tag, const core::Sourced<double>& number)
    {
        if (number.value) {
            text(tag, EVR_DS, decimalString(*number.value));
        }
    }
    void words(std::uint32_t tag, const std::vector<std::uint16_t>& values)
    {
        data_->putAndInsertUint16Array(tagOf(tag, EVR_OW), values.data(), values.size());
    }

private:
    static DcmTag tagOf(std::uint32_t tag, DcmEVR vr)
    {
        return {static_cast<Uint16>(tag >> 16U), static_cast<Uint16>(tag & 0xffffU), DcmVR(vr)};
    }

    DcmDataset* data_;
};

std::optional<core::Message> findUnwritable(const Angiogram& angiogram)
{
    if (angiogram.frames.empty() || angiogram.frames.front().isEmpty()) {
        return says::dicomNoFramesToWrite();
    }
    const int width = angiogram.width(), height = angiogram.height();
    for (const core::ImageF& frame : angiogram.frames) {
        if (frame.width != width || frame.height != height) {
            return says::imageFramesDiffer();
        }
        if (!std::all_of(frame.pixels.begin(), frame.pixels.end(), [](float value) { return std::isfinite(value); })) {
            return says::pixelNotFiniteWriting();
        }
    }
    const std::size_t pixels = angiogram.frames.front().pixels.size() * angiogram.frames.size();
    const bool isTooLarge = width > 65535 || height > 65535 || pixels > (std::size_t{1} << 31) - 16;
    return isTooLarge ? std::optional(says::dicomRunTooLarge()) : std::nullopt;
}

/// "2.25." and a decimal number below 10^36 that follows from the content (PS3.5 B.2).
std::string contentUid(const StoredValues& stored, const std::string& role)
{
    std::array<unsigned char, EVP_MAX_MD_SIZE> digest{};
    unsigned int size = 0;
    EVP_Digest(stored.pixels.data(), stored.pixels.size() * 2, digest.data(), &size, EVP_sha256(), nullptr);
    std::string seed(reinterpret_cast<const char*>(digest.data()), size);
    seed += role;
    EVP_Digest(seed.data(), seed.size(), digest.data(), &size, EVP_sha256(), nullptr);
    std::string uid = "2.25.1";
    for (int i = 0; i < 30; ++i) {
        uid += static_cast<char>('0' + digest[static_cast<std::size_t>(i)] % 10);
    }
    return uid;
}

std::string digitsOf(std::string text)
{
    std::erase_if(text, [](char c) { return c < '0' || c > '9'; });
    return text;
}

void addIdentity(DatasetWriter& out, const core::StudyIdentity& identity, const StoredValues& stored)
{
    const auto uidOr = [&](const std::string& known, const char* role) {
        return known.empty() ? contentUid(stored, role) : known;
    };
    out.text(0x00080005, EVR_CS, "ISO_IR 192");
    out.text(0x00080008, EVR_CS, "DERIVED\\PRIMARY\\SINGLE PLANE");
    out.text(0x00080016, EVR_UI, xaImageStorage);
    out.text(0x00080018, EVR_UI, uidOr(identity.sopInstanceUid, "instance"));
    out.text(0x00080020, EVR_DA, digitsOf(identity.studyDate));
    out.text(0x00080030, EVR_TM, digitsOf(identity.studyTime));
    out.text(0x00080050, EVR_SH, identity.accessionNumber);
    out.text(0x00080060, EVR_CS, "XA");
    out.text(0x00080070, EVR_LO, identity.manufacturer);
    out.text(0x00080080, EVR_LO, identity.institution);
    out.text(0x00080090, EVR_PN, "");
    out.text(0x0008103e, EVR_LO, identity.description);
    out.text(0x00100010, EVR_PN, identity.patientName);
    out.text(0x00100020, EVR_LO, identity.patientId);
    out.text(0x00100030, EVR_DA, digitsOf(identity.birthDate));
    out.text(0x00100040, EVR_CS, identity.sex);
    out.text(0x0020000d, EVR_UI, uidOr(identity.studyUid, "study"));
    out.text(0x0020000e, EVR_UI, uidOr(identity.seriesUid, "series"));
    out.text(0x00200010, EVR_SH, "1");
    out.text(0x00200011, EVR_IS, "1");
    out.text(0x00200013, EVR_IS, "1");
    out.text(0x00200060, EVR_CS, identity.laterality);
}

/// Row direction as seen on screen: image right is (cos α, sin α, 0) in LPS when not mirrored (ALGORITHMS §5.3).
void addOrientation(DatasetWriter& out, const CArm& cArm)
{
    if (!cArm.mirrored.value) {
        out.text(0x00200020, EVR_CS, "");
        return;
    }
    const double alpha = cArm.primaryAngleDeg.value.value_or(0.0) * std::numbers::pi / 180.0;
    const bool pointsLeft = (std::cos(alpha) > 0.0) != *cArm.mirrored.value;
    out.text(0x00200020, EVR_CS, pointsLeft ? "L\\F" : "R\\F");
}

/// The principal point has no tag of its own: it follows from where the field of view lies on the detector.
void addPrincipalPoint(DatasetWriter& out, const Angiogram& angiogram)
{
    const CArm& cArm = angiogram.cArm;
    if (!cArm.principalPointPx.value || !cArm.rowSpacingMm.value || !cArm.columnSpacingMm.value) {
        return;
    }
    const Eigen::Vector2d point = *cArm.principalPointPx.value;
    const double halfSidePx =
        std::ceil(std::max({point.x() + 1.0, point.y() + 1.0, double(angiogram.width()), double(angiogram.height())}));
    const double row = *cArm.rowSpacingMm.value, column = *cArm.columnSpacingMm.value;
    out.text(0x00187022, EVR_DS, decimalString(row) + "\\" + decimalString(column));
    out.text(0x00187026, EVR_DS,
             decimalString(2.0 * halfSidePx * row) + "\\" + decimalString(2.0 * halfSidePx * column));
    out.text(0x00187030, EVR_DS,
             decimalString(halfSidePx - point.y() - 0.5) + "\\" + decimalString(halfSidePx - point.x() - 0.5));
    out.text(0x00187032, EVR_DS, "0");
    out.text(0x00187034, EVR_CS, "NO");
}

void addGeometry(DatasetWriter& out, const Angiogram& angiogram)
{
    const CArm& cArm = angiogram.cArm;
    out.text(0x00180060, EVR_DS, "");
    for (const std::uint32_t unknown : {0x00181150U, 0x00181151U, 0x00181152U}) {   // exposure
        out.text(unknown, EVR_IS, "");
    }
    out.text(0x00181155, EVR_CS, "GR");
    out.decimal(0x00181110, cArm.sourceToDetectorMm);
    out.decimal(0x00181111, cArm.sourceToPatientMm);
    if (cArm.rowSpacingMm.value && cArm.columnSpacingMm.value) {
        out.text(0x00181164, EVR_DS,
                 decimalString(*cArm.rowSpacingMm.value) + "\\" + decimalString(*cArm.columnSpacingMm.value));
    }
    out.text(0x00181500, EVR_CS, "STATIC");
    out.text(0x00181510, EVR_DS, "");   // present even when unknown (type 2)
    out.text(0x00181511, EVR_DS, "");
    out.decimal(0x00181510, cArm.primaryAngleDeg);
    out.decimal(0x00181511, cArm.secondaryAngleDeg);
    addOrientation(out, cArm);
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

void addPixels(DatasetWriter& out, const Angiogram& angiogram, const StoredValues& stored)
{
    if (angiogram.frameCount() > 1) {
        out.text(0x00181063, EVR_DS, decimalString(angiogram.frameTimeMs));
        out.text(0x00280009, EVR_AT, "(0018,1063)");
        out.text(0x00280008, EVR_IS, std::to_string(angiogram.frameCount()));
        out.unsignedShorts(0x00286040, framesFromOne(angiogram.rWaveFrames));
    }
    out.unsignedShort(0x00280002, 1);
    out.text(0x00280004, EVR_CS, "MONOCHROME2");
    out.unsignedShort(0x00280010, angiogram.height());
    out.unsignedShort(0x00280011, angiogram.width());
    out.unsignedShort(0x00280100, 16);
    out.unsignedShort(0x00280101, 16);
    out.unsignedShort(0x00280102, 15);
    out.unsignedShort(0x00280103, 0);
    out.text(0x00281040, EVR_CS, "LOG");
    if (angiogram.polarity == core::Polarity::VesselsBright) {
        out.signedShort(0x00281041, -1);   // values fall with the X-ray intensity
    }
    out.text(0x00281052, EVR_DS, stored.intercept);
    out.text(0x00281053, EVR_DS, stored.slope);
    out.text(0x00281054, EVR_LO, "US");
    out.text(0x00282110, EVR_CS, "00");
    out.words(0x7fe00010, stored.pixels);
}

/// The file as it would lie on disk; nothing when an element is not one.
std::optional<std::string> fileContent(DcmFileFormat& file)
{
    std::string content;
    std::vector<char> buffer(std::size_t{1} << 20);
    DcmOutputBufferStream stream(buffer.data(), static_cast<offile_off_t>(buffer.size()));
    file.transferInit();
    OFCondition state = EC_StreamNotifyClient;
    while (state == EC_StreamNotifyClient) {   // the buffer is full
        state = file.write(stream, EXS_LittleEndianExplicit, EET_ExplicitLength, nullptr);
        void* bytes = nullptr;
        offile_off_t size = 0;
        stream.flushBuffer(bytes, size);
        content.append(static_cast<const char*>(bytes), static_cast<std::size_t>(size));
    }
    file.transferEnd();
    return state.good() ? std::optional(std::move(content)) : std::nullopt;
}

}   // namespace

core::Result<std::string> dicomText(const Angiogram& angiogram)
{
    quietLibraries();
    if (const auto unwritable = findUnwritable(angiogram)) {
        return core::Error(*unwritable);
    }
    try {
        const StoredValues stored = storedValuesOf(angiogram.frames);
        DcmFileFormat file;
        DatasetWriter out(*file.getDataset());
        addIdentity(out, angiogram.identity, stored);
        addGeometry(out, angiogram);
        addPixels(out, angiogram, stored);
        auto content = fileContent(file);
        return content ? core::Result<std::string>(std::move(*content)) : core::Error(says::dicomNotWritten());
    } catch (const std::exception&) {
        return core::Error(says::dicomNoMemoryToWrite());
    }
}

}   // namespace angiopose::io