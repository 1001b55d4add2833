#include "core/simulation/form_dsa_frames.h"

#include "core/imaging/image2d.h"
#include "core/imaging/image_filters.h"
#include "core/imaging/wide_gaussian_blur.h"
#include "core/simulation/splat_disc.h"
#include "core/support/random.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

namespace angiopose::core {
namespace {

/// Returns a smooth random field with grain size `sigmaPx`.
ImageF randomField(int width, int height, double sigmaPx, CounterRandom& random)
{
    ImageF field(width, height);
    for (float& value : field.pixels) {
        value = static_cast<float>(random.normal());
    }
    return wideGaussianBlur(field, sigmaPx);
}

void addScaled(ImageF& image, const ImageF& field, double standardDeviation)
{
    double squares = 0.0;
    for (const float value : field.pixels) {
        squares += static_cast<double>(value) * value;
    }
    const double rms = std::sqrt(squares / static_cast<double>(field.pixels.size()));
    const auto scale = static_cast<float>(rms > 0.0 ? standardDeviation / rms : 0.0);
    for (std::size_t i = 0; i < image.pixels.size(); ++i) {
        image.pixels[i] += scale * field.pixels[i];
    }
}

/// A long circular arc of low curvature across the image.
struct Arc {
    Eigen::Vector2d centerPx;
    double radiusPx;
    double fromRad;
    double toRad;

    Eigen::Vector2d at(double t) const
    {
        const double angle = fromRad + t * (toRad - fromRad);
        return centerPx + radiusPx * Eigen::Vector2d(std::cos(angle), std::sin(angle));
    }
    double lengthPx() const { return radiusPx * std::abs(toRad - fromRad); }
};

Arc drawArc(const ImageF& image, CounterRandom& random)
{
    const double size = std::max(image.width, image.height);
    const double angle = random.uniform(0.0, 2.0 * std::numbers::pi);
    const double radiusPx = size * random.uniform(0.5, 1.2);
    const Eigen::Vector2d crossing(random.uniform(0.1, 0.9) * image.width, random.uniform(0.1, 0.9) * image.height);
    const Eigen::Vector2d center = crossing - radiusPx * Eigen::Vector2d(std::cos(angle), std::sin(angle));
    const double halfSpan = 1.2 * size / radiusPx;
    return {center, radiusPx, angle - halfSpan, angle + halfSpan};
}

/// Adds discs along the arc; together they form a tube with attenuation `peak` at its center.
void addTubeAlong(ImageF& image, const Arc& arc, double radiusPx, double peak)
{
    const double stepPx = std::max(0.5, 0.15 * radiusPx);
    const int steps = static_cast<int>(arc.lengthPx() / stepPx);
    const double value = peak * stepPx / (2.0 * radiusPx);
    for (int k = 0; k <= steps; ++k) {
        splatDisc(image, arc.at(static_cast<double>(k) / steps), radiusPx, value);
    }
}

/// Adds bones as hollow tubes, whose cortex is visible as two bright edges.
void addBones(ImageF& image, double size, CounterRandom& random)
{
    const int bones = 2 + random.index(4);
    for (int i = 0; i < bones; ++i) {
        const Arc arc = drawArc(image, random);
        const double radiusPx = size * random.uniform(0.015, 0.04);
        const double peak = random.uniform(0.15, 0.5);
        const double wall = random.uniform(0.12, 0.25);
        addTubeAlong(image, arc, radiusPx, peak);
        addTubeAlong(image, arc, (1.0 - wall) * radiusPx, -0.75 * (1.0 - wall) * peak);
    }
}

/// Returns the background around the vessels, as −ln of its transmission relative to the average patient: soft tissue,
/// bones with bright cortex, spongy texture, and sometimes a monitoring lead.
ImageF bodyAttenuation(int width, int height, CounterRandom& random)
{
    const double size = std::max(width, height);
    ImageF body(width, height);
    addScaled(body, randomField(width, height, 0.14 * size, random), 0.22);
    addScaled(body, randomField(width, height, 0.03 * size, random), 0.06);
    addScaled(body, randomField(width, height, 2.2, random), 0.02);
    addBones(body, size, random);
    if (random.uniform() < 0.3) {
        addTubeAlong(body, drawArc(body, random), 0.0022 * size, 0.25);
    }
    return body;
}

constexpr double attenuationPerMm = 0.08;   ///< attenuation of undiluted contrast agent
constexpr double scatterShare = 0.2;
constexpr double scatterSigmaShare = 40.0 / 512.0;   ///< σ of the scatter blur as a fraction of the image width
constexpr double focalSpotSigmaPx = 0.5;   ///< focal-spot blur; combined with detectorSigmaPx, σ is 0.7 px
constexpr double detectorSigmaPx = 0.5;   ///< detector blur, which also affects the quantum noise
constexpr int maskAverage = 4;   ///< number of frames averaged for the mask
constexpr double midGray = 2048.0;
constexpr double grayPerAttenuation = 2200.0;
constexpr double maxGray = 4095.0;
constexpr int bodyMarginPx = 8;   ///< margin of the simulated body around the field of view, for patient motion

/// Independent random streams of a run.
enum FrameStream : std::uint64_t { BodyStream, MotionStream, ShutterStream, MaskStream, FirstFrameStream };

/// Returns the part of the body inside the field of view after a shift.
ImageF shiftedBody(const ImageF& body, const Eigen::Vector2d& shiftPx)
{
    ImageF result(body.width - 2 * bodyMarginPx, body.height - 2 * bodyMarginPx);
    for (int y = 0; y < result.height; ++y) {
        for (int x = 0; x < result.width; ++x) {
            result.at(x, y) = sampleBilinear(body, x + bodyMarginPx + shiftPx.x(), y + bodyMarginPx + shiftPx.y());
        }
    }
    return result;
}

/// Returns the expected photon counts behind an attenuation image: primary beam with focal-spot blur, plus scatter.
ImageF expectedCounts(const ImageF& attenuation, double photonCount)
{
    ImageF primary(attenuation.width, attenuation.height);
    std::transform(attenuation.pixels.begin(), attenuation.pixels.end(), primary.pixels.begin(),
                   [photonCount](float a) { return static_cast<float>(photonCount) * std::exp(-a); });
    const ImageF scattered = wideGaussianBlur(primary, scatterSigmaShare * attenuation.width);
    ImageF counts = gaussianBlur(primary, focalSpotSigmaPx);
    for (std::size_t i = 0; i < counts.pixels.size(); ++i) {
        counts.pixels[i] =
            static_cast<float>((1.0 - scatterShare) * counts.pixels[i] + scatterShare * scattered.pixels[i]);
    }
    return counts;
}

/// Returns ln of the detected photon counts, averaged over `frames` exposures.
ImageF logDetectedCounts(const ImageF& expected, int frames, CounterRandom random)
{
    ImageF counts(expected.width, expected.height);
    for (std::size_t i = 0; i < counts.pixels.size(); ++i) {
        const double total = static_cast<double>(random.poisson(frames * static_cast<double>(expected.pixels[i])));
        counts.pixels[i] = static_cast<float>(total / frames);
    }
    counts = gaussianBlur(counts, detectorSigmaPx);
    for (float& value : counts.pixels) {
        value = std::log(std::max(value, 0.5F));
    }
    return counts;
}

/// Draws the exposed field: the whole image, or an octagonal or round part of it.
Mask2d drawShutter(int width, int height, double probability, CounterRandom random)
{
    Mask2d open(width, height, 1);
    if (random.uniform() >= probability) {
        return open;
    }
    const double half = 0.5 * std::min(width, height);
    const double side = half * random.uniform(0.95, 0.99);
    const double corner = random.uniform() < 0.5 ? side * random.uniform(1.7, 1.9) : 10.0 * half;
    const double round = corner > 2.0 * half ? half * random.uniform(1.02, 1.15) : 10.0 * half;
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            const double dx = std::abs(x - 0.5 * (width - 1));
            const double dy = std::abs(y - 0.5 * (height - 1));
            const bool inside = dx <= side && dy <= side && dx + dy <= corner && std::hypot(dx, dy) <= round;
            open.at(x, y) = inside ? 1 : 0;
        }
    }
    return open;
}

/// Returns the patient's shift since the mask frames, at fraction `share` of the run: a growing drift with slight
/// breathing superimposed.
Eigen::Vector2d motionAt(double share, double largestPx, CounterRandom random)
{
    const double direction = random.uniform(0.0, 2.0 * std::numbers::pi);
    const double sizePx = largestPx * random.uniform(0.3, 1.0);
    const double breathing = 0.25 * std::sin(2.0 * std::numbers::pi * (share + random.uniform()));
    return sizePx * (0.4 + 0.35 * share + breathing) * Eigen::Vector2d(std::cos(direction), std::sin(direction));
}

ImageF withContrast(ImageF attenuation, const ImageF& thicknessMm)
{
    for (std::size_t i = 0; i < attenuation.pixels.size(); ++i) {
        attenuation.pixels[i] += static_cast<float>(attenuationPerMm) * thicknessMm.pixels[i];
    }
    return attenuation;
}

/// Returns the noise-free change of the gray values of a DSA frame that is due to the contrast agent.
ImageF noiselessContrast(const ImageF& attenuation, const ImageF& thicknessMm, double photonCount)
{
    ImageF contrast = gaussianBlur(expectedCounts(attenuation, photonCount), detectorSigmaPx);
    const ImageF filled =
        gaussianBlur(expectedCounts(withContrast(attenuation, thicknessMm), photonCount), detectorSigmaPx);
    for (std::size_t i = 0; i < contrast.pixels.size(); ++i) {
        contrast.pixels[i] = static_cast<float>(grayPerAttenuation) * std::log(contrast.pixels[i] / filled.pixels[i]);
    }
    return contrast;
}

ImageF subtracted(const ImageF& logMask, const ImageF& logFrame, const Mask2d& open)
{
    ImageF result(logMask.width, logMask.height);
    for (std::size_t i = 0; i < result.pixels.size(); ++i) {
        const double gray =
            midGray - grayPerAttenuation * (static_cast<double>(logMask.pixels[i]) - logFrame.pixels[i]);
        result.pixels[i] = open.pixels[i] != 0 ? static_cast<float>(std::round(std::clamp(gray, 0.0, maxGray))) : 0.0F;
    }
    return result;
}

}   // namespace

DsaRun formDsaFrames(const DsaScene& scene, const DsaOptions& options, const CounterRandom& random)
{
    const int width = options.width;
    const int height = options.height;
    CounterRandom bodyRandom = random.fork(BodyStream);
    const ImageF body = bodyAttenuation(width + 2 * bodyMarginPx, height + 2 * bodyMarginPx, bodyRandom);
    const ImageF logMask =
        logDetectedCounts(expectedCounts(shiftedBody(body, Eigen::Vector2d::Zero()), options.photonCount), maskAverage,
                          random.fork(MaskStream));
    const Mask2d open = drawShutter(width, height, options.shutterProbability, random.fork(ShutterStream));
    const ContrastTiming& timing = options.timing;
    const Bolus bolus{scene.maxPathMm / timing.fillingS, timing.injectionS, timing.riseS, timing.washoutS};

    DsaRun run;
    run.frameTimeMs = options.frameCount > 1 ? std::round(1000.0 * timing.runS / options.frameCount) : 0.0;
    double peak = -1.0;
    ImageF peakThicknessMm;
    ImageF peakAttenuation;   // attenuation of the body in the peak frame, without contrast agent
    for (int k = 0; k < options.frameCount; ++k) {
        const double share = (k + 0.5) / options.frameCount;
        const ImageF thicknessMm = contrastThicknessMm(scene.paths, bolus, timing.firstS + share * timing.runS,
                                                       scene.camera, scene.cameraFromPatient);
        const ImageF attenuation = shiftedBody(body, motionAt(share, options.maskMotionPx, random.fork(MotionStream)));
        const double contrast = std::accumulate(thicknessMm.pixels.begin(), thicknessMm.pixels.end(), 0.0);
        if (contrast > peak) {
            peak = contrast;
            run.peakFrame = k;
            peakThicknessMm = thicknessMm;
            peakAttenuation = attenuation;
        }
        const ImageF logFrame =
            logDetectedCounts(expectedCounts(withContrast(attenuation, thicknessMm), options.photonCount), 1,
                              random.fork(FirstFrameStream + static_cast<std::uint64_t>(k)));
        run.frames.push_back(subtracted(logMask, logFrame, open));
    }
    if (!run.frames.empty()) {
        run.trueContrast = noiselessContrast(peakAttenuation, peakThicknessMm, options.photonCount);
    }
    return run;
}

}   // namespace angiopose::core
