#pragma once

#include "angiopose/error.h"
#include "angiopose/export.h"
#include "angiopose/geometry.h"
#include "angiopose/vessel_tree.h"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

namespace angiopose {

namespace core {
struct Angiogram;
}

enum class Polarity { VesselsDark, VesselsBright };

/// Pixels row by row, (0, 0) top left.
template <class T>
struct Image2d {
    int width = 0;
    int height = 0;
    std::vector<T> pixels;   ///< width · height

    bool isEmpty() const { return pixels.empty(); }
};

using Image = Image2d<float>;
using Mask = Image2d<std::uint8_t>;   ///< 0 outside, anything else inside

/// One X-ray run: frames of equal size with the geometry of its header. Copies share the frames, which never change.
class ANGIOPOSE_EXPORT Angiogram {
public:
    /// Copies the frames. Fails where there is none, or they differ in size.
    Angiogram(const std::vector<Image>& frames, Polarity polarity, const CArm& cArm = {});
    explicit Angiogram(std::shared_ptr<const core::Angiogram> content);

    int width() const;
    int height() const;
    int frameCount() const;
    std::span<const float> pixels(int frame) const;   ///< height · width, row by row; lives as long as the run
    Image frame(int frame) const;   ///< a copy
    Polarity polarity() const;
    CArm cArm() const;
    double frameTimeMs() const;   ///< 0: not known
    int suggestedFrame() const;   ///< the fullest frame
    std::vector<Message> warnings() const;   ///< of reading

    const std::shared_ptr<const core::Angiogram>& content() const { return content_; }   ///< for the library itself

private:
    std::shared_ptr<const core::Angiogram> content_;
};

/// DICOM XA (single and multi-frame), PNG, TIFF, JPEG.
ANGIOPOSE_EXPORT Angiogram readAngiogram(const std::string& path);

/// Uncompressed multi-frame 16-bit DICOM XA with the geometry of its C-arm.
ANGIOPOSE_EXPORT void writeAngiogram(const Angiogram& angiogram, const std::string& path);

/// Lengths in px of a frame of 512 × 512; in larger frames they grow along.
struct TraceOptions {
    double minVesselRadiusPx = 1.5;   ///< thinnest vessel looked for
    double maxVesselRadiusPx = 0.0;   ///< widest vessel looked for; 0: by pixel spacing and magnification, 8 at least
    int minBranchLengthPx = 10;   ///< shorter spurs are removed
    int minComponentLengthPx = 30;   ///< shorter isolated pieces are removed
    double sensitivity = 1.0;   ///< above 1: fainter vessels too
};

/// What tracing found in one frame.
struct AngiogramTrace {
    Centerline2d centerline;
    std::vector<int> suspectCurves;   ///< ids of curves that may be catheters, wires or edges of bones
    Image vesselness;   ///< 0…1
    Mask vesselMask;   ///< between the walls of the curves
    Mask fieldMask;   ///< where the image is exposed
    std::vector<Message> warnings;   ///< that no contrast medium comes in this run
};

/// The vessels of one picture.
ANGIOPOSE_EXPORT AngiogramTrace traceAngiogram(const Image& frame, Polarity polarity, const TraceOptions& options = {});

/// The vessels of one frame of a run, with less noise where the run stands still. This is what registering a case uses.
ANGIOPOSE_EXPORT AngiogramTrace traceFrame(const Angiogram& run, int frame, const TraceOptions& options = {});

}   // namespace angiopose
