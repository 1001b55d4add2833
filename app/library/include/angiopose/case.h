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

/// Content of a case file: vessels, one or more angiograms of them (views), geometry, poses and options. A value type:
/// copies share the images and are otherwise independent. Functions refer to the first view unless they say otherwise.
class ANGIOPOSE_EXPORT Case {
public:
    /// Creates a case from vessels and an angiogram. If the geometry is known, the initial pose is that of the C-arm
    /// about its isocenter, else about the vessels' centroid; otherwise `setInitialPose` must set it. Starts at the
    /// angiogram's suggested frame.
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
    void setFrame(int frame);   ///< rotates the poses as the gantry rotated between the frames
    ProjectionCamera camera() const;
    void setCamera(const ProjectionCamera& camera);   ///< for images of the angiogram's size; overrides the C-arm
    CArm cArm() const;
    void setCArm(const CArm& cArm);   ///< overrides camera and initial pose, even if they were set before
    Pose initialPose() const;
    void setInitialPose(const Pose& cameraFromPatient);   ///< also moves the current pose there
    Pose cameraFromPatient() const;   ///< current pose; registration starts from it
    void setCameraFromPatient(const Pose& cameraFromPatient);
    RegistrationOptions options() const;
    void setOptions(const RegistrationOptions& options);
    void setTarget(const Centerline2d& target);   ///< of this frame, instead of tracing it; see targetOf
    TraceOptions traceOptions() const;   ///< used for frames without a given target
    void setTraceOptions(const TraceOptions& options);
    std::vector<int> excludedBranchIds() const;   ///< see RegistrationInput
    void setExcludedBranchIds(const std::vector<int>& ids);
    std::vector<int> auxiliaryBranchIds() const;
    void setAuxiliaryBranchIds(const std::vector<int>& ids);
    std::vector<Message> warnings() const;   ///< from reading the case and its files

    struct Content;
    explicit Case(std::unique_ptr<Content> content);
    Content& content() { return *content_; }   ///< internal use
    const Content& content() const { return *content_; }

private:
    std::unique_ptr<Content> content_;
};

/// Reads a case file and the files it names; traces vessels that are given as a scan, a label image or a surface.
ANGIOPOSE_EXPORT Case readCase(const std::string& path, const Observer& observe = {});

/// Reads a case from two files: vessels (centerlines, or a file to trace them from) and an angiogram.
ANGIOPOSE_EXPORT Case readCase(const std::string& vesselPath, const std::string& imagePath,
                               const VesselReadOptions& options = {}, const Observer& observe = {});

/// Writes a case file with relative paths. Content that comes from no file is first written next to it under its name:
/// for a.angiopose, the vessels to a.tree.vtp, the angiogram to a.angiogram.dcm, and a target that was set to
/// a.curves.csv (marked as edited in the case file because it is valid for one frame). The case refers to these files
/// from then on.
ANGIOPOSE_EXPORT void writeCase(Case& session, const std::string& path);

/// Target points of the case: the given ones, else those traced in its frame.
ANGIOPOSE_EXPORT Centerline2d targetOf(const Case& session);

/// Input of `registerVessels` as arrays; traces the angiogram if no target is given. It does not contain method,
/// settings and locks: `registerVessels(inputOf(session), session.options())` finds the same pose as `registerCase`.
/// Only a case knows the uncertainty of its geometry from the origin of the values; see option `geometryErrors`.
ANGIOPOSE_EXPORT RegistrationInput inputOf(const Case& session);

/// Registers the case with its options and adopts the pose. Throws if the case has several views; see registerViews.
ANGIOPOSE_EXPORT RegistrationResult registerCase(Case& session, const Observer& observe = {});

/// Registers all views of a case jointly and adopts the poses.
ANGIOPOSE_EXPORT MultiViewResult registerViews(Case& session, const Observer& observe = {});

/// Writes result.json of the last registration of the case.
ANGIOPOSE_EXPORT void writeResult(const Case& session, const std::string& path);

/// Options of a simulated case; lengths in mm.
struct SimulationOptions {
    int branchCount = 24;
    double nonRigidStdMm = 0.0;   ///< smooth deformation of the vessels in the image
    double missingBranchShare = 0.2;   ///< share of the branches that are unopacified in the image
    double extraBranchShare = 0.1;   ///< vessels in the image that the tree lacks, per branch
    int frameCount = 8;
};

/// Simulated case with ground truth.
struct SimulatedCase {
    Case session;   ///< with an initial pose as a header would give it
    Pose trueCameraFromPatient = Pose::Identity();
    Centerline2d trueTarget;   ///< curves of the opacified vessels, one point per px
    std::vector<int> missingBranchIds;   ///< unopacified in the image
};

/// Simulates an angiogram of a random tree from a random view. The result depends only on the seed and the options.
ANGIOPOSE_EXPORT SimulatedCase simulateCase(std::uint64_t seed, const SimulationOptions& options = {});

}   // namespace angiopose
