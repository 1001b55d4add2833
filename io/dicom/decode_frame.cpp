#include "io/dicom/decode_frame.h"

#include "io/dicom/decode_rle.h"
#include "io/support/quiet_libraries.h"

#include <gdcmDataElement.h>
#include <gdcmFragment.h>
#include <gdcmImage.h>
#include <gdcmSequenceOfFragments.h>
#include <exception>

namespace io {
namespace {

constexpr std::string_view rleSyntax = "1.2.840.10008.1.2.5";

/// The decoders trust what the stream declares: refuse one that is not the image of the header.
bool isTheImageExpected(std::string_view compressed, const PixelLayout& layout)
{
    const auto head = streamHeadOf(compressed);
    return head && head->columns == layout.columns && head->rows == layout.rows && head->components == layout.samples &&
           head->bits >= 2 && head->bits <= layout.bitsAllocated;
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
    const gdcm::SmartPointer<gdcm::SequenceOfFragments> fragments = new gdcm::SequenceOfFragments;
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

}   // namespace

std::optional<std::vector<char>> decodeFrame(std::string_view compressed, const std::string& transferSyntax,
                                             PixelLayout& layout)
{
    quietLibraries();
    if (transferSyntax == rleSyntax) {
        layout.isPlanar = false;
        return decodeRle(compressed, layout);
    }
    const auto syntax = gdcm::TransferSyntax::GetTSType(transferSyntax.c_str());
    if (syntax == gdcm::TransferSyntax::TS_END || !isTheImageExpected(compressed, layout) || !isWhole(compressed)) {
        return std::nullopt;
    }
    try {
        gdcm::Image image = imageOf(layout, syntax);
        image.SetDataElement(pixelElement(compressed));
        std::vector<char> bytes(image.GetBufferLength());
        if (!image.GetBuffer(bytes.data())) {
            return std::nullopt;
        }
        layout.isPlanar = image.GetPlanarConfiguration() == 1;
        return bytes;
    } catch (const std::exception&) {   // damaged streams
        return std::nullopt;
    }
}

}   // namespace io
