#pragma once

#include <QDateTime>
#include <QString>

#include <deque>

namespace angiopose::ui {

/// Entry of the message log.
struct LoggedMessage {
    QDateTime time;
    QString text;
};

/// Log of the most recent messages, which lists repeated messages only once.
class MessageLog {
public:
    static constexpr std::size_t maxCount = 500;

    void add(const QString& text)
    {
        if (text.isEmpty() || (!all_.empty() && all_.back().text == text)) {
            return;
        }
        all_.push_back({QDateTime::currentDateTime(), text});
        if (all_.size() > maxCount) {
            all_.pop_front();
        }
    }
    const std::deque<LoggedMessage>& all() const { return all_; }

private:
    std::deque<LoggedMessage> all_;
};

}   // namespace angiopose::ui
