#pragma once

#include "core/vessel/vessel_tree.h"
#include "ui/scenes/overlay_scene.h"

#include <QAbstractListModel>

#include <map>

namespace angiopose::ui {

/// List model of the branches of a tree with their marks and residuals, one branch per row.
class BranchModel : public QAbstractListModel {
    Q_OBJECT
public:
    enum Role {
        IdRole = Qt::UserRole,
        NameRole,
        LengthRole,
        RadiusRole,   ///< mean radius, mm; −1 if unknown
        GenerationRole,   ///< −1 if unknown
        OrderRole,   ///< index of the branch in the tree
        AuxiliaryRole,
        ExcludedRole,
        HiddenRole,
        HoveredRole,
        ResidualRole,
        ResidualScaleRole   ///< maximum of the residual scale, mm; 0 if there is none
    };

    using QAbstractListModel::QAbstractListModel;

    void setTree(const core::VesselTree& tree);
    void setMarks(const BranchMarks& marks);
    void setResiduals(const std::map<int, double>& residualMm, double scaleMaximumMm);   ///< medians by branch ID

    int rowOf(int branchId) const;   ///< −1 if the tree has no such branch

    int rowCount(const QModelIndex& parent = {}) const override;
    QVariant data(const QModelIndex& index, int role) const override;
    bool setData(const QModelIndex& index, const QVariant& value, int role) override;   ///< only emits `renamed`
    Qt::ItemFlags flags(const QModelIndex& index) const override;

signals:
    void renamed(int branchId, const QString& name);

private:
    struct Row {
        int id = 0;
        QString name;   ///< displayed name
        QString ownName;   ///< user-defined name; empty if the branch is unnamed
        double lengthMm = 0.0;
        double radiusMm = -1.0;
        int generation = -1;
    };
    void refresh();
    QString description(const Row& row) const;

    std::vector<Row> rows_;
    BranchMarks marks_;
    std::map<int, double> residualMm_;
    double scaleMaximumMm_ = 0.0;
};

}   // namespace angiopose::ui
