#include "io/movie/yuv_image.h"

#include "io/messages/messages.h"

#include <wels/codec_api.h>
#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace angiopose::io {
namespace {

// Luma coefficients and quantization ranges (ITU-R BT.709-6, 3.2 and 3.4).
constexpr double redShare = 0.2126, greenShare = 0.7152, blueShare = 0.0722;
constexpr double lumaRange = 219.0, chromaRange = 224.0;

using Rgb = std::array<double, 3>;   // red, green, blue, 0…1

Rgb pixelAt(const core::ColorImage& picture, int x, int y)
{
    const auto column = static_cast<std::size_t>(std::clamp(x, 0, picture.width - 1));
    const auto row = static_cast<std::size_t>(std::clamp(y, 0, picture.height - 1));
    const std::uint8_t* pixel = &picture.rgb[3 * (row * static_cast<std::size_t>(picture.width) + column)];
    return {pixel[0] / 255.0, pixel[1] / 255.0, pixel[2] / 255.0};
}

double brightness(const Rgb& color)
{
    return redShare * color[0] + greenShare * color[1] + blueShare * color[2];
}

std::uint8_t byteOf(double value)
{
    return static_cast<std::uint8_t>(std::clamp(std::lround(value), 0L, 255L));
}

/// Returns the weighted mean over two rows and three columns, centered on the left column of a chroma pair.
Rgb aroundPair(const core::ColorImage& picture, int x, int y)
{
    Rgb sum{};
    for (int row = 0; row < 2; ++row) {
        for (int column = -1; column <= 1; ++column) {
            const double weight = column == 0 ? 0.25 : 0.125;
            const Rgb color = pixelAt(picture, x + column, y + row);
            for (std::size_t i = 0; i < sum.size(); ++i) {
                sum[i] += weight * color[i];
            }
        }
    }
    return sum;
}

constexpr int blockPx = 16;
constexpr int maxBlocks = 36864;   // maximum frame size in macroblocks (MAX_MBS_PER_FRAME of openh264)
constexpr int maxSideBlocks = 543;   // maximum side in macroblocks (H.264 level 5.2): √(8 · 36,864)
constexpr int quality = 16;   // quantization parameter, 0 (best) to 51; this value causes no visible loss
constexpr unsigned keyFrameInterval = 30;   // key-frame interval, frames
constexpr float nominalRate = 30.0F;   // used only by the encoder; the file stores the actual times
constexpr std::size_t startCodeBytes = 4;

int blocksOf(int px)
{
    return (px + blockPx - 1) / blockPx;
}

struct EncoderCloser {
    void operator()(ISVCEncoder* encoder) const
    {
        encoder->Uninitialize();
        WelsDestroySVCEncoder(encoder);
    }
};

void tellColors(SSpatialLayerConfig& layer)
{
    layer.bVideoSignalTypePresent = true;
    layer.uiVideoFormat = VF_UNDEF;
    layer.bFullRange = false;
    layer.bColorDescriptionPresent = true;
    layer.uiColorPrimaries = CP_BT709;
    layer.uiTransferCharacteristics = TRC_BT709;
    layer.uiColorMatrix = CM_BT709;
}

SEncParamExt parametersFor(ISVCEncoder& encoder, const MovieSize& size)
{
    SEncParamExt parameters{};
    encoder.GetDefaultParams(&parameters);
    parameters.iUsageType = CAMERA_VIDEO_REAL_TIME;
    parameters.iPicWidth = size.width;
    parameters.iPicHeight = size.height;
    parameters.fMaxFrameRate = nominalRate;
    parameters.iRCMode = RC_OFF_MODE;
    parameters.iTargetBitrate = 0;
    parameters.iMaxBitrate = UNSPECIFIED_BIT_RATE;
    parameters.iMinQp = parameters.iMaxQp = quality;
    parameters.bEnableFrameSkip = false;
    parameters.iComplexityMode = HIGH_COMPLEXITY;
    parameters.uiIntraPeriod = keyFrameInterval;
    parameters.eSpsPpsIdStrategy = CONSTANT_ID;
    parameters.iEntropyCodingModeFlag = 1;
    parameters.iMultipleThreadIdc = 1;
    parameters.bEnableDenoise = false;
    parameters.bEnableBackgroundDetection = false;
    parameters.bEnableAdaptiveQuant = false;
    SSpatialLayerConfig& layer = parameters.sSpatialLayers[0];
    layer.iVideoWidth = size.width;
    layer.iVideoHeight = size.height;
    layer.fFrameRate = nominalRate;
    layer.iSpatialBitrate = 0;
    layer.iMaxSpatialBitrate = UNSPECIFIED_BIT_RATE;
    layer.uiProfileIdc = PRO_HIGH;
    layer.iDLayerQp = quality;
    layer.sSliceArgument.uiSliceMode = SM_SINGLE_SLICE;
    tellColors(layer);
    return parameters;
}

EncodedFrame takenFrom(const SFrameBSInfo& info)
{
    EncodedFrame picture;
    picture.isKeyFrame = info.eFrameType == videoFrameTypeIDR;
    for (int i = 0; i < info.iLayerNum; ++i) {
        const SLayerBSInfo& layer = info.sLayerInfo[i];
        const auto* at = reinterpret_cast<const char*>(layer.pBsBuf);
        for (int k = 0; k < layer.iNalCount; ++k) {
            const auto length = static_cast<std::size_t>(layer.pNalLengthInByte[k]);
            picture.nalUnits.emplace_back(at + startCodeBytes, length - startCodeBytes);
            at += length;
        }
    }
    return picture;
}

}   // namespace

YuvImage toYuvImage(const core::ColorImage& picture)
{
    YuvImage planar{picture.width + picture.width % 2, picture.height + picture.height % 2, {}, {}, {}};
    const auto pixels = static_cast<std::size_t>(planar.width) * static_cast<std::size_t>(planar.height);
    planar.luma.reserve(pixels);
    for (int y = 0; y < planar.height; ++y) {
        for (int x = 0; x < planar.width; ++x) {
            planar.luma.push_back(byteOf(16.0 + lumaRange * brightness(pixelAt(picture, x, y))));
        }
    }
    planar.blue.reserve(pixels / 4);
    planar.red.reserve(pixels / 4);
    for (int y = 0; y < planar.height; y += 2) {
        for (int x = 0; x < planar.width; x += 2) {
            const Rgb color = aroundPair(picture, x, y);
            const double light = brightness(color);
            planar.blue.push_back(byteOf(128.0 + chromaRange * 0.5 * (color[2] - light) / (1.0 - blueShare)));
            planar.red.push_back(byteOf(128.0 + chromaRange * 0.5 * (color[0] - light) / (1.0 - redShare)));
        }
    }
    return planar;
}

struct H264Encoder::Impl {
    std::unique_ptr<ISVCEncoder, EncoderCloser> encoder;
};

H264Encoder::H264Encoder(std::unique_ptr<Impl> parts) : impl_(std::move(parts)) {}
H264Encoder::H264Encoder(H264Encoder&&) noexcept = default;
H264Encoder& H264Encoder::operator=(H264Encoder&&) noexcept = default;
H264Encoder::~H264Encoder() = default;

bool canEncode(const MovieSize& size)
{
    const int columns = blocksOf(size.width), rows = blocksOf(size.height);
    return columns <= maxSideBlocks && rows <= maxSideBlocks && columns * rows <= maxBlocks;
}

core::Result<H264Encoder> H264Encoder::create(const MovieSize& size)
{
    ISVCEncoder* made = nullptr;
    if (WelsCreateSVCEncoder(&made) != 0 || made == nullptr) {
        return core::Error(messages::movieEncoderFailed());
    }
    auto parts = std::make_unique<Impl>();
    parts->encoder.reset(made);
    int quiet = WELS_LOG_QUIET;
    made->SetOption(ENCODER_OPTION_TRACE_LEVEL, &quiet);
    const SEncParamExt parameters = parametersFor(*made, size);
    if (made->InitializeExt(&parameters) != cmResultSuccess) {
        return core::Error(messages::movieEncoderFailed());
    }
    return H264Encoder(std::move(parts));
}

core::Result<EncodedFrame> H264Encoder::encode(const YuvImage& picture, double timeMs)
{
    const auto plane = [](const std::vector<std::uint8_t>& pixels) {
        return const_cast<std::uint8_t*>(pixels.data());   // the encoder does not modify the pixels
    };
    SSourcePicture source{};
    source.iColorFormat = videoFormatI420;
    source.iPicWidth = picture.width;
    source.iPicHeight = picture.height;
    source.iStride[0] = picture.width;
    source.iStride[1] = source.iStride[2] = picture.width / 2;
    source.pData[0] = plane(picture.luma);
    source.pData[1] = plane(picture.blue);
    source.pData[2] = plane(picture.red);
    source.uiTimeStamp = std::llround(timeMs);
    SFrameBSInfo info{};
    if (impl_->encoder->EncodeFrame(&source, &info) != cmResultSuccess || info.eFrameType == videoFrameTypeSkip ||
        info.eFrameType == videoFrameTypeInvalid) {
        return core::Error(messages::movieEncoderFailed());
    }
    return takenFrom(info);
}

}   // namespace angiopose::io
