#pragma once

#include <QStringList>
#include <QWidget>

class QComboBox;
class QPushButton;

namespace angiopose::ui {

/// Which archive is meant, and the list of archives: add, edit, remove, test.
class NodeBar : public QWidget {
    Q_OBJECT
public:
    explicit NodeBar(QWidget* parent = nullptr);

    void showNodes(const QStringList& names, const QString& chosen);
    QString node() const;   ///< empty: there is none yet
    void setBusy(bool isBusy);

signals:
    void nodeChosen(const QString& name);
    void testRequested();
    void addRequested();
    void editRequested();
    void removeRequested();

private:
    void showState();

    bool isBusy_ = false;
    QComboBox* nodes_;
    QPushButton* test_;
    QPushButton* add_;
    QPushButton* edit_;
    QPushButton* remove_;
};

}   // namespace angiopose::ui
