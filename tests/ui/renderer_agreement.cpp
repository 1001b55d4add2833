#include "tests/ui/renderer_agreement.h"

#include "core/imaging/display_range.h"
#include "core/simulation/simulated_case.h"
#include "ui/scenes/overlay_painter.h"
#include "ui/scenes/overlay_strokes.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <memory>

namespace angiopose::test {
namespace {

struct Picture {
    int width, height;
    std::vector<std::uint32_t> pixels;

    Picture(int w, int h) : width(w), height(h), pixels(static_cast<std::size_t>(w) * static_cast<std::size_t>(h)) {}
    ui::Canvas canvas() { return {pixels.data(), width, height}; }
    std::uint32_t at(int x, int y) const
    {
        return pixels[static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x)];
    }
};

int channel(std::uint32_t pixel, int index)
{
    return static_cast<int>((pixel >> (8 * index)) & 0xFFU);
}

int difference(std::uint32_t a, std::uint32_t b)
{
    int largest = 0;
    for (int k = 0; k < 3; ++k) {
        largest = std::max(largest, std::abs(channel(a, k) - channel(b, k)));
    }
    return largest;
}

/// Whether a rendering of the overlay alone changes between a pixel and its neighbors.
bool isEdge(const Picture& plain, int x, int y)
{
    constexpr int flat = 4;
    for (int dy = -1; dy <= 1; ++dy) {
        for (int dx = -1; dx <= 1; ++dx) {
            const int nx = std::clamp(x + dx, 0, plain.width - 1);
            const int ny = std::clamp(y + dy, 0, plain.height - 1);
            if (difference(plain.at(x, y), plain.at(nx, ny)) > flat) {
                return true;
            }
        }
    }
    return false;
}

/// Brightness added by the overlay at a position, interpolated linearly between pixel centers; x, y in px, pixel k
/// covers k … k + 1.
double lightAt(const Picture& picture, const Eigen::Vector2d& at, std::uint32_t ground)
{
    const auto light = [&](int x, int y) {
        const std::uint32_t pixel =
            picture.at(std::clamp(x, 0, picture.width - 1), std::clamp(y, 0, picture.height - 1));
        double sum = 0.0;
        for (int k = 0; k < 3; ++k) {
            sum += channel(pixel, k) - channel(ground, k);
        }
        return sum;
    };
    const double x = at.x() - 0.5;
    const double y = at.y() - 0.5;
    const int x0 = static_cast<int>(std::floor(x));
    const int y0 = static_cast<int>(std::floor(y));
    const double fx = x - x0;
    const double fy = y - y0;
    return (1.0 - fy) * ((1.0 - fx) * light(x0, y0) + fx * light(x0 + 1, y0)) +
           fy * ((1.0 - fx) * light(x0, y0 + 1) + fx * light(x0 + 1, y0 + 1));
}

/// Center of a line's light across the line, in px from `at`, and its amount.
struct CrossSection {
    double middle = 0.0;
    double light = 0.0;
};

CrossSection crossSection(const Picture& picture, const Eigen::Vector2d& at, const Eigen::Vector2d& across,
                          double reachPx, std::uint32_t ground)
{
    CrossSection section;
    for (double t = -reachPx; t <= reachPx; t += 0.125) {
        const double light = lightAt(picture, at + t * across, ground);
        section.middle += t * light;
        section.light += light;
    }
    section.middle /= section.light;
    return section;
}

/// Whether the lines at this point are isolated: no other part of the tree is near, and the vessel does not run toward
/// the viewer, where its points coincide.
bool isClear(const ui::ProjectedTree& tree, const ui::ProjectedBranch& branch,
             const std::vector<ui::ProjectedPoint>& run, std::size_t at, double roomPx)
{
    const Eigen::Vector2d& here = run[at].px;
    const Eigen::Vector2d in = here - run[at - 2].px;
    const Eigen::Vector2d out = run[at + 2].px - here;
    if (in.norm() < 1.5 || out.norm() < 1.5 || in.normalized().dot(out.normalized()) < 0.9) {
        return false;
    }
    for (const ui::ProjectedBranch& other : tree) {
        for (const auto& others : other.runs) {
            for (std::size_t i = 0; i < others.size(); ++i) {
                const bool isSame = &other == &branch && &others == &run &&
                                    (others[i].px - here).norm() < 2.0 * roomPx && i + 12 > at && i < at + 12;
                if (!isSame && (others[i].px - here).norm() < roomPx + others[i].radiusPx) {
                    return false;
                }
            }
        }
    }
    return true;
}

/// Compares every drawn line of the tree at several of its points.
void compareLines(const ui::OverlayContent& content, const Picture& a, const Picture& b, Agreement& agreement)
{
    const ui::DeviceFromImage device{content.viewRect, a.width, a.height};
    const std::uint32_t ground = ui::packColor(ui::palette(ui::ThemeMode::Dark).canvas);
    const double reachPx = 1.0 + 0.8 * content.lineWidthPx;
    const bool isCenter = content.mode == ui::OverlayMode::Centerline;
    for (const ui::ProjectedBranch& branch : content.projected) {
        for (const auto& run : branch.runs) {
            for (std::size_t i = 2; i + 2 < run.size(); i += 3) {
                if (!isClear(content.projected, branch, run, i, run[i].radiusPx + 2.0 * reachPx / device.scale())) {
                    continue;
                }
                for (const double side : isCenter ? std::vector<double>{0.0} : std::vector<double>{1.0, -1.0}) {
                    Eigen::Vector2d at = device * run[i].edgePx(side);
                    at.y() = a.height - at.y();
                    const Eigen::Vector2d across(-run[i].along.y(), run[i].along.x());
                    const CrossSection one = crossSection(a, at, across, reachPx, ground);
                    const CrossSection other = crossSection(b, at, across, reachPx, ground);
                    const bool isSeen = at.minCoeff() > 2.0 * reachPx && at.maxCoeff() < a.width - 2.0 * reachPx &&
                                        one.light > 8.0 * 200.0 * content.opacity;
                    if (!isSeen) {
                        continue;
                    }
                    ++agreement.lineSamples;
                    const double shift = std::abs(one.middle - other.middle);
                    if (shift > agreement.lineShiftPx) {
                        agreement.lineShiftPx = shift;
                        agreement.worstLineAt = at;
                    }
                }
            }
        }
    }
}

void compareGrays(const std::vector<const Picture*>& plain, const Picture& a, const Picture& b, Agreement& agreement)
{
    std::size_t edges = 0;
    for (int y = 0; y < a.height; ++y) {
        for (int x = 0; x < a.width; ++x) {
            if (std::ranges::any_of(plain, [&](const Picture* each) { return isEdge(*each, x, y); })) {
                ++edges;
                continue;
            }
            if (const int here = difference(a.at(x, y), b.at(x, y)); here > agreement.grayDifference) {
                agreement.grayDifference = here;
                agreement.worstGrayAt = {x, y};
            }
        }
    }
    agreement.edgeShare = static_cast<double>(edges) / static_cast<double>(a.pixels.size());
}

std::map<int, std::vector<double>> residualsOf(const core::VesselTree& tree)
{
    std::map<int, std::vector<double>> residuals;
    for (const core::VesselBranch& branch : tree.branches) {
        std::vector<double>& of = residuals[branch.id];
        for (std::size_t i = 0; i < branch.pointsInPatient.size(); ++i) {
            of.push_back(6.0 + 6.0 * std::sin(0.1 * static_cast<double>(i) + branch.id));
        }
    }
    return residuals;
}

/// Sets up the common starting point of all states of a case.
void showCase(ui::OverlayScene& scene, const core::SimulatedCase& simulated, int step)
{
    const core::ImageF& frame = simulated.angiogram.frames[simulated.angiogram.frames.size() / 2];
    const core::DisplayRange range = core::displayRange(frame);
    scene.setFrame(frame);
    scene.setWindowLevel(range.window(), range.level());
    scene.setTree(simulated.tree);
    scene.setCamera(simulated.camera);
    core::RigidTransform pose = simulated.trueCameraFromPatient;
    pose.translation += Eigen::Vector3d(2.5 * step, -1.5 * step, 4.0 * step);
    pose.rotation = Eigen::AngleAxisd(0.05 * step, Eigen::Vector3d(0.3, 0.8, 0.5).normalized()) * pose.rotation;
    scene.setPose(pose);
    scene.setViewRect({-0.5, frame.width - 0.5, -0.5, frame.height - 0.5});
}

ui::BranchMarks marksOf(const core::VesselTree& tree)
{
    const auto id = [&tree](std::size_t i) { return tree.branches[i % tree.branches.size()].id; };
    return {id(1), {id(3)}, {id(0), id(5)}, {id(2), id(7)}, {}};
}

core::ImageF drrOf(const core::ImageF& contrast)
{
    core::ImageF drr = contrast;
    std::ranges::transform(drr.pixels, drr.pixels.begin(), [](float gray) { return std::abs(gray); });
    return drr;
}

}   // namespace

std::vector<OverlayState> overlayStates(std::uint64_t seed)
{
    const auto simulated = std::make_shared<const core::SimulatedCase>(core::simulateCase(seed));
    const auto state = [&](const std::string& name, int step, const std::function<void(ui::OverlayScene&)>& dress) {
        return OverlayState{name, [simulated, step, dress](ui::OverlayScene& scene) {
                                showCase(scene, *simulated, step);
                                dress(scene);
                            }};
    };
    const core::SimulatedCase& c = *simulated;
    return {
        state("centrelines", 0, [](ui::OverlayScene&) {}),
        state("marks", 1, [&c, simulated](ui::OverlayScene& s) { s.setMarks(marksOf(c.tree)); }),
        state("outlines", 2, [](ui::OverlayScene& s) { s.setMode(ui::OverlayMode::Outline); }),
        state("tubes, 70 %", 3,
              [&c, simulated](ui::OverlayScene& s) {
                  s.setMode(ui::OverlayMode::Tube);
                  s.setOpacity(0.7);
                  s.setMarks({{}, {c.tree.branches.front().id}, {}, {}, {}});
              }),
        state("depth, traced", 4,
              [&c, simulated](ui::OverlayScene& s) {
                  s.setDepthCue(ui::DepthCue::NearBright);
                  s.setTracedCenterline(c.trueTarget);
                  s.showTracedCenterline(true);
              }),
        state("residuals, zoomed", -1,
              [&c, simulated](ui::OverlayScene& s) {
                  s.setResiduals(residualsOf(c.tree), 10.0);
                  s.setViewRect({120.3, 320.7, 90.1, 290.5});
              }),
        state("radiograph, lens", -2,
              [&c, simulated](ui::OverlayScene& s) {
                  s.setDrr(drrOf(c.trueContrast));
                  s.setCutout({ui::Cutout::Shape::Disc, {230.0, 260.0}, 70.0});
              }),
        state("shrunk, inverted, swipe", -3,
              [](ui::OverlayScene& s) {
                  s.setInverted(true);
                  s.setViewRect({-200.0, 900.0, -300.0, 800.0});
                  s.setCutout({ui::Cutout::Shape::RightOf, {330.0, 0.0}, 0.0});
              }),
    };
}

Agreement agreementOf(const OverlayState& state, ui::GlOverlay& gl, int sizePx, double scale,
                      const std::function<void(ui::OverlayScene&)>& disturb)
{
    ui::OverlayScene scene;
    ui::OverlayScene disturbed;
    for (ui::OverlayScene* each : {&scene, &disturbed}) {
        state.apply(*each);
        each->setLineWidthPx(2.4 * scale);
    }
    if (disturb) {
        disturb(disturbed);
    }
    ui::OverlayPainter painter;
    Picture a(sizePx, sizePx), b(sizePx, sizePx), plain(sizePx, sizePx), plainOther(sizePx, sizePx);
    painter.draw(scene, a.canvas());
    gl.draw(disturbed, false, {}, b.canvas());
    Agreement agreement;
    Picture brightPlain(sizePx, sizePx);
    scene.setFrame(core::ImageF(512, 512, 1.0F));   // bright background, because halos are dark
    scene.setInverted(false);
    scene.setWindowLevel(1.0, 0.7);
    painter.draw(scene, brightPlain.canvas());
    for (ui::OverlayScene* each : {&scene, &disturbed}) {
        each->setFrame({});
    }
    painter.draw(scene, plain.canvas());
    gl.draw(disturbed, false, {}, plainOther.canvas());
    compareGrays({&brightPlain, &plain, &plainOther}, a, b, agreement);
    for (ui::OverlayScene* each : {&scene, &disturbed}) {
        each->showTracedCenterline(false);
    }
    painter.draw(scene, plain.canvas());
    gl.draw(disturbed, false, {}, plainOther.canvas());
    compareLines(scene.content(), plain, plainOther, agreement);
    return agreement;
}

}   // namespace angiopose::test
