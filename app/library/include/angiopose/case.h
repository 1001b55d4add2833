#pragma once

#include "angiopose/angiogram.h"
#include "angiopose/error.h"
#include "angiopose/export.h"
#include "angiopose/registration.h"
#include "angiopose/vessel_tree.h"

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace angiopose {

/// What a case file holds: vessels, one or more angiograms of them (views), geometry, poses, options. A value: copies
/// share the images and go their own ways otherwise. Functions speak of the first view unless they say more.
class ANGIOPOSE_EXPORT Case {
public:
    /// Vessels in an angiogram. The start pose is that of the C-arm about its isocentre, else the vessels' centroid,
    /// where the geometry tells it, else `setStartPose` must. Begins at the angiogram's suggested frame.
    Case(const VesselTree& tree, const Angiogram& angiogram);

    Case(const Case& other);
    Case(Case&& other) noexcept;
    Case& operator=(Case other) noexcept;
    ~Case();

    std::string title() const;
    void setTitle(const std::string& title);
    VesselTree tree() const;
    Angiogram angiogram() const;
    int viewCount() const;
    int frame() const;
    void setFrame(int frame);   ///< poses turn along where the gantry did
    ProjectionCamera camera() const;
    void setCamera(const ProjectionCamera& camera);   ///< of the angiogram's size; in place of what the C-arm tells
    CArm cArm() const;
    void setCArm(const CArm& cArm);   ///< camera and start pose follow from it, whatever was set before
    Pose startPose() const;
    void setStartPose(const Pose& cameraFromPatient);   ///< moves the current pose there too
    Pose cameraFromPatient() const;   ///< where the vessels are now; registrations begin here
    void setCameraFromPatient(const Pose& cameraFromPatient);
    RegistrationOptions options() const;
    void setOptions(const RegistrationOptions& options);
    void setTarget(const Centerline2d& target);   ///< of this frame, in place of tracing it; see targetOf
    TraceOptions traceOptions() const;   ///< how frames are traced that have no target
    void setTraceOptions(const TraceOptions& options);
    std::vector<int> excludedBranchIds() const;   ///< see RegistrationInput
    void setExcludedBranchIds(const std::vector<int>& ids);
    std::vector<int> auxiliaryBranchIds() const;
    void setAuxiliaryBranchIds(const std::vector<int>& ids);
    std::vector<Message> warnings() const;   ///< of reading the case and its files

    struct Content;
    explicit Case(std::unique_ptr<Content> content);
    Content& content() { return *content_; }   ///< for the library itself
    const Content& content() const { return *content_; }

private:
    std::unique_ptr<Content> content_;
};

/// Reads a case file and the files it names; vessels given as a scan, a label image or a surface are traced.
ANGIOPOSE_EXPORT Case readCase(const std::string& path, const Observer& observe = {});

/// A case of two files: vessels (centrelines, or what they are traced from) and an angiogram.
ANGIOPOSE_EXPORT Case readCase(const std::string& vesselPath, const std::string& imagePath,
                               const VesselReadOptions& options = {}, const Observer& observe = {});

/// Writes a case file, with paths relative to it. What comes from no file is written beside it first, called after it:
/// of a.angiopose the vessels are a.tree.vtp, the angiogram a.angiogram.dcm, a target that was set a.curves.csv (the
/// case file calls it edited, as it holds for one frame). The case names them from then on.
ANGIOPOSE_EXPORT void writeCase(Case& session, const std::string& path);

/// The image points of the case: given with it, else traced in its frame.
ANGIOPOSE_EXPORT Centerline2d targetOf(const Case& session);

/// What `registerVessels` needs, as arrays; traces the angiogram where no target is given. Method, settings and locks
/// of the case are not among it: `registerVessels(inputOf(session), session.options())` finds the pose that
/// `registerCase` finds. Only a case knows how far its geometry may be off by where it comes from; see option
/// `geometryErrors`.
ANGIOPOSE_EXPORT RegistrationInput inputOf(const Case& session);

/// Registers the case with its options and takes over the pose. Throws for a case of several views, see registerViews.
ANGIOPOSE_EXPORT RegistrationResult registerCase(Case& session, const Observer& observe = {});

/// Registers all views of a case together and takes over the pose.
ANGIOPOSE_EXPORT MultiViewResult registerViews(Case& session, const Observer& observe = {});

/// Writes result.json of the last registration of the case.
ANGIOPOSE_EXPORT void writeResult(const Case& session, const std::string& path);

/// How a case is made up; lengths mm.
struct SimulationOptions {
    int branchCount = 24;
    double nonRigidStdMm = 0.0;   ///< smooth deformation of the vessels in the image
    double missingBranchShare = 0.2;   ///< of the branches, not filled in the image
    double extraBranchShare = 0.1;   ///< vessels of the image that the tree does not have, per branch
    int frameCount = 8;
};

/// A case with known answer.
struct SimulatedCase {
    Case session;   ///< with a start pose as a header gives it
    Pose trueCameraFromPatient = Pose::Identity();
    Centerline2d trueTarget;   ///< the curves of what is filled, sampled every px
    std::vector<int> missingBranchIds;   ///< not filled in the image
};

/// A random tree in a random view of a simulated angiogram. Everything follows from the seed.
ANGIOPOSE_EXPORT SimulatedCase simulateCase(std::uint64_t seed, const SimulationOptions& options = {});

}   // namespace angiopose
