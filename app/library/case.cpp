#include "angiopose/case.h"

#include "app/library/case_content.h"
#include "app/library/conversions.h"
#include "app/library/relay.h"

namespace angiopose {

Case::Case(const VesselTree& tree, const Angiogram& angiogram) : content_(std::make_unique<Content>())
{
    core::RegistrationCase& values = content_->values;
    values.tree = std::make_shared<const core::VesselTree>(library::toCore(tree));
    library::putAngiogram(values, angiogram.content());
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
    return library::toPublic(*content_->values.tree);
}

Angiogram Case::angiogram() const
{
    return Angiogram(content_->values.angiogram);
}

int Case::viewCount() const
{
    return 1 + static_cast<int>(content_->values.otherViews.size());
}

int Case::frame() const
{
    return content_->values.frame;
}

void Case::setFrame(int frame)
{
    const int count = content_->values.angiogram->frameCount();
    if (frame < 0 || frame >= count) {
        throw Error("library.no-frame", "Frame " + std::to_string(frame) + " does not exist: the run has " +
                                            std::to_string(count) + " frames, the first is 0.");
    }
    content_->values = core::withFrame(std::move(content_->values), frame);
}

ProjectionCamera Case::camera() const
{
    return library::toPublic(library::valueOf(core::cameraOf(content_->values)));
}

void Case::setCamera(const ProjectionCamera& camera)
{
    content_->values.cameraOverride = library::toCore(camera);
}

Pose Case::startPose() const
{
    return library::toPublic(library::valueOf(core::startPoseOf(content_->values)));
}

void Case::setStartPose(const Pose& cameraFromPatient)
{
    content_->values.initialCameraFromPatient = library::toCore(cameraFromPatient);
    content_->values.hasInitialPose = true;
    setCameraFromPatient(cameraFromPatient);
}

Pose Case::cameraFromPatient() const
{
    return library::toPublic(content_->values.cameraFromPatient);
}

void Case::setCameraFromPatient(const Pose& cameraFromPatient)
{
    content_->values.cameraFromPatient = library::toCore(cameraFromPatient);
    content_->values.result.reset();
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
    core::RegistrationCase& values = content_->values;
    values.givenTarget = std::make_shared<const core::Centerline2d>(library::toCore(target));
    values.targetFile = {};
    values.editedFrame = values.frame;
    values.acceptedCurveIds.clear();
}

std::vector<Message> Case::warnings() const
{
    return library::toPublic(content_->warnings);
}

}   // namespace angiopose
