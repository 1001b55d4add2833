#include "app/jobs/series_pictures.h"

#include "io/study/series_picture.h"

#include <algorithm>
#include <utility>

namespace angiopose::app {

SeriesPictures::SeriesPictures(int sidePx, QObject* parent)
    : QObject(parent),
      sidePx_(sidePx),
      job_({[this](const core::ImageF& picture) {
                const QString key = std::exchange(underWay_, {});
                startNext();
                emit made(key, picture);
            },
            [this](const core::Error&) {
                const QString key = std::exchange(underWay_, {});
                startNext();
                emit failed(key);
            }})
{
}

void SeriesPictures::want(std::deque<Wanted> wanted)
{
    const auto same = std::ranges::find(wanted, underWay_, &Wanted::key);
    if (!underWay_.isEmpty() && same != wanted.end()) {
        wanted.erase(same);
    } else {
        job_.drop();
        underWay_.clear();
    }
    waiting_ = std::move(wanted);
    if (underWay_.isEmpty()) {
        startNext();
    }
}

void SeriesPictures::startNext()
{
    if (waiting_.empty()) {
        return;
    }
    const Wanted next = std::move(waiting_.front());
    waiting_.pop_front();
    underWay_ = next.key;
    job_.start([series = next.series, side = sidePx_](JobLink<double>& link) {
        return io::seriesPicture(*series, side, [&link](double fraction) { return link.tell(fraction); });
    });
}

}   // namespace angiopose::app
