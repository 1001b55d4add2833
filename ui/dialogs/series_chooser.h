#pragma once

#include <QDialog>
#include <QStringList>

#include <vector>

class QLabel;
class QPushButton;
class QTreeWidget;

namespace angiopose::ui {

/// One series of a DICOM folder, as displayed in the list.
struct SeriesRow {
    QString id;
    QString description;
    QString modality;
    int imageCount = 0;
    QString size;   ///< e.g. "512 × 512 × 300"
    QString spacingMm;   ///< e.g. "0.49 × 0.49 × 0.75"
    QString date;
    QStringList notes;   ///< warnings, or the reason why the series cannot be opened
    bool isOpenable = true;
};

/// Dialog that selects one series of a folder to open. Deletes itself when closed.
class SeriesChooser : public QDialog {
    Q_OBJECT
public:
    SeriesChooser(const QString& folder, std::vector<SeriesRow> rows, QWidget* parent);

signals:
    void seriesChosen(const QString& seriesId);

private:
    void fill();
    int currentRow() const;
    void showNotes();
    void choose();

    std::vector<SeriesRow> rows_;
    QTreeWidget* list_;
    QLabel* notes_;
    QPushButton* open_;
};

}   // namespace angiopose::ui
