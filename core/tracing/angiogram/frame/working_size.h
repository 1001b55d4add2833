#pragma once

#include "core/imaging/image2d.h"
#include "core/vessel/centerline2d.h"

#include <Eigen/Core>
#include <vector>

namespace angiopose::core {

/// Scaling of a frame to the typical size, at which vessels are a few pixels wide: larger frames are halved and smaller
/// ones doubled, repeatedly if needed. Tracing therefore does not depend on the matrix size of the detector or export.
struct WorkingSize {
    int halvings = 0;   ///< number of halvings; negative for doublings

    double factor() const;   ///< px of the working frame per px of the stored frame
};

/// Returns the scaling that makes the shorter side 176 to 767 px long.
WorkingSize chooseWorkingSize(int width, int height);
inline WorkingSize chooseWorkingSize(const ImageF& frame)
{
    return chooseWorkingSize(frame.width, frame.height);
}

ImageF toWorkingSize(const ImageF& frame, const WorkingSize& size);
ImageF fromWorkingSize(const ImageF& image, const WorkingSize& size, int width, int height);
Mask2d fromWorkingSize(const Mask2d& mask, const WorkingSize& size, int width, int height);
std::vector<Eigen::Vector2d> fromWorkingSize(std::vector<Eigen::Vector2d> pointsPx, const WorkingSize& size);

}   // namespace angiopose::core
