#pragma once

#include "app/cli/console.h"
#include "app/cli/deidentify_options.h"
#include "app/texts/movie.h"
#include "core/tracing/volume/trace_vessels.h"
#include "core/viewing/angle_map.h"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace angiopose::app {

// One struct of arguments and one function per command; each function returns the exit code.

/// Result file to use instead of a case, and the folders in which to search for its inputs.
struct ResultSource {
    std::string path;   ///< if empty, a case is used
    std::vector<std::string> inputFolders;
};

struct RegisterArguments {
    std::string casePath;
    std::string angiogramPath;   ///< if set, `casePath` is the vessel file
    std::string savedPath;   ///< output path of the case with its results; if empty, the case is not written
    ResultSource from;
    std::string method;   ///< if empty, the method of the case
    std::vector<std::string> options;   ///< "key=value" pairs; the keys are those of core::optionFields()
    std::vector<int> auxiliaryBranchIds;   ///< if empty, the auxiliary branches of the case
    std::vector<int> excludedBranchIds;   ///< if empty, the excluded branches of the case
    std::vector<std::string> locks;   ///< IDs of core::PoseAxis; if empty, those of the case
    std::optional<int> frame;
    std::vector<std::string> otherViews;   ///< cases to register jointly with this one, in addition to its own `views`
    bool deformVessels = false;   ///< whether to deform the vessels after registration
    bool isSamePatient = false;   ///< whether to treat all images as those of one patient, whatever the headers state
    std::string outputFolder;   ///< if empty, "<case>-registered" in the current folder
    OutputFormat format = OutputFormat::Text;
};
int runRegister(const RegisterArguments& arguments);

struct TrackArguments {
    std::string casePath;
    std::string outputPath;   ///< path of the pose table
    std::string deformedFolder;   ///< folder for the deformed vessels, one tree per frame; optional
    bool keepPose = false;   ///< whether to start tracking at the current pose without registering its frame first
};
int runTrack(const TrackArguments& arguments);

struct ProjectArguments {
    std::string casePath;
    ResultSource from;
    std::string posePath;   ///< if empty, the current pose of the case
    std::string outputPath;
    int widthPx = 0;   ///< if 0, twice the image width
    std::optional<int> frame;
    bool depthCue = false;   ///< depth cueing: whether to draw near vessels bright and distant ones dim
    std::optional<double> swipePx;   ///< column (px) to the right of which only the angiogram is shown
    bool showInitialPose = false;   ///< whether to show the initial pose side by side with the current one
    bool isRigid = false;   ///< whether to show the rigid vessels even if the case has deformed ones
    bool isMotionColored = false;   ///< whether to color the deformed vessels by their distance from the rigid ones
    double dotsPerInch = 0.0;   ///< print resolution; 0 if not specified
    bool frameOnly = false;
    bool is16Bit = false;   ///< whether to write the gray values of the frame without overlay
};
int runProject(const ProjectArguments& arguments);

struct MovieArguments {
    std::string casePath;
    std::string outputPath;
    MovieContent content = MovieContent::Run;
    std::vector<int> frames;   ///< first and last frame of the run, from 1; all frames if empty
    bool isBackAndForth = false;
    bool isRegistered = false;   ///< whether to register the frame of the case first
    bool isTracked = false;   ///< whether to track the vessels through the run before writing
    double framesPerSecond = 0.0;   ///< if 0, the acquisition rate, or a default rate if that is unknown
    double speed = 1.0;   ///< playback speed factor
    int widthPx = 0;   ///< if 0, twice the image width
    std::optional<int> frame;
    bool isRigid = false;
    bool depthCue = false;
};
int runMovie(const MovieArguments& arguments);

struct AnglesArguments {
    std::string casePath;
    std::optional<int> frame;
    int branchId = 0;
    bool takeoffOnly = false;   ///< whether to evaluate only the origin of the branch
    core::AngleMapOptions map;
    std::string outputPath;   ///< path of the table of all angles; empty if not requested
    OutputFormat format = OutputFormat::Text;
};
int runAngles(const AnglesArguments& arguments);

struct MeasureArguments {
    std::string casePath;
    std::string outputPath;   ///< if empty, the table is printed
    bool writeBranches = false;   ///< whether to write measurements along every branch instead of those in the images
    std::optional<int> profileBranchId;   ///< if set, write the profile along this branch instead
    bool writeTargetPoints = false;   ///< whether to write target points and rings instead
    OutputFormat format = OutputFormat::Text;   ///< output format of target points
};
int runMeasure(const MeasureArguments& arguments);

struct SimulateArguments {
    std::optional<std::uint64_t> seed;   ///< random seed of a single case
    std::string studyPath;   ///< path of the description of a study with many cases
    std::string shard = "1/1";
    std::optional<int> threads;
    std::string outputFolder;
    double nonRigidMm = 0.0;
    int branches = 24;
    bool withScan = false;   ///< whether to also write a CT angiogram of the same vessels
    std::string room;   ///< angiography room for the headers of two views of one study; if empty, simulate one view
    bool moveTable = false;   ///< with a room, whether to move the table before the second view
    bool isMirrored = false;   ///< with a room, whether to mirror the second view
};
int runSimulate(const SimulateArguments& arguments);   ///< simulates one case or a study

struct TraceAngiogramArguments {
    std::string imagePath;
    std::optional<int> frame;
    std::string outputPath;
    std::string maskPath;
    std::string devicePath;   ///< output path of possible devices and bone edges; if empty, that of the other curves
    double sensitivity = 1.0;
    std::optional<bool> subtract;   ///< whether to subtract; if not set, only if the file names its mask
    std::vector<int> maskFrames;   ///< mask frames, from 1; if empty, those of the file or before contrast arrival
    std::vector<double> maskShiftPx;   ///< mask shift right and down; if empty, that of the file or an automatic one
    bool composite = false;   ///< whether to trace the peak-opacification image of all frames instead of one frame
};
int runTraceAngiogram(const TraceAngiogramArguments& arguments);

struct EvaluateArguments {
    std::string protocol;
    std::vector<std::string> inputPaths;   ///< case manifests for `own`, log files for `observers`
    std::string methods;   ///< if empty, defaultMethods; for own cases, the method of each case
    std::string conditions;   ///< if empty, the standard conditions
    std::optional<std::uint64_t> trials;   ///< trials per condition; if not set, the default of the protocol
    std::uint64_t seed = 1;
    std::optional<int> threads;   ///< if not set, one per core
    std::string shard = "1/1";
    std::vector<std::string> mergedFolders;   ///< if not empty, only merge the runs in these folders
    std::string outputFolder;
};
int runEvaluate(const EvaluateArguments& arguments);

struct BatchArguments {
    std::string manifestPath;
    std::string shard = "1/1";
    std::optional<int> threads;   ///< if not set, one per core
    std::optional<double> timeLimitSeconds;   ///< time limit per case, s
    bool resumes = false;   ///< whether to keep outcomes that are up to date
    bool skipImages = false;
    std::vector<std::string> settings;   ///< "name=value" pairs common to all rows
    std::vector<std::string> mergedFolders;   ///< if not empty, only write the tables of the outcomes in these folders
    std::string outputFolder;
};
int runBatch(const BatchArguments& arguments);

/// Runs a batch worker started by process `parent`: processes rows one at a time on `threads` threads until the parent
/// closes the connection. Returns the exit code.
int runBatchWorker(int parent, int threads);

/// Vessel section between two points (LPS, mm).
struct VesselSection {
    Eigen::Vector3d from;
    Eigen::Vector3d to;
};

struct TraceVesselArguments {
    std::string inputPath;   ///< volume, DICOM folder, label image or surface
    std::string outputPath;
    std::string maskPath;   ///< if empty, the lumen is not written
    std::string seriesId;
    std::vector<std::string> labels;   ///< label numbers or names; if empty, the labels named after vessels, or all
    double unitMm = 0.0;   ///< length of one unit, mm; if 0, as stated in the file, otherwise 1 mm
    core::VesselTracingOptions tracing;   ///< `pieces` applies only if there is no seed
    std::vector<VesselSection> sections;   ///< sections to trace instead of everything
    std::string baseTreePath;   ///< optional tree to which the sections are added
};
int runTraceVessel(const TraceVesselArguments& arguments);

struct ConvertArguments {
    std::string inputPath;
    std::string outputPath;
    std::string seriesId;
    double unitMm = 0.0;   ///< length of one unit, mm; if 0, as stated in the file, otherwise 1 mm
    double spacingMm = 0.0;   ///< voxel spacing for filling a surface, mm; if 0, chosen from the size of the surface
    std::shared_ptr<DeidentifyArguments> identity;
};
int runConvert(const ConvertArguments& arguments);

struct FileArguments {
    std::string path;
    bool allFiles = false;   ///< for `studies`: whether to read all files, not only those listed in a DICOMDIR
    OutputFormat format = OutputFormat::Text;
};
int runStudies(const FileArguments& arguments);
int runInfo(const FileArguments& arguments);
int runValidate(const FileArguments& arguments);

}   // namespace angiopose::app
