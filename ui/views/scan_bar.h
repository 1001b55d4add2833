#pragma once

#include <QWidget>

class QAction;
class QMenu;
class QSlider;
class QToolButton;

namespace angiopose::ui {

/// Above the 3-D view: how the scan is seen in it, and how strongly.
class ScanBar : public QWidget {
    Q_OBJECT
public:
    explicit ScanBar(QWidget* parent = nullptr);

    void fillMenu(const QList<QAction*>& actions);
    void showState(const QString& words, bool isShown);   ///< the strength is there while the scan is shown
    void showStrength(double strength);   ///< 0…1; silent

signals:
    void strengthChanged(double strength);

private:
    QToolButton* choice_;
    QMenu* menu_;
    QSlider* strength_;
};

}   // namespace angiopose::ui
