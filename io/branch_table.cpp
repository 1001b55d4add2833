#include "io/branch_table.h"

#include "io/support/atomic_file.h"
#include "io/support/csv_table.h"
#include "io/support/numbers.h"

#include <cmath>
#include <initializer_list>
#include <optional>

namespace angiopose::io {
namespace {

constexpr std::string_view branchHeader =
    "branch,name,length_mm,tortuosity,greatest_curvature_per_mm,mean_diameter_mm,least_diameter_mm,"
    "greatest_diameter_mm,narrowing_percent,narrowing_at_mm,narrowing_from_mm,narrowing_to_mm,narrowing_diameter_mm,"
    "narrowing_reference_mm,notes\n";
constexpr std::string_view profileHeader = "arc_mm,x,y,z,diameter_mm,reference_mm,curvature_per_mm\n";

std::string cellsOf(std::initializer_list<std::optional<double>> values)
{
    std::string cells;
    for (const std::optional<double>& value : values) {
        cells += "," + (value && std::isfinite(*value) ? toText(*value) : std::string());
    }
    return cells;
}

std::string stenosisCells(const std::optional<core::StenosisMeasure>& stenosis)
{
    return stenosis ? cellsOf({stenosis->percent, stenosis->positionMm, stenosis->fromMm, stenosis->toMm,
                               stenosis->diameterMm, stenosis->referenceDiameterMm})
                    : ",,,,,,";
}

std::string doubtsCell(const core::Messages& warnings)
{
    std::string text;
    for (const core::Message& doubt : warnings) {
        text += (text.empty() ? "" : " ") + doubt.text();
    }
    return "," + csvCell(text);
}

}   // namespace

std::string branchTable(const core::VesselTree& tree)
{
    std::string table(branchHeader);
    for (const core::VesselBranch& branch : tree.branches) {
        table += std::to_string(branch.id) + "," + csvCell(branch.name);
        if (const auto measured = core::measureProfile(branch)) {
            const core::BranchProfile& profile = measured.value();
            table += cellsOf({profile.lengthMm, profile.tortuosity, profile.maxCurvaturePerMm, profile.meanDiameterMm,
                              profile.minDiameterMm, profile.maxDiameterMm}) +
                     stenosisCells(profile.stenosis) + doubtsCell(profile.warnings);
        } else {
            table += ",,,,,," + stenosisCells({}) + doubtsCell({measured.error().message});
        }
        table += "\n";
    }
    return table;
}

std::string profileTable(const core::BranchProfile& profile)
{
    std::string table(profileHeader);
    for (const core::ProfileSample& sample : profile.samples) {
        const Eigen::Vector3d& place = sample.pointInPatient;
        table += toText(sample.arcLengthMm) +
                 cellsOf({place.x(), place.y(), place.z(), sample.diameterMm, sample.referenceDiameterMm,
                          sample.curvaturePerMm}) +
                 "\n";
    }
    return table;
}

core::Status writeBranchTable(const core::VesselTree& tree, const std::string& path)
{
    return writeAtomically(path, branchTable(tree));
}

core::Status writeProfile(const core::BranchProfile& profile, const std::string& path)
{
    return writeAtomically(path, profileTable(profile));
}

}   // namespace angiopose::io
