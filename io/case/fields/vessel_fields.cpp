#include "io/case/fields/vessel_fields.h"

#include "core/support/result.h"
#include "core/vessel/vessel_tree.h"
#include "io/case/fields/enum_field.h"
#include "io/case/fields/file_fields.h"
#include "io/case/fields/json_values.h"
#include "io/case/fields/mark_fields.h"
#include "io/case/fields/measurement_fields.h"
#include "io/case/fields/schema_builder.h"
#include "io/case/fields/vessel_key.h"
#include "io/messages/messages.h"

#include <limits>

namespace angiopose::io {
namespace {

Json branchJson(const core::VesselBranch& branch)
{
    Json json{{"id", branch.id}};
    if (!branch.name.empty()) {
        json["name"] = branch.name;
    }
    if (branch.generation >= 0) {
        json["generation"] = branch.generation;
    }
    const bool hasRadii = branch.radiusMm.size() == branch.pointsInPatient.size();
    Json& points = json["pointsMm"] = Json::array();
    for (std::size_t i = 0; i < branch.pointsInPatient.size(); ++i) {
        const Eigen::Vector3d& point = branch.pointsInPatient[i];
        Json values = Json::array({point.x(), point.y(), point.z()});
        if (hasRadii) {
            values.push_back(branch.radiusMm[i]);
        }
        points.push_back(std::move(values));
    }
    return json;
}

core::VesselBranch branchFrom(const Json& json)
{
    core::VesselBranch branch;
    branch.id = json.at("id").get<int>();
    branch.name = json.value("name", "");
    branch.generation = json.value("generation", -1);
    for (const Json& values : json.at("pointsMm")) {
        branch.pointsInPatient.emplace_back(values.at(0).get<double>(), values.at(1).get<double>(),
                                            values.at(2).get<double>());
        if (values.size() > 3) {
            branch.radiusMm.push_back(values[3].get<double>());
        }
    }
    if (branch.radiusMm.size() != branch.pointsInPatient.size()) {
        branch.radiusMm.clear();   // the radii of a branch are known for all points or for none
    }
    return branch;
}

/// Converts a vessel tree to the JSON stored under `vessel.editedTree`, with full double precision.
Json treeJson(const core::VesselTree& tree)
{
    Json json;
    Json& branches = json["branches"] = Json::array();
    for (const core::VesselBranch& branch : tree.branches) {
        branches.push_back(branchJson(branch));
    }
    return json;
}

/// Reads a tree from that JSON, which must conform to the schema; fails with a reason if the tree is unusable.
core::Result<core::VesselTree> treeFromJson(const Json& json)
{
    core::VesselTree tree;
    for (const Json& branch : json.at("branches")) {
        tree.branches.push_back(branchFrom(branch));
        if (tree.find(tree.branches.back().id) != &tree.branches.back()) {
            return core::Error(messages::caseBranchTwice(tree.branches.back().id));
        }
    }
    if (const auto problem = core::findProblem(tree)) {
        return core::Error(*problem);
    }
    return tree;
}

/// Returns the schema of `vessel.editedTree`.
Json treeSchema()
{
    Json point = listSchema(numberSchema());
    point["minItems"] = 3;
    point["maxItems"] = 4;
    Json points = about(listSchema(point), "Points in patient LPS, each with its radius if known.");
    points["minItems"] = 2;
    const Json id = integerSchema(std::numeric_limits<int>::min(), std::numeric_limits<int>::max());
    Json branches = listSchema(objectSchema(
        {{"id", id}, {"name", textSchema()}, {"generation", integerSchema(0, 100000)}, {"pointsMm", std::move(points)}},
        {"id", "pointsMm"}));
    branches["minItems"] = 1;
    return objectSchema({{"branches", std::move(branches)}}, {"branches"});
}

namespace fs = std::filesystem;
using core::VesselInput;
using core::VesselInputKind;
using core::Vessels;
using core::VesselTracingOptions;

constexpr std::array pieceWords = {"usual", "all", "largest"};
constexpr std::array loopWords = {"opened", "kept"};

Json inputSchema(VesselInputKind kind)
{
    static constexpr std::array sentences = {
        "One of centerline, segmentation, surface or volume; the first of them that is present is read.",
        "Label image: NIfTI, NRRD, MetaImage.", "VTP, VTK, STL, PLY, OBJ.",
        "NIfTI, NRRD, MetaImage, a DICOM slice, or a folder of slices; then dicom.seriesInstanceUid names the series. "
        "In addition to another kind: the scan that contains those vessels."};
    Json members{{"path", schemaReference("path")},
                 {"sha256", schemaReference("sha256")},
                 {"dicom", objectSchema({{"seriesInstanceUid", textSchema()}})}};
    if (kind == VesselInputKind::Segmentation) {
        members["origin"] = about(choiceSchema({"edited"}), "Edited manually: the mask belongs to this case.");
    }
    const Json schema = objectSchema(members, {"path"});
    return about(schema, sentences[static_cast<std::size_t>(kind)]);
}

Json inputJson(const core::InputFile& file, const std::string& seriesId, const fs::path& folder)
{
    Json json = fileJson(file, folder);
    if (!json.is_null() && !seriesId.empty()) {
        json["dicom"]["seriesInstanceUid"] = seriesId;
    }
    return json;
}

/// Returns the field of the input file of one kind. The first kind present is the source of the vessels; an additional
/// volume is the scan that shows them.
StoredField<Vessels> inputField(VesselInputKind kind)
{
    return {vesselKey(kind), inputSchema(kind),
            [kind](const Json& value, Vessels& vessels, ReadContext& reading) {
                const std::string seriesId = value.value("dicom", Json::object()).value("seriesInstanceUid", "");
                if (!std::exchange(reading.hasVessels, true)) {
                    vessels.file = fileFrom(value);
                    vessels.input.kind = kind;
                    vessels.input.seriesId = seriesId;
                    vessels.isLumenEdited =
                        kind == VesselInputKind::Segmentation && value.value("origin", "") == "edited";
                } else if (kind == VesselInputKind::Volume) {
                    vessels.scanFile = fileFrom(value);
                    vessels.scanSeriesId = seriesId;
                }
            },
            [kind](const Vessels& vessels, const fs::path& folder) {
                if (kind == vessels.input.kind && vessels.isLumenEdited) {
                    Json mask = inputJson(vessels.file, {}, folder);
                    mask["origin"] = "edited";
                    return mask;
                }
                return kind == vessels.input.kind        ? inputJson(vessels.file, vessels.input.seriesId, folder)
                       : kind == VesselInputKind::Volume ? inputJson(vessels.scanFile, vessels.scanSeriesId, folder)
                                                         : Json();
            }};
}

StoredField<Vessels> tracingField()
{
    const Json schema{{"description", "Options for tracing a segmentation, surface or volume; absent: the defaults."}};
    return writeFieldIf([](const Vessels& vessels) { return vessels.input.kind != VesselInputKind::Centerline; },
                        memberField<Vessels>(
                            [](auto& vessels) -> auto& { return vessels.input; },
                            objectField("tracing", schema, &VesselInput::tracing, vesselTracingFields())));
}

StoredField<Vessels> labelsField()
{
    return memberField<Vessels>(
        [](auto& vessels) -> auto& { return vessels.input; },
        optionalField("labels",
                      about(listSchema(integerSchema(1, 65535)),
                            "Labels of a segmentation that are vessels; empty or absent: all."),
                      &VesselInput::labels));
}

StoredField<Vessels> unitField()
{
    const Json schema{{"type", "number"}, {"exclusiveMinimum", 0}, {"maximum", 10000}};
    return memberField<Vessels>(
        [](auto& vessels) -> auto& { return vessels.input; },
        optionalField("unitMm", about(schema, "Length of one unit of a surface or a centerline file, mm."),
                      &VesselInput::unitMm));
}

/// Returns the field of the tree that the user edited, which replaces the tree of the input.
StoredField<Vessels> editedTreeField()
{
    return {
        "editedTree", about(treeSchema(), "The vessels after manual editing; they replace those of the input above."),
        [](const Json& value, Vessels& vessels, ReadContext& reading) {
            auto tree = treeFromJson(value);
            if (!tree) {
                reading.problems.push_back(messages::caseEditedTree(tree.error().message).about("vessel.editedTree"));
                return;
            }
            vessels.tree = std::make_shared<const core::VesselTree>(std::move(tree).value());
            vessels.isTreeEdited = true;
        },
        [](const Vessels& vessels, const fs::path&) {
            return vessels.isTreeEdited && vessels.tree ? treeJson(*vessels.tree) : Json();
        }};
}

}   // namespace

const StoredFields<VesselTracingOptions>& vesselTracingFields()
{
    using Options = VesselTracingOptions;
    static const StoredFields<Options> fields{
        valueField("minBranchLengthMm", numberSchema(0, 1000), &Options::minBranchLengthMm),
        valueField("minBranchRadiusMm", numberSchema(0, 1000), &Options::minBranchRadiusMm),
        valueField("pointSpacingMm", numberSchema(0.01, 100), &Options::pointSpacingMm),
        optionalField(
            "threshold",
            about(numberSchema(), "Minimum value of the lumen (HU for CT); absent: estimated from the blood."),
            &Options::threshold),
        optionalField("seedsInPatientMm", listSchema(schemaReference("point")), &Options::seedsInPatient),
        optionalField("avoidInPatientMm",
                      about(listSchema(schemaReference("point")),
                            "Points outside vessels: what is connected to them by a wider path is not a vessel."),
                      &Options::avoidInPatient),
        optionalField("rootInPatientMm", schemaReference("point"), &Options::rootInPatient),
        optionalField("tubesOnly",
                      about(flagSchema(),
                            "Only thin vessels, from the seeds; tracing ends at chambers, organs and wide vessels."),
                      &Options::tubesOnly),
        writeFieldIf([](const Options& options) { return options.pieces != core::TracedPieces::Usual; },
                     enumField("pieces",
                               about(choiceSchema({"usual", "all", "largest"}),
                                     "Pieces that are traced without a seed; absent or usual: all of a mask, or that "
                                     "of the great vessel of a scan."),
                               &Options::pieces, pieceWords)),
        writeFieldIf([](const Options& options) { return options.loops != core::VesselLoops::Opened; },
                     enumField("loops", about(choiceSchema({"opened", "kept"}), "Treatment of loops; absent: opened."),
                               &Options::loops, loopWords))};
    return fields;
}

const StoredFields<Vessels>& vesselFields()
{
    static const StoredFields<Vessels> fields{
        inputField(VesselInputKind::Centerline),
        inputField(VesselInputKind::Segmentation),
        inputField(VesselInputKind::Surface),
        inputField(VesselInputKind::Volume),
        tracingField(),
        labelsField(),
        unitField(),
        valueField("auxiliaryBranches", about(schemaReference("branchIds"), "Auxiliary branches; empty: the nodes."),
                   &Vessels::auxiliaryBranchIds),
        valueField("excludedBranches", schemaReference("branchIds"), &Vessels::excludedBranchIds),
        optionalField("hiddenBranches", about(schemaReference("branchIds"), "Branches that are used but not drawn."),
                      &Vessels::hiddenBranchIds),
        optionalField(
            "pivotInPatientMm",
            about(schemaReference("point"),
                  "Rotation center for manual rotation and reference of locked shifts; absent: the vessels' centroid."),
            &Vessels::pickedPivotInPatient),
        marksField(),
        sliceMeasurementsField(),
        editedTreeField(),
    };
    return fields;
}

}   // namespace angiopose::io
