#include "app/cli/vessel_commands.h"

#include "app/cli/commands.h"
#include "app/cli/convert_exchange.h"

#include <charconv>
#include <memory>
#include <optional>

namespace angiopose::app {
namespace {

/// Parses exactly `Count` numbers separated by commas; empty if the text has another form.
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

/// Parses "x,y,z" in patient LPS mm; empty if the text has another form.
std::optional<Eigen::Vector3d> pointFrom(const std::string& text)
{
    return numbersFrom<3>(text);
}

/// Adds a repeatable option that takes one point each time.
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
            return pointFrom(text) ? std::string() : "give a point as x,y,z in mm, not '" + text + "'";
        });
}

/// Adds a repeatable option that takes two points each time.
void addStretches(CLI::App* command, std::vector<Stretch>& stretches)
{
    command
        ->add_option_function<std::vector<std::string>>(
            "--between",
            [&stretches](const std::vector<std::string>& texts) {
                for (const std::string& text : texts) {
                    const Eigen::Vector<double, 6> ends =
                        numbersFrom<6>(text).value_or(Eigen::Vector<double, 6>::Zero());
                    stretches.push_back({ends.head<3>(), ends.tail<3>()});
                }
            },
            "x,y,z,x,y,z (LPS mm): trace just the vessel from one place to the other, by the path that is most like a "
            "vessel; may be repeated: later ones join the earlier")
        ->allow_extra_args(false)
        ->check([](const std::string& text) {
            return numbersFrom<6>(text) ? std::string() : "give two points as x,y,z,x,y,z in mm, not '" + text + "'";
        });
}

/// Parses the choice of components; rejects combinations that contradict the presence of seeds.
core::TracedPieces piecesCalled(const std::string& word, bool hasSeeds)
{
    if (word == "seeded" && !hasSeeds) {
        throw CLI::ValidationError("--pieces", "'seeded' needs a --seed");
    }
    if ((word == "all" || word == "largest") && hasSeeds) {
        throw CLI::ValidationError("--pieces", "'" + word + "' is for tracing without a --seed");
    }
    return word == "all"       ? core::TracedPieces::All
           : word == "largest" ? core::TracedPieces::Largest
                               : core::TracedPieces::Usual;
}

}   // namespace

void addTraceVessel(CLI::App& app, int& exitCode)
{
    auto* command = app.add_subcommand("trace-vessel", "Trace the vessels of a CT angiogram as a centreline tree");
    auto arguments = std::make_shared<TraceVesselArguments>();
    auto root = std::make_shared<std::vector<Eigen::Vector3d>>();
    command
        ->add_option("VOLUME", arguments->inputPath,
                     "DICOM folder or slice, NIfTI, NRRD, MetaImage; also a label image, DICOM SEG or a surface")
        ->required();
    command->add_option("--output", arguments->outputPath, "Tree to write: .vtp, .csv, .swc or .mrk.json")->required();
    command->add_option("--mask", arguments->maskPath, "Lumen to write as a label image, e.g. .nii.gz");
    command->add_option("--series", arguments->seriesId, "Which series of a DICOM folder; `info FOLDER` lists them");
    command->add_option("--threshold", arguments->tracing.threshold, "Least value of the lumen (default: found)");
    addPoints(command, "--seed", arguments->tracing.seedsInPatient,
              "x,y,z (LPS mm) anywhere in a vessel: trace what is connected to it; may be repeated (default: the great "
              "vessel, aorta or main artery, of a scan is found, all pieces of a mask are taken)");
    addPoints(command, "--avoid", arguments->tracing.avoidInPatient,
              "x,y,z (LPS mm) in the heart, a vein or bone; may be repeated");
    command->add_flag(
        "--tubes", arguments->tracing.tubesOnly,
        "Thin vessels alone, from the seeds: chambers, organs and what is wider than a centimetre end them");
    addStretches(command, arguments->stretches);
    command->add_option("--into", arguments->intoPath, "Tree that vessels traced by --between are added to");
    addPoints(command, "--root", *root, "x,y,z (LPS mm): the tree begins at the end nearest to it");
    command->add_option("--min-length", arguments->tracing.minBranchLengthMm, "Shorter branches are removed, mm")
        ->check(CLI::Range(0.0, 1000.0));
    command->add_option("--min-radius", arguments->tracing.minBranchRadiusMm, "Thinner branches are removed, mm")
        ->check(CLI::Range(0.0, 1000.0));
    command->add_option("--point-spacing", arguments->tracing.pointSpacingMm, "Between points of a branch, mm")
        ->check(CLI::Range(0.01, 100.0));
    command
        ->add_option("--label,--labels", arguments->labels,
                     "Labels that are vessels, by number or name, e.g. 1,2 or aorta; `info` lists them (default: those "
                     "with names of vessels, else all)")
        ->delimiter(',');
    command->add_option("--unit-mm", arguments->unitMm, "Length of one unit of a surface, mm")
        ->check(CLI::Range(1e-6, 1e4));
    auto pieces = std::make_shared<std::string>();
    command
        ->add_option("--pieces", *pieces,
                     "all: every piece of a mask, of a scan those of every great vessel; largest; seeded: those that "
                     "hold a --seed (default: seeded where there is a seed, else all of a mask, of a scan the aorta's)")
        ->check(CLI::IsMember({"all", "largest", "seeded"}));
    auto loops = std::make_shared<std::string>();
    command
        ->add_option("--loops", *loops,
                     "opened: at their thinnest places; kept: those that are no flaw of the lumen, such as the circle "
                     "of Willis (default: opened)")
        ->check(CLI::IsMember({"opened", "kept"}));
    command->add_option("--threads", arguments->tracing.threads, "Threads (default: all); the result is the same")
        ->check(CLI::Range(0, 256));
    command->footer("Example: angiopose-cli trace-vessel cta/ --output tree.vtp --mask lumen.nii.gz");
    command->callback([arguments, root, pieces, loops, &exitCode] {
        if (!root->empty()) {
            arguments->tracing.rootInPatient = root->back();
        }
        arguments->tracing.pieces = piecesCalled(*pieces, !arguments->tracing.seedsInPatient.empty());
        arguments->tracing.loops = *loops == "kept" ? core::VesselLoops::Kept : core::VesselLoops::Opened;
        exitCode = runTraceVessel(*arguments);
    });
}

void addConvert(CLI::App& app, int& exitCode)
{
    auto* command = app.add_subcommand("convert", "Write an input in another format, by the extension of OUT");
    auto arguments = std::make_shared<ConvertArguments>();
    command->add_option("IN", arguments->inputPath, "Any file that AngioPose reads, or a DICOM folder")->required();
    command
        ->add_option(
            "OUT", arguments->outputPath,
            "Centrelines: .vtp .csv .swc .mrk.json; volumes: .nii .nii.gz .nrrd .mha; surfaces: .stl; poses: .json "
            ".tfm .h5, with their camera .txt (P) .yml .yaml .xml (K, R, t); points: .fcsv .mrk.json; X-ray runs: "
            ".dcm; "
            "with --deidentify also DICOM slices, PNG, JPEG, and a folder for a folder")
        ->required();
    command->add_option("--series", arguments->seriesId, "Which series of a DICOM folder; `info FOLDER` lists them");
    command->add_option("--unit-mm", arguments->unitMm, "Length of one unit of a surface or a centreline file, mm")
        ->check(CLI::Range(1e-6, 1e4));
    command->add_option("--spacing-mm", arguments->spacingMm, "Voxels that a surface is filled with, mm")
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