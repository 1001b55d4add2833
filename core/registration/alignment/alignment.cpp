#include "core/registration/alignment/alignment.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace angiopose::core {
namespace {

constexpr double endOnShare = 0.3;   // shorter projected tangents say nothing about direction (§6.3)
constexpr double agreeingGate = 0.5;   // within 33°
constexpr std::size_t reverseStride = 2;   // neighbouring lines share their noise: every second one stands for two
constexpr double cutOff = 4.0;   // beyond 4 ℓ a Welsch weight is below 4e-4: nothing

AlignmentPoint alignmentPoint(const TreeSamples& tree, std::size_t i)
{
    return {tree.points[i] - tree.centroid, tree.tangents[i], tree.branchIndex[i]};
}

bool isInImage(const ProjectionCamera& camera, const Eigen::Vector2d& pixel)
{
    return pixel.x() >= -0.5 && pixel.y() >= -0.5 && pixel.x() <= camera.width - 0.5 &&
           pixel.y() <= camera.height - 0.5;
}

/// Adds w r² to the model; only the lower triangle of its Hessian.
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

/// A tree point and the line it is compared with.
struct Alignment::Match {
    Eigen::Vector3d turned;   ///< from the centroid, camera axes
    Eigen::Vector3d inCamera;
    double normalX, normalY;   ///< of the line
    double residual;   ///< along the normal
    double squaredDistance;
    double gate;   ///< cos⁴ between the directions
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
    buffers_.looks.here.branchWeight.reserve(pointCount_.size());
    buffers_.looks.there.branchWeight.reserve(pointCount_.size());
    buffers_.residuals.reserve(points_.size());
}

inline bool Alignment::match(const AlignmentPoint& point, const CentroidPose& pose, double limitPx, Match& match) const
{
    match.turned.noalias() = pose.rotation * point.fromCentroid;
    match.inCamera = match.turned + pose.centroidInCamera;
    const Eigen::Vector3d& X = match.inCamera;
    if (!(X.z() >= minProjectableDepthMm)) {
        return false;
    }
    const double perDepth = 1.0 / X.z();
    const double u = camera_.fx * X.x() * perDepth + camera_.cx;
    const double v = camera_.fy * X.y() * perDepth + camera_.cy;
    const TargetLines::Line& line = target_->nearest(u, v);
    const double du = u - line.x;
    const double dv = v - line.y;
    match.squaredDistance = du * du + dv * dv;
    if (match.squaredDistance > limitPx * limitPx) {
        return false;
    }
    const Eigen::Vector3d tangent = pose.rotation * point.tangent;
    const double su = camera_.fx * (tangent.x() - X.x() * perDepth * tangent.z());
    const double sv = camera_.fy * (tangent.y() - X.y() * perDepth * tangent.z());
    const double squaredLength = su * su + sv * sv;
    const double shortest = endOnShare * camera_.fy;
    const double along = su * line.tx + sv * line.ty;
    // The normal points to the same side of the branch however the curve was traced.
    const double side = along < 0.0 ? -1.0 : 1.0;
    match.normalX = -side * line.ty;
    match.normalY = side * line.tx;
    match.residual = match.normalX * du + match.normalY * dv;
    const double squaredCosine = squaredLength < shortest * shortest ? 1.0 : along * along / squaredLength;
    match.gate = squaredCosine * squaredCosine;
    return true;
}

/// d(residual) / d(rotation rad, shift mm).
inline Vector6d Alignment::residualGradient(const Match& found) const
{
    const Eigen::Vector3d& X = found.inCamera;
    const double perDepth = 1.0 / X.z();
    const double ax = found.normalX * camera_.fx * perDepth;
    const double ay = found.normalY * camera_.fy * perDepth;
    const Eigen::Vector3d a(ax, ay, -(ax * X.x() + ay * X.y()) * perDepth);
    Vector6d J;
    J << found.turned.cross(a), a;
    return J;
}

/// d(residual) / d(log of the focal length, cx px, cy px).
inline Eigen::Vector3d Alignment::cameraGradient(const Match& found) const
{
    const Eigen::Vector3d& X = found.inCamera;
    const double u = camera_.fx * X.x() / X.z();
    const double v = camera_.fy * X.y() / X.z();
    return {found.normalX * u + found.normalY * v, found.normalX, found.normalY};
}

Agreement Alignment::look(const CentroidPose& pose, double scalePx) const
{
    Agreement agreement;
    look(pose, scalePx, agreement);
    return agreement;
}

void Alignment::look(const CentroidPose& pose, double scalePx, Agreement& agreement) const
{
    agreement.equations = {};
    agreement.branchWeight.assign(visibility_.size(), 0.0);
    const double perSquaredScale = -0.5 / (scalePx * scalePx);
    double costShare = 0.0;
    Match found;
    for (const AlignmentPoint& point : points_) {
        const auto branch = static_cast<std::size_t>(point.branchIndex);
        const double importance = visibility_[branch] * visibility_[branch];
        costShare += importance;
        if (!match(point, pose, cutOff * scalePx, found)) {
            continue;
        }
        const double agreeing = found.gate * std::exp(perSquaredScale * found.squaredDistance);
        const double weight = importance * agreeing;
        agreement.branchWeight[branch] += agreeing;
        costShare -= weight;
        addRow(weight, found.residual, residualGradient(found), agreement.equations);
    }
    for (std::size_t b = 0; b < pointCount_.size(); ++b) {
        agreement.branchWeight[b] /= pointCount_[b];
    }
    agreement.loss = 2.0 * scalePx * scalePx * costShare;
}

void Alignment::projectPoints(const CentroidPose& pose, double reachPx)
{
    buffers_.projected.reserve(points_.size());
    buffers_.projected.restart(camera_.width, camera_.height, reachPx);
    for (std::size_t i = 0; i < points_.size(); ++i) {
        const Eigen::Vector3d X = pose.rotation * points_[i].fromCentroid + pose.centroidInCamera;
        const auto pixel = project(camera_, X);
        if (!pixel) {
            continue;
        }
        const Eigen::Vector3d tangent = pose.rotation * points_[i].tangent;
        const double su = camera_.fx * (tangent.x() - X.x() / X.z() * tangent.z());
        const double sv = camera_.fy * (tangent.y() - X.y() / X.z() * tangent.z());
        const double length = std::hypot(su, sv);
        if (length >= endOnShare * camera_.fy) {
            buffers_.projected.add({pixel->x(), pixel->y(), su / length, sv / length, static_cast<int>(i)});
        }
    }
}

void Alignment::addReverse(const CentroidPose& pose, double scalePx, Agreement& agreement)
{
    projectPoints(pose, cutOff * scalePx);
    const double perSquaredScale = -0.5 / (scalePx * scalePx);
    double weights = 0.0;
    Match match;
    const auto& lines = target_->lines();
    for (std::size_t j = 0; j < lines.size(); j += reverseStride) {
        const TargetLines::Line& line = lines[j];
        const ProjectedPoint* nearest = buffers_.projected.nearest(line.x, line.y);
        if (nearest == nullptr) {
            continue;
        }
        const AlignmentPoint& point = points_[static_cast<std::size_t>(nearest->number)];
        const double visibility = visibility_[static_cast<std::size_t>(point.branchIndex)];
        const double du = nearest->u - line.x;
        const double dv = nearest->v - line.y;
        const double cosine = nearest->su * line.tx + nearest->sv * line.ty;
        const double gate = cosine * cosine * cosine * cosine;
        const double weight =
            reverseStride * visibility * visibility * gate * std::exp(perSquaredScale * (du * du + dv * dv));
        weights += weight;
        match.turned = pose.rotation * point.fromCentroid;
        match.inCamera = match.turned + pose.centroidInCamera;
        match.normalX = -nearest->sv;
        match.normalY = nearest->su;
        addRow(weight, match.normalX * du + match.normalY * dv, residualGradient(match), agreement.equations);
    }
    agreement.loss -= 2.0 * scalePx * scalePx * weights;
}

double Alignment::loss(const CentroidPose& pose, double scalePx) const
{
    const double perSquaredScale = -0.5 / (scalePx * scalePx);
    double costShare = 0.0;
    Match found;
    for (const AlignmentPoint& point : points_) {
        const double visibility = visibility_[static_cast<std::size_t>(point.branchIndex)];
        const bool isMatched = match(point, pose, cutOff * scalePx, found);
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
    Match found;
    for (const AlignmentPoint& point : points_) {
        ResidualRow row;
        row.branchIndex = point.branchIndex;
        if (match(point, pose, cutOff * scalePx, found)) {
            const double v = visibility_[static_cast<std::size_t>(point.branchIndex)];
            row.weight = v * v * found.gate * std::exp(perSquaredScale * found.squaredDistance);
            row.residual = found.residual;
            row.fromCentroid = found.turned;
            row.gradient = residualGradient(found);
            row.cameraGradient = cameraGradient(found);
        }
        rows.push_back(row);
    }
}

void Alignment::collectAgreement(const CentroidPose& pose, double scalePx, std::vector<double>& agreement) const
{
    agreement.clear();
    agreement.reserve(points_.size());
    const double perSquaredScale = -0.5 / (scalePx * scalePx);
    Match found;
    for (const AlignmentPoint& point : points_) {
        const auto pixel = project(camera_, pose.rotation * point.fromCentroid + pose.centroidInCamera);
        if (!pixel || !isInImage(camera_, *pixel)) {
            agreement.push_back(std::numeric_limits<double>::quiet_NaN());
        } else if (match(point, pose, cutOff * scalePx, found)) {
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
    Match found;
    for (const AlignmentPoint& point : points_) {
        const bool agrees = match(point, pose, limitPx, found) && found.gate > agreeingGate;
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

std::size_t strideFor(std::size_t count, std::size_t wanted)
{
    return std::max<std::size_t>(1, (count + wanted - 1) / wanted);
}

std::vector<AlignmentPoint> alignmentPoints(const TreeSamples& tree, std::size_t stride)
{
    std::vector<AlignmentPoint> points;
    points.reserve(tree.size() / stride + 1);
    for (std::size_t i = stride / 2; i < tree.size(); i += stride) {
        points.push_back(alignmentPoint(tree, i));
    }
    return points;
}

std::vector<AlignmentPoint> tellingPoints(const TreeSamples& tree, double mmPerPx)
{
    const double leastMm = tellingSpacingPx * mmPerPx;
    std::vector<AlignmentPoint> points;
    points.reserve(tree.size());
    std::size_t last = 0;
    for (std::size_t i = 0; i < tree.size(); ++i) {
        if (i == 0 || tree.branchIndex[i] != tree.branchIndex[last] ||
            (tree.points[i] - tree.points[last]).squaredNorm() >= leastMm * leastMm) {
            points.push_back(alignmentPoint(tree, i));
            last = i;
        }
    }
    return points;
}

std::vector<AlignmentPoint> alignmentPoints(const TreeSamples& tree, const std::vector<int>& numbers)
{
    std::vector<AlignmentPoint> points;
    points.reserve(numbers.size());
    for (const int number : numbers) {
        points.push_back(alignmentPoint(tree, static_cast<std::size_t>(number)));
    }
    return points;
}

}   // namespace angiopose::core