#include "core/registration/alignment/alignment.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace angiopose::core {
namespace {

constexpr double agreeingGate = 0.5;   // cos⁴ of 33°: directions within this angle agree
constexpr double cutOff = 4.0;   // in units of ℓ; beyond it the Welsch weight is below 4e-4 and is ignored

bool isInImage(const ProjectionCamera& camera, const Eigen::Vector2d& pixel)
{
    return pixel.x() >= -0.5 && pixel.y() >= -0.5 && pixel.x() <= camera.width - 0.5 &&
           pixel.y() <= camera.height - 0.5;
}

/// Adds w r² to the model; fills only the lower triangle of the Hessian.
inline void addRow(double weight, double residual, const Vector6d& J, NormalEquations& sum)
{
    const Vector6d weighted = weight * J;
    for (int column = 0; column < 6; ++column) {
        for (int row = column; row < 6; ++row) {
            sum.hessian(row, column) += weighted[row] * J[column];
        }
    }
    sum.gradient += residual * weighted;
}

}   // namespace

/// Target line matched to a tree point.
struct Alignment::Match {
    const TargetLines::Line* line = nullptr;
    double du, dv;   ///< vector from the line point to the projected tree point, px
    double normalX, normalY;   ///< unit normal of the line
    double residual;   ///< signed distance along the normal, px
    double squaredDistance;
    double gate;   ///< cos⁴ of the angle between the directions

    bool find(const TargetLines& target, const PointInCamera& seen, double limitPx)
    {
        line = &target.nearest(seen.u, seen.v);
        du = seen.u - line->x;
        dv = seen.v - line->y;
        squaredDistance = du * du + dv * dv;
        return squaredDistance <= limitPx * limitPx;
    }

    void compare(const PointInCamera& seen)
    {
        const double cosine = seen.su * line->tx + seen.sv * line->ty;
        // Orients the normal to the same side of the branch, whether the curve was traced forward or backward.
        const double side = cosine < 0.0 ? -1.0 : 1.0;
        normalX = -side * line->ty;
        normalY = side * line->tx;
        residual = normalX * du + normalY * dv;
        gate = seen.hasDirection ? cosine * cosine * cosine * cosine : 1.0;
    }
};

Alignment::Alignment(std::vector<AlignmentPoint> points, const ProjectionCamera& camera, const TargetLines& target)
    : points_(std::move(points)), camera_(camera), target_(&target)
{
    double squares = 0.0;
    for (const AlignmentPoint& point : points_) {
        const auto branch = static_cast<std::size_t>(point.branchIndex);
        if (branch >= pointCount_.size()) {
            pointCount_.resize(branch + 1, 0.0);
        }
        pointCount_[branch] += 1.0;
        squares += point.fromCentroid.squaredNorm();
    }
    spreadMm_ = std::sqrt(squares / std::max(1.0, static_cast<double>(points_.size())));
    for (double& count : pointCount_) {
        count = std::max(count, 1.0);
    }
    visibility_.assign(pointCount_.size(), 1.0);
    buffers_.evaluations.here.branchWeight.reserve(pointCount_.size());
    buffers_.evaluations.there.branchWeight.reserve(pointCount_.size());
    buffers_.residuals.reserve(points_.size());
}

inline bool Alignment::match(const AlignmentPoint& point, const CentroidPose& pose, double limitPx, PointInCamera& seen,
                             Match& match) const
{
    if (!seePlace(camera_, point, pose, seen) || !match.find(*target_, seen, limitPx)) {
        return false;
    }
    seeDirection(camera_, point, pose, seen);
    match.compare(seen);
    return true;
}

/// Returns d(residual) / d(log focal length, cx px, cy px).
inline Eigen::Vector3d Alignment::cameraGradient(const PointInCamera& seen, const Match& found) const
{
    const double along = found.normalX * (seen.u - camera_.cx) + found.normalY * (seen.v - camera_.cy);
    return {along, found.normalX, found.normalY};
}

Agreement Alignment::evaluate(const CentroidPose& pose, double scalePx) const
{
    Agreement agreement;
    evaluate(pose, scalePx, agreement);
    return agreement;
}

/// Accumulates the residuals of all points, using the match that `matched` returns for each.
template <class Matched>
inline void Alignment::addForward(double scalePx, const Matched& matched, Agreement& agreement) const
{
    agreement.equations = {};
    agreement.branchWeight.assign(visibility_.size(), 0.0);
    const double perSquaredScale = -0.5 / (scalePx * scalePx);
    double costShare = 0.0;
    Match found;
    for (std::size_t i = 0; i < points_.size(); ++i) {
        const auto branch = static_cast<std::size_t>(points_[i].branchIndex);
        const double importance = visibility_[branch] * visibility_[branch];
        costShare += importance;
        const PointInCamera* seen = matched(i, found);
        if (seen == nullptr) {
            continue;
        }
        const double agreeing = found.gate * std::exp(perSquaredScale * found.squaredDistance);
        const double weight = importance * agreeing;
        agreement.branchWeight[branch] += agreeing;
        costShare -= weight;
        addRow(weight, found.residual, distanceGradient(camera_, *seen, found.normalX, found.normalY),
               agreement.equations);
    }
    for (std::size_t b = 0; b < pointCount_.size(); ++b) {
        agreement.branchWeight[b] /= pointCount_[b];
    }
    agreement.loss = 2.0 * scalePx * scalePx * costShare;
}

void Alignment::evaluate(const CentroidPose& pose, double scalePx, Agreement& agreement) const
{
    PointInCamera seen;
    const auto matched = [&](std::size_t i, Match& found) {
        return match(points_[i], pose, cutOff * scalePx, seen, found) ? &seen : nullptr;
    };
    addForward(scalePx, matched, agreement);
}

void Alignment::searchBothDirections(const CentroidPose& pose, double scalePx, Agreement& agreement)
{
    std::vector<PointInCamera>& seen = buffers_.reverse.seen();
    seen.resize(points_.size());
    for (std::size_t i = 0; i < points_.size(); ++i) {
        seen[i].isInFront = seePlace(camera_, points_[i], pose, seen[i]);
        seeDirection(camera_, points_[i], pose, seen[i]);
    }
    const auto matched = [&](std::size_t i, Match& found) -> const PointInCamera* {
        if (!seen[i].isInFront || !found.find(*target_, seen[i], cutOff * scalePx)) {
            return nullptr;
        }
        found.compare(seen[i]);
        return &seen[i];
    };
    addForward(scalePx, matched, agreement);
    buffers_.reverse.match(*target_, camera_.width, camera_.height, cutOff * scalePx);
    addReverse(scalePx, agreement);
}

void Alignment::addReverse(double scalePx, Agreement& agreement) const
{
    const double perSquaredScale = -0.5 / (scalePx * scalePx);
    double weights = 0.0;
    const auto& lines = target_->lines();
    const std::vector<int>& partners = buffers_.reverse.partners();
    for (std::size_t k = 0; k < partners.size(); ++k) {
        if (partners[k] < 0) {
            continue;
        }
        const TargetLines::Line& line = lines[k * ReverseMatching::lineStride];
        const auto number = static_cast<std::size_t>(partners[k]);
        const PointInCamera& seen = buffers_.reverse.seen()[number];
        const double visibility = visibility_[static_cast<std::size_t>(points_[number].branchIndex)];
        const double du = seen.u - line.x;
        const double dv = seen.v - line.y;
        const double cosine = seen.su * line.tx + seen.sv * line.ty;
        const double gate = cosine * cosine * cosine * cosine;
        const double weight = ReverseMatching::lineStride * visibility * visibility * gate *
                              std::exp(perSquaredScale * (du * du + dv * dv));
        weights += weight;
        addRow(weight, seen.su * dv - seen.sv * du, distanceGradient(camera_, seen, -seen.sv, seen.su),
               agreement.equations);
    }
    agreement.loss -= 2.0 * scalePx * scalePx * weights;
}

double Alignment::loss(const CentroidPose& pose, double scalePx) const
{
    const double perSquaredScale = -0.5 / (scalePx * scalePx);
    double costShare = 0.0;
    PointInCamera seen;
    Match found;
    for (const AlignmentPoint& point : points_) {
        const double visibility = visibility_[static_cast<std::size_t>(point.branchIndex)];
        const bool isMatched = match(point, pose, cutOff * scalePx, seen, found);
        const double weight = isMatched ? found.gate * std::exp(perSquaredScale * found.squaredDistance) : 0.0;
        costShare += visibility * visibility * (1.0 - weight);
    }
    return 2.0 * scalePx * scalePx * costShare;
}

void Alignment::collectRows(const CentroidPose& pose, double scalePx, std::vector<ResidualRow>& rows) const
{
    rows.clear();
    rows.reserve(points_.size());
    const double perSquaredScale = -0.5 / (scalePx * scalePx);
    PointInCamera seen;
    Match found;
    for (const AlignmentPoint& point : points_) {
        ResidualRow row;
        row.branchIndex = point.branchIndex;
        if (match(point, pose, cutOff * scalePx, seen, found)) {
            const double v = visibility_[static_cast<std::size_t>(point.branchIndex)];
            row.weight = v * v * found.gate * std::exp(perSquaredScale * found.squaredDistance);
            row.residual = found.residual;
            row.fromCentroid = seen.turned;
            row.gradient = distanceGradient(camera_, seen, found.normalX, found.normalY);
            row.cameraGradient = cameraGradient(seen, found);
        }
        rows.push_back(row);
    }
}

void Alignment::collectAgreement(const CentroidPose& pose, double scalePx, std::vector<double>& agreement) const
{
    agreement.clear();
    agreement.reserve(points_.size());
    const double perSquaredScale = -0.5 / (scalePx * scalePx);
    PointInCamera seen;
    Match found;
    for (const AlignmentPoint& point : points_) {
        const auto pixel = project(camera_, pose.rotation * point.fromCentroid + pose.centroidInCamera);
        if (!pixel || !isInImage(camera_, *pixel)) {
            agreement.push_back(std::numeric_limits<double>::quiet_NaN());
        } else if (match(point, pose, cutOff * scalePx, seen, found)) {
            agreement.push_back(found.gate * std::exp(perSquaredScale * found.squaredDistance));
        } else {
            agreement.push_back(0.0);
        }
    }
}

void Alignment::collectResiduals(const CentroidPose& pose, double limitPx, std::vector<double>& residuals) const
{
    residuals.clear();
    residuals.reserve(points_.size());
    PointInCamera seen;
    Match found;
    for (const AlignmentPoint& point : points_) {
        const bool agrees = match(point, pose, limitPx, seen, found) && found.gate > agreeingGate;
        residuals.push_back(agrees ? found.residual : std::numeric_limits<double>::quiet_NaN());
    }
}

double Alignment::medianDistancePx(const CentroidPose& pose, std::vector<double>& scratch) const
{
    scratch.clear();
    scratch.reserve(points_.size());
    for (const AlignmentPoint& point : points_) {
        const auto pixel = project(camera_, pose.rotation * point.fromCentroid + pose.centroidInCamera);
        scratch.push_back(
            pixel ? TargetLines::squaredDistance(target_->nearest(pixel->x(), pixel->y()), pixel->x(), pixel->y())
                  : std::numeric_limits<double>::infinity());
    }
    const auto middle = scratch.begin() + static_cast<std::ptrdiff_t>(scratch.size() / 2);
    std::nth_element(scratch.begin(), middle, scratch.end());
    return std::sqrt(*middle);
}

}   // namespace angiopose::core
