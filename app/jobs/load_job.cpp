#include "app/jobs/load_job.h"

#include "app/jobs/guarded.h"
#include "app/jobs/input_kind.h"
#include "io/angiogram_file.h"
#include "io/case_file.h"
#include "io/centerline2d_file.h"
#include "io/file_hash.h"
#include "io/vessel_tree_file.h"

#include <QFileInfo>
#include <QtConcurrentRun>

#include <algorithm>

namespace app {
namespace {

core::Result<LoadedInputs> readCase(const QString& path)
{
    LoadedInputs inputs;
    auto loaded = io::loadCase(path.toStdString(), inputs.warnings);
    if (!loaded) {
        return loaded.error();
    }
    inputs.wholeCase = std::move(loaded).value();
    return inputs;
}

core::Error twice(const QString& path, const char* what)
{
    return {QFileInfo(path).fileName().toStdString() + " is a second " + what + ". Open one " + what + " at a time."};
}

core::Status addCenterline(LoadedInputs& inputs, const QString& path)
{
    if (inputs.tree) {
        return twice(path, "centreline");
    }
    auto tree = io::readVesselTree(path.toStdString());
    if (!tree) {
        return tree.error();
    }
    inputs.tree = std::make_shared<core::VesselTree>(std::move(tree).value());
    inputs.centerlineFile.path = path.toStdString();
    return core::Done{};
}

core::Status addImage(LoadedInputs& inputs, const QString& path)
{
    if (inputs.angiogram) {
        return twice(path, "angiogram");
    }
    auto angiogram = io::readAngiogram(path.toStdString());
    if (!angiogram) {
        return angiogram.error();
    }
    const auto& warnings = angiogram.value().warnings;
    inputs.warnings.insert(inputs.warnings.end(), warnings.begin(), warnings.end());
    inputs.angiogram = std::make_shared<core::Angiogram>(std::move(angiogram).value());
    inputs.imageFile.path = path.toStdString();
    return core::Done{};
}

core::Status addTarget(LoadedInputs& inputs, const QString& path)
{
    if (inputs.target) {
        return twice(path, "2-D centreline");
    }
    auto target = io::readCenterline2d(path.toStdString());
    if (!target) {
        return target.error();
    }
    inputs.target = std::make_shared<core::Centerline2d>(std::move(target).value());
    inputs.targetFile.path = path.toStdString();
    return core::Done{};
}

core::Status addFile(LoadedInputs& inputs, const QString& path)
{
    const auto kind = inputKindOf(path);
    if (!kind) {
        return kind.error();
    }
    switch (kind.value()) {
        case InputKind::Centerline:
            return addCenterline(inputs, path);
        case InputKind::Image:
            return addImage(inputs, path);
        case InputKind::Target:
            return addTarget(inputs, path);
        case InputKind::Case:
            break;
    }
    return core::Error{QFileInfo(path).fileName().toStdString() + " is a case. Open it alone, without other files."};
}

void addHash(core::InputFile& file)
{
    if (!file.path.empty()) {
        if (const auto hash = io::sha256OfFile(file.path)) {
            file.sha256 = hash.value();
        }
    }
}

}   // namespace

core::Result<LoadedInputs> readInputs(const QStringList& paths)
{
    if (paths.size() == 1) {
        const auto kind = inputKindOf(paths.front());
        if (kind && kind.value() == InputKind::Case) {
            return readCase(paths.front());
        }
    }
    LoadedInputs inputs;
    for (const QString& path : paths) {
        if (const auto added = addFile(inputs, path); !added) {
            return added.error();
        }
    }
    for (core::InputFile* file : {&inputs.centerlineFile, &inputs.imageFile, &inputs.targetFile}) {
        addHash(*file);
    }
    return inputs;
}

LoadJob::LoadJob(QObject* parent) : QObject(parent)
{
    connect(&watcher_, &QFutureWatcherBase::finished, this, &LoadJob::publish);
}

void LoadJob::start(const QStringList& paths)
{
    Q_ASSERT(!isRunning());
    running_ = true;
    paths_ = paths;
    watcher_.setFuture(
        QtConcurrent::run([paths] { return guarded<LoadedInputs>([&paths] { return readInputs(paths); }); }));
}

void LoadJob::abandon()
{
    // The reader cannot be interrupted; its outcome is dropped by watching nothing.
    running_ = false;
    watcher_.setFuture({});
}

void LoadJob::publish()
{
    if (!running_ || watcher_.future().resultCount() == 0) {
        return;
    }
    running_ = false;
    const Outcome outcome = watcher_.result();
    if (outcome) {
        emit finished(outcome.value());
    } else {
        emit failed(QString::fromStdString(outcome.error().message));
    }
}

}   // namespace app
