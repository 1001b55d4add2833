#include "ui/scenes/overlay_lines.h"

#include "ui/scenes/branch_style.h"
#include "ui/scenes/overlay_pens.h"
#include "ui/scenes/point_colors.h"

#include <algorithm>
#include <vector>

namespace angiopose::ui {
namespace {

using ArcLengths = std::vector<std::array<float, 3>>;

/// Returns for every tree point the lengths along left edge, center and right edge, image px, from the first point of
/// the visible run to which the tree point belongs.
ArcLengths arcLengthsOf(const ProjectedTree& tree, int branchId, std::size_t pointCount)
{
    ArcLengths arcLengths(pointCount, {0.0F, 0.0F, 0.0F});
    const auto branch = std::ranges::find(tree, branchId, &ProjectedBranch::id);
    if (branch == tree.end()) {
        return arcLengths;
    }
    for (const auto& run : branch->runs) {
        std::array<double, 3> lengthPx{};
        for (std::size_t i = 1; i < run.size(); ++i) {
            for (std::size_t k = 0; k < 3; ++k) {
                const double side = 1.0 - static_cast<double>(k);
                lengthPx[k] += (run[i].edgePx(side) - run[i - 1].edgePx(side)).norm();
                arcLengths[run[i].index][k] = static_cast<float>(lengthPx[k]);
            }
        }
    }
    return arcLengths;
}

std::vector<LinePoint> linePointsOf(const core::VesselBranch& branch, const PointColors& colors,
                                    const ArcLengths& arcLengths)
{
    const std::vector<Eigen::Vector3d> directions = vesselDirections(branch.pointsInPatient);
    std::vector<LinePoint> points;
    points.reserve(directions.size());
    for (std::size_t i = 0; i < directions.size(); ++i) {
        points.push_back({branch.pointsInPatient[i], directions[i], branch.radiusMm.empty() ? 0.0 : branch.radiusMm[i],
                          colors.flat(i), arcLengths.empty() ? std::array<float, 3>{} : arcLengths[i]});
    }
    return points;
}

bool hasRadii(const core::VesselBranch& branch)
{
    return std::ranges::any_of(branch.radiusMm, [](double radius) { return radius > 0.0; });
}

void addTreeLine(LineData& lines, const core::VesselBranch& branch, const BranchStyle& style,
                 const OverlayContent& content)
{
    const bool isDashed = style.pattern == LinePattern::Dashed;
    const ArcLengths arcLengths =
        isDashed ? arcLengthsOf(content.projected, branch.id, branch.pointsInPatient.size()) : ArcLengths{};
    lines.add(linePointsOf(branch, PointColors(content, branch.id, style.color), arcLengths),
              {style.widthFactor, style.opacity, isDashed, style.hasEndDots, hasRadii(branch)});
}

}   // namespace

void fillTreeLines(LineData& lines, const OverlayContent& content)
{
    struct Ranked {
        const core::VesselBranch* branch;
        BranchStyle style;
    };
    std::vector<Ranked> ranked;
    for (const core::VesselBranch& branch : content.tree.branches) {
        ranked.push_back({&branch, branchStyle(branch.id, content.marks)});
    }
    std::ranges::stable_sort(ranked, {}, [](const Ranked& entry) { return entry.style.zOrder; });
    lines.clear();
    for (const Ranked& entry : ranked) {
        addTreeLine(lines, *entry.branch, entry.style, content);
    }
    lines.commit();
}

void fillGlowLines(LineData& lines, const OverlayContent& content)
{
    lines.clear();
    for (const core::VesselBranch& branch : content.tree.branches) {
        BranchStyle style = branchStyle(branch.id, content.marks);
        if (style.glow != Glow::None) {
            style.opacity = glowOpacity(style.glow);
            addTreeLine(lines, branch, style, content);
        }
    }
    lines.commit();
}

void fillTracedLines(LineData& lines, const core::Centerline2d& traced, const core::ProjectionCamera& camera)
{
    constexpr double depthMm = 1000.0;
    const Color tone = palette(ThemeMode::Dark).fine;
    lines.clear();
    for (const core::Curve2d& curve : traced.curves) {
        std::vector<LinePoint> points;
        double arcLengthPx = 0.0;
        for (const Eigen::Vector2d& px : curve.pointsPx) {
            arcLengthPx += points.empty() ? 0.0 : (px - curve.pointsPx[points.size() - 1]).norm();
            const Eigen::Vector3d at((px.x() - camera.cx) / camera.fx, (px.y() - camera.cy) / camera.fy, 1.0);
            points.push_back(
                {depthMm * at, Eigen::Vector3d::Zero(), 0.0, tone, {0.0F, static_cast<float>(arcLengthPx), 0.0F}});
        }
        lines.add(points, {.isDashed = true});
    }
    lines.commit();
}

}   // namespace angiopose::ui
