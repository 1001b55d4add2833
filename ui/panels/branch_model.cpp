#include "ui/panels/branch_model.h"

#include "ui/panels/result_sentences.h"
#include "ui/words/language.h"
#include "ui/words/number.h"

#include <algorithm>
#include <numeric>

namespace angiopose::ui {
namespace {

double meanRadiusMm(const core::VesselBranch& branch)
{
    const auto& radii = branch.radiusMm;
    return radii.empty() ? -1.0 : std::accumulate(radii.begin(), radii.end(), 0.0) / static_cast<double>(radii.size());
}

}   // namespace

void BranchModel::setTree(const core::VesselTree& tree)
{
    beginResetModel();
    rows_.clear();
    for (const core::VesselBranch& branch : tree.branches) {
        rows_.push_back({branch.id, displayName(branch), QString::fromStdString(branch.name), branch.lengthMm(),
                         meanRadiusMm(branch), branch.generation});
    }
    residualMm_.clear();
    endResetModel();
}

void BranchModel::setMarks(const BranchMarks& marks)
{
    if (marks != marks_) {
        marks_ = marks;
        refresh();
    }
}

void BranchModel::setResiduals(const std::map<int, double>& residualMm, double scaleMaximumMm)
{
    residualMm_ = residualMm;
    scaleMaximumMm_ = scaleMaximumMm;
    refresh();
}

int BranchModel::rowOf(int branchId) const
{
    const auto it = std::ranges::find(rows_, branchId, &Row::id);
    return it == rows_.end() ? -1 : static_cast<int>(it - rows_.begin());
}

int BranchModel::rowCount(const QModelIndex& parent) const
{
    return parent.isValid() ? 0 : static_cast<int>(rows_.size());
}

QVariant BranchModel::data(const QModelIndex& index, int role) const
{
    const Row& row = rows_[static_cast<std::size_t>(index.row())];
    switch (role) {
        case Qt::DisplayRole:
        case NameRole:
            return row.name;
        case Qt::AccessibleTextRole:
        case Qt::ToolTipRole:
            return description(row);
        case IdRole:
            return row.id;
        case Qt::EditRole:
            return row.ownName;
        case LengthRole:
            return row.lengthMm;
        case RadiusRole:
            return row.radiusMm;
        case GenerationRole:
            return row.generation;
        case OrderRole:
            return index.row();
        case HiddenRole:
            return marks_.hidden.contains(row.id);
        case ResidualScaleRole:
            return scaleMaximumMm_;
        case AuxiliaryRole:
            return marks_.auxiliary.contains(row.id);
        case ExcludedRole:
            return marks_.excluded.contains(row.id);
        case HoveredRole:
            return marks_.hovered == row.id;
        case ResidualRole: {
            const auto it = residualMm_.find(row.id);
            return it == residualMm_.end() ? QVariant() : QVariant(it->second);
        }
        default:
            return {};
    }
}

bool BranchModel::setData(const QModelIndex& index, const QVariant& value, int role)
{
    if (role == Qt::EditRole) {
        emit renamed(rows_[static_cast<std::size_t>(index.row())].id, value.toString());
    }
    return false;   // no change yet: the owner responds with a new tree
}

Qt::ItemFlags BranchModel::flags(const QModelIndex& index) const
{
    return QAbstractListModel::flags(index) | Qt::ItemIsEditable;
}

void BranchModel::refresh()
{
    if (!rows_.empty()) {
        emit dataChanged(index(0), index(static_cast<int>(rows_.size()) - 1));
    }
}

QString BranchModel::description(const Row& row) const
{
    QStringList parts{tr("%1, %2 mm long").arg(row.name).arg(numberText(row.lengthMm, 0))};
    if (row.radiusMm >= 0.0) {
        parts << tr("radius %1 mm").arg(numberText(row.radiusMm, 1));
    }
    if (row.generation >= 0) {
        parts << tr("generation %1").arg(row.generation);
    }
    if (marks_.hidden.contains(row.id)) {
        parts << tr("hidden");
    }
    if (marks_.auxiliary.contains(row.id)) {
        parts << tr("auxiliary branch");
    }
    if (marks_.excluded.contains(row.id)) {
        parts << tr("excluded");
    }
    if (const auto it = residualMm_.find(row.id); it != residualMm_.end()) {
        parts << tr("median residual %1 mm").arg(numberText(it->second, 2));
    }
    return joinNames(parts);
}

}   // namespace angiopose::ui
