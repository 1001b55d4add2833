#pragma once

#include "app/jobs/job.h"
#include "core/imaging/image2d.h"
#include "io/series/series.h"

#include <QObject>
#include <QString>

#include <deque>
#include <memory>

namespace angiopose::app {

/// Makes small pictures of series off the GUI thread, one after the other, those that are wanted now.
class SeriesPictures : public QObject {
    Q_OBJECT
public:
    struct Wanted {
        QString key;
        std::shared_ptr<const io::DicomSeries> series;
    };
    SeriesPictures(int sidePx, QObject* parent);

    /// Instead of those wanted before: what is under way ends unless it is wanted still.
    void want(std::deque<Wanted> wanted);

signals:
    void made(const QString& key, const core::ImageF& picture);   ///< 0 black to 1 white
    void failed(const QString& key);   ///< there is none

private:
    void startNext();

    int sidePx_;
    std::deque<Wanted> waiting_;
    QString underWay_;   ///< empty: none
    Job<core::ImageF> job_;
};

}   // namespace angiopose::app
