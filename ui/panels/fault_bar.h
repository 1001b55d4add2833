#pragma once

#include <QLabel>
#include <QWidget>

namespace angiopose::ui {

/// Says above the views that the program ended by a fault last time, where what is known of it lies, and offers to
/// hand that on. Hidden until there is something to say.
class FaultBar : public QWidget {
    Q_OBJECT
public:
    explicit FaultBar(QWidget* parent = nullptr);

    void showFault(const QString& dumpPath);

signals:
    void bundleRequested();

private:
    void sayWhere();

    QString dumpPath_;
    QLabel* words_;
};

}   // namespace angiopose::ui
