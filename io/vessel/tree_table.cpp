#include "io/vessel/tree_table.h"

#include "io/messages/messages.h"
#include "io/support/csv_table.h"
#include "io/support/file_error.h"
#include "io/support/numbers.h"

#include <algorithm>
#include <array>
#include <limits>

namespace angiopose::io {
namespace {

struct TreeColumns {
    std::size_t x = 0, y = 1, z = 2;
    std::optional<std::size_t> radius, branch, label;
};

core::Result<TreeColumns> columnsOf(const CsvTable& table)
{
    if (!table.hasHeader) {
        if (!table.rows.empty() && table.rows.front().size() == 3) {
            return TreeColumns{};
        }
        return fileError(table.path, messages::treeTableNoHeader());
    }
    const auto x = table.column("x"), y = table.column("y"), z = table.column("z");
    if (!x || !y || !z) {
        return fileError(table.path, messages::treeTableNoColumns());
    }
    if (table.column("id") && !table.column("branch")) {
        return fileError(table.path, messages::treeTableIsGraph());
    }
    return TreeColumns{*x, *y, *z, table.column("radius"), table.column("branch"), table.column("label")};
}

struct TreeRow {
    Eigen::Vector3d point;
    double radius = std::numeric_limits<double>::quiet_NaN();
    int branch = 1;
    std::string label;
};

core::Result<TreeRow> parseRow(const CsvTable& table, std::size_t row, const TreeColumns& columns)
{
    TreeRow content;
    const std::array<std::size_t, 3> axes = {columns.x, columns.y, columns.z};
    for (std::size_t axis = 0; axis < axes.size(); ++axis) {
        const auto value = numberInCell(table, row, axes[axis]);
        if (!value) {
            return value.error();
        }
        content.point[static_cast<Eigen::Index>(axis)] = value.value();
    }
    const auto& cells = table.rows[row];
    if (columns.radius) {
        content.radius = parseNumber(cells[*columns.radius]).value_or(content.radius);
    }
    if (columns.label) {
        content.label = cells[*columns.label];
    }
    if (columns.branch) {
        const auto id = branchIdInCell(table, row, *columns.branch);
        if (!id) {
            return id.error();
        }
        content.branch = id.value();
    }
    return content;
}

/// Joins consecutive rows with the same branch ID into a line; a branch ID that recurs later starts another line.
void joinRows(LineSet& set, const std::vector<int>& ids, const std::vector<std::string>& labels, bool hasIds)
{
    for (std::size_t i = 0; i < set.points.size(); ++i) {
        if (i == 0 || ids[i] != ids[i - 1]) {
            set.lines.emplace_back();
            set.names.push_back(labels[i]);
            if (hasIds) {
                set.ids.push_back(ids[i]);
            }
        }
        set.lines.back().push_back(i);
    }
}

std::string withoutSeparators(std::string name)
{
    std::replace_if(
        name.begin(), name.end(), [](char c) { return c == ',' || c == '"'; }, ' ');
    return sanitizedBranchName(name);
}

}   // namespace

bool isTreeTable(std::string_view head)
{
    const auto parsed = parseCsv(head.substr(0, head.find('\n')), {});
    if (!parsed) {
        return false;
    }
    const CsvTable& table = parsed.value();
    return table.hasHeader ? table.column("z").has_value() : !table.rows.empty() && table.rows.front().size() == 3;
}

core::Result<LineSet> parseTreeTable(std::string_view text, const std::string& path)
{
    const auto parsed = parseCsv(text, path);
    if (!parsed) {
        return parsed.error();
    }
    const CsvTable& table = parsed.value();
    const auto columns = columnsOf(table);
    if (!columns) {
        return columns.error();
    }
    LineSet set;
    std::vector<int> ids;
    std::vector<std::string> labels;
    for (std::size_t row = 0; row < table.rows.size(); ++row) {
        auto parsedRow = parseRow(table, row, columns.value());
        if (!parsedRow) {
            return parsedRow.error();
        }
        TreeRow content = std::move(parsedRow).value();
        set.points.emplace_back(content.point);
        if (columns.value().radius) {
            set.radius.push_back(content.radius);
        }
        ids.push_back(content.branch);
        labels.push_back(std::move(content.label));
    }
    joinRows(set, ids, labels, columns.value().branch.has_value());
    return set;
}

std::string treeTable(const core::VesselTree& tree)
{
    const bool hasRadius = std::any_of(tree.branches.begin(), tree.branches.end(),
                                       [](const core::VesselBranch& branch) { return !branch.radiusMm.empty(); });
    const bool hasNames = std::any_of(tree.branches.begin(), tree.branches.end(),
                                      [](const core::VesselBranch& branch) { return !branch.name.empty(); });
    std::string text =
        std::string("x,y,z") + (hasRadius ? ",radius" : "") + ",branch" + (hasNames ? ",label" : "") + "\n";
    for (const core::VesselBranch& branch : tree.branches) {
        for (std::size_t i = 0; i < branch.pointsInPatient.size(); ++i) {
            const Eigen::Vector3d& p = branch.pointsInPatient[i];
            text += toText(p.x()) + "," + toText(p.y()) + "," + toText(p.z());
            if (hasRadius) {
                text += "," + (branch.radiusMm.empty() ? std::string("nan") : toText(branch.radiusMm[i]));
            }
            text += "," + std::to_string(branch.id) + (hasNames ? "," + withoutSeparators(branch.name) : "") + "\n";
        }
    }
    return text;
}

}   // namespace angiopose::io
