#pragma once

#include <QDialog>
#include <QStringList>
#include <QWidget>

class QComboBox;
class QPushButton;

namespace angiopose::ui {

/// Selects an archive and manages the list of archives: add, edit, remove, test.
class NodeBar : public QWidget {
    Q_OBJECT
public:
    explicit NodeBar(QWidget* parent = nullptr);

    void showNodes(const QStringList& names, const QString& chosen);
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

/// Selects the archive that receives the DICOM objects of a case and shows the transfer progress; deletes itself when
/// closed.
class SendDialog : public QDialog {
    Q_OBJECT
public:
    explicit SendDialog(QWidget* parent);

    NodeBar& nodes() { return *nodes_; }
    TransferLine& line() { return *line_; }

    void showState();   ///< updates which actions are available
    void showNode();   ///< shows the selected archive, or that there is none
    void showSent(const QString& words);   ///< the transfer is complete

signals:
    void sendRequested();

private:
    NodeBar* nodes_;
    TransferLine* line_;
    QPushButton* close_;
    QPushButton* send_;
};

}   // namespace angiopose::ui
