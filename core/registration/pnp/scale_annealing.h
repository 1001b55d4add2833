#pragma once

#include "core/registration/options/registration_options.h"

namespace angiopose::core {

/// Kernel width ℓ, annealed from coarse to fine down to a minimum.
class ScaleAnnealing {
public:
    ScaleAnnealing(Decay decay, double startPx, double finalPx);

    double scalePx() const { return scalePx_; }
    bool isFinal() const { return scalePx_ <= finalPx_; }

    /// Counts an accepted step after which `pointsInReach` points are within reach of the kernel; shrinks ℓ when due.
    void countStep(int pointsInReach);

    /// Shrinks ℓ immediately, because the current width allows no further gain; returns false if ℓ is already final.
    bool shrinkScale();

private:
    Decay decay_;
    double finalPx_;
    double scalePx_;
    int stepsAtScale_ = 0;
    int maxInReach_ = 0;
};

}   // namespace angiopose::core
