#pragma once

#include <QDialog>
#include <QStringList>
#include <QWidget>

class QComboBox;
class QPushButton;

namespace angiopose::ui {

/// Row that selects an archive and adds, edits, removes and tests archives.
class NodeBar : public QWidget {
    Q_OBJECT
public:
    explicit NodeBar(QWidget* parent = nullptr);

    void showNodes(const QStringList& names, const QString& current);
    QString node() const;   ///< empty if no archive is configured
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

/// Dialog that selects the PACS to which the DICOM objects of a case are sent, and shows the transfer progress; deletes
/// itself when closed.
class SendDialog : public QDialog {
    Q_OBJECT
public:
    explicit SendDialog(QWidget* parent);

    NodeBar& nodes() { return *nodes_; }
    TransferLine& line() { return *transferStatus_; }

    void showState();   ///< enables the actions that are currently possible
    void showNode();   ///< shows the selected archive, or that none is configured
    void showSent(const QString& text);   ///< shows that the transfer is complete

signals:
    void sendRequested();

private:
    NodeBar* nodes_;
    TransferLine* transferStatus_;
    QPushButton* close_;
    QPushButton* send_;
};

}   // namespace angiopose::ui
