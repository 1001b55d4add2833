#include "app/menus/language_controller.h"
#include "app/messages/messages.h"
#include "app/preferences/apply_settings.h"
#include "app/preferences/private_mode.h"
#include "app/preferences/save_folder.h"
#include "app/report/case_report.h"
#include "app/start/start_options.h"
#include "app/texts/printable_text.h"
#include "app/window_host.h"
#include "app/words/snapshot_texts.h"
#include "app/words/view_words.h"
#include "core/case/registration_input.h"
#include "core/support/observer_decision.h"
#include "core/support/utc_time.h"
#include "core/workflow/register_case.h"
#include "io/opening/open_case_with_options.h"
#include "io/sharing/audit_file.h"
#include "io/support/atomic_file.h"
#include "io/support/crash_dumps.h"
#include "io/support/file_limits.h"
#include "io/support/system/current_process.h"
#include "ui/words/language.h"

#include <QApplication>
#include <QIcon>

#include <atomic>
#include <clocale>
#include <csignal>
#include <cstdio>
#include <string_view>
#include <utility>

namespace angiopose::app {
namespace {

std::atomic<bool> stopRequested{false};
static_assert(std::atomic<bool>::is_always_lock_free, "the signal handler must not lock");
int lastPercent = -1;

extern "C" void onStopSignal(int signal)
{
    stopRequested = true;
    std::signal(signal, SIG_DFL);
}

/// Turns SIGINT (Ctrl+C) and SIGTERM into a stop request; a second one ends the program at once.
void installStopHandlers()
{
    std::signal(SIGINT, onStopSignal);
    std::signal(SIGTERM, onStopSignal);
}

bool isStopRequested()
{
    return stopRequested;
}

/// Shows the progress in one line on stderr, if stderr is a terminal; returns Stop after a stop request.
core::ObserverDecision showWorkProgress(std::string_view stage, double fraction)
{
    static const bool isWatched = io::isTerminal(stderr);
    const int percent = static_cast<int>(100.0 * fraction);
    if (isWatched && percent != lastPercent) {
        lastPercent = percent;
        std::fprintf(stderr, "\r\x1b[K%.*s %3d %%", static_cast<int>(stage.size()), stage.data(), percent);
        std::fflush(stderr);
    }
    return isStopRequested() ? core::ObserverDecision::Stop : core::ObserverDecision::Continue;
}

/// Erases the progress line.
void clearProgressLine()
{
    if (lastPercent >= 0) {
        std::fputs("\r\x1b[K", stderr);
        lastPercent = -1;
    }
}

// Exit codes, see FORMATS §5.
constexpr int exitSuccess = 0;
constexpr int exitNoInput = 3;
constexpr int exitDistrusted = 4;
constexpr int exitAtStop = 130;

void tell(const core::Message& message, const char* kind = "")
{
    std::fprintf(stderr, "angiopose: %s%s\n", kind, printableText(message.text()).c_str());
}

int failWith(const core::Error& error)
{
    clearProgressLine();
    tell(error.message);
    return error.isCancellation() || isStopRequested() ? exitAtStop : exitNoInput;
}

void audit(io::AuditEvent event, const QString& path)
{
    const QString auditFile = auditPath();
    if (auditFile.isEmpty()) {
        return;
    }
    if (const auto kept = io::recordAudit(auditFile.toStdString(), {event, "angiopose", {path.toStdString()}}); !kept) {
        tell(kept.error().message, "warning: ");
    }
}

core::Result<core::Case> readCase(const ReportCommandOptions& words)
{
    core::Messages warnings;
    const io::CaseLoadOptions request{{}, io::PeakFrameSearch::Skipped};
    auto read = io::openCaseWithOptions(request, words.casePath.toStdString(), warnings,
                                        [](double fraction) { return showWorkProgress("reading", fraction); });
    clearProgressLine();
    for (const core::Message& warning : warnings) {
        tell(warning, "warning: ");
    }
    return read;
}

std::string authorOf(const ReportCommandOptions& words)
{
    return words.author.value_or(observerName()).toStdString();
}

/// Case with the pose to report, and the vessels traced in its image.
struct Reportable {
    core::Case session;
    core::Centerline2d target;
};

core::Result<Reportable> registered(core::Case session, const ReportCommandOptions& words)
{
    core::RegistrationPlan plan;
    plan.author = authorOf(words);
    plan.time = core::utcNow();
    auto found = core::registerCase(std::move(session), std::move(plan), [](const core::WorkReport& report) {
        return showWorkProgress("registering", report.fraction);
    });
    clearProgressLine();
    if (!found) {
        return found.error();
    }
    if (isStopRequested()) {
        return core::Cancellation{messages::reportStopped()};
    }
    core::RegisteredCase done = std::move(found).value();
    return Reportable{std::move(done.session), std::move(done.targets.front())};
}

core::Result<Reportable> asItIs(core::Case session)
{
    auto target = core::targetOf(session.shown());
    if (!target) {
        return target.error();
    }
    return Reportable{std::move(session), std::move(target).value()};
}

core::Result<std::vector<ReportedView>> viewsOf(const Reportable& reported, const ReportCommandOptions& words)
{
    OverlayImageOptions imageOptions;
    imageOptions.texts = windowTexts;
    imageOptions.identity = words.identity;
    return evaluateViews(caseForExport(reported.session), reported.target, imageOptions);
}

core::Status write(const std::vector<ReportedView>& views, const ReportCommandOptions& words)
{
    const bool isPdf = words.outputPath.endsWith(QLatin1String(".pdf"), Qt::CaseInsensitive);
    const CaseReport report{views, QString::fromStdString(authorOf(words)), QApplication::font().families(),
                            words.templatePath};
    const auto bytes = reportBytes(report, isPdf ? ReportKind::Pdf : ReportKind::Html);
    if (!bytes) {
        return bytes.error();
    }
    return io::writeAtomically(words.outputPath.toStdString(),
                               {bytes.value().constData(), static_cast<std::size_t>(bytes.value().size())});
}

/// Suppresses Qt's remarks about a missing desktop; messages report problems on which users can act.
void suppressQtWarnings()
{
    qInstallMessageHandler([](QtMsgType type, const QMessageLogContext&, const QString& text) {
        if (type == QtFatalMsg) {
            std::fprintf(stderr, "angiopose: %s\n", qPrintable(text));
        }
    });
}

int tellTrust(const core::RegistrationResult& evaluation)
{
    if (evaluation.trustworthy) {
        return exitSuccess;
    }
    tell(messages::reportDistrusted());
    for (const core::Message& warning : evaluation.warnings) {
        tell(warning, "warning: ");
    }
    return exitDistrusted;
}

int writeReportOf(const ReportCommandOptions& words)
{
    auto read = readCase(words);
    if (!read) {
        return failWith(read.error());
    }
    audit(io::AuditEvent::Opened, words.casePath);
    const auto reported =
        words.isRegistered ? registered(std::move(read).value(), words) : asItIs(std::move(read).value());
    if (!reported) {
        return failWith(reported.error().about(words.casePath.toStdString()));
    }
    const auto views = viewsOf(reported.value(), words);
    if (!views) {
        return failWith(views.error().about(words.casePath.toStdString()));
    }
    if (isStopRequested()) {
        return failWith(core::Cancellation{messages::reportStopped()});
    }
    if (const auto written = write(views.value(), words); !written) {
        return failWith(written.error());
    }
    audit(io::AuditEvent::Exported, words.outputPath);
    return tellTrust(views.value().front().evaluation);
}

/// Writes a report with these options as the window would, but without a window or a display; messages go to stderr, in
/// English. Returns the exit code of the program (FORMATS §5).
int writeReport(int argc, char** argv, const ReportCommandOptions& words)
{
    installStopHandlers();
    suppressQtWarnings();
    qputenv("QT_QPA_PLATFORM", "offscreen");   // set even if there is a display, because no window is shown
    QApplication application(argc, argv);
    std::setlocale(LC_NUMERIC, "C");   // Qt sets the system's numeric locale, in which libraries may parse 0.8 as 0
    if (words.language.isEmpty()) {
        applyLanguageSetting();
    } else {
        ui::applyLanguage(words.language);
    }
    applyThemeSetting(application);   // required for the font, which the theme sets
    applyColorSetting();
    return writeReportOf(words);
}

}   // namespace
}   // namespace angiopose::app

using namespace angiopose;

int main(int argc, char** argv)
{
    io::reportFileSizeLimit();
    io::enableCrashDumps("angiopose");
    const app::StartOptions words = app::parseStartOptions(argc, argv);
    if (words.exitCode) {
        return *words.exitCode;
    }
    if (words.report) {
        return app::writeReport(argc, argv, *words.report);
    }
    QApplication application(argc, argv);
    std::setlocale(LC_NUMERIC, "C");   // Qt sets the system's numeric locale, in which libraries may parse 0.8 as 0
    QApplication::setWindowIcon(QIcon(QStringLiteral(":/icons/angiopose.svg")));
    QGuiApplication::setDesktopFileName(QStringLiteral("org.angiopose.AngioPose"));

    app::applyLanguageSetting();
    app::applyShortcutSettings();
    app::applyThemeSetting(application);
    app::WindowHost host;
    host.controller().begin(words.files);
    return QApplication::exec();
}
