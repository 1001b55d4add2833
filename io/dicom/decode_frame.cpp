#include "io/dicom/decode_frame.h"

#include "io/dicom/decode_jpeg2000.h"
#include "io/raster/read_jpeg.h"
#include "io/support/silence_libraries.h"

#include <dcmtk/config/osconfig.h>
// DCMTK headers must come first because of their macros.
#include <dcmtk/dcmdata/dcpixel.h>
#include <dcmtk/dcmdata/dcpixseq.h>
#include <dcmtk/dcmdata/dcpxitem.h>
#include <dcmtk/dcmdata/dcrledrg.h>
#include <dcmtk/dcmdata/dctk.h>
#include <dcmtk/dcmjpeg/djdecode.h>
#include <dcmtk/dcmjpls/djdecode.h>
#include <algorithm>
#include <cmath>
#include <cstring>
#include <exception>
#include <mutex>

namespace angiopose::io {
namespace {

constexpr std::string_view rleSyntax = "1.2.840.10008.1.2.5";

/// Returns whether the stream declares the image that the header describes. Streams that do not are rejected, because
/// the decoders trust the stream; libjpeg converts color to gray.
bool matchesLayout(const StreamHeader& head, const PixelLayout& layout)
{
    return head.columns == layout.columns && head.rows == layout.rows &&
           (head.isBaseline || head.components == layout.samples) && head.bits >= 2 &&
           head.bits <= layout.bitsAllocated;
}

/// Decodes 8-bit lossy JPEG through libjpeg.
std::optional<DecodedPixels> decodeBaseline(std::string_view compressed, PixelLayout& layout)
{
    const auto raster =
        readJpeg(compressed, layout.photometric == "RGB" ? JpegColors::RgbUnlessMarked : JpegColors::FromMarkers);
    if (!raster) {
        return std::nullopt;
    }
    layout.samples = 1;
    layout.bitsAllocated = 8;
    layout.bitsStored = 8;
    layout.highBit = 7;
    layout.isSigned = false;
    const core::ImageF& image = raster->frames.front();
    std::vector<char> bytes(image.pixels.size());
    std::transform(image.pixels.begin(), image.pixels.end(), bytes.begin(),
                   [](float value) { return static_cast<char>(static_cast<unsigned char>(std::lround(value))); });
    return DecodedPixels{std::move(bytes), raster->isPartlyDamaged};
}

/// Returns whether a stream is complete, that is, contains its end marker, possibly followed by padding; otherwise,
/// DCMTK would fill missing parts with gray.
bool isWhole(std::string_view compressed)
{
    return !compressed.starts_with("\xff\xd8") || compressed.rfind("\xff\xd9") != std::string_view::npos;
}

void registerDecoders()
{
    static std::once_flag once;
    std::call_once(once, [] {
        DJDecoderRegistration::registerCodecs();
        DJLSDecoderRegistration::registerCodecs();
        DcmRLEDecoderRegistration::registerCodecs();
    });
}

/// Creates a data set with one compressed frame, as DCMTK's decoders require.
std::unique_ptr<DcmDataset> datasetOf(std::string_view compressed, E_TransferSyntax syntax, const PixelLayout& layout)
{
    auto data = std::make_unique<DcmDataset>();
    const auto put = [&](const DcmTagKey& tag, int value) {
        data->putAndInsertUint16(tag, static_cast<Uint16>(value));
    };
    put(DCM_SamplesPerPixel, layout.samples);
    put(DCM_Rows, layout.rows);
    put(DCM_Columns, layout.columns);
    put(DCM_BitsAllocated, layout.bitsAllocated);
    put(DCM_BitsStored, layout.bitsStored);
    put(DCM_HighBit, layout.highBit);
    put(DCM_PixelRepresentation, layout.isSigned ? 1 : 0);
    if (layout.samples > 1) {
        put(DCM_PlanarConfiguration, 0);
    }
    data->putAndInsertString(DCM_PhotometricInterpretation, layout.photometric.c_str());
    data->putAndInsertString(DCM_NumberOfFrames, "1");
    auto* sequence = new DcmPixelSequence(DCM_PixelSequenceTag);   // owned by the pixel data element below
    sequence->insert(new DcmPixelItem(DCM_PixelItemTag));   // basic offset table (empty)
    auto* frame = new DcmPixelItem(DCM_PixelItemTag);
    std::string padded(compressed);
    padded.resize(padded.size() + padded.size() % 2);
    frame->putUint8Array(reinterpret_cast<const Uint8*>(padded.data()), padded.size());
    sequence->insert(frame);
    auto* pixels = new DcmPixelData(DCM_PixelData);
    pixels->putOriginalRepresentation(syntax, nullptr, sequence);
    data->insert(pixels, OFTrue);
    return data;
}

/// Decodes a frame through DCMTK; updates `layout` to the color format of the result.
std::optional<DecodedPixels> decodeByDcmtk(std::string_view compressed, E_TransferSyntax syntax, PixelLayout& layout)
{
    registerDecoders();
    const auto data = datasetOf(compressed, syntax, layout);
    DcmElement* pixels = nullptr;
    if (data->chooseRepresentation(EXS_LittleEndianExplicit, nullptr).bad() ||
        data->findAndGetElement(DCM_PixelData, pixels).bad()) {
        return std::nullopt;
    }
    const std::size_t size =
        layout.pixelsPerFrame() * static_cast<std::size_t>(layout.samples * layout.bitsAllocated / 8);
    std::vector<char> bytes(size);
    Uint8* narrow = nullptr;
    Uint16* wide = nullptr;
    const bool isWide = layout.bitsAllocated == 16;
    const OFCondition got = isWide ? pixels->getUint16Array(wide) : pixels->getUint8Array(narrow);
    const void* values = isWide ? static_cast<const void*>(wide) : static_cast<const void*>(narrow);
    if (got.bad() || !values || pixels->getLength() < size) {
        return std::nullopt;
    }
    std::memcpy(bytes.data(), values, size);
    Uint16 planar = 0;
    data->findAndGetUint16(DCM_PlanarConfiguration, planar);
    layout.isPlanar = planar == 1;
    OFString photometric;
    data->findAndGetOFString(DCM_PhotometricInterpretation, photometric);
    layout.photometric = photometric.c_str();
    return DecodedPixels{std::move(bytes)};
}

}   // namespace

std::optional<DecodedPixels> decodeFrame(std::string_view compressed, const std::string& transferSyntax,
                                         PixelLayout& layout)
{
    silenceLibraries();
    const E_TransferSyntax syntax = DcmXfer(transferSyntax.c_str()).getXfer();
    if (syntax == EXS_Unknown || (layout.bitsAllocated != 8 && layout.bitsAllocated != 16)) {
        return std::nullopt;
    }
    try {
        if (transferSyntax == rleSyntax) {
            return decodeByDcmtk(compressed, syntax, layout);
        }
        const auto head = readStreamHeader(compressed);
        if (!head || !matchesLayout(*head, layout)) {
            return std::nullopt;
        }
        if (head->isBaseline) {
            return decodeBaseline(compressed, layout);
        }
        if (!compressed.starts_with("\xff\xd8")) {
            layout.isPlanar = false;
            auto bytes = decodeJpeg2000(compressed, layout);
            return bytes ? std::optional(DecodedPixels{std::move(*bytes)}) : std::nullopt;
        }
        return isWhole(compressed) ? decodeByDcmtk(compressed, syntax, layout) : std::nullopt;
    } catch (const std::exception&) {   // out of memory
        return std::nullopt;
    }
}

}   // namespace angiopose::io
