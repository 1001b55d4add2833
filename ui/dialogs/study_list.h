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

/// Display texts of one series of a study.
struct StudySeriesRow {
    enum class Use { Vessels, View, None };

    QString key;   ///< unique, and stable while more files are found
    Use use = Use::None;
    int number = 0;
    QString modality;
    QString description;
    int imageCount = 0;
    QString size;   ///< "512 × 512"
    QString pace;   ///< slice spacing, or frames per second
    double paceValue = 0.0;   ///< sort value
    QString bodyPart;
    QStringList notes;   ///< reason why it cannot be opened, missing parts, warnings
};

struct StudyRow {
    QString key;
    QString words;   ///< date, description, accession number
    std::vector<StudySeriesRow> series;
};

struct PatientRow {
    QString key;
    QString words;   ///< name, ID, birth date; may be empty
    std::vector<StudyRow> studies;
};

/// Patients with their studies and series as thumbnails. Check boxes select one series for the vessels and any number
/// of cine runs.
class StudyList : public QTreeWidget {
    Q_OBJECT
public:
    static constexpr int pictureSize = 56;

    explicit StudyList(QWidget* parent = nullptr);

    /// Updates the rows; checked, expanded and selected items stay so if they still exist.
    void showRows(const std::vector<PatientRow>& patients);
    void showPicture(const QString& key, const QImage& picture);
    void search(const QString& words);

    QString chosenVessels() const { return vessels_; }   ///< series key; empty: none
    QStringList chosenViews() const;   ///< in list order
    const StudySeriesRow* currentRow() const;
    const StudySeriesRow* rowOf(const QString& key) const;
    void choose(const QString& key);
    int seriesCount() const { return static_cast<int>(series_.size()); }

signals:
    void choiceChanged();
    void openRequested();   ///< double click or Enter on a series
    void picturesWanted(const QStringList& keys);   ///< visible rows, from top to bottom

protected:
    void resizeEvent(QResizeEvent* event) override;
    void scrollContentsBy(int dx, int dy) override;
    void keyPressEvent(QKeyEvent* event) override;

private:
    QTreeWidgetItem* itemFor(const QString& key, QTreeWidgetItem* parent, int place);
    void fillSeries(QTreeWidgetItem& item, const StudySeriesRow& row);
    void forget(const QTreeWidgetItem& item);
    void removeOthers(const std::set<QString>& kept);
    void takeTick(QTreeWidgetItem* item, int column);
    void activate(QTreeWidgetItem* item);
    void showMatches();
    void wantPictures();

    QHash<QString, QTreeWidgetItem*> items_;   ///< by key
    QHash<QString, StudySeriesRow> series_;
    QHash<QString, QImage> pictures_;
    QString vessels_;
    std::set<QString> views_;
    QStringList words_;
    QTimer looked_;   ///< delays thumbnail requests after scrolling
    bool isFilling_ = false;
};

}   // namespace angiopose::ui
