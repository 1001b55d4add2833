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

/// Contents of a case file: vessels, one or more angiograms of them (views), geometry, poses and options. A value type:
/// copies share the images but are otherwise independent. Functions refer to the first view unless stated otherwise.
class ANGIOPOSE_EXPORT Case {
public:
    /// Creates a case from vessels and an angiogram. If the geometry is known, the initial pose is that of the C-arm
    /// about its isocenter, or about the vessels' centroid if the isocenter is unknown; otherwise set it with
    /// `setInitialPose`. Selects the angiogram's suggested frame.
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
    void setFrame(int frame);   ///< also rotates the poses by the gantry rotation between the frames
    ProjectionCamera camera() const;
    void setCamera(const ProjectionCamera& camera);   ///< requires images of the angiogram's size; overrides the C-arm
    CArm cArm() const;
    void setCArm(const CArm& cArm);   ///< overrides a camera and an initial pose set earlier
    Pose initialPose() const;
    void setInitialPose(const Pose& cameraFromPatient);   ///< also sets the current pose
    Pose cameraFromPatient() const;   ///< current pose, from which registration starts
    void setCameraFromPatient(const Pose& cameraFromPatient);
    RegistrationOptions options() const;
    void setOptions(const RegistrationOptions& options);
    void setTarget(const Centerline2d& target);   ///< sets the target of the current frame, which is then not traced
    TraceOptions traceOptions() const;   ///< used for frames without a target of their own
    void setTraceOptions(const TraceOptions& options);
    std::vector<int> excludedBranchIds() const;   ///< see RegistrationInput
    void setExcludedBranchIds(const std::vector<int>& ids);
    std::vector<int> auxiliaryBranchIds() const;
    void setAuxiliaryBranchIds(const std::vector<int>& ids);
    std::vector<Message> warnings() const;   ///< warnings from reading the case and its files

    struct Content;
    explicit Case(std::unique_ptr<Content> content);
    Content& content() { return *content_; }   ///< internal use
    const Content& content() const { return *content_; }

private:
    std::unique_ptr<Content> content_;
};

/// Reads a case file and the files named in it. Traces vessels that are given as a scan, a label image or a surface.
ANGIOPOSE_EXPORT Case readCase(const std::string& path, const Observer& observe = {});

/// Reads a case from two files: vessels (centerlines, or a file in which to trace them) and an angiogram.
ANGIOPOSE_EXPORT Case readCase(const std::string& vesselPath, const std::string& imagePath,
                               const VesselReadOptions& options = {}, const Observer& observe = {});

/// Writes a case file with relative paths. First saves data that are not stored in files yet next to the case file: for
/// a.angiopose, the vessels as a.tree.vtp, the angiogram as a.angiogram.dcm, and a target that was set as a.curves.csv
/// (flagged as edited, because it is valid for one frame only). The case then refers to these files.
ANGIOPOSE_EXPORT void writeCase(Case& session, const std::string& path);

/// Returns the target points of the case: those that were set, otherwise those traced in its frame.
ANGIOPOSE_EXPORT Centerline2d targetOf(const Case& session);

/// Returns the input of `registerVessels` as arrays; traces the angiogram if no target is set. Excludes method,
/// settings and locks: `registerVessels(inputOf(session), session.options())` finds the pose of `registerCase`. Only a
/// case knows the origin of its geometry values, which determines their uncertainty; see the option `geometryErrors`.
ANGIOPOSE_EXPORT RegistrationInput inputOf(const Case& session);

/// Registers the case with its options and adopts the pose. Throws if the case has several views; see registerViews.
ANGIOPOSE_EXPORT RegistrationResult registerCase(Case& session, const Observer& observe = {});

/// Registers all views of a case jointly and sets their current poses to the result.
ANGIOPOSE_EXPORT MultiViewResult registerViews(Case& session, const Observer& observe = {});

/// Writes result.json of the last registration of the case.
ANGIOPOSE_EXPORT void writeResult(const Case& session, const std::string& path);

/// Options of a simulated case; lengths in mm.
struct SimulationOptions {
    int branchCount = 24;
    double nonRigidStdMm = 0.0;   ///< standard deviation of the smooth deformation of the vessels in the image
    double missingBranchShare = 0.2;   ///< fraction of the branches that are unopacified in the image
    double extraBranchShare = 0.1;   ///< number of vessels in the image that the tree lacks, per branch
    int frameCount = 8;
};

/// Simulated case with ground truth.
struct SimulatedCase {
    Case session;   ///< case whose initial pose has errors typical of DICOM headers
    Pose trueCameraFromPatient = Pose::Identity();
    Centerline2d trueTarget;   ///< curves of the opacified vessels, one point per px
    std::vector<int> missingBranchIds;   ///< branches that are unopacified in the image
};

/// Simulates an angiogram of a random tree from a random view. The result depends only on the seed and the options.
ANGIOPOSE_EXPORT SimulatedCase simulateCase(std::uint64_t seed, const SimulationOptions& options = {});

}   // namespace angiopose
