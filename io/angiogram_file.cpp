#include "io/angiogram_file.h"

#include "core/geometry/geometry_checks.h"
#include "core/tracing/angiogram/frame/drawn_mask.h"
#include "core/tracing/angiogram/run/suggest_frame.h"
#include "io/dicom/c_arm_tags.h"
#include "io/dicom/dicom_file.h"
#include "io/dicom/dicom_text.h"
#include "io/dicom/frame_source.h"
#include "io/dicom/frame_time.h"
#include "io/dicom/gantry_tags.h"
#include "io/dicom/heart_beats.h"
#include "io/dicom/projection.h"
#include "io/dicom/shutter_tags.h"
#include "io/dicom/write_dicom.h"
#include "io/messages/messages.h"
#include "io/peak_frame.h"
#include "io/raster/read_raster.h"
#include "io/support/atomic_file.h"
#include "io/support/file_error.h"
#include "io/support/inflate.h"
#include "io/support/input_bytes.h"

#include <algorithm>
#include <string_view>

namespace angiopose::io {
namespace {

using core::Angiogram;
using core::ImageF;

constexpr std::size_t maxUnpackedAngiogramBytes = std::size_t{128} << 20;

void transformValues(std::vector<ImageF>& frames, float slope, float intercept)
{
    for (ImageF& frame : frames) {
        for (float& value : frame.pixels) {
            value = slope * value + intercept;
        }
    }
}

void applyRescale(const DicomDataset& data, std::vector<ImageF>& frames)
{
    const double slope = data.number(0x00281053).value_or(1.0);
    const double intercept = data.number(0x00281052).value_or(0.0);
    if (slope != 0.0 && (slope != 1.0 || intercept != 0.0)) {
        transformValues(frames, static_cast<float>(slope), static_cast<float>(intercept));
    }
}

/// Inverts images stored for inverted display, so that high values are bright in all later processing.
bool invertIfNeeded(const DicomDataset& data, const PixelLayout& layout, std::vector<ImageF>& frames)
{
    const bool isInverted = layout.photometric == "MONOCHROME1" || data.text(0x20500020) == "INVERSE";
    if (!isInverted) {
        return false;
    }
    float low = frames.front().pixels.front();
    float high = low;
    for (const ImageF& frame : frames) {
        const auto [least, most] = std::minmax_element(frame.pixels.begin(), frame.pixels.end());
        low = std::min(low, *least);
        high = std::max(high, *most);
    }
    transformValues(frames, -1.0F, low + high);
    return true;
}

/// Formats frame numbers as DICOM counts them, starting at 1.
std::vector<std::string> namesOf(const std::vector<int>& frames)
{
    std::vector<std::string> names;
    std::ranges::transform(frames, std::back_inserter(names), [](int frame) { return std::to_string(frame + 1); });
    return names;
}

/// Fills lost frames with the background level, as in frames without contrast agent, so that nothing is detected in
/// them and they do not affect other frames.
void blank(const std::vector<int>& lostFrames, Angiogram& angiogram)
{
    const bool isDark = angiogram.polarity == core::Polarity::VesselsDark;
    float level = angiogram.frames.front().pixels.front();
    for (const ImageF& frame : angiogram.frames) {
        const auto [least, most] = std::minmax_element(frame.pixels.begin(), frame.pixels.end());
        level = isDark ? std::max(level, *most) : std::min(level, *least);
    }
    for (const int lost : lostFrames) {
        std::ranges::fill(angiogram.frames[static_cast<std::size_t>(lost)].pixels, level);
    }
    angiogram.warnings.push_back(messages::dicomFramesLost(namesOf(lostFrames), angiogram.frameCount()));
}

/// Returns the polarity: contrast agent absorbs X-rays, so vessels are dark if values rise with intensity, (0028,1041)
/// = +1.
core::Polarity polarityOf(const DicomDataset& data, bool wasInverted)
{
    const int sign = data.integer(0x00281041).value_or(wasInverted ? -1 : 1);
    const bool storedDark = sign >= 0;
    return storedDark != wasInverted ? core::Polarity::VesselsDark : core::Polarity::VesselsBright;
}

void describe(const DicomFile& file, const PixelLayout& layout, Angiogram& angiogram)
{
    angiogram.identity = identityOf(file.dataset);
    if (layout.samples == 3) {
        angiogram.warnings.push_back(messages::colorToGray());
    }
    if (angiogram.frameCount() != layout.frames) {
        angiogram.warnings.push_back(messages::dicomFramesOther(layout.frames, angiogram.frameCount()));
    } else if (file.damage) {
        angiogram.warnings.push_back(messages::dicomEndDamaged(*file.damage));
    }
    const std::string& modality = angiogram.identity.modality;
    angiogram.shutter = shutterMask(file.dataset, layout.columns, layout.rows, angiogram.warnings);
    if (isProjection(file.dataset)) {
        angiogram.cArm = cArmOf(file.dataset, angiogram.warnings);
        angiogram.gantry = gantryHeaderOf(file.dataset, angiogram.frameCount(), angiogram.warnings);
        const Eigen::Vector2i size(angiogram.width(), angiogram.height());
        for (const core::Message& contradiction : core::findContradictions(angiogram.cArm, angiogram.gantry, size)) {
            angiogram.warnings.push_back(contradiction);
        }
    } else {
        const bool isReconstructed = modality == "XA" || modality == "RF";
        angiogram.warnings.push_back(
            messages::dicomNotXray(isReconstructed    ? core::Message(messages::aReconstruction(modality))
                                   : modality.empty() ? core::Message(messages::anImageWithoutModality())
                                                      : core::Message(messages::aModality(modality))));
    }
}

/// Reads the layout and rejects images only a few pixels wide or high, in which nothing can be traced.
core::Result<PixelLayout> runLayout(const DicomFile& file, const std::string& path)
{
    auto layout = pixelLayoutOf(file, path);
    if (layout && (layout.value().rows < 8 || layout.value().columns < 8)) {
        return fileError(path, messages::dicomThumbnail(layout.value().columns, layout.value().rows));
    }
    return layout;
}

/// Reads an angiogram from the bytes of a DICOM file. Other modalities load with a warning and without geometry.
core::Result<core::Angiogram> readDicomAngiogram(std::string_view content, const std::string& path)
{
    const auto parsed = parseDicom(content, path);
    if (!parsed) {
        return parsed.error();
    }
    const DicomFile& file = parsed.value();
    const auto layout = runLayout(file, path);
    if (!layout) {
        return layout.error();
    }
    auto decoded = readFrames(file, layout.value(), path);
    if (!decoded) {
        return decoded.error();
    }
    DecodedRun run = std::move(decoded).value();
    Angiogram angiogram;
    angiogram.frames = std::move(run.frames);
    applyRescale(file.dataset, angiogram.frames);
    angiogram.polarity = polarityOf(file.dataset, invertIfNeeded(file.dataset, layout.value(), angiogram.frames));
    if (const FrameTime time = frameTimeOf(file.dataset); angiogram.frames.size() > 1) {
        angiogram.frameTimeMs = time.ms;
        if (time.contradiction) {
            angiogram.warnings.push_back(*time.contradiction);
        }
    }
    angiogram.rWaveFrames = rWaveFramesOf(file.dataset, angiogram.frameCount(), angiogram.frameTimeMs);
    describe(file, layout.value(), angiogram);
    if (!run.lostFrames.empty()) {
        blank(run.lostFrames, angiogram);
    }
    if (!run.damagedFrames.empty()) {
        angiogram.warnings.push_back(messages::dicomFramesFlawed(namesOf(run.damagedFrames), angiogram.frameCount()));
    }
    return angiogram;
}

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
    if (looksLikeDicom(content)) {   // check for DICOM first: the DICOM preamble may contain a TIFF header
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
