// A long session of random but valid user actions (issue 5): ends without a crash, a leak above 20 MiB or a case that
// differs after saving and reopening, and prints how long the window's event handlers took.
//   xvfb-run -a -s "-screen 0 1920x1200x24" random_session [actions=5000] [seed=1] [file…]
#include "app/files/sample_case.h"
#include "tests/app/session/random_user.h"
#include "tests/app/session/session_check.h"
#include "ui/theme/active_theme.h"

#include <malloc.h>
#include <QApplication>
#include <QElapsedTimer>
#include <QTemporaryDir>
#include <QTest>
#include <QThreadPool>

#include <algorithm>
#include <cstdio>
#include <ctime>
#include <map>

namespace {

constexpr double handlerLimitMs = 16.0;
constexpr double leakLimitMiB = 20.0;

double threadMs()
{
    timespec now{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
    return 1e3 * static_cast<double>(now.tv_sec) + 1e-6 * static_cast<double>(now.tv_nsec);
}

/// Measures the processor time of every event the loop delivers; events sent from within one count as part of it.
class TimedApplication : public QApplication {
public:
    using QApplication::QApplication;

    struct Slow {
        int count = 0;
        double worstMs = 0.0;
    };

    bool notify(QObject* receiver, QEvent* event) override
    {
        if (depth_++ > 0) {
            const bool inner = QApplication::notify(receiver, event);
            --depth_;
            return inner;
        }
        const QString name =
            QStringLiteral("%1 · event %2").arg(receiver->metaObject()->className()).arg(event->type());
        const double before = threadMs();
        const bool accepted = QApplication::notify(receiver, event);
        const double tookMs = threadMs() - before;
        --depth_;
        ++handled;
        if (tookMs > handlerLimitMs && isWatching) {
            Slow& slow = slowest[name];
            ++slow.count;
            slow.worstMs = std::max(slow.worstMs, tookMs);
        }
        return accepted;
    }

    bool isWatching = false;
    int handled = 0;
    std::map<QString, Slow> slowest;

private:
    int depth_ = 0;
};

double heapMiB()
{
    malloc_trim(0);
    const struct mallinfo2 info = mallinfo2();
    return static_cast<double>(info.uordblks + info.hblkhd) / (1024.0 * 1024.0);
}

/// Stops what runs; false when it does not end.
bool isIdle(app::CaseController& controller)
{
    controller.registration().stop();
    return QTest::qWaitFor([&] { return !controller.registration().isRunning(); }, 60000);
}

/// Opens the files as a fresh case, so that memory is comparable before and after.
bool openAfresh(app::CaseController& controller, const QStringList& paths)
{
    const bool hasStopped = isIdle(controller);
    controller.document().replace({}, {});
    controller.open(paths);
    const bool isOpen = QTest::qWaitFor([&] { return !controller.isLoading() && controller.judgement(); }, 60000);
    QTest::qWait(1000);
    return hasStopped && isOpen;
}

int run(TimedApplication& application, int actions, std::uint64_t seed, const QStringList& paths)
{
    ui::MainWindow window;
    app::CaseController controller(window);
    window.resize(1400, 900);
    window.show();
    if (!openAfresh(controller, paths)) {
        std::fputs("The case did not open.\n", stderr);
        return 1;
    }
    test::RandomUser user(window, controller, seed);
    const auto act = [&](int count) {
        for (int i = 0; i < count; ++i) {
            user.act();
        }
    };
    act(std::min(300, actions / 5));   // fonts, caches and dialogs are made once
    openAfresh(controller, paths);
    const double before = heapMiB();

    QElapsedTimer timer;
    timer.start();
    application.isWatching = true;
    act(actions);
    application.isWatching = false;
    const double minutes = static_cast<double>(timer.elapsed()) / 60000.0;

    const QTemporaryDir folder;
    const QString difference =
        isIdle(controller) ? test::differenceAfterReopening(controller, folder.path()) : "a run that does not stop";
    openAfresh(controller, paths);
    const double grownMiB = heapMiB() - before;

    std::printf("%d actions in %.1f min, seed %llu, %d events\n", actions, minutes,
                static_cast<unsigned long long>(seed), application.handled);
    std::printf("memory: %+.1f MiB (limit %.0f)\n", grownMiB, leakLimitMiB);
    std::printf("after saving and reopening: %s\n", difference.isEmpty() ? "the same" : qPrintable(difference));
    std::printf("event handlers above %.0f ms of processor time: %s\n", handlerLimitMs,
                application.slowest.empty() ? "none" : "");
    for (const auto& [name, slow] : application.slowest) {
        std::printf("  %4d x, worst %6.1f ms  %s\n", slow.count, slow.worstMs, qPrintable(name));
    }
    return difference.isEmpty() && grownMiB < leakLimitMiB ? 0 : 1;
}

}   // namespace

int main(int argc, char** argv)
{
    const QTemporaryDir home;
    qputenv("XDG_DATA_HOME", home.path().toUtf8());
    qputenv("XDG_CONFIG_HOME", home.path().toUtf8());
    TimedApplication application(argc, argv);
    QApplication::setOrganizationName(QStringLiteral("AngioPose"));
    QApplication::setApplicationName(QStringLiteral("AngioPoseSession"));
    QApplication::setQuitOnLastWindowClosed(false);
    ui::applyTheme(application, ui::ThemeMode::Dark);
    QStringList words = QApplication::arguments().mid(1);
    const int actions = words.isEmpty() ? 5000 : words.takeFirst().toInt();
    const std::uint64_t seed = words.isEmpty() ? 1 : words.takeFirst().toULongLong();
    if (words.isEmpty()) {
        const auto sample = app::writeSampleCase();
        if (!sample) {
            std::fputs(sample.error().message.c_str(), stderr);
            return 1;
        }
        words << sample.value();
    }
    const int outcome = run(application, actions, seed, words);
    QThreadPool::globalInstance()->waitForDone();
    return outcome;
}
