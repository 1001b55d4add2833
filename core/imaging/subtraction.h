#pragma once

#include "core/imaging/angiogram.h"
#include "core/imaging/image2d.h"

#include <Eigen/Core>
#include <vector>

namespace angiopose::core {

/// How stored values relate to the X-ray intensity, DICOM (0028,1040): LIN or LOG.
enum class PixelRelation { Linear, Logarithmic };

/// Mean of the frames with these indices; all must exist and be of one size. Empty without any.
ImageF meanFrame(const std::vector<ImageF>& frames, const std::vector<int>& indices);

/// How far the picture of `mask` must move (px right and down) to lie on `frame`, sub-pixel, up to a tenth of the
/// image: least squares on both without their slow changes, coarse to fine, with weights that let vessels (which only
/// one of the two shows) drop out (Lucas & Kanade 1981, Welsch weights). Zero where nothing tells.
Eigen::Vector2d maskShift(const ImageF& mask, const ImageF& frame, PixelRelation relation);

/// `frame` without what `mask`, moved by `shiftPx`, shows as well: logarithms subtracted (DICOM PS3.3 C.7.6.10). The
/// background has the frame's middle grey, vessels keep their sign.
ImageF subtracted(const ImageF& frame, const ImageF& mask, const Eigen::Vector2d& shiftPx, PixelRelation relation);

/// All the contrast medium of a run in one picture: the darkest value of each pixel (the brightest for bright vessels).
/// Frames of another size than the first are left out; empty without frames.
ImageF opacifiedComposite(const std::vector<ImageF>& frames, Polarity polarity);

}   // namespace angiopose::core