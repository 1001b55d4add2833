#pragma once

#include "app/jobs/job.h"
#include "core/imaging/image2d.h"
#include "io/series/series.h"

#include <QObject>
#include <QString>

#include <deque>
#include <memory>

namespace angiopose::app {

/// Creates thumbnails of the requested series off the GUI thread, one at a time.
class SeriesThumbnails : public QObject {
    Q_OBJECT
public:
    struct Request {
        QString key;
        std::shared_ptr<const io::DicomSeries> series;
    };
    SeriesThumbnails(int sidePx, QObject* parent);

    /// Replaces the previous requests. Work in progress stops unless its series is still requested.
    void request(std::deque<Request> requests);

signals:
    void loaded(const QString& key, const core::ImageF& picture);   ///< emitted with values from 0 (black) to 1 (white)
    void failed(const QString& key);   ///< emitted if no thumbnail can be created

private:
    void startNext();

    int sidePx_;
    std::deque<Request> pending_;
    QString currentKey_;   ///< key of the series in progress; empty if there is none
    Job<core::ImageF> job_;
};

}   // namespace angiopose::app
