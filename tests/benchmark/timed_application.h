#pragma once

#include "tests/benchmark/stack_watch.h"

#include <QApplication>

#include <map>
#include <string>
#include <vector>

namespace benchmarks {

/// Measures the processor time of every event the loop delivers; events sent from within one count as part of it, and
/// are told apart in what a slow one consisted of.
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
    static constexpr double lookAtStackMs = 10.0;

    void note(const QString& name, double tookMs);
    static void printInner(const Slow& slow);

    int depth_ = 0;
    std::map<QString, double> inner_;
    std::map<QString, Slow> slowest_;
    StackWatch stackWatch_{lookAtStackMs};
};

}   // namespace benchmarks
