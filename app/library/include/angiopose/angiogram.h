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

/// Image with pixels in row-major order; pixel (0, 0) is at the top left.
template <class T>
struct Image2d {
    int width = 0;
    int height = 0;
    std::vector<T> pixels;   ///< width · height values

    bool isEmpty() const { return pixels.empty(); }
};

using Image = Image2d<float>;
using Mask = Image2d<std::uint8_t>;   ///< 0 outside, any other value inside

/// X-ray cine run: frames of equal size, with the geometry from the header. Copies share the frames, which are
/// immutable.
class ANGIOPOSE_EXPORT Angiogram {
public:
    /// Copies the frames. Throws if there are no frames or if their sizes differ.
    Angiogram(const std::vector<Image>& frames, Polarity polarity, const CArm& cArm = {});
    explicit Angiogram(std::shared_ptr<const core::Angiogram> content);

    int width() const;
    int height() const;
    int frameCount() const;
    std::span<const float> pixels(
        int frame) const;   ///< height · width values in row-major order; valid as long as the angiogram exists
    Image frame(int frame) const;   ///< returns a copy
    Polarity polarity() const;
    CArm cArm() const;
    double frameTimeMs() const;   ///< 0 if unknown
    int suggestedFrame() const;   ///< peak-opacification frame
    std::vector<Message> warnings() const;   ///< warnings from reading the file

    const std::shared_ptr<const core::Angiogram>& content() const { return content_; }   ///< internal use

private:
    std::shared_ptr<const core::Angiogram> content_;
};

/// Reads DICOM XA (single-frame and multi-frame), PNG, TIFF or JPEG.
ANGIOPOSE_EXPORT Angiogram readAngiogram(const std::string& path);

/// Writes uncompressed 16-bit multi-frame DICOM XA with the C-arm geometry.
ANGIOPOSE_EXPORT void writeAngiogram(const Angiogram& angiogram, const std::string& path);

/// radius of the thinnest vessel to search for
struct TraceOptions {
    double minVesselRadiusPx = 1.5;   ///< radius of the thinnest vessel searched for
    double maxVesselRadiusPx =
        0.0;   ///< radius of the widest vessel searched for; 0: from pixel spacing and magnification, at least 8
    int minBranchLengthPx = 10;   ///< spurs shorter than this are removed
    int minComponentLengthPx = 30;   ///< isolated components shorter than this are removed
    double sensitivity = 1.0;   ///< larger values also detect fainter vessels
};

/// Result of tracing one frame.
struct AngiogramTrace {
    Centerline2d centerline;
    std::vector<int> suspectCurves;   ///< IDs of curves that may be catheters, guidewires or bone edges
    Image vesselness;   ///< 0…1
    Mask vesselMask;   ///< area between the vessel walls
    Mask fieldMask;   ///< exposed part of the image
    std::vector<Message> warnings;   ///< e.g. that no contrast agent arrives in this cine run
};

/// Traces the vessels of one image.
ANGIOPOSE_EXPORT AngiogramTrace traceAngiogram(const Image& frame, Polarity polarity, const TraceOptions& options = {});

/// Traces the vessels of one frame of a cine run. Averages neighboring frames where nothing moves, to reduce noise.
/// Registration of a case uses this trace.
ANGIOPOSE_EXPORT AngiogramTrace traceFrame(const Angiogram& run, int frame, const TraceOptions& options = {});

}   // namespace angiopose
