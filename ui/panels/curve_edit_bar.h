#pragma once

#include "ui/views/tools/edit_curves_tool.h"

#include <QFrame>

#include <map>
#include <utility>

class QLabel;
class QPushButton;
class QToolButton;

namespace angiopose::ui {

/// The edits of the traced curves as buttons, at the bottom of the angiogram while that mode is on.
class CurveEditBar : public QFrame {
    Q_OBJECT
public:
    explicit CurveEditBar(QWidget* parent = nullptr);

    void showEdit(CurveEdit edit);
    void showCurves(int count, int suspects);
    void setEdited(bool edited);   ///< only edited curves can be traced again

signals:
    void editChosen(ui::CurveEdit edit);
    void traceAgainRequested();
    void doneRequested();

private:
    void sayCounts();

    std::map<CurveEdit, QToolButton*> buttons_;
    std::pair<int, int> shownCounts_;   ///< of curves, and of suspects among them
    QLabel* count_;
    QPushButton* traceAgain_;
};

}   // namespace angiopose::ui