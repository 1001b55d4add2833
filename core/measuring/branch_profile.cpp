#include "core/measuring/branch_profile.h"

#include "core/messages/messages.h"
#include "core/support/quantile.h"
#include "core/vessel/polyline.h"

#include <Eigen/Core>
#include <Eigen/Dense>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>

namespace angiopose::core {
namespace {

/// Linear model of the diameter along a vessel.
struct DiameterLine {
    double startMm = 0.0;   ///< diameter at arc length 0
    double slope = 0.0;   ///< diameter change in mm per mm of arc length

    double at(double arcLengthMm) const { return startMm + slope * arcLengthMm; }
};

constexpr std::size_t minDiameters = 6;
constexpr double minInlierFraction = 0.25;
constexpr std::array outlierFractions{0.3, 0.2, 0.15, 0.1,
                                      0.1, 0.1, 0.1};   // limits per pass below the line; doubled above

DiameterLine fitLine(const std::vector<Eigen::Vector2d>& diameters)
{
    Eigen::Vector2d mean = Eigen::Vector2d::Zero();
    for (const Eigen::Vector2d& each : diameters) {
        mean += each / static_cast<double>(diameters.size());
    }
    double along = 0.0;
    double covariance = 0.0;
    for (const Eigen::Vector2d& each : diameters) {
        along += (each.x() - mean.x()) * (each.x() - mean.x());
        covariance += (each.x() - mean.x()) * (each.y() - mean.y());
    }
    const double slope = along > 0.0 ? covariance / along : 0.0;
    return {mean.y() - slope * mean.x(), slope};
}

/// Fits a line to the diameters, (arc length, diameter) in mm, of the healthy vessel: first to all diameters, then
/// again without those too far below or above the line, with limits that tighten to 10 % and 20 %. Returns nullopt for
/// fewer than 6 diameters, or if fewer than a quarter of them are within the limits.
std::optional<DiameterLine> referenceLine(const std::vector<Eigen::Vector2d>& diameters)
{
    if (diameters.size() < minDiameters) {
        return std::nullopt;
    }
    DiameterLine line = fitLine(diameters);
    for (const double shareBelow : outlierFractions) {
        std::vector<Eigen::Vector2d> healthy;
        for (const Eigen::Vector2d& each : diameters) {
            const double expected = line.at(each.x());
            if (each.y() > (1.0 - shareBelow) * expected && each.y() < (1.0 + 2.0 * shareBelow) * expected) {
                healthy.push_back(each);
            }
        }
        if (static_cast<double>(healthy.size()) < minInlierFraction * static_cast<double>(diameters.size())) {
            return std::nullopt;
        }
        line = fitLine(healthy);
    }
    return line;
}

constexpr double profileSpacingMm = 0.5;
constexpr double diameterReachMm = 1.0;
constexpr double curvatureReachMm = 3.0;
constexpr double minCurvatureArcMm = 2.0;   // minimum arc length for measuring curvature
constexpr double referenceReachMm = 30.0;   // beyond this distance, bifurcations have changed the vessel
constexpr double recoveryReachMm = 20.0;
constexpr double stenosisEndRatio = 0.9;   // fraction of the reference diameter at which a stenosis ends
constexpr double unknownProfileValue = std::numeric_limits<double>::quiet_NaN();

/// Whether every point has a valid radius.
bool hasAllRadii(const VesselBranch& branch)
{
    const auto isRadius = [](double radius) { return std::isfinite(radius) && radius > 0.0; };
    return branch.radiusMm.size() == branch.pointsInPatient.size() && std::ranges::all_of(branch.radiusMm, isRadius);
}

/// Returns the index range of the samples within `reachMm` of sample `middle`: the first, and one past the last.
std::pair<std::size_t, std::size_t> samplesAround(const std::vector<ProfileSample>& samples, std::size_t middle,
                                                  double reachMm)
{
    std::size_t first = middle;
    std::size_t end = middle + 1;
    while (first > 0 && samples[middle].arcLengthMm - samples[first - 1].arcLengthMm <= reachMm) {
        --first;
    }
    while (end < samples.size() && samples[end].arcLengthMm - samples[middle].arcLengthMm <= reachMm) {
        ++end;
    }
    return {first, end};
}

/// Returns the curvature of a parabola fitted to the surrounding samples.
double curvatureAt(const std::vector<ProfileSample>& samples, std::size_t middle)
{
    const auto [first, end] = samplesAround(samples, middle, curvatureReachMm);
    if (end - first < 4 || samples[end - 1].arcLengthMm - samples[first].arcLengthMm < minCurvatureArcMm) {
        return unknownProfileValue;
    }
    const auto count = static_cast<Eigen::Index>(end - first);
    Eigen::MatrixXd powers(count, 3);
    Eigen::MatrixXd points(count, 3);
    for (Eigen::Index i = 0; i < count; ++i) {
        const ProfileSample& sample = samples[first + static_cast<std::size_t>(i)];
        const double arc = sample.arcLengthMm - samples[middle].arcLengthMm;
        powers.row(i) << 1.0, arc, arc * arc;
        points.row(i) = sample.pointInPatient.transpose();
    }
    const Eigen::MatrixXd fitted = powers.colPivHouseholderQr().solve(points);
    const Eigen::Vector3d speed = fitted.row(1).transpose();
    const Eigen::Vector3d curvature = 2.0 * fitted.row(2).transpose();
    return speed.cross(curvature).norm() / std::pow(speed.norm(), 3.0);
}

std::vector<ProfileSample> profileSamples(const VesselBranch& branch)
{
    const std::vector<PolylineStation> stations = evenStations<3>(branch.pointsInPatient, profileSpacingMm);
    const Polyline<3> points = interpolate(branch.pointsInPatient, stations);
    std::vector<ProfileSample> samples(points.size());
    const double stepMm = branch.lengthMm() / static_cast<double>(points.size() - 1);
    for (std::size_t i = 0; i < points.size(); ++i) {
        samples[i] = {stepMm * static_cast<double>(i), points[i], unknownProfileValue, unknownProfileValue,
                      unknownProfileValue};
    }
    for (std::size_t i = 0; i < points.size(); ++i) {
        samples[i].curvaturePerMm = curvatureAt(samples, i);
    }
    if (!hasAllRadii(branch)) {
        return samples;
    }
    const std::vector<double> radii = interpolate(branch.radiusMm, stations);
    for (std::size_t i = 0; i < samples.size(); ++i) {
        const auto [first, end] = samplesAround(samples, i, diameterReachMm);
        samples[i].diameterMm = 2.0 * quantile({radii.begin() + static_cast<std::ptrdiff_t>(first),
                                                radii.begin() + static_cast<std::ptrdiff_t>(end)},
                                               0.5);
    }
    return samples;
}

double diameterRatio(const ProfileSample& sample)
{
    return sample.diameterMm / sample.referenceDiameterMm;
}

/// Returns the stenosis at the narrowest sample relative to its reference; requires a sample with a reference.
StenosisMeasure narrowestStenosis(const std::vector<ProfileSample>& samples)
{
    std::size_t narrowest = 0;
    for (std::size_t i = 1; i < samples.size(); ++i) {
        const bool isFirst = std::isnan(diameterRatio(samples[narrowest]));
        narrowest = isFirst || diameterRatio(samples[i]) < diameterRatio(samples[narrowest]) ? i : narrowest;
    }
    std::size_t from = narrowest;
    std::size_t to = narrowest;
    while (from > 0 && diameterRatio(samples[from]) < stenosisEndRatio) {
        --from;
    }
    while (to + 1 < samples.size() && diameterRatio(samples[to]) < stenosisEndRatio) {
        ++to;
    }
    return {std::max(0.0, 100.0 * (1.0 - diameterRatio(samples[narrowest]))),
            samples[narrowest].arcLengthMm,
            samples[from].arcLengthMm,
            samples[to].arcLengthMm,
            samples[narrowest].diameterMm,
            samples[narrowest].referenceDiameterMm};
}

/// Adds reference diameters to the samples from `first` up to, but excluding, `end`. Each is computed from the
/// surrounding samples; near an end, the window is shifted inward to contain equally many samples.
void addReferences(std::vector<ProfileSample>& samples, std::size_t first, std::size_t end)
{
    const auto reach = static_cast<std::size_t>(referenceReachMm / profileSpacingMm);
    for (std::size_t i = first; i < end; ++i) {
        const std::size_t latest = end > first + 2 * reach ? end - 2 * reach : first;
        const std::size_t from = std::clamp(i > reach ? i - reach : 0, first, latest);
        std::vector<Eigen::Vector2d> diameters;
        for (std::size_t k = from; k < std::min(from + 2 * reach, end); ++k) {
            diameters.emplace_back(samples[k].arcLengthMm, samples[k].diameterMm);
        }
        const auto line = referenceLine(diameters);
        if (line && line->at(samples[i].arcLengthMm) > 0.0) {
            samples[i].referenceDiameterMm = line->at(samples[i].arcLengthMm);
        }
    }
}

/// Lowers the reference where the vessel stays narrow because it tapers or has given off a branch: if the diameter does
/// not return to the reference farther along, the reference becomes the diameter to which it returns.
void lowerUnrecoveredReferences(std::vector<ProfileSample>& samples)
{
    const auto reach = static_cast<std::size_t>(recoveryReachMm / profileSpacingMm);
    std::vector<double> lowered;
    for (std::size_t i = 0; i < samples.size(); ++i) {
        double recovered = diameterRatio(samples[i]);
        for (std::size_t k = i; k < std::min(samples.size(), i + reach); ++k) {
            recovered = std::fmax(recovered, diameterRatio(samples[k]));
        }
        lowered.push_back(samples[i].referenceDiameterMm * std::min(1.0, recovered));
    }
    for (std::size_t i = 0; i < samples.size(); ++i) {
        samples[i].referenceDiameterMm = lowered[i];
    }
}

/// Adds reference diameters and the stenosis; excludes about one diameter at each end of the branch.
void addStenosis(BranchProfile& profile)
{
    std::vector<ProfileSample>& samples = profile.samples;
    const double endMm = std::min(*profile.meanDiameterMm, 0.25 * profile.lengthMm);
    const auto isBefore = [](const ProfileSample& sample, double arcLengthMm) {
        return sample.arcLengthMm < arcLengthMm;
    };
    const auto at = [&](double arcLengthMm) {
        return static_cast<std::size_t>(std::lower_bound(samples.begin(), samples.end(), arcLengthMm, isBefore) -
                                        samples.begin());
    };
    addReferences(samples, at(endMm), at(profile.lengthMm - endMm));
    lowerUnrecoveredReferences(samples);
    const auto hasReference = [](const ProfileSample& sample) { return std::isfinite(sample.referenceDiameterMm); };
    if (std::ranges::any_of(samples, hasReference)) {
        profile.stenosis = narrowestStenosis(samples);
    } else {
        profile.warnings.push_back(messages::profileNoReference());
    }
}

void addDiameters(BranchProfile& profile)
{
    double sum = 0.0;
    for (const ProfileSample& sample : profile.samples) {
        sum += sample.diameterMm;
    }
    const auto [narrowest, widest] = std::ranges::minmax_element(profile.samples, {}, &ProfileSample::diameterMm);
    profile.meanDiameterMm = sum / static_cast<double>(profile.samples.size());
    profile.minDiameterMm = narrowest->diameterMm;
    profile.maxDiameterMm = widest->diameterMm;
    addStenosis(profile);
}

}   // namespace

Result<BranchProfile> measureProfile(const VesselBranch& branch)
{
    const auto isFinite = [](const Eigen::Vector3d& point) { return point.allFinite(); };
    if (!std::ranges::all_of(branch.pointsInPatient, isFinite) || !(branch.lengthMm() > 0.0)) {
        return Error(messages::profileNoLength(branch.id));
    }
    BranchProfile profile;
    profile.branchId = branch.id;
    profile.samples = profileSamples(branch);
    profile.lengthMm = branch.lengthMm();
    const double chordMm = (branch.pointsInPatient.back() - branch.pointsInPatient.front()).norm();
    profile.tortuosity = chordMm > 1e-9 * profile.lengthMm ? profile.lengthMm / chordMm : unknownProfileValue;
    profile.maxCurvaturePerMm = unknownProfileValue;
    for (const ProfileSample& sample : profile.samples) {
        profile.maxCurvaturePerMm = std::fmax(profile.maxCurvaturePerMm, sample.curvaturePerMm);
    }
    if (hasAllRadii(branch)) {
        addDiameters(profile);
    } else {
        profile.warnings.push_back(messages::profileNoRadii());
    }
    return profile;
}

}   // namespace angiopose::core
