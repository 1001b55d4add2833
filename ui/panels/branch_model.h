#pragma once

#include "core/vessel/vessel_tree.h"
#include "ui/scenes/overlay_scene.h"

#include <QAbstractListModel>

#include <map>

namespace ui {

/// The branches of a tree with their marks and residuals, one row each.
class BranchModel : public QAbstractListModel {
    Q_OBJECT
public:
    enum Role { IdRole = Qt::UserRole, NameRole, LengthRole, AuxiliaryRole, ExcludedRole, HoveredRole, ResidualRole };

    using QAbstractListModel::QAbstractListModel;

    void setTree(const core::VesselTree& tree);
    void setMarks(const BranchMarks& marks);
    void setResiduals(const std::map<int, double>& residualMm, double scaleMaximumMm);   ///< medians by branch id

    int idAt(int row) const { return rows_[static_cast<std::size_t>(row)].id; }
    int rowOf(int branchId) const;   ///< −1 when there is none
    double scaleMaximumMm() const { return scaleMaximumMm_; }

    int rowCount(const QModelIndex& parent = {}) const override;
    QVariant data(const QModelIndex& index, int role) const override;

private:
    struct Row {
        int id = 0;
        QString name;
        double lengthMm = 0.0;
    };
    void refresh();
    QString description(const Row& row) const;

    std::vector<Row> rows_;
    BranchMarks marks_;
    std::map<int, double> residualMm_;
    double scaleMaximumMm_ = 0.0;
};

}   // namespace ui
