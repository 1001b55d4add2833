#include "app/cli/add_commands.h"

#include "app/cli/commands.h"
#include "app/cli/convert_exchange.h"

#include <charconv>
#include <memory>
#include <optional>

namespace angiopose::app {
namespace {

/// Parses exactly `Count` numbers separated by commas; returns nullopt for any other text.
template <int Count>
std::optional<Eigen::Matrix<double, Count, 1>> numbersFrom(const std::string& text)
{
    Eigen::Matrix<double, Count, 1> numbers;
    std::string_view rest = text;
    for (int place = 0; place < Count; ++place) {
        const std::size_t comma = rest.find(',');
        const std::string_view number = rest.substr(0, comma);
        const auto parsed = std::from_chars(number.data(), number.data() + number.size(), numbers[place]);
        const bool isLast = comma == std::string_view::npos;
        if (parsed.ec != std::errc{} || parsed.ptr != number.data() + number.size() || isLast != (place == Count - 1)) {
            return std::nullopt;
        }
        rest.remove_prefix(isLast ? rest.size() : comma + 1);
    }
    return numbers;
}

/// Parses a point "x,y,z" (LPS, mm); returns nullopt for any other text.
std::optional<Eigen::Vector3d> pointFrom(const std::string& text)
{
    return numbersFrom<3>(text);
}

/// Adds a repeatable option that takes one point per occurrence.
void addPoints(CLI::App* command, const std::string& name, std::vector<Eigen::Vector3d>& points,
               const std::string& help)
{
    command
        ->add_option_function<std::vector<std::string>>(
            name,
            [&points](const std::vector<std::string>& texts) {
                for (const std::string& text : texts) {
                    points.push_back(pointFrom(text).value_or(Eigen::Vector3d::Zero()));
                }
            },
            help)
        ->allow_extra_args(false)
        ->check([](const std::string& text) {
            return pointFrom(text) ? std::string() : "specify a point as x,y,z in mm, not '" + text + "'";
        });
}

/// Adds a repeatable option that takes two points per occurrence.
void addSections(CLI::App* command, std::vector<VesselSection>& sections)
{
    command
        ->add_option_function<std::vector<std::string>>(
            "--between",
            [&sections](const std::vector<std::string>& texts) {
                for (const std::string& text : texts) {
                    const Eigen::Vector<double, 6> ends =
                        numbersFrom<6>(text).value_or(Eigen::Vector<double, 6>::Zero());
                    sections.push_back({ends.head<3>(), ends.tail<3>()});
                }
            },
            "x,y,z,x,y,z (LPS mm): trace only the vessel between two points, along the most vessel-like path; may be "
            "repeated: each further vessel is joined to those traced before")
        ->allow_extra_args(false)
        ->check([](const std::string& text) {
            return numbersFrom<6>(text) ? std::string() : "specify two points as x,y,z,x,y,z in mm, not '" + text + "'";
        });
}

/// Parses the choice of components; rejects choices that require seeds if there are none, and vice versa.
core::TracedPieces parsePieces(const std::string& word, bool hasSeeds)
{
    if (word == "seeded" && !hasSeeds) {
        throw CLI::ValidationError("--pieces", "'seeded' requires a --seed");
    }
    if ((word == "all" || word == "largest") && hasSeeds) {
        throw CLI::ValidationError("--pieces", "'" + word + "' cannot be combined with --seed");
    }
    return word == "all"       ? core::TracedPieces::All
           : word == "largest" ? core::TracedPieces::Largest
                               : core::TracedPieces::Usual;
}

}   // namespace

void addTraceVessel(CLI::App& app, int& exitCode)
{
    auto* command = app.add_subcommand("trace-vessel", "Trace the vessels of a CT angiogram as a centerline tree");
    auto arguments = std::make_shared<TraceVesselArguments>();
    auto root = std::make_shared<std::vector<Eigen::Vector3d>>();
    command
        ->add_option("VOLUME", arguments->inputPath,
                     "DICOM folder or slice, NIfTI, NRRD or MetaImage; also a label image, DICOM SEG or surface")
        ->required();
    command->add_option("--output", arguments->outputPath, "Vessel tree to write (.vtp, .csv, .swc or .mrk.json)")
        ->required();
    command->add_option("--mask", arguments->maskPath, "Vessel mask to write as a label image (e.g., .nii.gz)");
    command->add_option("--series", arguments->seriesId, "Series of a DICOM folder; `info FOLDER` lists them");
    command->add_option("--threshold", arguments->tracing.threshold, "Minimum value of the lumen (default: automatic)");
    addPoints(command, "--seed", arguments->tracing.seedsInPatient,
              "x,y,z (LPS mm) inside a vessel: trace everything connected to it; may be repeated (default: in a scan, "
              "the aorta or main artery is found automatically; in a mask, all components are traced)");
    addPoints(command, "--avoid", arguments->tracing.avoidInPatient,
              "x,y,z (LPS mm) in the heart, a vein or bone to avoid; may be repeated");
    command->add_flag("--tubes", arguments->tracing.tubesOnly,
                      "Trace only thin vessels, starting at the seeds; tracing stops at heart chambers, organs and "
                      "other structures wider than 1 cm");
    addSections(command, arguments->sections);
    command->add_option("--into", arguments->baseTreePath,
                        "Vessel tree to which the vessels traced with --between are added");
    addPoints(command, "--root", *root, "x,y,z (LPS mm): the root is the branch end nearest to this point");
    command
        ->add_option("--min-length", arguments->tracing.minBranchLengthMm,
                     "Minimum branch length in mm; shorter branches are removed")
        ->check(CLI::Range(0.0, 1000.0));
    command
        ->add_option("--min-radius", arguments->tracing.minBranchRadiusMm,
                     "Minimum mean branch radius in mm; thinner branches are removed")
        ->check(CLI::Range(0.0, 1000.0));
    command
        ->add_option("--point-spacing", arguments->tracing.pointSpacingMm,
                     "Distance between the points of a branch in mm")
        ->check(CLI::Range(0.01, 100.0));
    command
        ->add_option("--label,--labels", arguments->labels,
                     "Vessel labels, by number or name (e.g., 1,2 or aorta); `info` lists them (default: labels with "
                     "vessel names, otherwise all)")
        ->delimiter(',');
    command->add_option("--unit-mm", arguments->unitMm, "Coordinate unit of a surface, in mm")
        ->check(CLI::Range(1e-6, 1e4));
    auto pieces = std::make_shared<std::string>();
    command
        ->add_option("--pieces", *pieces,
                     "all: all components of a mask, or those of all great vessels in a scan; largest: the largest "
                     "component; seeded: the components that contain a --seed (default: seeded if there is a seed; "
                     "otherwise all components of a mask, or that of the aorta in a scan)")
        ->check(CLI::IsMember({"all", "largest", "seeded"}));
    auto loops = std::make_shared<std::string>();
    command
        ->add_option("--loops", *loops,
                     "opened: loops are cut at their narrowest point; kept: loops that are not segmentation errors, "
                     "such as the circle of Willis, are kept (default: opened)")
        ->check(CLI::IsMember({"opened", "kept"}));
    command
        ->add_option("--threads", arguments->tracing.threads,
                     "Number of threads (default: all); the result does not depend on it")
        ->check(CLI::Range(0, 256));
    command->footer("Example: angiopose-cli trace-vessel cta/ --output tree.vtp --mask lumen.nii.gz");
    command->callback([arguments, root, pieces, loops, &exitCode] {
        if (!root->empty()) {
            arguments->tracing.rootInPatient = root->back();
        }
        arguments->tracing.pieces = parsePieces(*pieces, !arguments->tracing.seedsInPatient.empty());
        arguments->tracing.loops = *loops == "kept" ? core::VesselLoops::Kept : core::VesselLoops::Opened;
        exitCode = runTraceVessel(*arguments);
    });
}

void addConvert(CLI::App& app, int& exitCode)
{
    auto* command = app.add_subcommand("convert", "Convert an input to the format given by the extension of OUT");
    auto arguments = std::make_shared<ConvertArguments>();
    command->add_option("IN", arguments->inputPath, "Any file that AngioPose reads, or a DICOM folder")->required();
    command
        ->add_option("OUT", arguments->outputPath,
                     "Centerlines: .vtp .csv .swc .mrk.json; volumes: .nii .nii.gz .nrrd .mha; surfaces: .stl; poses: "
                     ".json .tfm .h5; poses with camera: .txt (P) .yml .yaml .xml (K, R, t); points: .fcsv .mrk.json; "
                     "X-ray runs: .dcm; with --deidentify also DICOM slices, PNG, JPEG, and folders")
        ->required();
    command->add_option("--series", arguments->seriesId, "Series of a DICOM folder; `info FOLDER` lists them");
    command->add_option("--unit-mm", arguments->unitMm, "Coordinate unit of a surface or centerline file, in mm")
        ->check(CLI::Range(1e-6, 1e4));
    command->add_option("--spacing-mm", arguments->spacingMm, "Voxel size in mm for voxelizing a surface")
        ->check(CLI::Range(0.01, 100.0));
    arguments->identity = addDeidentifyOptions(*command);
    const auto exchange = addExchangeOptions(*command);
    command->footer("Example: angiopose-cli convert cta/ cta.nii.gz");
    command->callback([arguments, exchange, &exitCode] {
        const bool isExchange = isExchangeConversion(*arguments, *exchange);
        exitCode = isExchange ? runExchangeConversion(*arguments, *exchange) : runConvert(*arguments);
    });
}

}   // namespace angiopose::app
