#pragma once

#include "ui/dialogs/study_list.h"

#include <QDialog>
#include <QImage>

class QLabel;
class QLineEdit;
class QPlainTextEdit;
class QProgressBar;
class QPushButton;

namespace angiopose::ui {

class StudyList;

/// Browser for the contents of a folder or disc: in which the user selects one series for the vessels and cine runs for
/// the views. Updates while the folder is scanned; deletes itself when closed.
class StudyBrowser : public QDialog {
    Q_OBJECT
public:
    StudyBrowser(const QString& place, QWidget* parent);

    void showRows(const std::vector<PatientRow>& patients);
    void showThumbnail(const QString& key, const QImage& image);
    void showProgress(qsizetype read, qsizetype total);
    /// Shows that scanning has ended. `words` summarizes the result, `damaged` lists damaged files, and `offer`
    /// describes files that were not read; it is empty if there are none.
    void showEnd(const QString& summary, const QStringList& damaged, const QString& offer);
    void choose(const QString& key);
    StudyList& list() { return *list_; }

signals:
    void stopRequested();
    void allFilesRequested();
    void thumbnailsRequested(const QStringList& keys);
    /// Carries the keys of the selected series; `vessels` or `views` may be empty.
    void seriesChosen(const QString& vessels, const QStringList& views);

protected:
    void keyPressEvent(QKeyEvent* event) override;

private:
    QLayout* makeStatus();
    QLayout* makeButtons();
    void showSelection();
    void acceptChoice();

    bool isReading_ = false;
    QLineEdit* search_;
    StudyList* list_;
    QLabel* choice_;
    QLabel* notes_;
    QProgressBar* progress_;
    QLabel* status_;
    QPushButton* stop_;
    QPushButton* damaged_;
    QLabel* offer_;
    QPushButton* allFiles_;
    QPlainTextEdit* damagedFiles_;
    QPushButton* open_;
};

}   // namespace angiopose::ui
