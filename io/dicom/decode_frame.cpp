#include "io/dicom/decode_frame.h"

#include "io/dicom/decode_rle.h"
#include "io/raster/read_jpeg.h"
#include "io/support/captured_stderr.h"
#include "io/support/quiet_libraries.h"

#include <gdcmDataElement.h>
#include <gdcmFragment.h>
#include <gdcmImage.h>
#include <gdcmSequenceOfFragments.h>
#include <algorithm>
#include <cmath>
#include <exception>

namespace angiopose::io {
namespace {

constexpr std::string_view rleSyntax = "1.2.840.10008.1.2.5";

/// The decoders trust what the stream declares: refuse one that is not the image of the header.
bool isTheImageExpected(const StreamHead& head, const PixelLayout& layout)
{
    return head.columns == layout.columns && head.rows == layout.rows && head.components == layout.samples &&
           head.bits >= 2 && head.bits <= layout.bitsAllocated;
}

/// 8-bit lossy JPEG through libjpeg: GDCM asserts on damaged ones. RGB without a colour transform is not told apart by
/// the stream, so it is left alone.
std::optional<std::vector<char>> decodeBaseline(std::string_view compressed, PixelLayout& layout)
{
    const auto raster = layout.photometric == "RGB" ? std::nullopt : readJpeg(compressed);
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
    return bytes;
}

/// libjpeg fills what is missing with grey; a whole stream ends with its end marker.
bool isWhole(std::string_view compressed)
{
    if (!compressed.starts_with("\xff\xd8")) {
        return true;
    }
    return compressed.substr(compressed.size() - std::min<std::size_t>(compressed.size(), 16)).find("\xff\xd9") !=
           std::string_view::npos;
}

gdcm::DataElement pixelElement(std::string_view compressed)
{
    const gdcm::SmartPointer<gdcm::SequenceOfFragments> fragments = gdcm::SequenceOfFragments::New();
    gdcm::Fragment fragment;
    fragment.SetByteValue(compressed.data(), static_cast<std::uint32_t>(compressed.size()));
    fragments->AddFragment(fragment);
    gdcm::DataElement element(gdcm::Tag(0x7fe0, 0x0010));
    element.SetVR(gdcm::VR::OB);
    element.SetValue(*fragments);
    return element;
}

gdcm::Image imageOf(const PixelLayout& layout, gdcm::TransferSyntax::TSType syntax)
{
    gdcm::Image image;
    image.SetNumberOfDimensions(2);
    image.SetDimension(0, static_cast<unsigned int>(layout.columns));
    image.SetDimension(1, static_cast<unsigned int>(layout.rows));
    gdcm::PixelFormat format(static_cast<std::uint16_t>(layout.samples),
                             static_cast<std::uint16_t>(layout.bitsAllocated),
                             static_cast<std::uint16_t>(layout.bitsStored), static_cast<std::uint16_t>(layout.highBit),
                             layout.isSigned ? 1 : 0);
    image.SetPixelFormat(format);
    image.SetPhotometricInterpretation(gdcm::PhotometricInterpretation::GetPIType(layout.photometric.c_str()));
    image.SetPlanarConfiguration(layout.isPlanar ? 1 : 0);
    image.SetTransferSyntax(gdcm::TransferSyntax(syntax));
    return image;
}

/// GDCM's own JPEG libraries print what they think of a stream, and fill what is damaged with grey.
bool decodeQuietly(const gdcm::Image& image, std::vector<char>& bytes)
{
    CapturedStderr said;
    return image.GetBuffer(bytes.data()) && said.text().find("Corrupt") == std::string::npos;
}

}   // namespace

std::optional<std::vector<char>> decodeFrame(std::string_view compressed, const std::string& transferSyntax,
                                             PixelLayout& layout)
{
    quietLibraries();
    if (transferSyntax == rleSyntax) {
        layout.isPlanar = false;
        return decodeRle(compressed, layout);
    }
    const auto head = streamHeadOf(compressed);
    const auto syntax = gdcm::TransferSyntax::GetTSType(transferSyntax.c_str());
    if (syntax == gdcm::TransferSyntax::TS_END || !head || !isTheImageExpected(*head, layout) || !isWhole(compressed)) {
        return std::nullopt;
    }
    if (head->isBaseline) {
        return decodeBaseline(compressed, layout);
    }
    if (layout.samples != 1 && compressed.starts_with("\xff\xd8")) {   // colour in lossless JPEG: GDCM asserts
        return std::nullopt;
    }
    try {
        gdcm::Image image = imageOf(layout, syntax);
        image.SetDataElement(pixelElement(compressed));
        std::vector<char> bytes(image.GetBufferLength());
        if (!decodeQuietly(image, bytes)) {
            return std::nullopt;
        }
        layout.isPlanar = image.GetPlanarConfiguration() == 1;
        return bytes;
    } catch (const std::exception&) {   // damaged streams
        return std::nullopt;
    }
}

}   // namespace angiopose::io