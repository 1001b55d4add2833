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

    bool find(const TargetLines& target, const PointInCamera& projected, double limitPx)
    {
        line = &target.nearest(projected.u, projected.v);
        du = projected.u - line->x;
        dv = projected.v - line->y;
        squaredDistance = du * du + dv * dv;
        return squaredDistance <= limitPx * limitPx;
    }

    void compare(const PointInCamera& projected)
    {
        const double cosine = projected.su * line->tx + projected.sv * line->ty;
        // Orients the normal to the same side of the branch, whether the curve was traced forward or backward.
        const double side = cosine < 0.0 ? -1.0 : 1.0;
        normalX = -side * line->ty;
        normalY = side * line->tx;
        residual = normalX * du + normalY * dv;
        gate = projected.hasDirection ? cosine * cosine * cosine * cosine : 1.0;
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
    buffers_.evaluations.current.branchWeight.reserve(pointCount_.size());
    buffers_.evaluations.next.branchWeight.reserve(pointCount_.size());
    buffers_.residuals.reserve(points_.size());
}

inline bool Alignment::match(const AlignmentPoint& point, const CentroidPose& pose, double limitPx,
                             PointInCamera& projected, Match& match) const
{
    if (!projectPoint(camera_, point, pose, projected) || !match.find(*target_, projected, limitPx)) {
        return false;
    }
    projectDirection(camera_, point, pose, projected);
    match.compare(projected);
    return true;
}

/// Returns d(residual) / d(log focal length, cx px, cy px).
inline Eigen::Vector3d Alignment::cameraGradient(const PointInCamera& projected, const Match& found) const
{
    const double along = found.normalX * (projected.u - camera_.cx) + found.normalY * (projected.v - camera_.cy);
    return {along, found.normalX, found.normalY};
}

AlignmentEvaluation Alignment::evaluate(const CentroidPose& pose, double scalePx) const
{
    AlignmentEvaluation agreement;
    evaluate(pose, scalePx, agreement);
    return agreement;
}

/// Accumulates the residuals of all points, using the match that `matched` returns for each.
template <class Matched>
inline void Alignment::addForwardMatches(double scalePx, const Matched& matched, AlignmentEvaluation& agreement) const
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
        const PointInCamera* projected = matched(i, found);
        if (projected == nullptr) {
            continue;
        }
        const double agreeing = found.gate * std::exp(perSquaredScale * found.squaredDistance);
        const double weight = importance * agreeing;
        agreement.branchWeight[branch] += agreeing;
        costShare -= weight;
        addRow(weight, found.residual, distanceGradient(camera_, *projected, found.normalX, found.normalY),
               agreement.equations);
    }
    for (std::size_t b = 0; b < pointCount_.size(); ++b) {
        agreement.branchWeight[b] /= pointCount_[b];
    }
    agreement.loss = 2.0 * scalePx * scalePx * costShare;
}

void Alignment::evaluate(const CentroidPose& pose, double scalePx, AlignmentEvaluation& agreement) const
{
    PointInCamera projected;
    const auto matched = [&](std::size_t i, Match& found) {
        return match(points_[i], pose, cutOff * scalePx, projected, found) ? &projected : nullptr;
    };
    addForwardMatches(scalePx, matched, agreement);
}

void Alignment::searchBothDirections(const CentroidPose& pose, double scalePx, AlignmentEvaluation& agreement)
{
    std::vector<PointInCamera>& projected = buffers_.reverse.projected();
    projected.resize(points_.size());
    for (std::size_t i = 0; i < points_.size(); ++i) {
        projected[i].isInFront = projectPoint(camera_, points_[i], pose, projected[i]);
        projectDirection(camera_, points_[i], pose, projected[i]);
    }
    const auto matched = [&](std::size_t i, Match& found) -> const PointInCamera* {
        if (!projected[i].isInFront || !found.find(*target_, projected[i], cutOff * scalePx)) {
            return nullptr;
        }
        found.compare(projected[i]);
        return &projected[i];
    };
    addForwardMatches(scalePx, matched, agreement);
    buffers_.reverse.match(*target_, camera_.width, camera_.height, cutOff * scalePx);
    addReverseMatches(scalePx, agreement);
}

void Alignment::addReverseMatches(double scalePx, AlignmentEvaluation& agreement) const
{
    const double perSquaredScale = -0.5 / (scalePx * scalePx);
    double weights = 0.0;
    const auto& lines = target_->lines();
    const std::vector<int>& matches = buffers_.reverse.matches();
    for (std::size_t k = 0; k < matches.size(); ++k) {
        if (matches[k] < 0) {
            continue;
        }
        const TargetLines::Line& line = lines[k * ReverseMatcher::lineStride];
        const auto number = static_cast<std::size_t>(matches[k]);
        const PointInCamera& projected = buffers_.reverse.projected()[number];
        const double visibility = visibility_[static_cast<std::size_t>(points_[number].branchIndex)];
        const double du = projected.u - line.x;
        const double dv = projected.v - line.y;
        const double cosine = projected.su * line.tx + projected.sv * line.ty;
        const double gate = cosine * cosine * cosine * cosine;
        const double weight = ReverseMatcher::lineStride * visibility * visibility * gate *
                              std::exp(perSquaredScale * (du * du + dv * dv));
        weights += weight;
        addRow(weight, projected.su * dv - projected.sv * du,
               distanceGradient(camera_, projected, -projected.sv, projected.su), agreement.equations);
    }
    agreement.loss -= 2.0 * scalePx * scalePx * weights;
}

double Alignment::loss(const CentroidPose& pose, double scalePx) const
{
    const double perSquaredScale = -0.5 / (scalePx * scalePx);
    double costShare = 0.0;
    PointInCamera projected;
    Match found;
    for (const AlignmentPoint& point : points_) {
        const double visibility = visibility_[static_cast<std::size_t>(point.branchIndex)];
        const bool isMatched = match(point, pose, cutOff * scalePx, projected, found);
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
    PointInCamera projected;
    Match found;
    for (const AlignmentPoint& point : points_) {
        ResidualRow row;
        row.branchIndex = point.branchIndex;
        if (match(point, pose, cutOff * scalePx, projected, found)) {
            const double v = visibility_[static_cast<std::size_t>(point.branchIndex)];
            row.weight = v * v * found.gate * std::exp(perSquaredScale * found.squaredDistance);
            row.residual = found.residual;
            row.fromCentroid = projected.rotated;
            row.gradient = distanceGradient(camera_, projected, found.normalX, found.normalY);
            row.cameraGradient = cameraGradient(projected, found);
        }
        rows.push_back(row);
    }
}

void Alignment::collectAgreement(const CentroidPose& pose, double scalePx, std::vector<double>& agreement) const
{
    agreement.clear();
    agreement.reserve(points_.size());
    const double perSquaredScale = -0.5 / (scalePx * scalePx);
    PointInCamera projected;
    Match found;
    for (const AlignmentPoint& point : points_) {
        const auto pixel = project(camera_, pose.rotation * point.fromCentroid + pose.centroidInCamera);
        if (!pixel || !isInImage(camera_, *pixel)) {
            agreement.push_back(std::numeric_limits<double>::quiet_NaN());
        } else if (match(point, pose, cutOff * scalePx, projected, found)) {
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
    PointInCamera projected;
    Match found;
    for (const AlignmentPoint& point : points_) {
        const bool agrees = match(point, pose, limitPx, projected, found) && found.gate > agreeingGate;
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
