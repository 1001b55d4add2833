#pragma once

#include <QDialog>
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

class NodeBar;
class TransferLine;

/// Asks to which archive the DICOM objects of a case are sent, and shows how that goes; deletes itself when closed.
class SendDialog : public QDialog {
    Q_OBJECT
public:
    explicit SendDialog(QWidget* parent);

    NodeBar& nodes() { return *nodes_; }
    TransferLine& line() { return *line_; }

    void showState();   ///< what can be done now
    void showNode();   ///< which is chosen now, or that there is none
    void showSent(const QString& words);   ///< nothing is left to do

signals:
    void sendRequested();

private:
    NodeBar* nodes_;
    TransferLine* line_;
    QPushButton* close_;
    QPushButton* send_;
};

}   // namespace angiopose::ui
