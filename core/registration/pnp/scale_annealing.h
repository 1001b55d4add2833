#pragma once

#include "core/registration/options/registration_options.h"

namespace angiopose::core {

/// Kernel width ℓ from coarse to fine; never below its floor.
class ScaleAnnealing {
public:
    ScaleAnnealing(Decay decay, double startPx, double finalPx);

    double scalePx() const { return scalePx_; }
    bool isFinal() const { return scalePx_ <= finalPx_; }

    /// Counts an accepted step after which `pointsInReach` points feel the kernel; shrinks ℓ when it is due.
    void noteStep(int pointsInReach);

    /// Shrinks ℓ at once, as nothing more is to be gained at this one; false when it is final already.
    bool sharpen();

private:
    Decay decay_;
    double finalPx_;
    double scalePx_;
    int stepsAtScale_ = 0;
    int maxInReach_ = 0;
};

}   // namespace angiopose::core