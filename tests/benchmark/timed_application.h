#pragma once

#include "tests/benchmark/stack_watch.h"

#include <QApplication>

#include <deque>
#include <map>
#include <string>
#include <vector>

namespace angiopose::benchmarks {

/// Measures the processor time of every event the loop delivers; events sent from within one count as part of it, and
/// are told apart in what a slow one consisted of. What a loop inside it delivers (an open menu runs one) are handlers
/// of their own.
class TimedApplication : public QApplication {
public:
    static constexpr double handlerLimitMs = 16.0;

    using QApplication::QApplication;

    bool notify(QObject* receiver, QEvent* event) override;
    void printSlow() const;   ///< handlers that took longer than the limit while it was watching

    bool isWatching = false;
    int handled = 0;

private:
    struct Slow {
        int count = 0;
        double worstMs = 0.0;
        std::map<QString, double> innerMs;   ///< of all `count` together
        std::vector<std::string> stack;   ///< of the worst, after `lookAtStackMs`
    };
    struct Handler {
        int loopLevel = 0;
        double awayMs = 0.0;   ///< in handlers of a loop inside it
        bool isInside = false;   ///< an event that was sent from it
        std::map<QString, double> innerMs;
    };
    static constexpr double lookAtStackMs = 10.0;

    bool handle(QObject* receiver, QEvent* event, int loopLevel);
    void note(const QString& name, double tookMs, const Handler& handler);
    static void printInner(const Slow& slow);

    std::deque<Handler> handlers_;   ///< under way; each runs in a loop inside the one before
    std::map<QString, Slow> slowest_;
    StackWatch stackWatch_{lookAtStackMs};
};

}   // namespace angiopose::benchmarks