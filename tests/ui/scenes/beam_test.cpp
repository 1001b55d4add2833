#include "ui/scenes/beam.h"

#include <gtest/gtest.h>

#include <set>
#include <utility>

using namespace angiopose;

namespace {

constexpr double sizePx = 400.0;

ui::Beam beamOf()
{
    ui::Beam beam;
    beam.camera = {-2500.0, 2500.0, 255.5, 255.5, 512, 512};
    beam.sourceToDetectorMm = 1000.0;
    beam.patientFromCamera.translation = {0.0, 0.0, -750.0};
    return beam;
}

/// View from the side with a vertical beam, `focalPointInPatient` at the center of the image.
ui::ScreenFromPatient fromTheSide(double pxPerMm, const Eigen::Vector3d& focalPointInPatient)
{
    ui::ScreenFromPatient screen;
    screen.rotation << 1.0, 0.0, 0.0, 0.0, 0.0, -1.0, 0.0, 1.0, 0.0;
    screen.focalPoint = focalPointInPatient;
    screen.centerPx = Eigen::Vector2d::Constant(0.5 * sizePx);
    screen.pxPerMm = pxPerMm;
    return screen;
}

ui::StrokeMesh strokesOf(const ui::ScreenFromPatient& screen)
{
    ui::StrokeMesh mesh;
    ui::addBeamStrokes(mesh, beamOf(), screen,
                       {ui::palette(ui::ThemeMode::Dark), Eigen::Vector2d::Constant(sizePx), 1.0});
    return mesh;
}

/// Vertices well inside the image, rounded to a tenth of a px, shifted by `shiftPx`.
std::set<std::pair<long, long>> inside(const ui::StrokeMesh& mesh, const Eigen::Vector2d& shiftPx)
{
    std::set<std::pair<long, long>> places;
    for (std::size_t i = 0; i < mesh.vertexCount(); ++i) {
        const Eigen::Vector2d at = Eigen::Vector2d(mesh.points[3 * i], mesh.points[3 * i + 1]) + shiftPx;
        if ((at.array() > 40.0).all() && (at.array() < sizePx - 40.0).all()) {
            places.emplace(std::lround(10.0 * at.x()), std::lround(10.0 * at.y()));
        }
    }
    return places;
}

TEST(BeamStrokes, TakeNoMoreWorkHoweverFarTheViewIsZoomedIn)
{
    const std::size_t whole = strokesOf(fromTheSide(0.35, {0.0, 0.0, -250.0})).vertexCount();
    const Eigen::Vector3d onAnEdge = 0.5 * (beamOf().source() + beamOf().detectorCorners()[0]);
    for (const double pxPerMm : {10.0, 1e3, 1e5}) {
        const std::size_t near = strokesOf(fromTheSide(pxPerMm, onAnEdge)).vertexCount();
        EXPECT_GT(near, 0U) << pxPerMm;
        EXPECT_LT(near, 2 * whole) << pxPerMm;
    }
}

TEST(BeamStrokes, DashesStayWhereTheyAreWhenTheViewMoves)
{
    const Eigen::Vector3d onAnEdge = 0.5 * (beamOf().source() + beamOf().detectorCorners()[0]);
    constexpr double pxPerMm = 8.0;   // the source is far outside the image
    constexpr double stepMm = 2.5;
    const auto before = inside(strokesOf(fromTheSide(pxPerMm, onAnEdge)), {0.0, -pxPerMm * stepMm});
    const auto after =
        inside(strokesOf(fromTheSide(pxPerMm, onAnEdge - stepMm * Eigen::Vector3d::UnitZ())), {0.0, 0.0});
    std::size_t common = 0;
    for (const auto& place : after) {
        common += before.contains(place) ? 1 : 0;
    }
    ASSERT_GT(after.size(), 100U);
    EXPECT_GT(static_cast<double>(common), 0.85 * static_cast<double>(after.size())) << after.size();
}

}   // namespace
