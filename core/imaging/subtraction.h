#pragma once

#include "core/imaging/angiogram.h"
#include "core/imaging/image2d.h"

#include <Eigen/Core>
#include <vector>

namespace angiopose::core {

/// Relation of stored values to X-ray intensity in DICOM (0028,1040): LIN or LOG.
enum class PixelRelation { Linear, Logarithmic };

/// Returns the mean of the frames with these indices; all must exist and have the same size. Empty without indices.
ImageF meanFrame(const std::vector<ImageF>& frames, const std::vector<int>& indices);

/// Returns the subpixel shift (px right and down), up to a tenth of the image, that aligns `mask` with `frame`: least
/// squares on both images without their slow variation, coarse to fine, with robust weights that exclude vessels, which
/// are visible in one image only (Lucas & Kanade 1981, Welsch weights). Zero if the images do not determine the shift.
Eigen::Vector2d findMaskShift(const ImageF& mask, const ImageF& frame, PixelRelation relation);

/// Returns `frame` with `mask`, shifted by `shiftPx`, subtracted logarithmically (DICOM PS3.3 C.7.6.10). The background
/// gets the medium gray of the frame; dark vessels stay dark and bright vessels bright.
ImageF subtracted(const ImageF& frame, const ImageF& mask, const Eigen::Vector2d& shiftPx, PixelRelation relation);

/// Returns the peak-opacification image of a run: the darkest value of each pixel, or the brightest for bright vessels.
/// Frames that differ in size from the first are left out; the image is empty if there are no frames.
ImageF peakOpacificationImage(const std::vector<ImageF>& frames, Polarity polarity);

}   // namespace angiopose::core
