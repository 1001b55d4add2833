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

/// One series of a study, in words.
struct StudySeriesRow {
    enum class Use { Vessels, View, None };

    QString key;   ///< tells it from all others, and stays while more is found
    Use use = Use::None;
    int number = 0;
    QString modality;
    QString description;
    int imageCount = 0;
    QString size;   ///< "512 × 512"
    QString pace;   ///< distance of slices, or frames in a second
    double paceValue = 0.0;   ///< by which it is sorted
    QString bodyPart;
    QStringList notes;   ///< why it cannot be opened, what is missing, warnings
};

struct StudyRow {
    QString key;
    QString words;   ///< date, description, accession
    std::vector<StudySeriesRow> series;
};

struct PatientRow {
    QString key;
    QString words;   ///< name, ID, birth date; or nothing of these
    std::vector<StudyRow> studies;
};

/// Patients, their studies and series with small pictures. Ticks choose: of series with vessels one, of runs any.
class StudyList : public QTreeWidget {
    Q_OBJECT
public:
    static constexpr int pictureSize = 56;

    explicit StudyList(QWidget* parent = nullptr);

    /// What was ticked, unfolded and selected stays so, as far as it is still there.
    void showRows(const std::vector<PatientRow>& patients);
    void showPicture(const QString& key, const QImage& picture);
    void search(const QString& words);

    QString chosenVessels() const { return vessels_; }   ///< a key; empty: none
    QStringList chosenViews() const;   ///< in the order of the list
    const StudySeriesRow* currentRow() const;
    const StudySeriesRow* rowOf(const QString& key) const;
    void choose(const QString& key);
    int seriesCount() const { return static_cast<int>(series_.size()); }

signals:
    void choiceChanged();
    void openRequested();   ///< a double click or Enter on a series
    void picturesWanted(const QStringList& keys);   ///< of the rows that are seen, from above

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
    QTimer looked_;   ///< runs for a moment after the list moved
    bool isFilling_ = false;
};

}   // namespace angiopose::ui
