#pragma once

#include <QHash>
#include <QImage>
#include <QString>
#include <QStringList>
#include <QTimer>
#include <QTreeWidget>
#include <set>
#include <vector>

namespace angiopose::ui {

/// One series of a study, as displayed in the list.
struct StudySeriesRow {
    enum class Use { Vessels, View, None };

    QString key;   ///< unique; the key of a part of a series changes as more files are found
    Use use = Use::None;
    int number = 0;
    QString modality;
    QString description;
    int imageCount = 0;
    QString size;   ///< e.g. "512 × 512"
    QString frameRate;   ///< slice spacing or frame rate, as text
    double sortValue = 0.0;   ///< value by which `pace` is sorted
    QString bodyPart;
    QStringList notes;   ///< warnings, missing parts, or the reason why the series cannot be opened
};

struct StudyRow {
    QString key;
    QString words;   ///< description of the study: date, description, accession number
    std::vector<StudySeriesRow> series;
};

struct PatientRow {
    QString key;
    QString words;   ///< name, ID and birth date of the patient; may be empty
    std::vector<StudyRow> studies;
};

/// Tree of patients, studies and series with thumbnails. Check boxes select one series for the vessels and any number
/// of cine runs.
class StudyList : public QTreeWidget {
    Q_OBJECT
public:
    static constexpr int thumbnailSize = 56;

    explicit StudyList(QWidget* parent = nullptr);

    /// Updates the rows; items that still exist stay checked, expanded and selected.
    void showRows(const std::vector<PatientRow>& patients);
    void showThumbnail(const QString& key, const QImage& image);
    void search(const QString& words);

    QString chosenVessels() const { return vessels_; }   ///< key of the series; empty if none
    QStringList chosenViews() const;   ///< keys of the series, in list order
    const StudySeriesRow* currentRow() const;
    const StudySeriesRow* rowOf(const QString& key) const;
    void choose(const QString& key);
    int seriesCount() const { return static_cast<int>(series_.size()); }

signals:
    void choiceChanged();
    void openRequested();   ///< emitted on double-click or Enter on a series
    void thumbnailsRequested(const QStringList& keys);   ///< keys of the visible rows, from top to bottom

protected:
    void resizeEvent(QResizeEvent* event) override;
    void scrollContentsBy(int dx, int dy) override;
    void keyPressEvent(QKeyEvent* event) override;

private:
    QTreeWidgetItem* itemFor(const QString& key, QTreeWidgetItem* parent, int place);
    void fillSeries(QTreeWidgetItem& item, const StudySeriesRow& row);
    void forget(const QTreeWidgetItem& item);
    void removeOthers(const std::set<QString>& currentKeys);
    void applyCheckState(QTreeWidgetItem* item, int column);
    void activate(QTreeWidgetItem* item);
    void showMatches();
    void requestThumbnails();

    QHash<QString, QTreeWidgetItem*> items_;   ///< items by key
    QHash<QString, StudySeriesRow> series_;
    QHash<QString, QImage> thumbnails_;
    QString vessels_;
    std::set<QString> views_;
    QStringList searchTerms_;
    QTimer thumbnailTimer_;   ///< delays thumbnail requests until scrolling pauses
    bool isFilling_ = false;
};

}   // namespace angiopose::ui
