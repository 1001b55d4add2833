#pragma once

#include "ui/controls/section.h"

#include <QMenuBar>
#include <QWidget>

namespace angiopose::ui {

/// Top row of the window: case title, study, menus and the permanent "not for clinical use" notice.
class HeaderBar : public QWidget {
    Q_OBJECT
public:
    explicit HeaderBar(QWidget* parent = nullptr);

    void showTitle(const QString& title);   ///< `title` includes `*` if there are unsaved changes
    void showStudy(const QString& study);
    QMenuBar* menuBar() const { return menuBar_; }

private:
    ElidedLabel* title_;
    ElidedLabel* study_;
    QMenuBar* menuBar_;
};

}   // namespace angiopose::ui
