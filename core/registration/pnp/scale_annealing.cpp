#include "core/registration/pnp/scale_annealing.h"

#include <algorithm>

namespace angiopose::core {
namespace {

constexpr int stepsPerHalving = 5;
constexpr int minStepsToStagnate = 10;
constexpr double halvingFactor = 0.5;
constexpr double stagnationFactor = 0.7;

}   // namespace

ScaleAnnealing::ScaleAnnealing(Decay decay, double startPx, double finalPx)
    : decay_(decay), finalPx_(finalPx), scalePx_(std::max(startPx, finalPx))
{
}

void ScaleAnnealing::countStep(int pointsInReach)
{
    ++stepsAtScale_;
    const bool stagnates = pointsInReach <= maxInReach_;
    maxInReach_ = std::max(maxInReach_, pointsInReach);
    const bool isDue =
        decay_ == Decay::Halving ? stepsAtScale_ >= stepsPerHalving : stagnates && stepsAtScale_ >= minStepsToStagnate;
    if (isDue) {
        shrinkScale();
    }
}

bool ScaleAnnealing::shrinkScale()
{
    if (isFinal()) {
        return false;
    }
    scalePx_ = std::max(finalPx_, scalePx_ * (decay_ == Decay::Halving ? halvingFactor : stagnationFactor));
    stepsAtScale_ = 0;
    maxInReach_ = 0;
    return true;
}

}   // namespace angiopose::core
