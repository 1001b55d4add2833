#include "angiopose/case.h"

#include "app/library/case_content.h"
#include "app/library/conversions.h"
#include "app/library/observer_adapter.h"
#include "core/messages/messages.h"

namespace angiopose::library {
namespace {

/// Throws if a branch ID is not in the tree, since a case file with that ID could not be opened again.
void checkBranches(const core::VesselTree& tree, const std::vector<int>& ids)
{
    for (const int id : ids) {
        if (tree.find(id) == nullptr) {
            throwError(core::messages::noSuchBranch(id));
        }
    }
}

}   // namespace
}   // namespace angiopose::library

namespace angiopose {

Case::Case(const VesselTree& tree, const Angiogram& angiogram) : content_(std::make_unique<Content>())
{
    core::Case& values = content_->values;
    values.vessels.tree = std::make_shared<const core::VesselTree>(library::toCore(tree));
    if (const auto problem = core::findProblem(*values.vessels.tree)) {
        library::throwError(*problem);
    }
    library::addAngiogram(values, angiogram.content());
}

Case::Case(std::unique_ptr<Content> content) : content_(std::move(content)) {}
Case::Case(const Case& other) : content_(std::make_unique<Content>(*other.content_)) {}
Case::Case(Case&& other) noexcept = default;
Case::~Case() = default;

Case& Case::operator=(Case other) noexcept
{
    content_.swap(other.content_);
    return *this;
}

std::string Case::title() const
{
    return content_->values.title;
}

void Case::setTitle(const std::string& title)
{
    content_->values.title = title;
}

VesselTree Case::tree() const
{
    return library::toPublic(*content_->values.vessels.tree);
}

Angiogram Case::angiogram() const
{
    return Angiogram(content_->values.shown().angiogram);
}

int Case::viewCount() const
{
    return static_cast<int>(content_->values.views.size());
}

int Case::frame() const
{
    return content_->values.shown().frame;
}

void Case::setFrame(int frame)
{
    const int count = content_->values.shown().angiogram->frameCount();
    if (frame < 0 || frame >= count) {
        throw Error("library.no-frame", "Frame " + std::to_string(frame) + " does not exist: the run has " +
                                            std::to_string(count) + " frames, the first is 0.");
    }
    core::View& view = content_->values.shown();
    view = core::withFrame(std::move(view), frame);
}

ProjectionCamera Case::camera() const
{
    return library::toPublic(library::valueOf(core::cameraOf(content_->values.shown())));
}

void Case::setCamera(const ProjectionCamera& camera)
{
    core::View view = content_->values.shown();
    view.geometry.cameraOverride = library::toCore(camera);
    library::valueOf(core::cameraOf(view));   // throws if the camera is invalid for this image
    core::discardResults(view);
    content_->values.shown() = std::move(view);
}

CArm Case::cArm() const
{
    return library::toPublic(content_->values.shown().geometry.cArm);
}

void Case::setCArm(const CArm& cArm)
{
    core::View& view = content_->values.shown();
    view.geometry = {library::toCore(cArm), {}};
    view.initialCameraFromPatient.reset();
    core::discardResults(view);
    if (const auto start = core::initialPoseOf(content_->values)) {
        view.cameraFromPatient = start.value();
    }
}

Pose Case::initialPose() const
{
    return library::toPublic(library::valueOf(core::initialPoseOf(content_->values)));
}

void Case::setInitialPose(const Pose& cameraFromPatient)
{
    content_->values.shown().initialCameraFromPatient = library::toCore(cameraFromPatient);
    setCameraFromPatient(cameraFromPatient);
}

Pose Case::cameraFromPatient() const
{
    return library::toPublic(content_->values.shown().cameraFromPatient);
}

void Case::setCameraFromPatient(const Pose& cameraFromPatient)
{
    content_->values.shown().cameraFromPatient = library::toCore(cameraFromPatient);
    core::discardResults(content_->values.shown());
}

RegistrationOptions Case::options() const
{
    return library::toPublic(content_->values.options);
}

void Case::setOptions(const RegistrationOptions& options)
{
    content_->values.options = library::toCore(options);
}

void Case::setTarget(const Centerline2d& target)
{
    core::View& view = content_->values.shown();
    view.target = {{}, std::make_shared<const core::Centerline2d>(library::toCore(target)), view.frame, {}};
}

TraceOptions Case::traceOptions() const
{
    return library::toPublic(content_->values.shown().traceOptions);
}

void Case::setTraceOptions(const TraceOptions& options)
{
    content_->values.shown().traceOptions = library::toCore(options);
}

std::vector<int> Case::excludedBranchIds() const
{
    return content_->values.vessels.excludedBranchIds;
}

void Case::setExcludedBranchIds(const std::vector<int>& ids)
{
    library::checkBranches(*content_->values.vessels.tree, ids);
    content_->values.vessels.excludedBranchIds = ids;
}

std::vector<int> Case::auxiliaryBranchIds() const
{
    return content_->values.vessels.auxiliaryBranchIds;
}

void Case::setAuxiliaryBranchIds(const std::vector<int>& ids)
{
    library::checkBranches(*content_->values.vessels.tree, ids);
    content_->values.vessels.auxiliaryBranchIds = ids;
}

std::vector<Message> Case::warnings() const
{
    return library::toPublic(content_->warnings);
}

}   // namespace angiopose
