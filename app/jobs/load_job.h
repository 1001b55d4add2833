#pragma once

#include "core/registration_case.h"

#include <QFutureWatcher>
#include <QObject>
#include <QStringList>

#include <memory>
#include <optional>

namespace app {

/// What a set of files turned out to be: a whole case, or parts of one.
struct LoadedInputs {
    std::optional<core::RegistrationCase> wholeCase;
    core::InputFile centerlineFile;
    std::shared_ptr<const core::VesselTree> tree;
    core::InputFile imageFile;
    std::shared_ptr<const core::Angiogram> angiogram;
    core::InputFile targetFile;
    std::shared_ptr<const core::Centerline2d> target;
    std::vector<std::string> warnings;
};

/// Reads files together: either one case file, or at most one of each kind of input. Fails with one sentence.
core::Result<LoadedInputs> readInputs(const QStringList& paths);

/// Reads files off the GUI thread. A job that is abandoned or destroyed drops what it reads.
class LoadJob : public QObject {
    Q_OBJECT
public:
    explicit LoadJob(QObject* parent = nullptr);

    void start(const QStringList& paths);
    void abandon();
    bool isRunning() const { return running_; }
    const QStringList& paths() const { return paths_; }

signals:
    void finished(const app::LoadedInputs& inputs);
    void failed(const QString& reason);

private:
    using Outcome = core::Result<LoadedInputs>;
    void publish();

    QStringList paths_;
    QFutureWatcher<Outcome> watcher_;
    bool running_ = false;
};

}   // namespace app
