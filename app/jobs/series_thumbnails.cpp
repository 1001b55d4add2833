#include "app/jobs/series_thumbnails.h"

#include "io/study/series_thumbnail.h"

#include <algorithm>
#include <utility>

namespace angiopose::app {

SeriesThumbnails::SeriesThumbnails(int sidePx, QObject* parent)
    : QObject(parent),
      sidePx_(sidePx),
      job_({[this](const core::ImageF& picture) {
                const QString key = std::exchange(currentKey_, {});
                startNext();
                emit loaded(key, picture);
            },
            [this](const core::Error&) {
                const QString key = std::exchange(currentKey_, {});
                startNext();
                emit failed(key);
            }})
{
}

void SeriesThumbnails::request(std::deque<Request> requests)
{
    const auto same = std::ranges::find(requests, currentKey_, &Request::key);
    if (!currentKey_.isEmpty() && same != requests.end()) {
        requests.erase(same);
    } else {
        job_.drop();
        currentKey_.clear();
    }
    pending_ = std::move(requests);
    if (currentKey_.isEmpty()) {
        startNext();
    }
}

void SeriesThumbnails::startNext()
{
    if (pending_.empty()) {
        return;
    }
    const Request next = std::move(pending_.front());
    pending_.pop_front();
    currentKey_ = next.key;
    job_.start([series = next.series, side = sidePx_](JobLink<double>& link) {
        return io::seriesThumbnail(*series, side, [&link](double fraction) { return link.tell(fraction); });
    });
}

}   // namespace angiopose::app
