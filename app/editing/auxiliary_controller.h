#pragma once

#include "app/document/case_document.h"
#include "app/editing/branch_advice.h"
#include "app/editing/branch_controller.h"
#include "ui/dialogs/auxiliary_dialog.h"
#include "ui/views/tools/lasso_tool.h"

#include <QObject>
#include <QPointer>

#include <vector>

class QWidget;

namespace angiopose::ui {
class AngiogramView;
class WindowActions;
}   // namespace angiopose::ui

namespace angiopose::app {

/// Supports the selection of auxiliary branches by lasso, by generation, by radius, and by how strongly each branch
/// constrains the pose, with a live preview of the effect.
class AuxiliaryController : public QObject {
    Q_OBJECT
public:
    AuxiliaryController(CaseDocument& document, BranchController& branches, ui::WindowActions& actions,
                        ui::AngiogramView& view, QWidget& dialogParent, QObject* parent = nullptr);

    bool isRunning() const { return adviser_.isRunning(); }   ///< true while computing the branches' constraints
    void open();
    ui::AuxiliaryDialog* dialog() const { return dialog_; }   ///< null while the dialog is closed
    const std::vector<int>& suggestion() const;   ///< empty if unknown

    void selectInside(const QPolygonF& outlineInImagePx, ui::LassoEffect effect);
    void selectGenerations(int last);
    void selectByRadius(double atLeastMm);
    void selectSuggested();

signals:
    void refused(const QString& reason);

private:
    void connectDialog();
    void useAlternatingMethod();
    void request();
    void show();

    CaseDocument& document_;
    BranchController& branches_;
    ui::WindowActions& actions_;
    ui::AngiogramView& view_;
    QWidget& dialogParent_;
    QPointer<ui::AuxiliaryDialog> dialog_;
    BranchAdviser adviser_;
};

}   // namespace angiopose::app
