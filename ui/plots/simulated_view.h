#pragma once

#include "core/geometry/sight.h"
#include "core/vessel/vessel_tree.h"

#include <QWidget>

#include <memory>
#include <optional>

namespace angiopose::ui {

/// The vessels as the detector would show them, as wide as they are, what is looked at in the accent.
class SimulatedView : public QWidget {
    Q_OBJECT
public:
    explicit SimulatedView(QWidget* parent = nullptr);

    /// No sight: nothing to show yet.
    void showVessels(std::shared_ptr<const core::VesselTree> tree, int branchId,
                     const std::optional<core::Sight>& sight);
    QSize sizeHint() const override { return {230, 230}; }

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    void paintBranch(QPainter& painter, const core::VesselBranch& branch, double scale) const;

    std::shared_ptr<const core::VesselTree> tree_;
    int branchId_ = 0;
    std::optional<core::Sight> sight_;
};

}   // namespace angiopose::ui
