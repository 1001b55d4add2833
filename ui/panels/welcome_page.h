#pragma once

#include "ui/panels/recent_list.h"

#include <QBoxLayout>
#include <QWidget>

namespace angiopose::ui {

/// Start page, shown if no case is open: supported file types, the sample case and recent cases.
class WelcomePage : public QWidget {
    Q_OBJECT
public:
    explicit WelcomePage(QWidget* parent = nullptr);

    RecentList& recent() { return *recent_; }

signals:
    void openRequested();
    void folderRequested();
    void sampleRequested();

protected:
    void resizeEvent(QResizeEvent* event) override;

private:
    RecentList* recent_;
    QWidget* page_;
    QBoxLayout* buttons_;
};

}   // namespace angiopose::ui
