#include "app/editor/panels/measure/measurement_file.h"

#include "app/editor/dialogs/ask.h"
#include "app/editor/dialogs/attempt.h"
#include "app/editor/document/file_memory.h"

namespace esm {

QString writeMeasurement(QWidget* window, const NewFile& asked, const QString& failure,
                         const std::function<void(const std::filesystem::path&)>& writing) {
    const auto file = ask(*window, [&] { return chooseNewFile(window, asked); });
    if (!file || !attempt(window, failure, [&] { writing(*file); })) return {};
    rememberFolder(FileKind::Package, *file);
    return QObject::tr("%1 is written").arg(QString::fromStdString(file->filename().string()));
}

} // namespace esm
