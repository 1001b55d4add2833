#pragma once

#include <QStringList>
#include <QWidget>

class QVBoxLayout;

namespace ui {

/// What the middle shows while no case is open: what can be dropped, the sample case, recent cases.
class WelcomePage : public QWidget {
    Q_OBJECT
public:
    explicit WelcomePage(QWidget* parent = nullptr);

    void showRecent(const QStringList& paths);

signals:
    void openRequested();
    void sampleRequested();
    void recentRequested(const QString& path);

private:
    QVBoxLayout* recent_;
};

}   // namespace ui
