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

// One struct of arguments and one function per command; each returns its exit code.

/// Result file to use instead of a case, and folders in which to look for its inputs.
struct FromResult {
    std::string path;   ///< empty: use a case
    std::vector<std::string> inputFolders;
};

struct RegisterArguments {
    std::string casePath;
    std::string angiogramPath;   ///< not empty: `casePath` is the vessels' file
    std::string savedPath;   ///< output path of the case with its results; empty: not written
    FromResult from;
    std::string method;   ///< empty: that of the case
    std::vector<std::string> options;   ///< "key=value", keys of core::optionFields()
    std::vector<int> auxiliaryBranchIds;   ///< empty: those of the case
    std::vector<int> excludedBranchIds;   ///< empty: those of the case
    std::vector<std::string> locks;   ///< ids of core::PoseAxis; empty: those of the case
    std::optional<int> frame;
    std::vector<std::string> otherViews;   ///< cases registered jointly with this one, in addition to its own `views`
    bool isDeformation = false;   ///< deform the vessels after the registration
    bool isSamePatient = false;   ///< assume the same patient, whatever the headers state
    std::string outputFolder;   ///< empty: "<case>-registered" in the current folder
    OutputFormat format = OutputFormat::Text;
};
int runRegister(const RegisterArguments& arguments);

struct TrackArguments {
    std::string casePath;
    std::string outputPath;   ///< table of poses
    std::string deformedFolder;   ///< folder for one tree per frame with deformed vessels; empty: none
    bool keepPose = false;   ///< track from the current pose of the case instead of registering its frame first
};
int runTrack(const TrackArguments& arguments);

struct ProjectArguments {
    std::string casePath;
    FromResult from;
    std::string posePath;   ///< empty: the current pose of the case
    std::string outputPath;
    int widthPx = 0;   ///< 0: twice the image width
    std::optional<int> frame;
    bool depthCue = false;   ///< depth cueing: near vessels bright, far ones dim
    std::optional<double> swipePx;   ///< column, px, right of which only the angiogram is shown
    bool startBeside = false;   ///< initial pose side by side with the current pose
    bool isRigid = false;   ///< vessels of the rigid pose, even if the case has deformed ones
    bool isMotionColored = false;   ///< colored by the distance of the deformed vessels from the rigid ones
    double dotsPerInch = 0.0;   ///< 0: not specified
    bool isFrameAlone = false;
    bool is16Bit = false;   ///< gray values of the frame without overlay
};
int runProject(const ProjectArguments& arguments);

struct MovieArguments {
    std::string casePath;
    std::string outputPath;
    MovieContent content = MovieContent::Run;
    std::vector<int> frames;   ///< first and last frame of the run, from 1; empty: all
    bool isBackAndForth = false;
    bool isRegistered = false;   ///< register its frame first
    bool isFollowed = false;   ///< then track the vessels through the run
    double framesPerSecond = 0.0;   ///< 0: acquisition rate, or the default rate if unknown
    double speed = 1.0;   ///< speed factor
    int widthPx = 0;   ///< 0: twice the image width
    std::optional<int> frame;
    bool isRigid = false;
    bool depthCue = false;
};
int runMovie(const MovieArguments& arguments);

struct AnglesArguments {
    std::string casePath;
    std::optional<int> frame;
    int branchId = 0;
    bool isTakeOff = false;   ///< the takeoff of the branch instead of the whole branch
    core::AngleMapOptions map;
    std::string outputPath;   ///< table of all angles; empty: none
    OutputFormat format = OutputFormat::Text;
};
int runAngles(const AnglesArguments& arguments);

struct MeasureArguments {
    std::string casePath;
    std::string outputPath;   ///< empty: print the table
    bool areBranchesWanted = false;   ///< measurements along every branch instead of those in the images
    std::optional<int> profiledBranch;   ///< profile along this branch instead
    bool areCheckPointsWanted = false;   ///< target points and rings instead
    OutputFormat format = OutputFormat::Text;   ///< for target points
};
int runMeasure(const MeasureArguments& arguments);

struct SimulateArguments {
    std::optional<std::uint64_t> seed;   ///< for one case
    std::string studyPath;   ///< for many cases
    std::string shard = "1/1";
    std::optional<int> threads;
    std::string outputFolder;
    double nonRigidMm = 0.0;
    int branches = 24;
    bool withScan = false;   ///< also write a CT angiogram of the same vessels
    std::string room;   ///< room whose headers two views of one study get; empty: one view
    bool movesTable = false;   ///< with a room: move the table before the second view
    bool isMirrored = false;   ///< with a room: mirror the second view
};
int runSimulate(const SimulateArguments& arguments);   ///< simulates one case or a study

struct TraceAngiogramArguments {
    std::string imagePath;
    std::optional<int> frame;
    std::string outputPath;
    std::string maskPath;
    std::string apartPath;   ///< output for possible catheters, guidewires and bone edges; empty: with the other curves
    double sensitivity = 1.0;
    std::optional<bool> subtract;   ///< mask of the file, or the best one; empty: only if the file names its mask
    std::vector<int> maskFrames;   ///< mask frames, from 1; empty: the file's, or those before contrast arrival
    std::vector<double> maskShiftPx;   ///< right, down; empty: that of the file, or automatic
    bool composite = false;   ///< peak-opacification image of all frames instead of one frame
};
int runTraceAngiogram(const TraceAngiogramArguments& arguments);

struct EvaluateArguments {
    std::string protocol;
    std::vector<std::string> inputPaths;   ///< for `own`: the list of cases; for `observers`: their logs
    std::string methods;   ///< empty: those of defaultMethods; for own cases, that of each case
    std::string conditions;   ///< empty: the standard ones
    std::optional<std::uint64_t> trials;   ///< per condition; empty: the default of the protocol
    std::uint64_t seed = 1;
    std::optional<int> threads;   ///< empty: all cores
    std::string shard = "1/1";
    std::vector<std::string> mergedFolders;   ///< not empty: nothing is run, the runs in these folders are merged
    std::string outputFolder;
};
int runEvaluate(const EvaluateArguments& arguments);

struct BatchArguments {
    std::string manifestPath;
    std::string shard = "1/1";
    std::optional<int> threads;   ///< empty: all cores
    std::optional<double> timeLimitSeconds;   ///< per case
    bool isResumed = false;   ///< keep outcomes that are up to date
    bool isWithoutPictures = false;
    std::vector<std::string> settings;   ///< "name=value", common to all rows
    std::vector<std::string>
        mergedFolders;   ///< not empty: nothing is run, the tables of the outcomes in these folders are written
    std::string outputFolder;
};
int runBatch(const BatchArguments& arguments);

/// Runs the worker of a batch started by process `parent`: processes rows one after the other as they arrive, on
/// `threads` threads, until the parent closes the connection. Returns the exit code.
int runBatchWorker(int parent, int threads);

/// Section of a vessel between two points, patient LPS mm.
struct Stretch {
    Eigen::Vector3d from;
    Eigen::Vector3d to;
};

struct TraceVesselArguments {
    std::string inputPath;   ///< volume, DICOM folder, label image or surface
    std::string outputPath;
    std::string maskPath;   ///< empty: do not write the lumen
    std::string seriesId;
    std::vector<std::string> labels;   ///< numbers or names; empty: the vessel labels, or all
    double unitMm = 0.0;   ///< millimeters per unit; 0: as the file states, else mm
    core::VesselTracingOptions tracing;   ///< its `pieces` applies when there is no seed
    std::vector<Stretch> stretches;   ///< sections to trace instead of everything
    std::string intoPath;   ///< tree to add them to; empty: none
};
int runTraceVessel(const TraceVesselArguments& arguments);

struct ConvertArguments {
    std::string inputPath;
    std::string outputPath;
    std::string seriesId;
    double unitMm = 0.0;   ///< millimeters per unit; 0: as the file states, else mm
    double spacingMm = 0.0;   ///< voxel spacing when filling a surface; 0: chosen by its size
    std::shared_ptr<DeidentifyArguments> identity;
};
int runConvert(const ConvertArguments& arguments);

struct FileArguments {
    std::string path;
    bool allFiles = false;   ///< for `studies`: all files, not only those listed in a DICOMDIR
    OutputFormat format = OutputFormat::Text;
};
int runStudies(const FileArguments& arguments);
int runInfo(const FileArguments& arguments);
int runValidate(const FileArguments& arguments);

}   // namespace angiopose::app