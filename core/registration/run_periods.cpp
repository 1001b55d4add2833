#include "core/registration/run_periods.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

namespace angiopose::core {
namespace {

constexpr std::size_t minPoses = 12;
constexpr double minCycles = 1.8;   // minimum number of observed cycles of the slowest period
constexpr double samplesPerCycle = 3.0;   // minimum number of samples per cycle of the fastest period searched
constexpr double stepsPerCycle = 8.0;   // frequency grid points per 1 / duration, the width of a peak
constexpr double minAmplitudeMm = 0.3;
constexpr double chanceOfNoise = 1e-4;

struct Band {
    double shortestS;
    double longestS;
};
constexpr Band breathing{2.0, 10.0};
constexpr Band beating{0.4, 1.5};

using Signal = Eigen::Matrix<double, Eigen::Dynamic, 2>;   // position perpendicular to the rays, mm, one row per pose

/// Returns the regression columns for a constant, a linear drift and, at a nonzero frequency, a wave.
Eigen::MatrixXd designMatrix(const Eigen::VectorXd& seconds, double frequencyHz)
{
    const bool hasWave = frequencyHz > 0.0;
    Eigen::MatrixXd basis(seconds.size(), hasWave ? 4 : 2);
    basis.col(0).setOnes();
    basis.col(1) = seconds.array() - seconds.mean();
    if (hasWave) {
        const Eigen::ArrayXd phase = 2.0 * std::numbers::pi * frequencyHz * seconds.array();
        basis.col(2) = phase.sin();
        basis.col(3) = phase.cos();
    }
    return basis;
}

struct WaveFit {
    Eigen::MatrixXd factors;
    Signal left;
};

WaveFit fitWave(const Eigen::VectorXd& seconds, const Signal& signal, double frequencyHz)
{
    const Eigen::MatrixXd basis = designMatrix(seconds, frequencyHz);
    WaveFit fit;
    fit.factors = basis.colPivHouseholderQr().solve(signal);
    fit.left = signal - basis * fit.factors;
    return fit;
}

/// Returns the amplitude of an elliptical motion, which is its semi-major axis.
double amplitudeOf(const WaveFit& fit)
{
    return Eigen::JacobiSVD<Eigen::Matrix2d>(fit.factors.bottomRows<2>()).singularValues()[0];
}

/// Finds the strongest wave in a band and, if it is significant, subtracts it from the signal.
std::optional<PeriodicMotion> extractWave(const Band& band, const Eigen::VectorXd& seconds, Signal& signal)
{
    const double duration = seconds.maxCoeff() - seconds.minCoeff();
    const double meanStep = duration / static_cast<double>(seconds.size() - 1);
    const double slowest = std::max(1.0 / band.longestS, minCycles / duration);
    const double fastest = std::min(1.0 / band.shortestS, 1.0 / (samplesPerCycle * meanStep));
    const double before = fitWave(seconds, signal, 0.0).left.squaredNorm();
    if (!(slowest < fastest) || !(before > 0.0)) {
        return std::nullopt;
    }
    double best = before;
    double bestHz = 0.0;
    for (double hz = slowest; hz <= fastest; hz += 1.0 / (stepsPerCycle * duration)) {
        const double left = fitWave(seconds, signal, hz).left.squaredNorm();
        if (left < best) {
            best = left;
            bestHz = hz;
        }
    }
    if (bestHz <= slowest) {   // a maximum at the lower limit is not a peak
        return std::nullopt;
    }
    const double share = 1.0 - best / before;
    // For noise, the explained fraction has a beta distribution: 4 degrees of freedom (sine and cosine of two
    // coordinates) against the rest. The number of independent frequencies is the number that fits between the limits.
    const double half = static_cast<double>(seconds.size()) - 4.0;
    const double tried = std::max(1.0, (fastest - slowest) * duration);
    const double chance = tried * std::pow(1.0 - share, half) * (1.0 + half * share);
    const WaveFit fit = fitWave(seconds, signal, bestHz);
    const PeriodicMotion found{1.0 / bestHz, amplitudeOf(fit), share};
    if (chance > chanceOfNoise || found.amplitudeMm < minAmplitudeMm) {
        return std::nullopt;
    }
    signal = fit.left;
    return found;
}

}   // namespace

RunPeriods findPeriods(std::span<const TimedPose> poses, const Eigen::Vector3d& pointInPatient)
{
    RunPeriods periods;
    if (poses.size() < minPoses) {
        return periods;
    }
    const auto count = static_cast<Eigen::Index>(poses.size());
    Eigen::VectorXd seconds(count);
    Signal places(count, 2);
    for (Eigen::Index k = 0; k < count; ++k) {
        const TimedPose& pose = poses[static_cast<std::size_t>(k)];
        seconds[k] = pose.seconds;
        places.row(k) = (pose.cameraFromPatient * pointInPatient).head<2>().transpose();
    }
    if (!(seconds.maxCoeff() > seconds.minCoeff())) {
        return periods;
    }
    periods.breathMotion = extractWave(breathing, seconds, places);
    periods.heartMotion = extractWave(beating, seconds, places);
    return periods;
}

}   // namespace angiopose::core
