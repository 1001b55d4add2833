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

/// A result instead of a case, and where its inputs may lie.
struct FromResult {
    std::string path;   ///< empty: a case
    std::vector<std::string> inputFolders;
};

struct RegisterArguments {
    std::string casePath;
    std::string angiogramPath;   ///< not empty: `casePath` is the vessels' file
    std::string savedPath;   ///< of the case with its results; empty: not written
    FromResult from;
    std::string method;   ///< empty: the case's own
    std::vector<std::string> options;   ///< "key=value", keys of core::optionFields()
    std::vector<int> auxiliaryBranchIds;   ///< empty: the case's own
    std::vector<int> excludedBranchIds;   ///< empty: the case's own
    std::vector<std::string> locks;   ///< ids of core::PoseAxis; empty: the case's own
    std::optional<int> frame;
    std::vector<std::string> otherViews;   ///< cases registered together with this one, beside its own `views`
    bool isDeformation = false;   ///< the vessels are bent after the registration
    bool isSamePatient = false;   ///< whatever the headers say
    std::string outputFolder;   ///< empty: "<case>-registered" in the current folder
    OutputFormat format = OutputFormat::Text;
};
int runRegister(const RegisterArguments& arguments);

struct TrackArguments {
    std::string casePath;
    std::string outputPath;   ///< table of poses
    std::string deformedFolder;   ///< of a tree for every frame in which vessels are bent; empty: none
    bool keepPose = false;   ///< follow from the case's pose instead of registering its frame first
};
int runTrack(const TrackArguments& arguments);

struct ProjectArguments {
    std::string casePath;
    FromResult from;
    std::string posePath;   ///< empty: the case's current pose
    std::string outputPath;
    int widthPx = 0;   ///< 0: twice the image
    std::optional<int> frame;
    bool depthCue = false;   ///< near vessels bright, far ones dim
    std::optional<double> swipePx;   ///< right of this column the angiogram alone
    bool startBeside = false;   ///< before and after
    bool isRigid = false;   ///< the vessels of the rigid pose, where the case keeps bent ones
    bool isMotionColored = false;   ///< coloured by how far the bent vessels lie from the rigid ones
    double dotsPerInch = 0.0;   ///< 0: not told
    bool isFrameAlone = false;
    bool is16Bit = false;   ///< the frame alone, its grey values
};
int runProject(const ProjectArguments& arguments);

struct MovieArguments {
    std::string casePath;
    std::string outputPath;
    MovieContent content = MovieContent::Run;
    std::vector<int> frames;   ///< first and last of a run, from 1; empty: all
    bool isBackAndForth = false;
    bool isRegistered = false;   ///< its frame is registered first
    bool isFollowed = false;   ///< then the vessels are followed through the run
    double framesPerSecond = 0.0;   ///< 0: as the run was taken, or usual
    double speed = 1.0;   ///< times as fast
    int widthPx = 0;   ///< 0: twice the image
    std::optional<int> frame;
    bool isRigid = false;
    bool depthCue = false;
};
int runMovie(const MovieArguments& arguments);

struct AnglesArguments {
    std::string casePath;
    std::optional<int> frame;
    int branchId = 0;
    bool isTakeOff = false;   ///< where the branch leaves, not the whole branch
    core::AngleMapOptions map;
    std::string outputPath;   ///< table of all angles; empty: none
    OutputFormat format = OutputFormat::Text;
};
int runAngles(const AnglesArguments& arguments);

struct MeasureArguments {
    std::string casePath;
    std::string outputPath;   ///< empty: the table is printed
    bool areBranchesWanted = false;   ///< measures along every branch instead of those in the images
    std::optional<int> profiledBranch;   ///< places along this branch instead
    bool areCheckPointsWanted = false;   ///< check points and rings instead
    OutputFormat format = OutputFormat::Text;   ///< of check points
};
int runMeasure(const MeasureArguments& arguments);

struct SimulateArguments {
    std::optional<std::uint64_t> seed;   ///< of one case
    std::string studyPath;   ///< of many
    std::string shard = "1/1";
    std::optional<int> threads;
    std::string outputFolder;
    double nonRigidMm = 0.0;
    int branches = 24;
    bool withScan = false;   ///< a CT angiogram of the same vessels besides
    std::string room;   ///< two views of one study, with the headers of such a room; empty: one view
    bool movesTable = false;   ///< of a room: during the second view
    bool isMirrored = false;   ///< likewise: the second view
};
int runSimulate(const SimulateArguments& arguments);   ///< one case or a study

struct TraceAngiogramArguments {
    std::string imagePath;
    std::optional<int> frame;
    std::string outputPath;
    std::string maskPath;
    std::string apartPath;   ///< of curves that may be catheters, wires or edges of bones; empty: with the others
    double sensitivity = 1.0;
    std::optional<bool> subtract;   ///< as the file says, or as is best; not given: where the file names its mask
    std::vector<int> maskFrames;   ///< to subtract, from 1; empty: the file's, or those before the contrast
    std::vector<double> maskShiftPx;   ///< right, down; empty: the file's, or found
    bool composite = false;   ///< all frames in one picture instead of one frame
};
int runTraceAngiogram(const TraceAngiogramArguments& arguments);

struct EvaluateArguments {
    std::string protocol;
    std::vector<std::string> inputPaths;   ///< of `own` the list of cases, of `observers` their logs
    std::string methods;   ///< empty: those of defaultMethods, of own cases each case's own
    std::string conditions;   ///< empty: the standard ones
    std::optional<std::uint64_t> trials;   ///< of each condition; the protocol's own when not given
    std::uint64_t seed = 1;
    std::optional<int> threads;   ///< all cores when not given
    std::string shard = "1/1";
    std::vector<std::string> mergedFolders;   ///< not empty: nothing runs, their runs are brought together
    std::string outputFolder;
};
int runEvaluate(const EvaluateArguments& arguments);

struct BatchArguments {
    std::string manifestPath;
    std::string shard = "1/1";
    std::optional<int> threads;   ///< all cores when not given
    std::optional<double> timeLimitSeconds;   ///< of one case
    bool isResumed = false;   ///< what is done and up to date stays
    bool isWithoutPictures = false;
    std::vector<std::string> settings;   ///< "name=value" of all rows
    std::vector<std::string> mergedFolders;   ///< not empty: nothing runs, the tables of their outcomes are written
    std::string outputFolder;
};
int runBatch(const BatchArguments& arguments);

/// What runs in a worker of a batch, started by process `parent`: rows one after the other, as they come, on so many
/// threads. Ends with the other side. Its exit code.
int runBatchWorker(int parent, int threads);

/// A vessel's part between two places, patient LPS mm.
struct Stretch {
    Eigen::Vector3d from;
    Eigen::Vector3d to;
};

struct TraceVesselArguments {
    std::string inputPath;   ///< volume, DICOM folder, label image or surface
    std::string outputPath;
    std::string maskPath;   ///< empty: the lumen is not written
    std::string seriesId;
    std::vector<std::string> labels;   ///< numbers or names; empty: those of vessels, or all
    double unitMm = 0.0;   ///< 0: as the file states, else mm
    core::VesselTracingOptions tracing;   ///< its `pieces` counts where there is no seed
    std::vector<Stretch> stretches;   ///< traced instead of everything
    std::string intoPath;   ///< a tree that they are added to; empty: none
};
int runTraceVessel(const TraceVesselArguments& arguments);

struct ConvertArguments {
    std::string inputPath;
    std::string outputPath;
    std::string seriesId;
    double unitMm = 0.0;   ///< 0: as the file states, else mm
    double spacingMm = 0.0;   ///< of the voxels a surface is filled with; 0: chosen by its size
    std::shared_ptr<DeidentifyArguments> identity;
};
int runConvert(const ConvertArguments& arguments);

struct FileArguments {
    std::string path;
    bool allFiles = false;   ///< of `studies`: not only those that a DICOMDIR lists
    OutputFormat format = OutputFormat::Text;
};
int runStudies(const FileArguments& arguments);
int runInfo(const FileArguments& arguments);
int runValidate(const FileArguments& arguments);

}   // namespace angiopose::app