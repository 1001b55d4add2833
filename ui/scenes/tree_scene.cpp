#include "ui/scenes/tree_scene.h"

#include "core/imaging/display_range.h"
#include "ui/scenes/beam.h"
#include "ui/scenes/frame_quad.h"
#include "ui/scenes/orbit.h"
#include "ui/scenes/orientation_marker.h"
#include "ui/scenes/scan_quad.h"
#include "ui/scenes/stroke_actor.h"
#include "ui/scenes/tree_tubes.h"

#include <vtkCallbackCommand.h>
#include <vtkCamera.h>
#include <vtkMatrix4x4.h>
#include <vtkProperty.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <utility>

namespace angiopose::ui {
namespace {

constexpr double treePickTolerancePx = 7.0;

Eigen::AlignedBox3d boxOf(const core::VesselTree& tree)
{
    Eigen::AlignedBox3d box;
    for (const core::VesselBranch& branch : tree.branches) {
        for (const Eigen::Vector3d& point : branch.pointsInPatient) {
            box.extend(point);
        }
    }
    return box;
}

core::VesselTree cornersOf(const Eigen::AlignedBox3d& box)
{
    core::VesselTree corners;
    corners.branches.emplace_back();
    for (int i = 0; i < 8; ++i) {
        corners.branches.front().pointsInPatient.push_back(box.corner(static_cast<Eigen::AlignedBox3d::CornerType>(i)));
    }
    return corners;
}

/// Returns whether both trees lie in the same place, so that the view can stay, as when a tree is being edited.
bool lieTogether(const core::VesselTree& shown, const core::VesselTree& next)
{
    const Eigen::AlignedBox3d before = boxOf(shown);
    const Eigen::AlignedBox3d after = boxOf(next);
    return !before.isEmpty() && !after.isEmpty() && before.contains(after.center()) && after.contains(before.center());
}

}   // namespace

struct TreeScene::Parts {
    vtkNew<vtkRenderer> ground;   // detector, beam and source, always drawn behind the tree
    vtkNew<vtkRenderer> middle;   // rendering of the scan
    vtkNew<vtkRenderer> front;   // tree
    FrameQuad detector;
    StrokeActor strokes;
    TreeTubes tubes;
    GrayFrame frame;
    GrayFrame detectorPicture;   // shown instead of the frame if set
    ScanQuad scan;
    std::optional<Eigen::AlignedBox3d> scanBox;
    core::VesselTree boxCorners;   // corners of `scanBox` as the points of a branch
    core::VesselTree tree;
    Beam beam;
    BranchMarks marks;
    Palette colors = palette(ThemeMode::Dark);
    double pixelScale = 1.0;
    bool isTreeStale = false;
    bool isGrayStale = false;   // true if the gray range still belongs to the previous frame
    bool isViewStale = true;   // true if the camera must be framed again
    ViewExtent extent = ViewExtent::Everything;
    bool isTouched = false;   // true if the user has rotated, moved or zoomed the view since framing
    double framedAspect = 0.0;   // aspect ratio for which the view was framed
    unsigned long observerTag = 0;

    void showNext(ViewExtent newExtent)
    {
        extent = newExtent;
        isViewStale = true;
    }
    vtkCamera& camera() { return *ground->GetActiveCamera(); }
    ScreenFromPatient screen() const;
    bool isEmpty() const { return tree.branches.empty() && !scanBox; }
    const core::VesselTree& subject() const;   // content to which the view is framed
    void showDetector();
    void update();
    StrokeMesh groundStrokes(const ScreenFromPatient& toScreen) const;
    OrientationMarker sign(const ScreenFromPatient& toScreen) const;
    double detectorScale() const;
};

ScreenFromPatient TreeScene::Parts::screen() const
{
    const int* size = ground->GetSize();
    return screenFromPatient(*ground->GetActiveCamera(), size[0], size[1]);
}

OrientationMarker TreeScene::Parts::sign(const ScreenFromPatient& toScreen) const
{
    return {toScreen, ground->GetSize()[0], pixelScale};
}

double TreeScene::Parts::detectorScale() const
{
    return beam.hasDetector() ? screen().pxPerMm * beam.sourceToDetectorMm / std::abs(beam.camera.fx) : 1.0;
}

StrokeMesh TreeScene::Parts::groundStrokes(const ScreenFromPatient& toScreen) const
{
    StrokeMesh mesh;
    if (isEmpty()) {
        return mesh;   // without vessels or a scan, no beam is shown
    }
    addBeamStrokes(mesh, beam, toScreen, {colors, 2.0 * toScreen.centerPx, pixelScale});
    addOrientationMarker(mesh, sign(toScreen), colors);
    return mesh;
}

const core::VesselTree& TreeScene::Parts::subject() const
{
    return tree.branches.empty() && scanBox ? boxCorners : tree;
}

/// Shows the detector image; at any resolution, the image covers the same area of the detector as the frame.
void TreeScene::Parts::showDetector()
{
    const GrayFrame& shown = detectorPicture.width() > 0 ? detectorPicture : frame;
    const bool isVisible = beam.hasDetector() && shown.width() > 0;
    const double pxPerPx = !isVisible || &shown == &frame ? 1.0 : beam.camera.width / (1.0 * shown.width());
    detector.show(shown, pxPerPx * detectorScale());
    detector.actor()->SetVisibility(isVisible && !isEmpty());
    if (!isVisible) {
        return;
    }
    Eigen::Affine3d larger = Eigen::Affine3d::Identity();
    larger.linear().diagonal() << pxPerPx, pxPerPx, 1.0;
    larger.translation() << 0.5 * (pxPerPx - 1.0), 0.5 * (pxPerPx - 1.0), 0.0;
    vtkNew<vtkMatrix4x4> patientFromImage;
    const Eigen::Matrix<double, 4, 4, Eigen::RowMajor> matrix = beam.patientFromImagePlane() * larger.matrix();
    patientFromImage->DeepCopy(matrix.data());
    detector.actor()->SetUserMatrix(patientFromImage);
}

void TreeScene::Parts::update()
{
    if (std::exchange(isTreeStale, false)) {
        tubes.show(tree, marks, colors);
    }
    if (std::exchange(isGrayStale, false)) {
        frame.setRange(core::displayRange(frame.pixels()));
    }
    const auto back = colors.field.unit();
    ground->SetBackground(back[0], back[1], back[2]);
    showDetector();
    const int* size = ground->GetSize();
    const double aspect = static_cast<double>(size[0]) / std::max(1, size[1]);
    const bool isReshaped = !isTouched && aspect != framedAspect;
    if ((isViewStale || isReshaped) && !isEmpty()) {
        frameBeam(camera(), beam, subject(), aspect, extent);
        framedAspect = aspect;
        isViewStale = false;
        isTouched = false;
    }
    std::array<double, 6> bounds = sceneBounds(beam, subject());
    if (scan.actor()->GetVisibility() != 0) {
        const double* pane = scan.actor()->GetBounds();
        for (std::size_t i = 0; i < 6; i += 2) {
            bounds[i] = std::min(bounds[i], pane[i]);
            bounds[i + 1] = std::max(bounds[i + 1], pane[i + 1]);
        }
    }
    ground->ResetCameraClippingRange(bounds.data());
    strokes.show(groundStrokes(screen()));
}

TreeScene::TreeScene() : parts_(std::make_unique<Parts>())
{
    Parts& p = *parts_;
    p.ground->InteractiveOff();
    p.ground->AddActor(p.detector.actor());
    p.ground->AddActor2D(p.strokes.actor());
    p.detector.actor()->GetProperty()->SetColor(0.55, 0.55, 0.55);   // dimmed so that the tree stands out
    p.middle->SetLayer(1);
    p.middle->InteractiveOff();
    p.middle->AddActor(p.scan.actor());
    p.middle->SetActiveCamera(p.ground->GetActiveCamera());
    p.front->SetLayer(2);
    p.front->AddActor(p.tubes.actor());
    p.front->SetActiveCamera(p.ground->GetActiveCamera());
    vtkNew<vtkCallbackCommand> refresh;
    refresh->SetClientData(parts_.get());
    refresh->SetCallback([](vtkObject*, unsigned long, void* client, void*) { static_cast<Parts*>(client)->update(); });
    p.observerTag = p.ground->AddObserver(vtkCommand::StartEvent, refresh);
}

TreeScene::~TreeScene()
{
    parts_->ground->RemoveObserver(parts_->observerTag);
    if (vtkRenderWindow* window = parts_->ground->GetRenderWindow()) {
        window->RemoveRenderer(parts_->front);
        window->RemoveRenderer(parts_->middle);
        window->RemoveRenderer(parts_->ground);
    }
}

void TreeScene::setTree(const core::VesselTree& tree)
{
    if (!lieTogether(parts_->tree, tree)) {
        parts_->showNext(ViewExtent::Everything);
    }
    parts_->tree = tree;
    parts_->isTreeStale = true;
}

void TreeScene::setCamera(const core::ProjectionCamera& camera, double sourceToDetectorMm)
{
    const bool isFirst = !parts_->beam.hasDetector();
    parts_->beam.camera = camera;
    parts_->beam.sourceToDetectorMm = sourceToDetectorMm;
    if (isFirst) {
        parts_->showNext(ViewExtent::Everything);
    }
}

void TreeScene::setPose(const core::RigidTransform& cameraFromPatient)
{
    parts_->beam.patientFromCamera = cameraFromPatient.inverse();
}

void TreeScene::setFrame(const core::ImageF& frame)
{
    parts_->frame.setPixels(frame);
    parts_->isGrayStale = true;
}

void TreeScene::setDetectorImage(const core::ImageF& image)
{
    parts_->detectorPicture.setPixels(image);
    if (!image.isEmpty()) {
        parts_->detectorPicture.setRange(core::displayRange(image));
    }
}

void TreeScene::setScanBox(const std::optional<Eigen::AlignedBox3d>& boxInPatient)
{
    const bool isFirst = boxInPatient && parts_->isEmpty();
    parts_->scanBox = boxInPatient;
    parts_->boxCorners = boxInPatient ? cornersOf(*boxInPatient) : core::VesselTree();
    if (isFirst) {
        parts_->showNext(ViewExtent::Everything);
    }
}

void TreeScene::setScanRendering(const ScanRendering& image)
{
    parts_->scan.show(image);
}

core::ParallelProjection TreeScene::projection(int maxPx) const
{
    const ScreenFromPatient toScreen = parts_->screen();
    const int* size = parts_->ground->GetSize();
    const double wholePx = std::max(1.0, 1.0 * size[0] * size[1]);
    const double share = std::min(1.0, std::sqrt(maxPx / wholePx));
    const auto sideOf = [share](int px) {   // powers of two would require a separate OpenGL program
        const int side = std::max(3, static_cast<int>(std::lround(share * px)));
        return std::has_single_bit(static_cast<unsigned>(side)) ? side + 1 : side;
    };
    core::ParallelProjection projection;
    projection.centerInPatient = toScreen.focalPoint;
    projection.right = toScreen.rotation.row(0);
    projection.up = toScreen.rotation.row(1);
    projection.mmPerPx = 1.0 / (share * toScreen.pxPerMm);
    projection.width = sideOf(size[0]);
    projection.height = sideOf(size[1]);
    return projection;
}

void TreeScene::setMarks(const BranchMarks& marks)
{
    parts_->isTreeStale = parts_->isTreeStale || !(marks == parts_->marks);
    parts_->marks = marks;
}

void TreeScene::setColors(const Palette& colors)
{
    parts_->colors = colors;
    parts_->isTreeStale = true;
}

void TreeScene::setPixelScale(double devicePxPerPx)
{
    parts_->pixelScale = devicePxPerPx;
}

void TreeScene::attachTo(vtkRenderWindow* window)
{
    window->SetNumberOfLayers(3);
    window->AddRenderer(parts_->ground);
    window->AddRenderer(parts_->middle);
    window->AddRenderer(parts_->front);
}

void TreeScene::nextView()
{
    const bool showsAll = parts_->extent == ViewExtent::Everything && !parts_->isTouched;
    parts_->showNext(showsAll ? ViewExtent::Vessels : ViewExtent::Everything);
}

void TreeScene::reframe()
{
    parts_->isViewStale = parts_->isViewStale || !parts_->isTouched;
}

void TreeScene::turnBy(double rightDeg, double downDeg)
{
    vtkCamera& camera = parts_->camera();
    camera.Azimuth(-rightDeg);
    camera.Elevation(downDeg);
    camera.OrthogonalizeViewUp();
    parts_->isTouched = true;
}

void TreeScene::zoomBy(double factor)
{
    vtkCamera& camera = parts_->camera();
    camera.SetParallelScale(camera.GetParallelScale() / factor);
    parts_->isTouched = true;
}

void TreeScene::panBy(double rightDevicePx, double upDevicePx)
{
    pan(parts_->camera(), parts_->ground->GetSize()[1], rightDevicePx, upDevicePx);
    parts_->isTouched = true;
}

Eigen::Vector2d TreeScene::deviceFromPatient(const Eigen::Vector3d& pointInPatient) const
{
    return parts_->screen() * pointInPatient;
}

std::optional<TreePick> TreeScene::pickAt(int xDevicePx, int yDevicePxFromBottom) const
{
    const ScreenFromPatient toScreen = parts_->screen();
    const Eigen::Vector2d mouse(xDevicePx + 0.5, yDevicePxFromBottom + 0.5);
    std::optional<TreePick> nearest;
    double distance = treePickTolerancePx * parts_->pixelScale;
    for (const core::VesselBranch& branch : parts_->tree.branches) {
        for (const Eigen::Vector3d& point : branch.pointsInPatient) {
            const double candidate = (toScreen * point - mouse).norm();
            if (candidate < distance) {
                distance = candidate;
                nearest = TreePick{branch.id, point};
            }
        }
    }
    return nearest;
}

bool TreeScene::isEmpty() const
{
    return parts_->isEmpty();
}

std::vector<OrientationLetter> TreeScene::orientationLetters() const
{
    return parts_->isEmpty() ? std::vector<OrientationLetter>() : markerLetters(parts_->sign(parts_->screen()));
}

}   // namespace angiopose::ui
