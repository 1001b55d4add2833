#pragma once

#include "ui/views/tools/edit_curves_tool.h"

#include <QFrame>

#include <map>

class QLabel;
class QPushButton;
class QToolButton;

namespace ui {

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
    std::map<CurveEdit, QToolButton*> buttons_;
    QLabel* count_;
    QPushButton* traceAgain_;
};

}   // namespace ui
