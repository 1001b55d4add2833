#include "io/angiogram_file.h"

#include "core/tracing/angiogram/frame/drawn_mask.h"
#include "core/tracing/angiogram/run/suggest_frame.h"
#include "io/dicom/dicom_file.h"
#include "io/dicom/read_dicom.h"
#include "io/dicom/write_dicom.h"
#include "io/messages/messages.h"
#include "io/peak_frame.h"
#include "io/raster/read_raster.h"
#include "io/support/atomic_file.h"
#include "io/support/file_error.h"
#include "io/support/inflate.h"
#include "io/support/input_bytes.h"

namespace angiopose::io {
namespace {

constexpr std::size_t maxUnpackedAngiogramBytes = std::size_t{128} << 20;

core::Result<core::Angiogram> rasterAngiogram(std::string_view content, const std::string& path)
{
    auto raster = readRaster(content, path);
    if (!raster) {
        return raster.error();
    }
    core::Angiogram angiogram;
    if (raster.value().wasColor) {
        angiogram.warnings.push_back(messages::colorToGray());
    }
    if (raster.value().hadAlpha) {
        angiogram.warnings.push_back(messages::transparencyIgnored());
    }
    if (raster.value().orientation != 1) {
        angiogram.warnings.push_back(messages::pictureTurned(raster.value().orientation));
    }
    if (raster.value().isPartlyDamaged) {
        angiogram.warnings.push_back(messages::imageFlawed());
    }
    angiogram.warnings.push_back(messages::plainImage());
    angiogram.frames = std::move(raster).value().frames;
    return angiogram;
}

core::Result<core::Angiogram> angiogramFrom(std::string_view content, const std::string& path)
{
    if (looksLikeDicom(content)) {   // check DICOM first: the DICOM preamble may contain a TIFF header
        return readDicomAngiogram(content, path);
    }
    if (looksLikeRaster(content)) {
        return rasterAngiogram(content, path);
    }
    const auto* found = describeContent(content);
    if (found == nullptr) {
        return fileError(path, messages::imageUnknown());
    }
    return fileError(path, messages::imageIsOther((*found)()));
}

}   // namespace

core::Result<core::Angiogram> readAngiogram(const std::string& path)
{
    return readAngiogram(path, PeakFrameSearch::Enabled);
}

core::Result<core::Angiogram> readAngiogram(const std::string& path, PeakFrameSearch peak)
{
    const auto input = openInput(path);
    if (!input) {
        return input.error();
    }
    std::string_view content = input.value().view();
    std::string unpacked;
    if (content.starts_with("\x1f\x8b")) {   // gzip: PACS often export compressed DICOM files
        auto inflatedContent = isGzippedDicom(content)
                                   ? decompress(content, CompressionFormat::Gzip, maxUnpackedAngiogramBytes)
                                   : std::nullopt;
        if (!inflatedContent) {
            return fileError(path, messages::imageGzipWithoutDicom());
        }
        unpacked = std::move(*inflatedContent);
        content = unpacked;
    }
    auto angiogram = angiogramFrom(content, path);
    if (!angiogram) {
        return angiogram;
    }
    core::Angiogram result = std::move(angiogram).value();
    if (result.frames.size() == 1 && core::vesselMaskFromDrawing(result.frames.front())) {
        result.warnings.push_back(messages::pictureIsMask());
    }
    if (result.frames.size() > 1 && peak == PeakFrameSearch::Enabled) {
        result.suggestedFrame = core::suggestFrame(result.frames, result.polarity, result.shutter);
    }
    return result;
}

bool looksLikeImageFile(const std::string& path)
{
    const auto input = openInputStart(path);
    return (input && looksLikeRaster(input.value().view())) || isDicomFile(path);
}

core::Status writeAngiogram(const core::Angiogram& angiogram, const std::string& path)
{
    const auto content = encodeDicomAngiogram(angiogram);
    return content ? writeAtomically(path, content.value()) : fileError(path, content.error());
}

}   // namespace angiopose::io
