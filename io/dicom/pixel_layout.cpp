#include "io/dicom/pixel_layout.h"

#include "io/messages/messages.h"
#include "io/support/file_error.h"

#include <algorithm>
#include <array>
#include <optional>

namespace angiopose::io {
namespace {

core::Message missingImage(const DicomFile& file)
{
    const std::string modality(file.dataset.text(0x00080060));
    const core::Message what =
        modality.empty() ? messages::dicomThisFile() : messages::dicomThisFileOf(modality.substr(0, 16));
    if (file.damage) {
        return messages::dicomDamagedBeforePixels(what, *file.damage);
    }
    return messages::dicomHoldsNoImage(what);
}

std::optional<core::Message> findUnsupported(const PixelLayout& layout)
{
    constexpr std::array<std::string_view, 7> colors = {"RGB",     "YBR_FULL",        "YBR_FULL_422",   "YBR_RCT",
                                                        "YBR_ICT", "YBR_PARTIAL_422", "YBR_PARTIAL_420"};
    const bool isGray =
        layout.samples == 1 && (layout.photometric == "MONOCHROME1" || layout.photometric == "MONOCHROME2");
    const bool isColor =
        layout.samples == 3 && std::find(colors.begin(), colors.end(), layout.photometric) != colors.end();
    if (layout.photometric == "PALETTE COLOR") {
        return messages::dicomPaletteColors();
    }
    if (!isGray && !isColor) {
        return messages::dicomNotGray(layout.photometric.substr(0, 16), layout.samples);
    }
    const int bits = layout.bitsAllocated;
    if ((bits != 1 && bits != 8 && bits != 16 && bits != 32) || (bits == 1 && layout.samples != 1)) {
        return messages::dicomPixelBits(bits);
    }
    if (layout.bitsStored < 1 || layout.bitsStored > bits || layout.highBit >= bits ||
        layout.highBit + 1 < layout.bitsStored) {
        return messages::dicomBitsContradict();
    }
    return {};
}

}   // namespace

core::Result<PixelLayout> pixelLayoutOf(const DicomFile& file, const std::string& path, std::size_t maxPixels)
{
    const DicomDataset& data = file.dataset;
    PixelLayout layout;
    layout.isFloat = file.pixels.contains(floatPixelsTag);
    if (!file.pixels.contains(pixelDataTag) && !layout.isFloat) {
        return fileError(path, missingImage(file));
    }
    layout.rows = data.integer(0x00280010).value_or(0);
    layout.columns = data.integer(0x00280011).value_or(0);
    layout.frames = data.integer(0x00280008).value_or(1);
    layout.samples = data.integer(0x00280002).value_or(1);
    layout.bitsAllocated = data.integer(0x00280100).value_or(layout.isFloat ? 32 : 16);
    layout.bitsStored = data.integer(0x00280101).value_or(layout.bitsAllocated);
    layout.highBit = data.integer(0x00280102).value_or(layout.bitsStored - 1);
    layout.isSigned = data.integer(0x00280103).value_or(0) == 1;
    layout.isPlanar = data.integer(0x00280006).value_or(0) == 1;
    if (layout.isFloat) {
        layout.samples = 1;
        layout.bitsAllocated = 32;
    }
    layout.photometric = data.text(0x00280004);
    const bool isOnlyColored = layout.photometric == "PALETTE COLOR" && data.text(0x00080060) == "SEG";
    if (layout.photometric.empty() || isOnlyColored) {   // the values of a label map are its labels
        layout.photometric = layout.samples == 3 ? "RGB" : "MONOCHROME2";
    }
    if (layout.rows <= 0 || layout.columns <= 0 || layout.frames <= 0) {
        return fileError(path, messages::dicomNoImageSize());
    }
    if (layout.pixelsPerFrame() > maxFramePixels ||
        layout.pixelsPerFrame() > maxPixels / static_cast<std::size_t>(layout.frames)) {
        return fileError(path, messages::dicomTooManyFrames(layout.frames, layout.columns, layout.rows));
    }
    if (const auto unsupported = layout.isFloat ? std::nullopt : findUnsupported(layout)) {
        return fileError(path, *unsupported);
    }
    return layout;
}

}   // namespace angiopose::io
