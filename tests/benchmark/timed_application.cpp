#include "tests/benchmark/timed_application.h"

#include <QAbstractButton>
#include <QThread>

#include <algorithm>
#include <cstdio>
#include <ctime>
#include <functional>
#include <utility>

namespace angiopose::benchmarks {
namespace {

double threadMs()
{
    timespec now{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
    return 1e3 * static_cast<double>(now.tv_sec) + 1e-6 * static_cast<double>(now.tv_nsec);
}

/// Text of a button, to identify it; read before the event, which may delete the button.
QString wordsOn(const QObject& receiver)
{
    const auto* button = qobject_cast<const QAbstractButton*>(&receiver);
    return button ? QStringLiteral(" “%1”").arg(button->text()) : QString();
}

QString nameOf(const QObject& receiver, const QEvent& event)
{
    return QStringLiteral("%1 · event %2%3")
        .arg(QLatin1String(receiver.metaObject()->className()))
        .arg(event.type())
        .arg(wordsOn(receiver));
}

/// Prints the stack of a slow handler, innermost first: our own functions, and the function that the innermost one was
/// calling.
void printStack(const std::vector<std::string>& stack)
{
    constexpr std::size_t maxCalled = 3;
    constexpr std::size_t maxOwn = 5;
    const auto isOwn = [](const std::string& name) { return name.starts_with("angiopose::"); };
    std::vector<std::string> reported(stack.begin(), std::ranges::find_if(stack, isOwn));
    reported.resize(std::min(reported.size(), maxCalled));
    std::size_t own = 0;
    for (const std::string& name : stack) {
        if (isOwn(name) && own++ < maxOwn) {
            reported.push_back(name);
        }
    }
    for (const std::string& name : reported) {
        std::printf("          in %s\n", name.c_str());
    }
}

}   // namespace

bool TimedApplication::notify(QObject* receiver, QEvent* event)
{
    if (!isWatching || QThread::currentThread() != thread()) {
        return QApplication::notify(receiver, event);
    }
    const int loopLevel = thread()->loopLevel();
    if (handlers_.empty() || loopLevel > handlers_.back().loopLevel) {
        return handle(receiver, event, loopLevel);
    }
    Handler& handler = handlers_.back();
    if (handler.isInside) {
        return QApplication::notify(receiver, event);
    }
    const QString name = nameOf(*receiver, *event);
    const double before = threadMs() - handler.awayMs;
    handler.isInside = true;
    const bool accepted = QApplication::notify(receiver, event);
    handler.isInside = false;
    handler.innerMs[name] += threadMs() - handler.awayMs - before;
    return accepted;
}

bool TimedApplication::handle(QObject* receiver, QEvent* event, int loopLevel)
{
    const QString name = nameOf(*receiver, *event);
    const double before = threadMs();
    handlers_.emplace_back().loopLevel = loopLevel;
    stackWatch_.begin();
    const bool accepted = QApplication::notify(receiver, event);
    const Handler done = std::move(handlers_.back());
    handlers_.pop_back();
    const double allMs = threadMs() - before;
    ++handled;
    if (allMs - done.awayMs > handlerLimitMs) {
        note(name, allMs - done.awayMs, done);
    }
    if (!handlers_.empty()) {
        handlers_.back().awayMs += allMs;
        stackWatch_.begin();
    }
    return accepted;
}

void TimedApplication::note(const QString& name, double tookMs, const Handler& handler)
{
    Slow& slow = slowest_[name];
    ++slow.count;
    if (tookMs > slow.worstMs) {
        slow.worstMs = tookMs;
        slow.stack = stackWatch_.end();
    }
    for (const auto& [inner, ms] : handler.innerMs) {
        slow.innerMs[inner] += ms;
    }
}

/// Prints the nested events that took the time of slow handlers, longest first.
void TimedApplication::printInner(const Slow& slow)
{
    std::vector<std::pair<double, QString>> parts;
    for (const auto& [name, ms] : slow.innerMs) {
        parts.emplace_back(ms / slow.count, name);
    }
    std::ranges::sort(parts, std::greater());
    parts.resize(std::min<std::size_t>(parts.size(), 6));
    for (const auto& [ms, name] : parts) {
        std::printf("          %5.1f ms on average in %s\n", ms, qPrintable(name));
    }
}

void TimedApplication::printSlow() const
{
    std::printf("event handlers above %.0f ms of processor time: %s\n", handlerLimitMs, slowest_.empty() ? "none" : "");
    for (const auto& [name, slow] : slowest_) {
        std::printf("  %4d x, worst %6.1f ms  %s\n", slow.count, slow.worstMs, qPrintable(name));
        printInner(slow);
        printStack(slow.stack);
    }
}

}   // namespace angiopose::benchmarks
