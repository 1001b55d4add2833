#include "core/evaluation/report/table_parts.h"
#include "core/evaluation/trial/evaluated_method.h"
#include "core/registration/options/option_fields.h"
#include "core/support/format_number.h"

#include <algorithm>

namespace angiopose::core {
namespace {

constexpr std::size_t minSettings = 4;   // minimum for an ablation; fewer settings make a comparison

/// The three settings of DynaWeightPnP that an ablation varies.
struct AblationSetting {
    std::string label;
    PriorPreset preset = PriorPreset::SeedSum;
    bool rotationFirst = false;
    bool alternation = false;
};

std::vector<AblationSetting> settingsOf(const RunGroups& groups)
{
    std::vector<AblationSetting> settings;
    for (const std::string& label : groups.methods()) {
        const auto evaluatedMethod = parseMethod(label);
        if (evaluatedMethod && evaluatedMethod.value().options.method == "dynaweight") {
            const RegistrationOptions& options = evaluatedMethod.value().options;
            settings.push_back({label, options.seed.preset, options.seed.rotationFirst, options.seed.alternation});
        }
    }
    return settings;
}

std::string presetName(PriorPreset preset)
{
    return std::string(nameOf(*findOption("preset"), static_cast<std::size_t>(preset)));
}

std::string cellOf(const RunGroup& group)
{
    return group.count() == 0 ? "–"
                              : fixedText(100.0 * group.countIf(isGrossFailurePx) / group.count(), 1) + " / " +
                                    significantText(group.median(&RunRecord::meanPx)) + " / " +
                                    significantText(group.median(&RunRecord::angleDeg)) + " / " +
                                    fixedText(group.median(&RunRecord::seedDistanceMm), 2);
}

ResultTable tableOf(const RunGroups& groups, const Condition& condition, const std::vector<AblationSetting>& settings)
{
    ResultTable table;
    table.id = std::string(groups.protocol().id) + "-" + condition.id + "-ablation";
    table.title = "Ablation of DynaWeightPnP: " + condition.title + " (GFR % / median PR px / angle ° / Dist mm)";
    table.columns = {"prior", "neither", "alternation", "rotation first", "both"};
    for (const PriorPreset preset :
         {PriorPreset::SeedSum, PriorPreset::SeedMean, PriorPreset::SeedMetric, PriorPreset::NoPrior}) {
        ResultTable::Row row{{presetName(preset), "–", "–", "–", "–"}, false};
        for (const AblationSetting& setting : settings) {
            if (setting.preset == preset) {
                const std::size_t column = 1 + (setting.alternation ? 1 : 0) + (setting.rotationFirst ? 2 : 0);
                row.cells[column] = cellOf(groups.groupOf(condition, setting.label));
            }
        }
        table.rows.push_back(std::move(row));
    }
    table.notes = {"The pull toward the initial pose ties Dist to that of the initial pose; the alternation frees it."};
    return table;
}

}   // namespace

std::vector<ResultTable> ablationTables(const RunGroups& groups)
{
    const std::vector<AblationSetting> settings = settingsOf(groups);
    std::vector<ResultTable> tables;
    if (settings.size() >= minSettings) {
        for (const Condition& condition : groups.conditions()) {
            tables.push_back(tableOf(groups, condition, settings));
        }
    }
    return tables;
}

}   // namespace angiopose::core
