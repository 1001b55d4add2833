#pragma once

namespace angiopose::core {

/// When the kernel width ℓ shrinks (ALGORITHMS §3.1).
enum class Decay {
    Halving,   ///< ÷2 every five accepted steps: the seed
    Stagnation   ///< ×0.7 after at least ten steps, once no further point comes within reach: RKHS-BA
};

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
    int mostInReach_ = 0;
};

}   // namespace angiopose::core