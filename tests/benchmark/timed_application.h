#pragma once

#include "tests/benchmark/stack_watch.h"

#include <QApplication>

#include <deque>
#include <map>
#include <string>
#include <vector>

namespace angiopose::benchmarks {

/// Measures the processor time of every event that the loop delivers. Events sent from a handler count as part of it
/// and are listed separately in the breakdown of slow ones. Events delivered by a nested loop (as of an open menu) are
/// handlers of their own.
class TimedApplication : public QApplication {
public:
    static constexpr double handlerLimitMs = 16.0;

    using QApplication::QApplication;

    bool notify(QObject* receiver, QEvent* event) override;
    void printSlow() const;   ///< handlers that exceeded the limit while watching

    bool isWatching = false;
    int handled = 0;

private:
    struct Slow {
        int count = 0;
        double worstMs = 0.0;
        std::map<QString, double> innerMs;   ///< total over all `count` handlers
        std::vector<std::string> stack;   ///< of the slowest handler, after `lookAtStackMs`
    };
    struct Handler {
        int loopLevel = 0;
        double awayMs = 0.0;   ///< time in handlers of a nested loop
        bool isInside = false;   ///< an event sent from this handler
        std::map<QString, double> innerMs;
    };
    static constexpr double lookAtStackMs = 10.0;

    bool handle(QObject* receiver, QEvent* event, int loopLevel);
    void note(const QString& name, double tookMs, const Handler& handler);
    static void printInner(const Slow& slow);

    std::deque<Handler> handlers_;   ///< running handlers; each runs in a loop nested in the previous one
    std::map<QString, Slow> slowest_;
    StackWatch stackWatch_{lookAtStackMs};
};

}   // namespace angiopose::benchmarks
