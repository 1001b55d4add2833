#include "core/registration/judging/within_2mm.h"

#include "core/registration/deformable/deform_vessels.h"

#include <algorithm>
#include <cmath>

namespace angiopose::core {
namespace {

constexpr double farthestMm = 1000.0;

/// Logarithms, since twice as far means the same everywhere; what is below the floor is no longer told apart.
double logMm(double distanceMm, double floorMm)
{
    return std::isfinite(distanceMm) ? std::log(std::clamp(distanceMm, 0.0, farthestMm) + floorMm)
                                     : std::log(farthestMm);
}

double logCount(int count)
{
    return std::log1p(static_cast<double>(std::max(0, count)));
}

bool isDeformed(const RegistrationResult& result)
{
    return result.deformed && result.deformed->verdict != DeformationVerdict::Rigid;
}

/// Where bending was not asked, or found nothing, the rigid tree stands.
double deformationOffMm(const RegistrationResult& result)
{
    return isDeformed(result) ? std::hypot(result.deformed->rigid.meanMm, result.deformed->placeStdMm) : 0.0;
}

/// How surely the bent vessels lie beside the rigid ones by as much as it is asked about, 0…1.
double surelyOff(double offMm)
{
    constexpr double asManyMm = 1.8;
    constexpr double sharpness = 3.0;
    return 1.0 / (1.0 + std::exp(sharpness * (asManyMm - offMm)));
}

/// One sign: its mean and spread in the made-up world, and what it and its square weigh in these units.
struct Weight {
    double mean, spread, linear, square;
};

// By fit_within_2mm.py from `trust_table --world made-up --cases 3000` (DECISIONS D73); do not edit by hand.
constexpr double constantTerm = 3.7134;
constexpr std::array<Weight, signCount> weights{{
    {0.5077, 0.2469, 0.8324, -0.5139},   // agreement
    {0.7010, 0.2799, 1.3651, -0.3148},   // treeShare
    {0.5451, 0.3045, 0.4593, 0.3137},   // coverage
    {0.3150, 0.2870, -0.1191, 0.0092},   // followedShare
    {4.2853, 1.5627, 0.9980, 0.2668},   // followedMm
    {1.4646, 1.0556, 0.3645, -0.0003},   // branches
    {-1.3089, 1.1764, -1.5997, -0.2988},   // expectedError
    {-0.7342, 1.1341, -0.2333, -0.1390},   // rival
    {-1.0091, 1.3259, -0.4656, 0.5484},   // medianMm
    {1.3354, 1.4806, 0.1443, 0.3962},   // p95Mm
    {0.1813, 0.3853, -0.3365, -0.5566},   // inParts
    {0.1413, 0.4283, 0.1197, 0.1842},   // filledForks
    {0.5366, 1.3852, 0.6929, 0.2579},   // bendOff
    {0.1320, 0.3385, 0.0244, 0.0530},   // unsure
    {0.1231, 0.3100, -0.1553, -0.8125},   // surelyOff
}};

constexpr double farthestUnits = 3.0;   // nothing was learned beyond
// A tree that lies farther than this from every vessel is seldom right; squares must not say otherwise.
constexpr double farOffMm = 2.0;
constexpr double farOffProbability = 0.45;

/// Half of the tree lies far from vessels, and not because it lies outside the image.
bool isFarOff(const RegistrationResult& result)
{
    const bool isNear = result.metrics.medianMm < farOffMm;   // not where it is no number
    return !isNear && result.signs.treeShare <= 0.5 * result.signs.inViewShare;
}

}   // namespace

const std::array<std::string_view, signCount>& signNames()
{
    static constexpr std::array<std::string_view, signCount> names{
        "agreement", "treeShare", "coverage", "followedShare", "followedMm", "branches", "expectedError", "rival",
        "medianMm",  "p95Mm",     "inParts",  "filledForks",   "bendOff",    "unsure",   "surelyOff"};
    return names;
}

std::array<double, signCount> signVector(const RegistrationResult& result)
{
    constexpr double maxOffMm = 5.0;
    const FitSigns& signs = result.signs;
    const double offMm = deformationOffMm(result);
    const bool isUnsure = isDeformed(result) && result.deformed->verdict == DeformationVerdict::Unsure;
    return {signs.agreement,
            signs.treeShare,
            std::isfinite(result.metrics.coverage) ? result.metrics.coverage : 0.0,
            signs.followedShare,
            logMm(signs.followedMm, 5.0),
            logCount(signs.followedBranches),
            logMm(signs.expectedErrorMm, 0.03),
            logMm(signs.rivalMm, 0.3),
            logMm(result.metrics.medianMm, 0.05),
            logMm(result.metrics.p95Mm, 0.2),
            signs.isPartlyOpacified ? 1.0 : 0.0,
            signs.isPartlyOpacified ? logCount(signs.filledForks) : 0.0,
            std::min(offMm, maxOffMm),
            isUnsure ? 1.0 : 0.0,
            surelyOff(offMm)};
}

double overlayProbability(const RegistrationResult& result)
{
    const std::array<double, signCount> values = signVector(result);
    double logit = constantTerm;
    for (std::size_t k = 0; k < signCount; ++k) {
        const Weight& weight = weights[k];
        const double units = std::clamp((values[k] - weight.mean) / weight.spread, -farthestUnits, farthestUnits);
        logit += weight.linear * units + weight.square * units * units;
    }
    const double probability = 1.0 / (1.0 + std::exp(-logit));
    return isFarOff(result) ? std::min(probability, farOffProbability) : probability;
}

}   // namespace angiopose::core
