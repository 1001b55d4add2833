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

/// Image of pixels in row order, (0, 0) top left.
template <class T>
struct Image2d {
    int width = 0;
    int height = 0;
    std::vector<T> pixels;   ///< width · height

    bool isEmpty() const { return pixels.empty(); }
};

using Image = Image2d<float>;
using Mask = Image2d<std::uint8_t>;   ///< 0 outside, any other value inside

/// One X-ray cine run: frames of equal size with the geometry from its header. Copies share the frames, which never
/// change.
class ANGIOPOSE_EXPORT Angiogram {
public:
    /// Copies the frames. Throws if there is none or if they differ in size.
    Angiogram(const std::vector<Image>& frames, Polarity polarity, const CArm& cArm = {});
    explicit Angiogram(std::shared_ptr<const core::Angiogram> content);

    int width() const;
    int height() const;
    int frameCount() const;
    std::span<const float> pixels(
        int frame) const;   ///< height · width, row by row; valid as long as the angiogram exists
    Image frame(int frame) const;   ///< a copy
    Polarity polarity() const;
    CArm cArm() const;
    double frameTimeMs() const;   ///< 0: unknown
    int suggestedFrame() const;   ///< peak-opacification frame
    std::vector<Message> warnings() const;   ///< from reading the file

    const std::shared_ptr<const core::Angiogram>& content() const { return content_; }   ///< internal use

private:
    std::shared_ptr<const core::Angiogram> content_;
};

/// Reads DICOM XA (single-frame and multi-frame), PNG, TIFF or JPEG.
ANGIOPOSE_EXPORT Angiogram readAngiogram(const std::string& path);

/// Writes uncompressed multi-frame 16-bit DICOM XA with the C-arm geometry.
ANGIOPOSE_EXPORT void writeAngiogram(const Angiogram& angiogram, const std::string& path);

/// Options of 2-D tracing. Lengths are px of a 512 × 512 frame and scale with larger frames.
struct TraceOptions {
    double minVesselRadiusPx = 1.5;   ///< radius of the thinnest vessel searched for
    double maxVesselRadiusPx =
        0.0;   ///< radius of the widest vessel searched for; 0: from pixel spacing and magnification, at least 8
    int minBranchLengthPx = 10;   ///< shorter spurs are removed
    int minComponentLengthPx = 30;   ///< shorter isolated components are removed
    double sensitivity = 1.0;   ///< above 1: also detects fainter vessels
};

/// Result of tracing one frame.
struct AngiogramTrace {
    Centerline2d centerline;
    std::vector<int> suspectCurves;   ///< ids of curves that may be catheters, guidewires or bone edges
    Image vesselness;   ///< 0…1
    Mask vesselMask;   ///< between the walls of the curves
    Mask fieldMask;   ///< exposed part of the image
    std::vector<Message> warnings;   ///< for example: no contrast agent arrives in this cine run
};

/// Traces the vessels of one image.
ANGIOPOSE_EXPORT AngiogramTrace traceAngiogram(const Image& frame, Polarity polarity, const TraceOptions& options = {});

/// Traces the vessels of one frame of a cine run, with reduced noise where neighboring frames do not move. Registration
/// of a case uses this trace.
ANGIOPOSE_EXPORT AngiogramTrace traceFrame(const Angiogram& run, int frame, const TraceOptions& options = {});

}   // namespace angiopose
