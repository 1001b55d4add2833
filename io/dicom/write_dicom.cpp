#include "io/dicom/write_dicom.h"

#include "io/dicom/stored_values.h"
#include "io/messages/says.h"
#include "io/support/quiet_libraries.h"

#include <gdcmDataElement.h>
#include <gdcmFile.h>
#include <gdcmWriter.h>
#include <openssl/evp.h>
#include <algorithm>
#include <array>
#include <cmath>
#include <exception>
#include <numbers>
#include <optional>
#include <sstream>

namespace angiopose::io {
namespace {

using core::Angiogram;
using core::CArm;

constexpr const char* xaImageStorage = "1.2.840.10008.5.1.4.1.1.12.1";

/// Adds elements to a data set, padded to even length as PS3.5 asks.
class DatasetWriter {
public:
    explicit DatasetWriter(gdcm::DataSet& data) : data_(&data) {}

    void text(std::uint32_t tag, gdcm::VR::VRType vr, std::string value)
    {
        if (value.size() % 2 == 1) {
            value += vr == gdcm::VR::UI ? '\0' : ' ';
        }
        bytes(tag, vr, value.data(), value.size());
    }
    void unsignedShort(std::uint32_t tag, int value)
    {
        const auto number = static_cast<std::uint16_t>(value);
        bytes(tag, gdcm::VR::US, reinterpret_cast<const char*>(&number), sizeof number);
    }
    void decimal(std::uint32_t tag, const core::Sourced<double>& number)
    {
        if (number.value) {
            text(tag, gdcm::VR::DS, decimalString(*number.value));
        }
    }
    void bytes(std::uint32_t tag, gdcm::VR::VRType vr, const char* content, std::size_t size)
    {
        gdcm::DataElement element(gdcm::Tag(tag), 0, vr);
        element.SetByteValue(content, gdcm::VL(static_cast<std::uint32_t>(size)));
        data_->Replace(element);
    }

private:
    gdcm::DataSet* data_;
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
    out.text(0x00080005, gdcm::VR::CS, "ISO_IR 192");
    out.text(0x00080008, gdcm::VR::CS, "DERIVED\\PRIMARY\\SINGLE PLANE");
    out.text(0x00080016, gdcm::VR::UI, xaImageStorage);
    out.text(0x00080018, gdcm::VR::UI, uidOr(identity.sopInstanceUid, "instance"));
    out.text(0x00080020, gdcm::VR::DA, digitsOf(identity.studyDate));
    out.text(0x00080030, gdcm::VR::TM, digitsOf(identity.studyTime));
    out.text(0x00080050, gdcm::VR::SH, "");
    out.text(0x00080060, gdcm::VR::CS, "XA");
    out.text(0x00080070, gdcm::VR::LO, identity.manufacturer);
    out.text(0x00080080, gdcm::VR::LO, identity.institution);
    out.text(0x00080090, gdcm::VR::PN, "");
    out.text(0x0008103e, gdcm::VR::LO, identity.description);
    out.text(0x00100010, gdcm::VR::PN, identity.patientName);
    out.text(0x00100020, gdcm::VR::LO, identity.patientId);
    out.text(0x00100030, gdcm::VR::DA, digitsOf(identity.birthDate));
    out.text(0x00100040, gdcm::VR::CS, identity.sex);
    out.text(0x0020000d, gdcm::VR::UI, uidOr(identity.studyUid, "study"));
    out.text(0x0020000e, gdcm::VR::UI, uidOr(identity.seriesUid, "series"));
    out.text(0x00200010, gdcm::VR::SH, "1");
    out.text(0x00200011, gdcm::VR::IS, "1");
    out.text(0x00200013, gdcm::VR::IS, "1");
    out.text(0x00200060, gdcm::VR::CS, "");
}

/// Row direction as seen on screen: image right is (cos α, sin α, 0) in LPS when not mirrored (ALGORITHMS §5.3).
void addOrientation(DatasetWriter& out, const CArm& cArm)
{
    if (!cArm.mirrored.value) {
        out.text(0x00200020, gdcm::VR::CS, "");
        return;
    }
    const double alpha = cArm.primaryAngleDeg.value.value_or(0.0) * std::numbers::pi / 180.0;
    const bool pointsLeft = (std::cos(alpha) > 0.0) != *cArm.mirrored.value;
    out.text(0x00200020, gdcm::VR::CS, pointsLeft ? "L\\F" : "R\\F");
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
    out.text(0x00187022, gdcm::VR::DS, decimalString(row) + "\\" + decimalString(column));
    out.text(0x00187026, gdcm::VR::DS,
             decimalString(2.0 * halfSidePx * row) + "\\" + decimalString(2.0 * halfSidePx * column));
    out.text(0x00187030, gdcm::VR::DS,
             decimalString(halfSidePx - point.y() - 0.5) + "\\" + decimalString(halfSidePx - point.x() - 0.5));
    out.text(0x00187032, gdcm::VR::DS, "0");
    out.text(0x00187034, gdcm::VR::CS, "NO");
}

void addGeometry(DatasetWriter& out, const Angiogram& angiogram)
{
    const CArm& cArm = angiogram.cArm;
    out.text(0x00180060, gdcm::VR::DS, "");
    for (const std::uint32_t unknown : {0x00181150U, 0x00181151U, 0x00181152U}) {   // exposure
        out.text(unknown, gdcm::VR::IS, "");
    }
    out.text(0x00181155, gdcm::VR::CS, "GR");
    out.decimal(0x00181110, cArm.sourceToDetectorMm);
    out.decimal(0x00181111, cArm.sourceToPatientMm);
    if (cArm.rowSpacingMm.value && cArm.columnSpacingMm.value) {
        out.text(0x00181164, gdcm::VR::DS,
                 decimalString(*cArm.rowSpacingMm.value) + "\\" + decimalString(*cArm.columnSpacingMm.value));
    }
    out.text(0x00181500, gdcm::VR::CS, "STATIC");
    out.text(0x00181510, gdcm::VR::DS, "");   // present even when unknown (type 2)
    out.text(0x00181511, gdcm::VR::DS, "");
    out.decimal(0x00181510, cArm.primaryAngleDeg);
    out.decimal(0x00181511, cArm.secondaryAngleDeg);
    addOrientation(out, cArm);
    addPrincipalPoint(out, angiogram);
}

void addPixels(DatasetWriter& out, const Angiogram& angiogram, const StoredValues& stored)
{
    if (angiogram.frameCount() > 1) {
        out.text(0x00181063, gdcm::VR::DS, decimalString(angiogram.frameTimeMs));
        const std::array<std::uint16_t, 2> frameTime = {0x0018, 0x1063};
        out.bytes(0x00280009, gdcm::VR::AT, reinterpret_cast<const char*>(frameTime.data()), sizeof frameTime);
        out.text(0x00280008, gdcm::VR::IS, std::to_string(angiogram.frameCount()));
    }
    out.unsignedShort(0x00280002, 1);
    out.text(0x00280004, gdcm::VR::CS, "MONOCHROME2");
    out.unsignedShort(0x00280010, angiogram.height());
    out.unsignedShort(0x00280011, angiogram.width());
    out.unsignedShort(0x00280100, 16);
    out.unsignedShort(0x00280101, 16);
    out.unsignedShort(0x00280102, 15);
    out.unsignedShort(0x00280103, 0);
    out.text(0x00281040, gdcm::VR::CS, "LOG");
    if (angiogram.polarity == core::Polarity::VesselsBright) {
        const std::int16_t sign = -1;   // values fall with the X-ray intensity
        out.bytes(0x00281041, gdcm::VR::SS, reinterpret_cast<const char*>(&sign), sizeof sign);
    }
    out.text(0x00281052, gdcm::VR::DS, stored.intercept);
    out.text(0x00281053, gdcm::VR::DS, stored.slope);
    out.text(0x00281054, gdcm::VR::LO, "US");
    out.text(0x00282110, gdcm::VR::CS, "00");
    out.bytes(0x7fe00010, gdcm::VR::OW, reinterpret_cast<const char*>(stored.pixels.data()), 2 * stored.pixels.size());
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
        gdcm::Writer writer;
        std::ostringstream stream;
        writer.SetStream(stream);
        writer.GetFile().GetHeader().SetDataSetTransferSyntax(gdcm::TransferSyntax::ExplicitVRLittleEndian);
        DatasetWriter out(writer.GetFile().GetDataSet());
        addIdentity(out, angiogram.identity, stored);
        addGeometry(out, angiogram);
        addPixels(out, angiogram, stored);
        if (!writer.Write()) {
            return core::Error(says::dicomNotWritten());
        }
        return std::move(stream).str();
    } catch (const std::exception&) {
        return core::Error(says::dicomNoMemoryToWrite());
    }
}

}   // namespace angiopose::io