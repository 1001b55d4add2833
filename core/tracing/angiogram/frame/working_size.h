#pragma once

#include "core/imaging/image2d.h"
#include "core/vessel/centerline2d.h"

#include <Eigen/Core>
#include <vector>

namespace angiopose::core {

/// Vessels are a few pixels wide in frames of usual size: larger frames are halved until they have it, smaller ones
/// doubled. The same vessels are then traced alike, whatever the detector's or an export's matrix.
struct WorkingSize {
    int halvings = 0;   ///< negative: doublings

    double factor() const;   ///< px of the working frame per px of the stored one
};

/// The shorter side gets 176 to 767 px.
WorkingSize workingSizeOf(int width, int height);
inline WorkingSize workingSizeOf(const ImageF& frame)
{
    return workingSizeOf(frame.width, frame.height);
}

ImageF toWorkingSize(const ImageF& frame, const WorkingSize& size);
ImageF fromWorkingSize(const ImageF& image, const WorkingSize& size, int width, int height);
Mask2d fromWorkingSize(const Mask2d& mask, const WorkingSize& size, int width, int height);
std::vector<Eigen::Vector2d> fromWorkingSize(std::vector<Eigen::Vector2d> pointsPx, const WorkingSize& size);

}   // namespace angiopose::core