#pragma once

#include "ui/archive/archive_rows.h"

#include <QHash>
#include <QTreeWidget>

namespace angiopose::ui {

/// List of the studies found in an archive, with multiple selection; series are loaded when a study is expanded.
class MatchList : public QTreeWidget {
    Q_OBJECT
public:
    explicit MatchList(QWidget* parent = nullptr);

    void showStudies(const std::vector<MatchRow>& studies);
    void showSeries(const QString& studyKey, const std::vector<MatchRow>& series);
    /// Marks the series of a study as not loaded, so expanding the study requests them again.
    void markSeriesUnloaded(const QString& studyKey);
    /// Sets the text shown in the middle of an empty list.
    void setPlaceholderText(const QString& placeholder);

    struct Selection {
        QString study, series;   ///< keys; an empty `series` stands for the whole study
    };
    std::vector<Selection> selection() const;

signals:
    void seriesRequested(const QString& studyKey);
    void choiceChanged();
    void retrieveRequested();

protected:
    void keyPressEvent(QKeyEvent* event) override;
    void paintEvent(QPaintEvent* event) override;

private:
    void requestSeries(QTreeWidgetItem* study);
    void activate(QTreeWidgetItem* item);
    void fill(QTreeWidgetItem& item, const MatchRow& row);
    void fitColumns();
    void addPlaceholder(QTreeWidgetItem& study);

    QHash<QString, QTreeWidgetItem*> studies_;
    QString placeholder_;
};

}   // namespace angiopose::ui
