#pragma once

#include "ui/panels/recent_list.h"

#include <QWidget>

namespace angiopose::ui {

/// What the middle shows while no case is open: what can be dropped, the sample case, recent cases.
class WelcomePage : public QWidget {
    Q_OBJECT
public:
    explicit WelcomePage(QWidget* parent = nullptr);

    RecentList& recent() { return *recent_; }

signals:
    void openRequested();
    void folderRequested();
    void sampleRequested();

private:
    RecentList* recent_;
};

}   // namespace angiopose::ui
